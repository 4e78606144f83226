// Two lines combine as docs/unit.md says (4.2.1 and Table 7, ordered by angle and as printed, with the vertex
// rule per line and per entry), the crossing points' products included: for every pair of lines at 2-bit fields.
// Written from the definitions: a half plane by the sign of its line's equation, an angle as a number.
//
// pipeline: 1
// package: FractionBits=2 SlopeBits=2 PolygonBits=1
// broken: combine.sv: `both_through ? a_holds && b_holds : a_holds || b_holds` => `a_holds && b_holds`
// broken: combine.sv: `parallel   = a_angle == b_angle` => `parallel   = 1'b0`
// broken: combine.sv: `a_i.slope ^ {S{a_odd}}` => `a_i.slope`
// broken: combine.sv: `a_i.slope <= b_i.slope` => `a_i.slope < b_i.slope`
// broken: combine.sv: `cannot_meet = low_both ? high_both :` => `cannot_meet = low_both ? 1'b0 :`
// broken: combine.sv: `printed_first = !a_i.x_positive;` => `printed_first = a_i.x_positive;`
// broken: combine.sv: `b_i.x_positive ? bu : bnu` => `b_i.x_positive ? bnu : bu`
module combine_proof (
  input logic              clk_i,
  input logic              vertex_per_entry_i,
  input logic              table7_printed_i,
  input shadow_pkg::line_t a_i,
  input shadow_pkg::line_t b_i,
  input logic              vertex_i
);
  localparam logic [2:0] One = 3'd4;
  logic and_o;
  combine dut (
    .a_complement_i(One - {1'b0, a_i.fraction}), .b_complement_i(One - {1'b0, b_i.fraction}), .*
  );

  // Where each line takes its Fraction.
  wire signed [9:0] au = !a_i.x_major ? $signed({8'd0, a_i.fraction}) : a_i.cross_flag ? 10'sd4 : 10'sd0;
  wire signed [9:0] ax = a_i.x_positive ? au : 10'sd4 - au;
  wire signed [9:0] ay = a_i.x_major ? $signed({8'd0, a_i.fraction}) : a_i.cross_flag ? 10'sd4 : 10'sd0;
  wire signed [9:0] bu = !b_i.x_major ? $signed({8'd0, b_i.fraction}) : b_i.cross_flag ? 10'sd4 : 10'sd0;
  wire signed [9:0] bx = b_i.x_positive ? bu : 10'sd4 - bu;
  wire signed [9:0] by = b_i.x_major ? $signed({8'd0, b_i.fraction}) : b_i.cross_flag ? 10'sd4 : 10'sd0;
  logic a_has_b, b_has_a;
  half_plane a_plane (.line_i(a_i), .x_i(bx), .y_i(by), .holds_o(a_has_b));
  half_plane b_plane (.line_i(b_i), .x_i(ax), .y_i(ay), .holds_o(b_has_a));
  wire a_ends = a_i.start_here || a_i.end_here;
  wire b_ends = b_i.start_here || b_i.end_here;
  wire by_fractions = a_ends || b_ends ? a_has_b || b_has_a : a_has_b && b_has_a;

  // Ordered by angle: octants x+, y+, y-, x-; the slope grows with the angle in the first and third.
  logic [3:0] a_angle, b_angle;
  always_comb begin
    case ({a_i.x_major, a_i.x_positive})
      2'b11:   a_angle = {2'd0, a_i.slope};
      2'b01:   a_angle = {2'd1, 2'd3 - a_i.slope};
      2'b00:   a_angle = {2'd2, a_i.slope};
      default: a_angle = {2'd3, 2'd3 - a_i.slope};
    endcase
    case ({b_i.x_major, b_i.x_positive})
      2'b11:   b_angle = {2'd0, b_i.slope};
      2'b01:   b_angle = {2'd1, 2'd3 - b_i.slope};
      2'b00:   b_angle = {2'd2, b_i.slope};
      default: b_angle = {2'd3, 2'd3 - b_i.slope};
    endcase
  end
  shadow_pkg::line_t low, high;
  assign low  = a_angle < b_angle ? a_i : b_i;
  assign high = a_angle < b_angle ? b_i : a_i;
  wire low_both  = low.start_here && low.end_here;
  wire high_both = high.start_here && high.end_here;
  // One outline through both: what ends in the vertex on one side begins there on the other.
  wire seen_end  = low.left == high.left ? !high.end_here : high.end_here;
  wire low_end   = !vertex_per_entry_i && low_both ? seen_end : low.end_here;
  wire no_vertex = !vertex_per_entry_i && (low_both ? high_both : !high_both && low.end_here != seen_end);
  wire by_angles = a_angle == b_angle || no_vertex ? by_fractions : high.left != low_end;
  // As printed: row by A's major axis and sign, column by B's. first: Exp1 decides, else its contrary.
  logic first;
  always_comb begin
    case ({a_i.x_major, a_i.x_positive, b_i.x_major, b_i.x_positive})
      4'b1111, 4'b1010, 4'b0101, 4'b0000: first = a_i.slope <= b_i.slope;
      4'b1110, 4'b1101, 4'b1100:          first = 1'b1;
      4'b1011, 4'b1001, 4'b1000:          first = 1'b0;
      4'b0111, 4'b0010:                   first = !a_i.x_positive;
      4'b0110, 4'b0100:                   first = 1'b1;
      default:                            first = 1'b0;
    endcase
  end
  wire exp1_and = b_i.left != a_i.end_here;
  wire printed  = first ? exp1_and : !exp1_and;
  wire meet     = vertex_per_entry_i ? vertex_i : a_ends && b_ends;

  always_ff @(posedge clk_i)
    assert (and_o == (!meet ? by_fractions : table7_printed_i ? printed : by_angles));
endmodule

// Tables 5 and 6: d in 1/16 texel, of the point (x, y) in 1/4 texel.
module half_plane (
  input  shadow_pkg::line_t  line_i,
  input  logic signed [9:0]  x_i,
  input  logic signed [9:0]  y_i,
  output logic               holds_o
);
  wire signed [9:0] u        = line_i.x_positive ? x_i : 10'sd4 - x_i;
  wire signed [9:0] major    = line_i.x_major ? u : y_i;
  wire signed [9:0] minor    = line_i.x_major ? y_i : u;
  wire signed [9:0] fraction = $signed({8'd0, line_i.fraction});
  wire signed [9:0] slope    = $signed({8'd0, line_i.slope});
  wire signed [9:0] cross_at = line_i.cross_flag ? 10'sd4 : 10'sd0;
  wire signed [9:0] d        = minor * 10'sd4 - fraction * 10'sd4 - slope * (major - cross_at);
  wire point_is_left = line_i.x_major == line_i.x_positive ? d > 10'sd0 : d < 10'sd0;
  assign holds_o = line_i.left != point_is_left;
endmodule

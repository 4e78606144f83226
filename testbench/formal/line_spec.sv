// What docs/unit.md says of lines, written from the definitions: a half plane by the sign of its line's
// equation, an angle as a number. For widths of a few bits.

// Tables 5 and 6: does the line's half plane hold the point?
module half_plane_spec #(
  parameter int unsigned PointBits = 2
) (
  input  shadow_pkg::line_t  line_i,
  input  logic [PointBits:0] x_i,
  input  logic [PointBits:0] y_i,
  output logic               holds_o
);
  localparam int unsigned F = shadow_pkg::FractionBits;
  localparam int unsigned S = shadow_pkg::SlopeBits;
  localparam int unsigned W = PointBits + S + 4;
  localparam logic signed [W-1:0] One = W'(1 << PointBits);
  wire signed [W-1:0] x        = $signed({{(W-PointBits-1){1'b0}}, x_i});
  wire signed [W-1:0] y        = $signed({{(W-PointBits-1){1'b0}}, y_i});
  wire signed [W-1:0] u        = line_i.x_positive ? x : One - x;
  wire signed [W-1:0] major    = line_i.x_major ? u : y;
  wire signed [W-1:0] minor    = line_i.x_major ? y : u;
  wire signed [W-1:0] fraction = $signed({{(W-F){1'b0}}, line_i.fraction});
  wire signed [W-1:0] slope    = $signed({{(W-S){1'b0}}, line_i.slope});
  wire signed [W-1:0] cross_at = line_i.cross_flag ? One : W'(0);
  // In units of 2^-(PointBits + S) texel.
  wire signed [W-1:0] d = (minor <<< S) - (fraction <<< (PointBits + S - F)) - slope * (major - cross_at);
  logic point_is_left;
  always_comb begin
    case ({line_i.x_major, line_i.x_positive})
      2'b11, 2'b00: point_is_left = d > W'(0);
      default:      point_is_left = d < W'(0);
    endcase
  end
  // A Left line has its inside on the right, which the line itself belongs to.
  assign holds_o = line_i.left != point_is_left;
endmodule

// 4.2.1 and Table 7, ordered by angle and as printed, with the vertex rule per line and per entry.
module combine_spec (
  input  logic              vertex_per_entry_i,
  input  logic              table7_printed_i,
  input  shadow_pkg::line_t a_i,
  input  shadow_pkg::line_t b_i,
  input  logic              vertex_i,
  output logic              and_o
);
  localparam int unsigned F = shadow_pkg::FractionBits;
  localparam int unsigned S = shadow_pkg::SlopeBits;
  localparam logic [F:0] One = (F + 1)'(1 << F);

  // Where each line takes its Fraction.
  wire [F:0] au = !a_i.x_major ? {1'b0, a_i.fraction} : a_i.cross_flag ? One : '0;
  wire [F:0] ax = a_i.x_positive ? au : One - au;
  wire [F:0] ay = a_i.x_major ? {1'b0, a_i.fraction} : a_i.cross_flag ? One : '0;
  wire [F:0] bu = !b_i.x_major ? {1'b0, b_i.fraction} : b_i.cross_flag ? One : '0;
  wire [F:0] bx = b_i.x_positive ? bu : One - bu;
  wire [F:0] by = b_i.x_major ? {1'b0, b_i.fraction} : b_i.cross_flag ? One : '0;
  logic a_has_b, b_has_a;
  half_plane_spec #(.PointBits(F)) a_plane (.line_i(a_i), .x_i(bx), .y_i(by), .holds_o(a_has_b));
  half_plane_spec #(.PointBits(F)) b_plane (.line_i(b_i), .x_i(ax), .y_i(ay), .holds_o(b_has_a));
  wire a_ends = a_i.start_here || a_i.end_here;
  wire b_ends = b_i.start_here || b_i.end_here;
  wire by_fractions = a_ends || b_ends ? a_has_b || b_has_a : a_has_b && b_has_a;

  // Ordered by angle: octants x+, y+, y-, x-; the slope grows with the angle in the first and third.
  localparam logic [S-1:0] Steepest = {S{1'b1}};
  logic [S+1:0] a_angle, b_angle;
  always_comb begin
    case ({a_i.x_major, a_i.x_positive})
      2'b11:   a_angle = {2'd0, a_i.slope};
      2'b01:   a_angle = {2'd1, Steepest - a_i.slope};
      2'b00:   a_angle = {2'd2, a_i.slope};
      default: a_angle = {2'd3, Steepest - a_i.slope};
    endcase
    case ({b_i.x_major, b_i.x_positive})
      2'b11:   b_angle = {2'd0, b_i.slope};
      2'b01:   b_angle = {2'd1, Steepest - b_i.slope};
      2'b00:   b_angle = {2'd2, b_i.slope};
      default: b_angle = {2'd3, Steepest - b_i.slope};
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
  assign and_o  = !meet ? by_fractions : table7_printed_i ? printed : by_angles;
endmodule

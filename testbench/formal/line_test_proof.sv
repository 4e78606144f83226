// The test of a line equals Tables 5 and 6 as docs/unit.md states them, products and all, for every
// line and every point of a 1/16 texel grid, at 3-bit fields.
//
// package: FractionBits=3 SlopeBits=3 PolygonBits=1
// broken: line_test.sv: `D'(above_is_left)` => `D'(1'b0)`
// broken: line_test.sv: `line_i.x_major == line_i.x_positive` => `line_i.x_positive`
// broken: line_test.sv: `{S{line_i.cross_flag}}` => `{S{1'b0}}`
// broken: line_test.sv: `line_i.x_major ? y_i : u` => `line_i.x_major ? u : y_i`
module line_test_proof #(
  parameter int unsigned PointBits = 4
) (
  input logic              clk_i,
  input shadow_pkg::line_t line_i,
  input logic [PointBits:0] x_i,
  input logic [PointBits:0] y_i
);
  localparam logic [PointBits:0] One = (PointBits + 1)'(1 << PointBits);
  logic holds_o;
  line_test #(.PointBits(PointBits)) dut (.nx_i(One - x_i), .*);

  // In units of 2^-7 texel: 4 bits of the point and 3 of the slope.
  wire signed [15:0] mx       = $signed({11'b0, x_i});
  wire signed [15:0] my       = $signed({11'b0, y_i});
  wire signed [15:0] u        = line_i.x_positive ? mx : 16'sd16 - mx;
  wire signed [15:0] major    = line_i.x_major ? u : my;
  wire signed [15:0] minor    = line_i.x_major ? my : u;
  wire signed [15:0] fraction = $signed({13'b0, line_i.fraction});
  wire signed [15:0] slope    = $signed({13'b0, line_i.slope});
  wire signed [15:0] cross_at = line_i.cross_flag ? 16'sd16 : 16'sd0;
  wire signed [15:0] d        = minor * 16'sd8 - fraction * 16'sd16 - slope * (major - cross_at);
  logic point_is_left;
  always_comb begin
    case ({line_i.x_major, line_i.x_positive})
      2'b11, 2'b00: point_is_left = d > 16'sd0;
      default:      point_is_left = d < 16'sd0;
    endcase
  end

  always_ff @(posedge clk_i) begin
    assume (x_i <= One && y_i <= One);
    // A Left line has its inside on the right, which the line itself belongs to.
    assert (holds_o == (line_i.left != point_is_left));
  end
endmodule

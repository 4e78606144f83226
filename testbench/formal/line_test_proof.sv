// The test of a line equals Tables 5 and 6 as docs/unit.md states them (line_spec.sv), products and all, for every
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

  logic spec_holds;
  half_plane_spec #(.PointBits(PointBits)) spec (.line_i, .x_i, .y_i, .holds_o(spec_holds));

  always_ff @(posedge clk_i) begin
    assume (x_i <= One && y_i <= One);
    assert (holds_o == spec_holds);
  end
endmodule

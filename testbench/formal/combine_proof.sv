// Two lines combine as docs/unit.md says (4.2.1 and Table 7, ordered by angle and as printed, with the vertex
// rule per line and per entry; line_spec.sv), the crossing points' products included: for every pair of lines
// at 2-bit fields.
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

  logic spec_and;
  combine_spec spec (.and_o(spec_and), .*);
  always_ff @(posedge clk_i) assert (and_o == spec_and);
endmodule

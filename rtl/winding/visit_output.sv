// Visit output: the front's output register. Whether a corner is counted is known a cycle after the rest of a visit.
//
// Timing:  a visit of cycle n stands at the output in n + 1. `free_o` does not know of what is dropped: that is late.
module visit_output #(
  localparam int unsigned B = shadow_pkg::BaseBits
) (
  input  logic               clk_i,
  input  logic               rst_ni,
  input  logic               clear_i,
  input  logic               valid_i,
  output logic               free_o,       // takes a visit
  input  shadow_pkg::visit_t visit_i,
  input  logic               upper_i,      // the upper bases alone: a word's first pair has waited here
  input  logic               passes_i,     // of an edge that is not walked: visits only where it has a corner to count
  input  logic               covers_i,     // the triangle covers the texel's corner
  input  logic               visited_i,    // of the visit at the output: its corner was counted before
  output logic               held_o,       // something is at the output, dropped or not
  output logic               valid_o,
  input  logic               ready_i,
  output shadow_pkg::visit_t visit_o
);
  logic               valid_q, passes_q, covers_q, dropped;
  shadow_pkg::visit_t visit_q;
  assign dropped = passes_q && !(covers_q && !visited_i);
  assign valid_o = valid_q && !dropped;
  assign held_o  = valid_q;
  assign free_o  = !valid_q || ready_i;
  always_comb begin
    visit_o        = visit_q;
    visit_o.corner = covers_q && !visited_i;
  end
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) valid_q <= 1'b0;
    else if (clear_i) valid_q <= 1'b0;
    else if (free_o) valid_q <= valid_i;
    else if (dropped) valid_q <= 1'b0;
  end
  logic [2*B-1:0] lower;
  assign lower = {visit_q.base1, visit_q.base0};
  always_ff @(posedge clk_i) begin
    if (free_o) begin
      visit_q <= visit_i;
      if (upper_i) {visit_q.base1, visit_q.base0} <= lower;
      passes_q <= passes_i;
      covers_q <= covers_i;
    end
  end
endmodule

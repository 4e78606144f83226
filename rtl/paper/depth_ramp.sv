// Depth ramp: an edge's depth at its next border along one axis.
//
// Twin:    EdgeSetup::major_depth and minor_depth in model/unit/edge_setup.h.
// Timing:  load or advance in cycle n, the new depth in n + 1.
module depth_ramp #(
  localparam int unsigned W = shadow_pkg::DepthBits + 1,
  localparam int unsigned C = shadow_pkg::CoordBits
) (
  input  logic         clk_i,
  input  logic         load_i,
  input  logic [W-1:0] whole_i,       // at the first border; wraps where no border is crossed
  input  logic [C-1:0] rest_i,
  input  logic [W-1:0] step_whole_i,  // taken with the load, as the next
  input  logic [C-1:0] step_rest_i,
  input  logic [C-1:0] base_i,        // constant until the next load
  input  logic         advance_i,
  output logic [W-1:0] whole_o
);
  logic [W-1:0] whole_q, step_whole_q, whole_next;
  logic [C-1:0] rest_q, step_rest_q, rest_next;
  exact_step #(.WholeBits(W), .RestBits(C)) step (
    .whole_i(whole_q), .rest_i(rest_q), .step_whole_i(step_whole_q), .step_rest_i(step_rest_q), .base_i,
    .whole_o(whole_next), .rest_o(rest_next));
  always_ff @(posedge clk_i) begin
    if (load_i) begin
      whole_q      <= whole_i;
      rest_q       <= rest_i;
      step_whole_q <= step_whole_i;
      step_rest_q  <= step_rest_i;
    end else if (advance_i) begin
      whole_q <= whole_next;
      rest_q  <= rest_next;
    end
  end
  assign whole_o = whole_q;
endmodule

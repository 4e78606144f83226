// Two requesters of one port; the first goes first, but what is offered stays until it is taken.
//
// Timing: combinational; no cycle is lost.
module port_merge #(
  parameter int unsigned Width = 8
) (
  input  logic             clk_i,
  input  logic             rst_ni,
  input  logic             clear_i,  // forgets what was offered
  input  logic             valid0_i,
  output logic             ready0_o,
  input  logic [Width-1:0] data0_i,
  input  logic             valid1_i,
  output logic             ready1_o,
  input  logic [Width-1:0] data1_i,
  output logic             valid_o,
  input  logic             ready_i,
  output logic [Width-1:0] data_o
);
  logic offered_q;  // requester 1 was, and not taken
  logic second;

  assign second   = offered_q || !valid0_i;
  assign valid_o  = second ? valid1_i : valid0_i;
  assign data_o   = second ? data1_i : data0_i;
  assign ready0_o = ready_i && !second;
  assign ready1_o = ready_i && second;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) offered_q <= 1'b0;
    else offered_q <= !clear_i && second && valid1_i && !ready_i;
  end
endmodule

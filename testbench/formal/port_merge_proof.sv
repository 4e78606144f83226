// What is offered at the one port stays until it is taken; each requester's words go through once, in
// order and unchanged; one that waits is served as soon as the port takes what is before it: with
// requester 0 silent for a cycle, requester 1 is next.
//
// profile: winding
// broken: port_merge.sv: `offered_q || !valid0_i` => `!valid0_i`
// broken: port_merge.sv: `assign ready1_o = ready_i && second;` => `assign ready1_o = ready_i;`
// broken: port_merge.sv: `second ? data1_i : data0_i` => `valid0_i ? data0_i : data1_i`
module port_merge_proof #(
  parameter int unsigned Width = 2
) (
  input logic             clk_i,
  input logic             clear_i,
  input logic             valid0_i,
  input logic             valid1_i,
  input logic             ready_i,
  input logic [Width-1:0] data0_i,
  input logic [Width-1:0] data1_i
);
  logic running_q = 1'b0;
  always_ff @(posedge clk_i) running_q <= 1'b1;

  logic             ready0_o, ready1_o, valid_o;
  logic [Width-1:0] data_o;
  port_merge #(.Width(Width)) dut (.rst_ni(running_q), .*);

  logic             held_q = 1'b0, held0_q = 1'b0, held1_q = 1'b0;
  logic [Width-1:0] data_q, data0_q, data1_q;
  always_ff @(posedge clk_i) begin
    if (running_q) begin
      // The requesters keep the rule, but for a clear.
      if (held0_q) assume (valid0_i && data0_i == data0_q);
      if (held1_q) assume (valid1_i && data1_i == data1_q);
      if (held_q) assert (valid_o && data_o == data_q);
      assert (!(valid0_i && ready0_o && valid1_i && ready1_o));
      assert ((valid_o && ready_i) == ((valid0_i && ready0_o) || (valid1_i && ready1_o)));
      if (valid0_i && ready0_o) assert (data_o == data0_i);
      if (valid1_i && ready1_o) assert (data_o == data1_i);
      assert (valid_o || !(valid0_i || valid1_i));
      held_q  <= valid_o && !ready_i && !clear_i;
      held0_q <= valid0_i && !ready0_o && !clear_i;
      held1_q <= valid1_i && !ready1_o && !clear_i;
      data_q  <= data_o;
      data0_q <= data0_i;
      data1_q <= data1_i;
    end
  end
endmodule

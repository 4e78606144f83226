// A request that is offered outside stays until it is taken, also while the guard closes; no request
// gets through twice or is swallowed; and closing ends once every offer was taken.
//
// broken: abort_guard.sv: `(closed_q | ~valid_i | ready_i)` => `(closed_q | ~valid_i | {Channels{1'b1}})`
// broken: abort_guard.sv: `assign ready_o  = ready_i & ~closed_q;` => `assign ready_o  = ready_i;`
// broken: abort_guard.sv: `(closed_q | ~valid_i | ready_i)` => `(closed_q | ready_i)`
module abort_guard_proof #(
  parameter int unsigned Channels = 2
) (
  input logic                clk_i,
  input logic                close_i,
  input logic [Channels-1:0] valid_i,
  input logic [Channels-1:0] ready_i
);
  logic running_q = 1'b0;
  always_ff @(posedge clk_i) running_q <= 1'b1;

  logic [Channels-1:0] ready_o, valid_o;
  logic                closed_o;
  abort_guard #(.Channels(Channels)) dut (.rst_ni(running_q), .*);

  logic [Channels-1:0] inner_held_q = '0, outer_held_q = '0;
  logic                closing_q = 1'b0, all_quiet_q = 1'b0;
  always_ff @(posedge clk_i) begin
    if (running_q) begin
      assume ((inner_held_q & ~valid_i) == '0);         // inside keeps the rule
      assume (!closing_q || close_i || closed_o);       // who closes waits
      assert ((outer_held_q & ~valid_o) == '0);         // so does outside
      assert ((valid_o & ready_i) == (valid_i & ready_o));
      assert (!all_quiet_q || closed_o || !close_i);
      assert (!closed_o || valid_o == '0);
      inner_held_q <= valid_i & ~ready_o;
      outer_held_q <= valid_o & ~ready_i;
      closing_q    <= close_i;
      all_quiet_q  <= close_i && (valid_o & ~ready_i) == '0;
    end
  end
endmodule

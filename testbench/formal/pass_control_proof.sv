// From reset on, whatever the blocks say: a pass runs from its start until exactly its counted items have
// entered and its blocks are at rest, ends once, and ends in the cycle that allows it; an abort lets nothing
// enter after the channels closed, clears until nothing is due and ends too; idle means ready for a start.
// Cycles count the cycles that the pass ran.
//
// broken: pass_control.sv: `Run:   if (abort_i) state_d = Close; else if (finished) state_d = Idle;` => `Run:   if (finished) state_d = Idle; else if (abort_i) state_d = Close;`
// broken: pass_control.sv: `Clear: if (!outstanding_i) state_d = Idle;` => `Clear: state_d = Idle;`
// broken: pass_control.sv: `finished = !waits_o && front_idle_i && store_idle_i;` => `finished = !waits_o && store_idle_i;`
// broken: pass_control.sv: `left_q   <= left_q - 32'(items_q);` => `left_q   <= left_q - 32'(items_q != 3'd0);`
// broken: pass_control.sv: `Close: if (closed_i) state_d = Clear;` => `Close: state_d = Clear;`
// broken: pass_control.sv: `(state_q == Run || state_q == Close) && waits_o` => `state_q != Idle && waits_o`
module pass_control_proof (
  input logic        clk_i,
  input logic        start_i,
  input logic [2:0]  pass_i,
  input logic [1:0]  small_count_i,
  input logic        abort_i,
  input logic [2:0]  offered_i,
  input logic        front_idle_i, store_idle_i, wiped_i, settled_i, lanes_idle_i, closed_i, outstanding_i
);
  logic running_q = 1'b0;
  always_ff @(posedge clk_i) running_q <= 1'b1;

  logic [2:0]  pass_o;
  logic        pass2_o, busy_o, open_o, waits_o, close_o, clear_o, clear_lanes_o, done_o;
  logic [31:0] cycles_o;
  wire [31:0]  count_i = {30'd0, small_count_i};
  wire [2:0]   items_i = open_o ? offered_i : 3'd0;
  pass_control dut (.rst_ni(running_q), .*);

  // The specification's own state.
  logic       busy_q = 1'b0, aborted_q = 1'b0, cleared_q = 1'b0;
  logic [2:0] kind_q;
  logic [1:0] left_q;
  logic [3:0] ran_q;  // modulo 16
  wire takes = kind_q == shadow_pkg::PassAnnounce || kind_q == shadow_pkg::PassDraw ||
               kind_q == shadow_pkg::PassDecide;
  logic at_rest;
  always_comb begin
    case (kind_q)
      shadow_pkg::PassWipe:   at_rest = wiped_i;
      shadow_pkg::PassSettle: at_rest = settled_i;
      shadow_pkg::PassDraw:   at_rest = store_idle_i && front_idle_i;
      shadow_pkg::PassAnnounce: at_rest = store_idle_i;
      shadow_pkg::PassDecide: at_rest = lanes_idle_i;
      default:                at_rest = 1'b1;
    endcase
  end
  wire enters = takes && left_q != 2'd0;
  wire ends   = busy_q && (aborted_q ? cleared_q && !outstanding_i : !abort_i && !enters && at_rest);

  always_ff @(posedge clk_i) begin
    if (running_q) begin
      assume (!start_i || !busy_o);
      assume (offered_i <= {1'b0, left_q});
      assert (busy_o == busy_q);
      assert (done_o == ends);
      assert (pass_o == (busy_q && !cleared_q ? kind_q : shadow_pkg::PassIdle));
      assert (!busy_q || waits_o == enters);
      assert (open_o == (busy_q && enters && !cleared_q));
      assert (close_o == (busy_q && aborted_q));
      assert (clear_o == (busy_q && cleared_q));
      assert (clear_lanes_o == (clear_o || start_i));
      assert (!busy_q || pass2_o == (kind_q == shadow_pkg::PassDecide));
      if (busy_q) assert (cycles_o[3:0] == ran_q);

      if (busy_q && !aborted_q) begin
        left_q <= left_q - items_i[1:0];
        ran_q  <= ran_q + 4'd1;
      end
      if (busy_q && !aborted_q && abort_i) aborted_q <= 1'b1;
      if (busy_q && aborted_q && closed_i) cleared_q <= 1'b1;
      if (ends) busy_q <= 1'b0;
      if (start_i) begin
        busy_q    <= 1'b1;
        aborted_q <= 1'b0;
        cleared_q <= 1'b0;
        kind_q    <= pass_i;
        left_q    <= pass_i == shadow_pkg::PassAnnounce || pass_i == shadow_pkg::PassDraw ||
                     pass_i == shadow_pkg::PassDecide ? small_count_i : 2'd0;
        ran_q     <= 4'd0;
      end
    end
  end
endmodule

// Of any slot that is given out: its verdict leaves once, behind exactly those of the slots given out
// before, and is the one of the first stage that called it final; nothing else ever leaves; and a
// verdict whose turn it is does not wait. The stages are held to their contract alone.
//
// broken: lane_slots.sv: `if (take_i) done_d[slot_o] = 1'b0;` => `if (take_i && !fetch) done_d[slot_o] = 1'b0;`
// broken: lane_slots.sv: `(!out_valid_q || verdict_ready_i);` => `1'b1;`
// broken: lane_slots.sv: `known[Width] ? known[Width-1:0] : early` => `early`
// broken: lane_slots.sv: `assign oldest_done_o = head_q != tail_q && done_q[oldest_o];` => `assign oldest_done_o = done_q[oldest_o];`
module lane_slots_proof #(
  parameter int unsigned Slots = 4,
  parameter int unsigned Width = 1
) (
  input logic             clk_i,
  input logic             clear_i,
  input logic             want_i,
  input logic             known_i, known_final_i, early_i, early_final_i, late_i,
  input logic [1:0]       known_slot_i, early_slot_i, late_slot_i,
  input logic [Width-1:0] known_verdict_i, early_verdict_i, late_verdict_i,
  input logic             verdict_ready_i,
  input logic             pick_i
);
  logic running_q = 1'b0;
  always_ff @(posedge clk_i) running_q <= 1'b1;

  logic             free_o, verdict_valid_o, oldest_done_o, idle_o;
  logic [1:0]       slot_o, oldest_o;
  logic [Width-1:0] verdict_o;
  wire take_i = want_i && free_o;
  lane_slots #(.Slots(Slots), .Width(Width)) dut (.rst_ni(running_q), .*);

  // What the stages may do: a slot is with none (0), with stage 0, 1 or 2 (1, 2, 3), or decided (4).
  logic [2:0] with0_q = '0, with1_q = '0, with2_q = '0, with3_q = '0;
  function automatic logic [2:0] next(input logic [1:0] slot, input logic [2:0] now);
    next = now;
    if (known_i && known_slot_i == slot) next = known_final_i ? 3'd4 : 3'd2;
    if (early_i && early_slot_i == slot) next = early_final_i ? 3'd4 : 3'd3;
    if (late_i && late_slot_i == slot) next = 3'd4;
    if (take_i && slot_o == slot) next = 3'd1;
    if (clear_i) next = 3'd0;
  endfunction
  function automatic logic [2:0] at(input logic [1:0] slot);
    at = slot == 2'd0 ? with0_q : slot == 2'd1 ? with1_q : slot == 2'd2 ? with2_q : with3_q;
  endfunction
  always_ff @(posedge clk_i) begin
    if (running_q) begin
      assume (!known_i || at(known_slot_i) == 3'd1);
      assume (!early_i || at(early_slot_i) == 3'd2 || at(early_slot_i) == 3'd3);
      assume (!late_i || at(late_slot_i) == 3'd3);
      assume (!(early_i && late_i && early_slot_i == late_slot_i));
      with0_q <= next(2'd0, with0_q);
      with1_q <= next(2'd1, with1_q);
      with2_q <= next(2'd2, with2_q);
      with3_q <= next(2'd3, with3_q);
    end
  end

  logic [2:0]       inside_q = '0, ahead_q = '0;
  logic             followed_q = 1'b0, decided_q = 1'b0, held_q = 1'b0;
  logic [1:0]       slot_q;
  logic [Width-1:0] verdict_q, held_verdict_q;
  logic [1:0]       waited_q = '0;
  wire pop = verdict_valid_o && verdict_ready_i;
  wire decide_known = known_i && known_final_i && known_slot_i == slot_q;
  wire decide_early = early_i && early_final_i && early_slot_i == slot_q;
  wire decide_late  = late_i && late_slot_i == slot_q;

  always_ff @(posedge clk_i) begin
    if (running_q) begin
      assert (idle_o == (inside_q == '0));
      assert (free_o || inside_q >= 3'(Slots));
      assert (!verdict_valid_o || inside_q != '0);
      assert (waited_q != 2'd2);
      if (held_q) assert (verdict_valid_o && verdict_o == held_verdict_q);
      if (followed_q && ahead_q == '0 && verdict_valid_o) assert (decided_q && verdict_o == verdict_q);

      held_q         <= verdict_valid_o && !verdict_ready_i;
      held_verdict_q <= verdict_o;
      inside_q       <= inside_q + 3'(take_i) - 3'(pop);
      // The oldest one is followed and decided, and yet nothing is offered.
      waited_q <= followed_q && decided_q && ahead_q == '0 && !verdict_valid_o ? waited_q + 2'd1 : '0;
      if (take_i && pick_i && !followed_q) begin
        followed_q <= 1'b1;
        decided_q  <= 1'b0;
        slot_q     <= slot_o;
        ahead_q    <= inside_q - 3'(pop);
      end else if (followed_q) begin
        if (!decided_q && (decide_known || decide_early || decide_late)) begin
          decided_q <= 1'b1;
          verdict_q <= decide_known ? known_verdict_i : decide_early ? early_verdict_i : late_verdict_i;
        end
        if (pop) begin
          followed_q <= ahead_q != '0;
          ahead_q    <= ahead_q - 3'd1;
        end
      end
      if (clear_i) begin
        inside_q   <= '0;
        followed_q <= 1'b0;
        waited_q   <= '0;
        held_q     <= 1'b0;
      end
    end
  end
endmodule

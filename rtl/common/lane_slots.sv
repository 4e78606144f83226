// Slots of the fragments that a lane has in flight: given out in a circle, decided in any order,
// retired in the order in which they were given out.
//
// Three stages may decide: the one that knows a verdict without memory, the one that sees a texel
// word (or a tile), the one that sees an SLB record. A slot passes them in that order. The first two
// write `final_i` each time they see a slot, so that it is known later whose verdict holds; a slot
// that neither called final is the last stage's. Each stage writes memories of its own, so that all
// three may do so in one cycle.
// Timing: a slot that is decided in cycle n leaves in n + 2 at the earliest, one a cycle.
`include "check.svh"
module lane_slots #(
  parameter int unsigned Slots = 64,  // a power of two, 4 or more
  parameter int unsigned Most  = Slots,  // taken at once
  parameter int unsigned Width = 4,   // of a verdict
  localparam int unsigned SlotBits = $clog2(Slots)
) (
  input  logic                clk_i,
  input  logic                rst_ni,
  input  logic                clear_i,  // drops every slot
  // a slot for the next fragment
  output logic                free_o,   // slot_o may be taken
  input  logic                take_i,   // it is; only where free_o
  output logic [SlotBits-1:0] slot_o,
  // stage 0: once for every slot, before any other stage sees it
  input  logic                known_i,
  input  logic [SlotBits-1:0] known_slot_i,
  input  logic                known_final_i,    // the verdict holds
  input  logic [Width-1:0]    known_verdict_i,
  // stage 1: any number of times
  input  logic                early_i,
  input  logic [SlotBits-1:0] early_slot_i,
  input  logic                early_final_i,
  input  logic [Width-1:0]    early_verdict_i,
  // stage 2: only final verdicts
  input  logic                late_i,
  input  logic [SlotBits-1:0] late_slot_i,
  input  logic [Width-1:0]    late_verdict_i,
  // verdicts, in the order of the slots
  output logic                verdict_valid_o,
  input  logic                verdict_ready_i,
  output logic [Width-1:0]    verdict_o,
  // for counters
  output logic [SlotBits-1:0] oldest_o,       // slot that leaves next
  output logic                oldest_done_o,  // it is decided
  output logic                idle_o          // no slot is taken, no verdict is due
);
  logic [SlotBits:0] head_q, tail_q;  // oldest, next to give out; one bit more tells full from none
  logic [Slots-1:0]  done_d, done_q;  // means something for taken slots alone
  logic              out_valid_q;
  logic              fetch;
  logic [Width:0]    known, early;    // {final, verdict}
  logic [Width-1:0]  late;

  assign slot_o        = tail_q[SlotBits-1:0];
  assign oldest_o      = head_q[SlotBits-1:0];
  assign free_o        = (tail_q - head_q) != (SlotBits + 1)'(Most);
  assign oldest_done_o = head_q != tail_q && done_q[oldest_o];
  assign idle_o        = head_q == tail_q && !out_valid_q;

  always_comb begin
    done_d = done_q;
    if (take_i) done_d[slot_o] = 1'b0;
    if (known_i && known_final_i) done_d[known_slot_i] = 1'b1;
    if (early_i && early_final_i) done_d[early_slot_i] = 1'b1;
    if (late_i) done_d[late_slot_i] = 1'b1;
  end

  ram_1r1w #(.Width(Width + 1), .Depth(Slots)) known_ram (
    .clk_i, .write_i(known_i), .write_addr_i(known_slot_i),
    .write_data_i({known_final_i, known_verdict_i}),
    .read_i(fetch), .read_addr_i(oldest_o), .read_data_o(known)
  );
  ram_1r1w #(.Width(Width + 1), .Depth(Slots)) early_ram (
    .clk_i, .write_i(early_i), .write_addr_i(early_slot_i),
    .write_data_i({early_final_i, early_verdict_i}),
    .read_i(fetch), .read_addr_i(oldest_o), .read_data_o(early)
  );
  ram_1r1w #(.Width(Width), .Depth(Slots)) late_ram (
    .clk_i, .write_i(late_i), .write_addr_i(late_slot_i), .write_data_i(late_verdict_i),
    .read_i(fetch), .read_addr_i(oldest_o), .read_data_o(late)
  );

  // A slot is free again once its verdict is being read: the memories' outputs hold it until it
  // leaves.
  assign fetch           = oldest_done_o && (!out_valid_q || verdict_ready_i);
  assign verdict_valid_o = out_valid_q;
  assign verdict_o       = known[Width] ? known[Width-1:0] : early[Width] ? early[Width-1:0] : late;

  always_ff @(posedge clk_i) done_q <= done_d;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      head_q      <= '0;
      tail_q      <= '0;
      out_valid_q <= 1'b0;
    end else if (clear_i) begin
      head_q      <= '0;
      tail_q      <= '0;
      out_valid_q <= 1'b0;
    end else begin
      if (take_i) tail_q <= tail_q + 1'b1;
      if (fetch) head_q <= head_q + 1'b1;
      out_valid_q <= fetch || (out_valid_q && !verdict_ready_i);
      `CHECK(takes_only_free_slots, !take_i || free_o)
      `CHECK(decides_once_known, !(known_i && known_final_i) || !done_q[known_slot_i])
      `CHECK(decides_once_early, !(early_i && early_final_i) || !done_q[early_slot_i])
      `CHECK(decides_once_late, !late_i || !done_q[late_slot_i])
    end
  end
endmodule

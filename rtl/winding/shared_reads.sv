// Words for a stream of fragments, in order: one is read only if its address is not that of the word before,
// so neighbours share a read. Many reads are under way at once; their responses come in any order.
//
// Timing:  a fragment whose word is there leaves three cycles after it came at the earliest, one a cycle.
//          The word is in a memory's output, which holds it until a fragment with another one moves up.
// Data:    what the fragment needs beside stands in memories that its slot addresses: they are to be read
//          at `next_slot_o` in a cycle of `next_o`, for the cycle in which the fragment is at the output.
`include "check.svh"
module shared_reads #(
  parameter int unsigned Width     = 8,   // of what is kept of a word
  parameter int unsigned AddrBits  = 8,
  parameter int unsigned Words     = 32,  // under way, a power of two
  parameter int unsigned Slots     = 64,  // fragments inside are no more
  parameter int unsigned SideBits  = 4,   // of what goes with a fragment
  localparam int unsigned IndexBits = $clog2(Words),
  localparam int unsigned SlotBits = $clog2(Slots)
) (
  input  logic                 clk_i,
  input  logic                 rst_ni,
  input  logic                 clear_i,
  // fragments
  input  logic                 valid_i,
  output logic                 ready_o,
  input  logic                 needs_i,   // a word
  input  logic [AddrBits-1:0]  addr_i,
  input  logic [SlotBits-1:0]  slot_i,
  input  logic [SideBits-1:0]  side_i,
  // the same ones, with their words
  output logic                 next_o,
  output logic [SlotBits-1:0]  next_slot_o,
  output logic                 valid_o,
  input  logic                 ready_i,
  output logic [SlotBits-1:0]  slot_o,
  output logic [SideBits-1:0]  side_o,
  output logic [Width-1:0]     data_o,    // of the last fragment that needed a word
  // memory
  output logic                 rd_valid_o,
  input  logic                 rd_ready_i,
  output logic [AddrBits-1:0]  rd_addr_o,
  output logic [IndexBits-1:0] rd_tag_o,
  input  logic                 rsp_valid_i,
  input  logic [IndexBits-1:0] rsp_tag_i,
  input  logic [Width-1:0]     rsp_data_i
);
  // The last word asked for, and the reads from the oldest one whose word no fragment has taken up yet.
  logic                last_valid_q, rd_valid_q, fresh, push, go;
  logic [AddrBits-1:0] last_q;
  logic [IndexBits:0]  head_q, tail_q;
  logic [Words-1:0]    here_d, here_q;  // its response came
  logic                queued, queue_ready, queued_fresh, out_valid_q;
  logic [SlotBits-1:0] queued_slot, slot_q;
  logic [SideBits-1:0] queued_side, side_q;

  assign fresh   = needs_i && !(last_valid_q && last_q == addr_i);
  // The address of the word under way to the port is the last one.
  assign ready_o = (!rd_valid_q || rd_ready_i) && (tail_q - head_q) != (IndexBits + 1)'(Words);
  assign push    = valid_i && ready_o;

  /* verilator lint_off PINCONNECTEMPTY */  // that it is empty is nobody's business here
  fifo #(.Width(1 + SlotBits + SideBits), .Depth(Slots)) queue (
    .clk_i, .rst_ni, .clear_i, .valid_i(push), .ready_o(queue_ready), .data_i({fresh, slot_i, side_i}),
    .valid_o(queued), .ready_i(go), .data_o({queued_fresh, queued_slot, queued_side}),
    .empty_o()
  );
  /* verilator lint_on PINCONNECTEMPTY */
  ram_1r1w #(.Width(Width), .Depth(Words)) word_ram (
    .clk_i, .write_i(rsp_valid_i), .write_addr_i(rsp_tag_i), .write_data_i(rsp_data_i),
    .read_i(go && queued_fresh), .read_addr_i(head_q[IndexBits-1:0]), .read_data_o(data_o)
  );

  assign go = queued && (!queued_fresh || here_q[head_q[IndexBits-1:0]]) && (!out_valid_q || ready_i);
  assign next_o      = go;
  assign next_slot_o = queued_slot;
  assign valid_o     = out_valid_q;
  assign slot_o      = slot_q;
  assign side_o      = side_q;
  assign rd_valid_o  = rd_valid_q;
  assign rd_addr_o   = last_q;
  assign rd_tag_o    = tail_q[IndexBits-1:0] - 1'b1;

  always_comb begin
    here_d = here_q;
    if (push && fresh) here_d[tail_q[IndexBits-1:0]] = 1'b0;
    if (rsp_valid_i) here_d[rsp_tag_i] = 1'b1;
  end

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      last_valid_q <= 1'b0;
      rd_valid_q   <= 1'b0;
      head_q       <= '0;
      tail_q       <= '0;
      out_valid_q  <= 1'b0;
    end else if (clear_i) begin
      last_valid_q <= 1'b0;
      rd_valid_q   <= 1'b0;
      head_q       <= '0;
      tail_q       <= '0;
      out_valid_q  <= 1'b0;
    end else begin
      last_valid_q <= last_valid_q || (push && needs_i);
      rd_valid_q   <= (push && fresh) || (rd_valid_q && !rd_ready_i);
      if (push && fresh) tail_q <= tail_q + 1'b1;
      if (go && queued_fresh) head_q <= head_q + 1'b1;
      out_valid_q  <= go || (out_valid_q && !ready_i);
      `CHECK(room_for_every_slot, !valid_i || queue_ready)
    end
  end
  always_ff @(posedge clk_i) begin
    here_q <= here_d;
    if (push && fresh) last_q <= addr_i;
    if (go) begin
      slot_q <= queued_slot;
      side_q <= queued_side;
    end
  end
endmodule

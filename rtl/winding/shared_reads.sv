// Words for a stream of fragments, in order, through a small cache: neighbours share a read, and fragments of
// the next row of the image find what the last row read. Many reads are under way at once; their responses
// come in any order.
//
// Whether a word is in the cache is decided in order when a fragment comes, and words enter the cache in order
// when fragments take them up: so a fragment finds there what it was told, however many reads lie between.
// Timing:  a fragment whose word is there leaves four cycles after it came at the earliest, one a cycle.
//          The word is in a memory's output, which holds it until a fragment with another one moves up.
// Data:    what the fragment needs beside stands in memories that its slot addresses: they are to be read
//          at `next_slot_o` in a cycle of `next_o`, for the cycle in which the fragment is at the output.
`include "check.svh"
module shared_reads #(
  parameter int unsigned Width     = 8,   // of what is kept of a word
  parameter int unsigned AddrBits  = 16,  // at least twice LineBits
  parameter int unsigned Words     = 32,  // under way, a power of two
  parameter int unsigned Lines     = 64,  // of the cache, a power of two
  parameter int unsigned Slots     = 64,  // fragments inside are no more
  parameter int unsigned SideBits  = 4,   // of what goes with a fragment
  localparam int unsigned IndexBits = $clog2(Words),
  localparam int unsigned LineBits = $clog2(Lines),
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
  input  logic [Width-1:0]     rsp_data_i,
  // why the oldest fragment waits here, if it does
  output logic                 empty_o,   // none inside, but perhaps at the output
  output logic                 waits_port_o,
  output logic                 waits_memory_o
);
  // ---- Look-up: is the word the last one, in the cache, or to be read? -----------------------------
  function automatic logic [LineBits-1:0] line_of(input logic [AddrBits-1:0] addr);
    for (int unsigned i = 0; i < LineBits; i++) line_of[i] = addr[i] ^ addr[2*LineBits-1-i];
  endfunction
  logic                look_valid_q, needs_q, last_valid_q, same, cached, fresh, push;
  logic [AddrBits-1:0] addr_q, last_q, known;
  logic [SlotBits-1:0] look_slot_q;
  logic [SideBits-1:0] look_side_q;
  logic [LineBits-1:0] line;
  logic [Lines-1:0]    valid_d, valid_q;

  // The reads from the oldest one whose word no fragment has taken up yet.
  logic                rd_valid_q;
  logic [AddrBits-1:0] rd_addr_q;
  logic [IndexBits:0]  head_q, tail_q;
  logic [Words-1:0]    here_d, here_q;  // its response came

  ram_1r1w #(.Width(AddrBits), .Depth(Lines)) addresses (
    .clk_i, .write_i(push && fresh), .write_addr_i(line), .write_data_i(addr_q),
    .read_i(valid_i && ready_o), .read_addr_i(line_of(addr_i)), .read_data_o(known)
  );
  // The last one's address is not readable yet; where it displaced this one's, the words differ.
  assign line    = line_of(addr_q);
  assign same    = last_valid_q && last_q == addr_q;
  assign cached  = valid_q[line] && known == addr_q && !(last_valid_q && line_of(last_q) == line);
  assign fresh   = needs_q && !same && !cached;
  assign push    = look_valid_q && (!fresh || ((!rd_valid_q || rd_ready_i) &&
                                               (tail_q - head_q) != (IndexBits + 1)'(Words)));
  assign ready_o = !look_valid_q || push;

  // ---- Queue of fragments -----------------------------------------------------------------------
  logic                queued, queue_ready, queue_empty, queued_fresh, queued_cached, go, out_valid_q;
  logic [LineBits-1:0] queued_line;
  logic [SlotBits-1:0] queued_slot, slot_q;
  logic [SideBits-1:0] queued_side, side_q;
  fifo #(.Width(2 + LineBits + SlotBits + SideBits), .Depth(Slots)) queue (
    .clk_i, .rst_ni, .clear_i, .valid_i(push), .ready_o(queue_ready),
    .data_i({fresh, needs_q && !same && cached, line, look_slot_q, look_side_q}),
    .valid_o(queued), .ready_i(go),
    .data_o({queued_fresh, queued_cached, queued_line, queued_slot, queued_side}), .empty_o(queue_empty)
  );

  // ---- Words: as they came, and in the cache once they are taken up -------------------------------
  logic                fill_q, from_cache_q;
  logic [LineBits-1:0] fill_line_q;
  logic [Width-1:0]    word, cached_word;
  ram_1r1w #(.Width(Width), .Depth(Words)) word_ram (
    .clk_i, .write_i(rsp_valid_i), .write_addr_i(rsp_tag_i), .write_data_i(rsp_data_i),
    .read_i(go && queued_fresh), .read_addr_i(head_q[IndexBits-1:0]), .read_data_o(word)
  );
  ram_1r1w #(.Width(Width), .Depth(Lines)) cache_ram (
    .clk_i, .write_i(fill_q), .write_addr_i(fill_line_q), .write_data_i(word),
    .read_i(go && queued_cached), .read_addr_i(queued_line), .read_data_o(cached_word)
  );

  assign go = queued && (!queued_fresh || here_q[head_q[IndexBits-1:0]]) && (!out_valid_q || ready_i);
  assign next_o      = go;
  assign next_slot_o = queued_slot;
  assign valid_o     = out_valid_q;
  assign slot_o      = slot_q;
  assign side_o      = side_q;
  assign data_o      = from_cache_q ? cached_word : word;
  assign rd_valid_o  = rd_valid_q;
  assign rd_addr_o   = rd_addr_q;
  assign rd_tag_o    = tail_q[IndexBits-1:0] - 1'b1;

  logic missing, at_port;
  assign empty_o        = queue_empty && !look_valid_q;
  assign missing        = queued && queued_fresh && !here_q[head_q[IndexBits-1:0]];
  assign at_port        = rd_valid_q && tail_q - head_q == (IndexBits + 1)'(1);
  assign waits_port_o   = missing && at_port;
  assign waits_memory_o = missing && !at_port;

  always_comb begin
    here_d  = here_q;
    valid_d = valid_q;
    if (push && fresh) begin
      here_d[tail_q[IndexBits-1:0]] = 1'b0;
      valid_d[line] = 1'b1;
    end
    if (rsp_valid_i) here_d[rsp_tag_i] = 1'b1;
    if (clear_i) valid_d = '0;
  end

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      look_valid_q <= 1'b0;
      last_valid_q <= 1'b0;
      rd_valid_q   <= 1'b0;
      head_q       <= '0;
      tail_q       <= '0;
      out_valid_q  <= 1'b0;
      fill_q       <= 1'b0;
    end else if (clear_i) begin
      look_valid_q <= 1'b0;
      last_valid_q <= 1'b0;
      rd_valid_q   <= 1'b0;
      head_q       <= '0;
      tail_q       <= '0;
      out_valid_q  <= 1'b0;
      fill_q       <= 1'b0;
    end else begin
      look_valid_q <= valid_i || (look_valid_q && !push);
      last_valid_q <= last_valid_q || (push && needs_q);
      rd_valid_q   <= (push && fresh) || (rd_valid_q && !rd_ready_i);
      if (push && fresh) tail_q <= tail_q + 1'b1;
      if (go && queued_fresh) head_q <= head_q + 1'b1;
      out_valid_q  <= go || (out_valid_q && !ready_i);
      fill_q       <= go && queued_fresh;
      `CHECK(room_for_every_slot, !push || queue_ready)
    end
  end
  // Lines mean something after a clear, which every pass begins with.
  always_ff @(posedge clk_i) valid_q <= valid_d;
  always_ff @(posedge clk_i) begin
    here_q <= here_d;
    if (valid_i && ready_o) begin
      needs_q     <= needs_i;
      addr_q      <= addr_i;
      look_slot_q <= slot_i;
      look_side_q <= side_i;
    end
    if (push && needs_q) last_q <= addr_q;
    if (push && fresh) rd_addr_q <= addr_q;
    if (go) begin
      slot_q      <= queued_slot;
      side_q      <= queued_side;
      fill_line_q <= queued_line;
      if (queued_fresh || queued_cached) from_cache_q <= queued_cached;
    end
  end
endmodule

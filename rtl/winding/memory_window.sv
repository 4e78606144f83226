// Words of a memory that queued work needs, fetched ahead and kept on chip.
//
// Work enters and leaves in order; each piece names a word. As it enters, the word gets a line, and is fetched
// unless it is there; a line is taken from its word only when no piece of work inside needs it and the owner does
// not hold it. So what leaves finds its word without a look at any tag, and no fetch ever races with a write.
//
// Owner:  `out_fresh_o`: it does not hold the word of this piece; load_i in a cycle of out_valid_o takes it from
//         data_o. It writes the word it held back (write_i while write_ready_o, and to the memory) before or as it
//         loads the next. pop_i ends the piece, at the earliest in the cycle of load_i.
// Timing: in to out three cycles, then one piece a cycle; a load takes a cycle of its own.
`include "check.svh"
module memory_window #(
  parameter int unsigned Width       = 8,  // of a word
  parameter int unsigned AddrBits    = 8,
  parameter int unsigned PayloadBits = 8,
  parameter int unsigned Lines       = 4,  // powers of two, 2 or more
  parameter int unsigned Depth       = 4,
  parameter int unsigned RowBits     = AddrBits,  // of the address's lower coordinate, LineBits or more
  localparam int unsigned LineBits   = $clog2(Lines)
) (
  input  logic                   clk_i,
  input  logic                   rst_ni,
  input  logic                   clear_i,      // drops all work and all words
  // work
  input  logic                   in_valid_i,
  output logic                   in_ready_o,
  input  logic                   in_bare_i,    // needs no word
  input  logic [AddrBits-1:0]    in_addr_i,
  input  logic [PayloadBits-1:0] in_payload_i,
  output logic                   out_valid_o,
  output logic                   out_fresh_o,
  output logic [PayloadBits-1:0] out_payload_o,
  output logic [Width-1:0]       data_o,
  input  logic                   load_i,
  input  logic                   pop_i,
  output logic                   empty_o,      // no work inside
  output logic                   waits_o,      // the oldest piece waits for its word
  // the word the owner holds
  output logic [AddrBits-1:0]    held_addr_o,
  input  logic                   write_i,
  output logic                   write_ready_o,
  input  logic [Width-1:0]       write_data_i,
  input  logic                   clean_i,      // the held word was written back: it may be let go
  // memory; tag = line
  output logic                   rd_valid_o,
  input  logic                   rd_ready_i,
  output logic [AddrBits-1:0]    rd_addr_o,
  output logic [LineBits-1:0]    rd_tag_o,
  input  logic                   rsp_valid_i,
  input  logic [LineBits-1:0]    rsp_tag_i,
  input  logic [Width-1:0]       rsp_data_i
);
  localparam int unsigned KeyBits = AddrBits - LineBits;
  // Neighbours along either axis of the map are to have different lines: all of the address plays a part, and
  // the low bits of the one coordinate meet the high bits of the other.
  function automatic logic [LineBits-1:0] line_of(input logic [AddrBits-1:0] addr);
    line_of = addr[LineBits-1:0];
    for (int unsigned i = LineBits; i < AddrBits; i++) begin
      if (i < RowBits) line_of[i%LineBits] = line_of[i%LineBits] ^ addr[i];
      else line_of[(i-RowBits+(LineBits+1)/2)%LineBits] = line_of[(i-RowBits+(LineBits+1)/2)%LineBits] ^ addr[i];
    end
  endfunction
  localparam int unsigned SeqBits = $clog2(Depth) + 5;  // pieces inside: Depth + 2 at most

  logic [Lines-1:0] valid_q, busy_q;  // has a word; it is being fetched

  // ---- Entry: a line for the word -------------------------------------------------------------
  logic                entry_valid_q, entry_bare_q, last_valid_q;
  logic [AddrBits-1:0] entry_addr_q;
  logic [LineBits-1:0] entry_line, last_line_q;
  logic [KeyBits-1:0]  entry_key, key, ram_key, last_key_q;
  logic [SeqBits-1:0]  seq, ram_seq, last_seq_q, pushed_q, popped_q, age, pieces;
  logic                accept, push, payload_ready, line_ready, hit, in_use, newest, fetch;
  logic                let_go, held_valid_q, payload_valid, line_valid, payload_empty, line_empty;
  logic [LineBits-1:0] held_line_q;
  logic [AddrBits-1:0] held_addr_q;

  assign in_ready_o = payload_ready && (!entry_valid_q || push);
  assign accept     = in_valid_i && in_ready_o;
  assign entry_line = line_of(entry_addr_q);
  assign entry_key  = entry_addr_q[AddrBits-1:LineBits];
  assign newest     = last_valid_q && last_line_q == entry_line;  // its key may not be in the memory yet
  assign key        = newest ? last_key_q : ram_key;
  assign seq        = newest ? last_seq_q : ram_seq;
  assign hit        = valid_q[entry_line] && key == entry_key;
  // An old number may look like a recent one: then the entry waits until the work inside is done.
  assign age        = pushed_q - seq;
  assign pieces     = pushed_q - popped_q;
  assign in_use     = valid_q[entry_line]
                      && ((pieces != '0 && age <= pieces) || (held_valid_q && held_line_q == entry_line));
  // Nothing inside makes the owner load another word: the one it holds would keep its line for ever.
  assign let_go     = entry_valid_q && !entry_bare_q && !hit && pieces == '0 && clean_i;
  assign rd_valid_o = entry_valid_q && !entry_bare_q && !hit && !in_use && !busy_q[entry_line] && line_ready;
  assign rd_addr_o  = entry_addr_q;
  assign rd_tag_o   = entry_line;
  assign fetch      = rd_valid_o && rd_ready_i;
  assign push       = entry_valid_q && line_ready && (entry_bare_q || hit || fetch);

  ram_1r1w #(.Width(KeyBits + SeqBits), .Depth(Lines)) key_ram (
    .clk_i, .write_i(push && !entry_bare_q), .write_addr_i(entry_line),
    .write_data_i({entry_key, pushed_q}),
    .read_i(accept), .read_addr_i(line_of(in_addr_i)), .read_data_o({ram_key, ram_seq})
  );
  fifo #(.Width(PayloadBits), .Depth(Depth)) payloads (
    .clk_i, .rst_ni, .clear_i, .valid_i(accept), .ready_o(payload_ready), .data_i(in_payload_i),
    .valid_o(payload_valid), .ready_i(pop_i), .data_o(out_payload_o), .empty_o(payload_empty)
  );

  // ---- Exit: one piece ahead of the owner ---------------------------------------------------------
  logic                next_bare, next_same, next_take, ahead_valid_q, ahead_fresh_q, newest_valid_q;
  logic [AddrBits-1:0] next_addr, ahead_addr_q;
  logic [LineBits-1:0] next_line, newest_line_q;
  logic                next_filled;

  fifo #(.Width(1 + AddrBits), .Depth(Depth)) lines (
    .clk_i, .rst_ni, .clear_i, .valid_i(push), .ready_o(line_ready), .data_i({entry_bare_q, entry_addr_q}),
    .valid_o(line_valid), .ready_i(next_take), .data_o({next_bare, next_addr}), .empty_o(line_empty)
  );
  assign next_line   = line_of(next_addr);
  // The word of the piece before: the owner has it or is about to load it.
  assign next_same   = newest_valid_q && newest_line_q == next_line;
  // The held word is not here as it now is: it comes back when the owner loads another one.
  assign next_filled = valid_q[next_line] && !busy_q[next_line]
                       && !(held_valid_q && held_line_q == next_line);
  assign next_take   = line_valid && (!ahead_valid_q || pop_i) && (next_bare || next_same || next_filled);

  ram_1r1w #(.Width(Width), .Depth(Lines)) word_ram (
    .clk_i, .write_i(rsp_valid_i ? valid_q[rsp_tag_i] : write_i),
    .write_addr_i(rsp_valid_i ? rsp_tag_i : held_line_q),
    .write_data_i(rsp_valid_i ? rsp_data_i : write_data_i),
    .read_i(next_take && !next_bare && !next_same), .read_addr_i(next_line), .read_data_o(data_o)
  );
  assign write_ready_o = !rsp_valid_i;

  assign out_valid_o = ahead_valid_q && payload_valid;
  assign out_fresh_o = ahead_fresh_q;
  assign held_addr_o = held_addr_q;
  assign empty_o     = payload_empty && !ahead_valid_q && line_empty && !entry_valid_q;
  assign waits_o     = !ahead_valid_q && !payload_empty;

  logic [Lines-1:0] valid_d, busy_d;
  always_comb begin
    valid_d = valid_q;
    busy_d  = busy_q;
    if (rsp_valid_i) busy_d[rsp_tag_i] = 1'b0;
    if (fetch) begin
      valid_d[entry_line] = 1'b1;
      busy_d[entry_line]  = 1'b1;
    end
    if (clear_i) valid_d = '0;
  end

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      valid_q        <= '0;
      busy_q         <= '0;
      entry_valid_q  <= 1'b0;
      last_valid_q   <= 1'b0;
      ahead_valid_q  <= 1'b0;
      newest_valid_q <= 1'b0;
      held_valid_q   <= 1'b0;
      pushed_q       <= '0;
      popped_q       <= '0;
    end else begin
      valid_q <= valid_d;
      busy_q  <= busy_d;
      if (clear_i) begin
        entry_valid_q  <= 1'b0;
        last_valid_q   <= 1'b0;
        ahead_valid_q  <= 1'b0;
        newest_valid_q <= 1'b0;
        held_valid_q   <= 1'b0;
        pushed_q       <= '0;
        popped_q       <= '0;
      end else begin
        entry_valid_q  <= accept || (entry_valid_q && !push);
        last_valid_q   <= last_valid_q || (push && !entry_bare_q);
        ahead_valid_q  <= next_take || (ahead_valid_q && !pop_i);
        newest_valid_q <= (newest_valid_q && !let_go) || (next_take && !next_bare);
        held_valid_q   <= (held_valid_q && !let_go) || load_i;
        if (push) pushed_q <= pushed_q + 1'b1;
        if (pop_i) popped_q <= popped_q + 1'b1;
      end
      `CHECK(pops_what_is_there, !pop_i || (out_valid_o && (load_i || !out_fresh_o)))
      `CHECK(loads_what_is_there, !load_i || (out_valid_o && out_fresh_o))
      `CHECK(response_was_asked_for, !rsp_valid_i || busy_q[rsp_tag_i])
    end
  end

  always_ff @(posedge clk_i) begin
    if (accept) begin
      entry_addr_q <= in_addr_i;
      entry_bare_q <= in_bare_i;
    end
    if (push && !entry_bare_q) begin
      last_line_q <= entry_line;
      last_key_q  <= entry_key;
      last_seq_q  <= pushed_q;
    end
    if (next_take) begin
      ahead_fresh_q <= !next_bare && !next_same;
      ahead_addr_q  <= next_addr;
      if (!next_bare) newest_line_q <= next_line;
    end else if (load_i) begin
      ahead_fresh_q <= 1'b0;
    end
    if (load_i) begin
      held_addr_q <= ahead_addr_q;
      held_line_q <= line_of(ahead_addr_q);
    end
  end
endmodule

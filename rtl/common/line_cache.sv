// Direct-mapped, write-through cache of memory words on chip, for the one owner of a memory in pass 1.
//
// Lookup:  lookup_i in cycle n; from n + 1 on hit_o says whether data_o is the word, as of now: updates
//          show one cycle later. A miss is fetched without being asked for. One lookup a cycle on hits.
// Update:  a word goes to the cache and, by way of the write register, to the memory. It waits while its
//          line is being filled, so no fill ever replaces a newer word. Fills and updates have a data
//          memory each, and do not wait for each other.
// Hint:    fetches a word that is absent. It waits while its line is in use, or holds a hinted word that
//          no lookup asked for yet; that one it takes only while there is no lookup at all. Changes
//          time, never a value. A hint that repeats the last one is dropped.
// Lines:   an address's line is its low bits; with Fold they are XORed with all higher ones, so that
//          the words of a column of a map, whose addresses differ by powers of two, spread too.
// Memory:  tag of a read = line. A read waits while a write to its address does. After clear_i what is
//          under way comes back and is dropped; its lines wait for that.
`include "check.svh"
module line_cache #(
  parameter int unsigned Width    = 8,
  parameter int unsigned AddrBits = 6,
  parameter int unsigned Lines    = 4,  // a power of two, 2 or more, below 2^AddrBits; at most 2^TagBits
  parameter int unsigned TagBits  = 8,
  parameter bit          Fold     = 1'b1
) (
  input  logic                clk_i,
  input  logic                rst_ni,
  input  logic                clear_i,        // drops all lines, the lookup and what waits to be read or written
  // words that lookups will ask for soon
  input  logic                hint_valid_i,
  output logic                hint_ready_o,
  input  logic [AddrBits-1:0] hint_addr_i,
  // the word being worked on
  input  logic                lookup_i,       // begins a lookup, replaces the one before
  input  logic                lookup_end_i,   // ends it without another
  input  logic [AddrBits-1:0] lookup_addr_i,
  output logic                hit_o,
  output logic [Width-1:0]    data_o,
  // a new word, of any address
  input  logic                update_i,
  output logic                update_ready_o, // depends on update_addr_i
  input  logic [AddrBits-1:0] update_addr_i,
  input  logic [Width-1:0]    update_data_i,
  output logic                idle_o,         // nothing is being read or written, or waits to be
  // memory
  output logic                rd_valid_o,
  input  logic                rd_ready_i,
  output logic [AddrBits-1:0] rd_addr_o,
  output logic [TagBits-1:0]  rd_tag_o,
  input  logic                rsp_valid_i,
  input  logic [TagBits-1:0]  rsp_tag_i,
  input  logic [Width-1:0]    rsp_data_i,
  output logic                wr_valid_o,
  input  logic                wr_ready_i,
  output logic [AddrBits-1:0] wr_addr_o,
  output logic [Width-1:0]    wr_data_o
);
  localparam int unsigned LineBits = $clog2(Lines);
  localparam int unsigned KeyBits  = AddrBits - LineBits;  // of an address beside its line

  function automatic logic [LineBits-1:0] line_of(input logic [AddrBits-1:0] addr);
    line_of = addr[LineBits-1:0];
    if (Fold) begin
      for (int unsigned i = LineBits; i < AddrBits; i++) begin
        line_of[i%LineBits] = line_of[i%LineBits] ^ addr[i];
      end
    end
  endfunction

  // A line: valid and not busy: holds a word; busy: a read is under way, whose word is kept if valid.
  logic [Lines-1:0] valid_q, busy_q, valid_d, busy_d;
  logic [Lines-1:0] updated_q, hinted_q;  // the word is in the memory of updates; nobody looked it up yet

  logic                lookup_valid_q, forward_q, raced_q, hint_valid_q, hint_raced_q, hinting_q, rd_valid_q, wr_valid_q;
  logic [AddrBits-1:0] lookup_q, hint_q, rd_addr_q, wr_addr_q;
  logic [Width-1:0]    wr_data_q;

  logic [AddrBits-1:0] read_addr, fill_addr;
  logic [LineBits-1:0] read_line, lookup_line, hint_line, update_line, fill_line, rsp_line, hint_read_line;
  logic [KeyBits-1:0]  lookup_key, hint_key;
  logic [Width-1:0]    filled_word, updated_word;
  logic                reading, updating, keep_rsp, fill, fill_lookup, fill_hint, can_fill, hint_done, hint_free;
  logic                key_write, moving;
  logic [LineBits-1:0] key_line;
  logic [KeyBits-1:0]  key_data;

  assign lookup_line = line_of(lookup_q);
  assign hint_line   = line_of(hint_q);
  assign update_line = line_of(update_addr_i);
  assign rsp_line    = rsp_tag_i[LineBits-1:0];

  // ---- Lookup -------------------------------------------------------------------------------
  assign hit_o   = lookup_valid_q && (forward_q || (!raced_q && valid_q[lookup_line]
                   && !busy_q[lookup_line] && lookup_key == lookup_q[AddrBits-1:LineBits]));
  assign data_o  = forward_q ? wr_data_q : updated_q[lookup_line] ? updated_word : filled_word;
  // Read again until it is there, and after each update: it may be of this word, or take its line.
  assign reading   = lookup_i || (lookup_valid_q && (!hit_o || updating));
  assign read_addr = lookup_i ? lookup_addr_i : lookup_q;
  assign read_line = line_of(read_addr);

  // ---- Fill: one request waits in a register --------------------------------------------------
  assign can_fill    = (!rd_valid_q || (rd_valid_o && rd_ready_i)) && !moving;
  assign fill_lookup = can_fill && lookup_valid_q && !hit_o && !raced_q && !busy_q[lookup_line];
  // The lookup's line is left alone by hints: what it reads now, it will write.
  assign hint_free   = !busy_q[hint_line] && (!lookup_valid_q
                       || (lookup_line != hint_line && !(valid_q[hint_line] && hinted_q[hint_line])));
  assign hint_done   = valid_q[hint_line] && hint_key == hint_q[AddrBits-1:LineBits] && !hint_raced_q;
  assign fill_hint   = can_fill && !fill_lookup && hint_valid_q && hint_free && !hint_done && !hint_raced_q;
  assign hint_ready_o = !hint_valid_q || hint_done || fill_hint;
  assign fill        = fill_lookup || fill_hint;
  assign fill_addr   = fill_lookup ? lookup_q : hint_q;
  assign fill_line   = line_of(fill_addr);

  // It is read again while it waits.
  assign hint_read_line = hint_ready_o ? line_of(hint_addr_i) : hint_line;

  // ---- Update -------------------------------------------------------------------------------
  assign keep_rsp       = rsp_valid_i && valid_q[rsp_line];
  assign update_ready_o = (!wr_valid_q || wr_ready_i) && !busy_q[update_line];
  assign updating       = update_i && update_ready_o;

  // An update of the word that is looked up finds its address in place.
  assign moving     = updating && !(hit_o && update_addr_i == lookup_q);
  assign key_write  = moving || fill;
  assign key_line   = moving ? update_line : fill_line;
  assign key_data   = moving ? update_addr_i[AddrBits-1:LineBits] : fill_addr[AddrBits-1:LineBits];

  ram_1r1w #(.Width(Width), .Depth(Lines)) fill_ram (
    .clk_i, .write_i(keep_rsp), .write_addr_i(rsp_line), .write_data_i(rsp_data_i),
    .read_i(reading), .read_addr_i(read_line), .read_data_o(filled_word)
  );
  ram_1r1w #(.Width(Width), .Depth(Lines)) update_ram (
    .clk_i, .write_i(updating), .write_addr_i(update_line), .write_data_i(update_data_i),
    .read_i(reading), .read_addr_i(read_line), .read_data_o(updated_word)
  );
  ram_1r1w #(.Width(KeyBits), .Depth(Lines)) lookup_key_ram (
    .clk_i, .write_i(key_write), .write_addr_i(key_line), .write_data_i(key_data),
    .read_i(reading), .read_addr_i(read_line), .read_data_o(lookup_key)
  );
  ram_1r1w #(.Width(KeyBits), .Depth(Lines)) hint_key_ram (
    .clk_i, .write_i(key_write), .write_addr_i(key_line), .write_data_i(key_data),
    .read_i(1'b1), .read_addr_i(hint_read_line),
    .read_data_o(hint_key)
  );

  always_comb begin
    valid_d = valid_q;
    busy_d  = busy_q;
    if (rsp_valid_i) busy_d[rsp_line] = 1'b0;
    if (updating) valid_d[update_line] = 1'b1;
    if (fill) begin
      valid_d[fill_line] = 1'b1;
      busy_d[fill_line]  = 1'b1;
    end
    // Dropped requests were never sent: nothing will come back for them.
    if (clear_i) begin
      valid_d = '0;
      if (fill) busy_d[fill_line] = 1'b0;
      if (rd_valid_q && !(rd_valid_o && rd_ready_i)) busy_d[line_of(rd_addr_q)] = 1'b0;
    end
  end

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      valid_q        <= '0;
      busy_q         <= '0;
      lookup_valid_q <= 1'b0;
      hint_valid_q   <= 1'b0;
      hinting_q      <= 1'b0;
      rd_valid_q     <= 1'b0;
      wr_valid_q     <= 1'b0;
    end else begin
      valid_q <= valid_d;
      busy_q  <= busy_d;
      if (clear_i) begin
        lookup_valid_q <= 1'b0;
        hint_valid_q   <= 1'b0;
        hinting_q      <= 1'b0;
        rd_valid_q     <= 1'b0;
        wr_valid_q     <= 1'b0;
      end else begin
        lookup_valid_q <= lookup_i || (lookup_valid_q && !lookup_end_i);
        hint_valid_q   <= hint_ready_o ? hint_valid_i && !(hinting_q && hint_addr_i == hint_q) : 1'b1;
        hinting_q      <= hinting_q || hint_valid_i;
        rd_valid_q     <= fill || (rd_valid_q && !(rd_valid_o && rd_ready_i));
        wr_valid_q     <= updating || (wr_valid_q && !wr_ready_i);
      end
      `CHECK(response_was_asked_for, !rsp_valid_i || busy_q[rsp_line])
      `CHECK(response_has_a_line, !rsp_valid_i || rsp_tag_i == TagBits'(rsp_line))
    end
  end

  always_ff @(posedge clk_i) begin
    if (lookup_i) lookup_q <= lookup_addr_i;
    if (hint_valid_i && hint_ready_o) hint_q <= hint_addr_i;
    hint_raced_q <= key_write && key_line == hint_read_line;
    if (fill) rd_addr_q <= fill_addr;
    if (updating) begin
      wr_addr_q <= update_addr_i;
      wr_data_q <= update_data_i;
    end
    if (reading) begin
      forward_q <= updating && update_addr_i == read_addr;
      raced_q   <= (updating && update_line == read_line) || (keep_rsp && rsp_line == read_line)
                || (key_write && key_line == read_line);
    end
    if (lookup_valid_q) hinted_q[lookup_line] <= 1'b0;
    if (updating) begin
      updated_q[update_line] <= 1'b1;
      hinted_q[update_line]  <= 1'b0;
    end
    if (fill) begin
      updated_q[fill_line] <= 1'b0;
      hinted_q[fill_line]  <= fill_hint;
    end
  end

  assign rd_valid_o = rd_valid_q && !(wr_valid_q && wr_addr_q == rd_addr_q);
  assign rd_addr_o  = rd_addr_q;
  assign rd_tag_o   = TagBits'(line_of(rd_addr_q));
  assign wr_valid_o = wr_valid_q;
  assign wr_addr_o  = wr_addr_q;
  assign wr_data_o  = wr_data_q;
  assign idle_o     = !hint_valid_q && !rd_valid_q && !wr_valid_q && busy_q == '0;
endmodule

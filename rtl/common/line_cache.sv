// Write-through cache, direct-mapped or of two ways, of memory words on chip, for the one owner of a memory in pass 1.
//
// Lookup:  lookup_i in cycle n; from n + 1 on hit_o says whether data_o is the word, as of now: updates
//          show one cycle later. A miss is fetched without being asked for. One lookup a cycle on hits.
// Update:  a word goes to the cache and, by way of the write register, to the memory. It waits while its
//          line is being filled, so no fill ever replaces a newer word. Fills and updates have a data
//          memory each, and do not wait for each other. An update of the word that is looked up takes
//          its line; lookup_new_i says that the word will be updated without having been read. An
//          update of another word takes its set's first line and empties the other. One that takes a
//          line waits while a hint does.
// Flags:   what an update changes of them shows two cycles later; in between its set counts as raced.
// Hint:    fetches a word that is absent. It waits while its set is in use, or each of its lines holds
//          a hinted word whose lookups did not all come yet (two are counted); such a one it takes only
//          while there is no lookup at all. Changes time, never a value. A hint that repeats the last
//          one is dropped, and so is a weak one that would have to wait; a weak one holds no line.
// Lines:   one or two a set. An address's set is its low bits; with Fold they are XORed with all higher
//          ones, so that the words of a column of a map, whose addresses differ by powers of two, spread.
// Memory:  tag of a read = line. A read waits while a write to its address does. After clear_i what is
//          under way comes back and is dropped; its lines wait for that.
`include "check.svh"
module line_cache #(
  parameter int unsigned Width    = 8,
  parameter int unsigned AddrBits = 6,
  parameter int unsigned Lines    = 4,  // a power of two, 2 or more, below 2^AddrBits; at most 2^TagBits
  parameter int unsigned Ways     = 1,  // or 2: of a set's lines, of which a word may take either
  parameter int unsigned TagBits  = 8,
  parameter bit          Fold     = 1'b1
) (
  input  logic                clk_i,
  input  logic                rst_ni,
  input  logic                clear_i,        // drops all lines, the lookup and what waits to be read or written
  // words that lookups will ask for soon
  input  logic                hint_valid_i,
  output logic                hint_ready_o,
  input  logic                hint_weak_i,    // perhaps
  input  logic [AddrBits-1:0] hint_addr_i,
  // the word being worked on
  input  logic                lookup_i,       // begins a lookup, replaces the one before
  input  logic                lookup_new_i,   // it is not to be fetched
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
  localparam int unsigned Sets     = Lines / Ways;
  localparam int unsigned SetBits  = $clog2(Sets);
  localparam int unsigned KeyBits  = AddrBits - SetBits;  // of an address beside its set

  function automatic logic [SetBits-1:0] set_of(input logic [AddrBits-1:0] addr);
    set_of = addr[SetBits-1:0];
    if (Fold) begin
      for (int unsigned i = SetBits; i < AddrBits; i++) begin
        set_of[i%SetBits] = set_of[i%SetBits] ^ addr[i];
      end
    end
  endfunction
  // Line of a set and a way; the ways of a set stand beside each other.
  function automatic logic [LineBits-1:0] line_of(input logic [SetBits-1:0] set, input logic way);
    line_of = LineBits'(set);
    if (Ways == 2) line_of = LineBits'({set, way});
  endfunction
  function automatic logic [SetBits-1:0] set_of_line(input logic [LineBits-1:0] line);
    set_of_line = SetBits'(line >> (Ways - 1));
  endfunction

  logic [Lines-1:0]    valid, busy, updated, awaited;  // line_flags

  logic                lookup_valid_q, new_q, met_q, hint_valid_q, hint_weak_q, hint_raced_q, hinting_q;
  logic                rd_valid_q, wr_valid_q, turn_q;  // which way the next choice among equals takes
  logic                update_q, came_q, filled_q, read_q;  // of the cycle before: an update, a response, ..
  logic                forward, forward_way, raced, forward_q, forward_way_q, raced_q;
  logic [AddrBits-1:0] lookup_q, hint_q, rd_addr_q, wr_addr_q;
  logic [SetBits-1:0]  lookup_set, hint_set;  // of lookup_q, hint_q
  logic [SetBits-1:0]  came_set_q, filled_set_q;
  logic [LineBits-1:0] rd_line_q, update_line_q;  // update_line_q: of update_q
  logic [Width-1:0]    wr_data_q;

  logic [AddrBits-1:0] fill_addr;
  logic [SetBits-1:0]  read_set, update_set, hint_read_set, fill_set;
  logic [LineBits-1:0] lookup_line, update_line, fill_line, rsp_line;
  logic [Ways*KeyBits-1:0] lookup_keys, hint_keys;
  logic [Ways*Width-1:0]   filled_words, updated_words;
  logic [Width-1:0]    word;
  logic [Ways-1:0]     match, settled;  // match: holds the word; settled: is not being read
  logic                reading, updating, keep_rsp, fill, fill_lookup, fill_hint, can_fill, wants_fill, hint_done, hint_free;
  logic                taking, moving, claiming, in_place, new_ready, present, hint_again, met_now, lookup_way, lookup_free, fill_way, hint_way, done_way, update_way;
  logic [KeyBits-1:0]  key_data;

  assign update_set = set_of(update_addr_i);
  assign rsp_line   = rsp_tag_i[LineBits-1:0];

  // What was read in the cycle before: is it the word of that cycle's update, or has its set changed?
  assign forward     = read_q ? update_q && wr_addr_q == lookup_q : forward_q;
  assign forward_way = read_q ? Ways == 2 && update_line_q[0] : forward_way_q;
  assign raced       = read_q ? (update_q && set_of_line(update_line_q) == lookup_set)
                                || (came_q && came_set_q == lookup_set) || (filled_q && filled_set_q == lookup_set)
                              : raced_q;

  // ---- Lookup: the way that holds the word; or the one it will take ----------------------------
  always_comb begin
    word        = '0;
    lookup_free = 1'b0;
    lookup_way  = Ways == 2 && turn_q;
    // The one that no hint needs, if there is one.
    for (int unsigned w = 0; w < Ways; w++) begin
      settled[w] = !busy[line_of(lookup_set, 1'(w))];
      match[w]   = valid[line_of(lookup_set, 1'(w))] && lookup_keys[w*KeyBits +: KeyBits] == lookup_q[AddrBits-1:SetBits];
      if (settled[w] && (!lookup_free
          || (awaited[line_of(lookup_set, lookup_way)] && !awaited[line_of(lookup_set, 1'(w))])
          || (awaited[line_of(lookup_set, lookup_way)] == awaited[line_of(lookup_set, 1'(w))] && turn_q))) begin
        lookup_free = 1'b1;
        lookup_way  = 1'(w);
      end
      if (w == 0 || match[w]) begin  // without a match it is not looked at
        word = updated[line_of(lookup_set, 1'(w))] ? updated_words[w*Width +: Width] : filled_words[w*Width +: Width];
      end
    end
    present = match != '0;
    if (present) lookup_way = Ways == 2 && match[Ways-1];
    if (forward) lookup_way = forward_way;
  end
  assign lookup_line = line_of(lookup_set, lookup_way);
  assign hit_o       = lookup_valid_q && (forward || (!raced && (match & settled) != '0));
  assign data_o      = forward ? wr_data_q : word;
  // Read again until it is there, and after each update: it may be of this word, or take its line.
  assign reading   = lookup_i || (lookup_valid_q && (!hit_o || updating));
  assign read_set  = lookup_i ? set_of(lookup_addr_i) : lookup_set;  // which of the two is known last

  // ---- Hint: a way that no other hint needs; while there is no lookup, any ---------------------
  always_comb begin
    hint_done = 1'b0;
    done_way  = 1'b0;
    hint_free = 1'b0;
    hint_way  = Ways == 2 && turn_q;
    for (int unsigned w = 0; w < Ways; w++) begin
      if (valid[line_of(hint_set, 1'(w))] && hint_keys[w*KeyBits +: KeyBits] == hint_q[AddrBits-1:SetBits]
          && !hint_raced_q) begin
        hint_done = 1'b1;
        done_way  = 1'(w);
      end
      // The lookup's set is left alone by hints: what it reads now, it will write.
      if (!busy[line_of(hint_set, 1'(w))] && (!lookup_valid_q || (lookup_set != hint_set
          && !awaited[line_of(hint_set, 1'(w))]))
          && !(hint_free && hint_way == turn_q)) begin
        hint_free = 1'b1;
        hint_way  = 1'(w);
      end
    end
  end

  // ---- Fill: one request waits in a register --------------------------------------------------
  // A hint's hangs on no update of this cycle, so that what hints wait for is known early; nor does the
  // lookup's, with two ways. An update that takes a line waits for it.
  assign can_fill    = !rd_valid_q || (rd_valid_o && rd_ready_i);
  assign wants_fill  = lookup_valid_q && !new_q && !forward && !present && !raced && lookup_free;
  assign fill_lookup = can_fill && wants_fill && (Ways == 2 || !taking);
  assign fill_hint   = can_fill && !wants_fill && hint_valid_q && hint_free && !hint_done && !hint_raced_q;
  assign hint_ready_o = !hint_valid_q || hint_done || fill_hint || (hint_weak_q && !hint_free && !hint_raced_q);
  assign fill        = fill_lookup || fill_hint;
  assign fill_addr   = fill_lookup ? lookup_q : hint_q;
  assign fill_way    = fill_lookup ? lookup_way : hint_way;
  assign fill_set    = fill_lookup ? lookup_set : hint_set;
  assign fill_line   = line_of(fill_set, fill_way);

  assign hint_again  = hint_valid_q && hint_done && !hint_weak_q;
  assign met_now     = hit_o && !met_q;

  // It is read again while it waits.
  assign hint_read_set = hint_ready_o ? set_of(hint_addr_i) : hint_set;

  // ---- Update -------------------------------------------------------------------------------
  // Of the word that is looked up it is known where it is, or where it may go. Of another one it is
  // not: it takes way 0, and the other way gives its word up.
  assign keep_rsp       = rsp_valid_i && valid[rsp_line];
  assign new_ready      = lookup_valid_q && new_q && !forward && !raced && !present && lookup_free;
  assign in_place       = (hit_o || new_ready) && update_addr_i == lookup_q;
  assign update_ready_o = (!wr_valid_q || wr_ready_i)
                          && ((hit_o && in_place)
                              || (!fill_hint && !(Ways == 2 && fill_lookup) && (in_place || (!busy[line_of(update_set, 1'b0)]
                                  && !busy[line_of(update_set, 1'b1)]))));
  assign updating       = update_i && update_ready_o;
  assign moving         = updating && !in_place;
  assign claiming       = updating && in_place && new_ready;
  assign update_way     = !moving && lookup_way;
  assign update_line    = line_of(update_set, update_way);

  assign taking     = moving || claiming;
  assign key_data   = fill ? fill_addr[AddrBits-1:SetBits] : update_addr_i[AddrBits-1:SetBits];

  for (genvar w = 0; w < Ways; w++) begin : gen_way
    ram_1r1w #(.Width(Width), .Depth(Sets)) fill_ram (
      .clk_i, .write_i(keep_rsp && rsp_line == line_of(set_of_line(rsp_line), 1'(w))),
      .write_addr_i(set_of_line(rsp_line)), .write_data_i(rsp_data_i),
      .read_i(reading), .read_addr_i(read_set), .read_data_o(filled_words[w*Width +: Width])
    );
    ram_1r1w #(.Width(Width), .Depth(Sets)) update_ram (
      .clk_i, .write_i(updating && update_line == line_of(update_set, 1'(w))),
      .write_addr_i(update_set), .write_data_i(update_data_i),
      .read_i(reading), .read_addr_i(read_set), .read_data_o(updated_words[w*Width +: Width])
    );
    ram_1r1w #(.Width(KeyBits), .Depth(Sets)) lookup_key_ram (
      .clk_i, .write_i(fill ? Ways == 1 || fill_way == 1'(w) : taking && (Ways == 1 || update_way == 1'(w))),
      .write_addr_i(fill ? fill_set : update_set), .write_data_i(key_data),
      .read_i(reading), .read_addr_i(read_set), .read_data_o(lookup_keys[w*KeyBits +: KeyBits])
    );
    ram_1r1w #(.Width(KeyBits), .Depth(Sets)) hint_key_ram (
      .clk_i, .write_i(fill ? Ways == 1 || fill_way == 1'(w) : taking && (Ways == 1 || update_way == 1'(w))),
      .write_addr_i(fill ? fill_set : update_set), .write_data_i(key_data),
      .read_i(1'b1), .read_addr_i(hint_read_set), .read_data_o(hint_keys[w*KeyBits +: KeyBits])
    );
  end

  line_flags #(.Lines(Lines), .Ways(Ways)) flags (
    .clk_i, .rst_ni, .clear_i, .unsent_i(rd_valid_q && !(rd_valid_o && rd_ready_i)), .unsent_line_i(rd_line_q),
    .hint_i(hint_again), .hint_line_i(line_of(hint_set, done_way)), .met_i(met_now), .met_line_i(lookup_line),
    .came_i(rsp_valid_i), .came_line_i(rsp_line),
    .update_i(updating), .update_line_i(update_line), .take_i(taking), .move_i(moving),
    .fill_i(fill), .fill_line_i(fill_line), .fill_hinted_i(fill_hint && !hint_weak_q),
    .valid_o(valid), .busy_o(busy), .updated_o(updated), .awaited_o(awaited),
    .update_o(update_q), .update_line_o(update_line_q)
  );

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      lookup_valid_q <= 1'b0;
      hint_valid_q   <= 1'b0;
      hinting_q      <= 1'b0;
      rd_valid_q     <= 1'b0;
      wr_valid_q     <= 1'b0;
      turn_q         <= 1'b0;
      met_q          <= 1'b0;
    end else begin
      turn_q         <= !clear_i && (turn_q ^ fill);
      // As hints do, lookups of one word that follow each other count once.
      met_q          <= !clear_i && (met_q || hit_o) && (!lookup_i || lookup_addr_i == lookup_q);
      lookup_valid_q <= !clear_i && (lookup_i || (lookup_valid_q && !lookup_end_i));
      hint_valid_q   <= !clear_i && (!hint_ready_o || (hint_valid_i && !(hinting_q && hint_addr_i == hint_q)));
      hinting_q      <= !clear_i && (hinting_q || hint_valid_i);
      rd_valid_q     <= !clear_i && (fill || (rd_valid_q && !(rd_valid_o && rd_ready_i)));
      wr_valid_q     <= !clear_i && (updating || (wr_valid_q && !wr_ready_i));
      `CHECK(response_has_a_line, !rsp_valid_i || rsp_tag_i == TagBits'(rsp_line))
    end
  end

  always_ff @(posedge clk_i) begin
    if (lookup_i) begin
      lookup_q   <= lookup_addr_i;
      lookup_set <= read_set;
      new_q      <= lookup_new_i;
    end
    if (hint_valid_i && hint_ready_o) begin
      hint_q      <= hint_addr_i;
      hint_set    <= hint_read_set;
      hint_weak_q <= hint_weak_i;
    end
    hint_raced_q  <= (taking && update_set == hint_read_set) || (fill && fill_set == hint_read_set);
    if (fill) begin
      rd_addr_q <= fill_addr;
      rd_line_q <= fill_line;
    end
    if (updating) begin
      wr_addr_q <= update_addr_i;
      wr_data_q <= update_data_i;
    end
    read_q        <= reading;
    came_q        <= keep_rsp;
    came_set_q    <= set_of_line(rsp_line);
    filled_q      <= fill;
    filled_set_q  <= fill_set;
    forward_q     <= forward;
    forward_way_q <= forward_way;
    raced_q       <= raced;
  end

  assign rd_valid_o = rd_valid_q && !(wr_valid_q && wr_addr_q == rd_addr_q);
  assign {rd_addr_o, rd_tag_o} = {rd_addr_q, TagBits'(rd_line_q)};
  assign {wr_valid_o, wr_addr_o, wr_data_o} = {wr_valid_q, wr_addr_q, wr_data_q};
  assign idle_o     = !hint_valid_q && !rd_valid_q && !wr_valid_q && busy == '0;
endmodule

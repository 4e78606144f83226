// Shadow decision: what the records of a texel's chain say of a fragment (4.2, Tables 4 to 7).
// Twins: decide_by_lines in model/unit/shadow_unit_pass2.cpp, ShadowDecision and Combination.
//
// A record a cycle, of any slot: either the verdict, or which record the slot asks for next. An
// entry is inside iff some line holds the point and every line that it is ANDed with does too. One
// such candidate at a time is held against all lines of the entry: from its own record to the
// entry's last one, then from the first one on, until it is killed (then the next line that holds
// the point is the candidate) or has come round (then the fragment is dark). What must be known
// until the slot's next record comes stands in two memories, a word a slot.
//
// Timing: a record in cycle n (its fragment with it), by what it was asked for in n + 1
//         (`first_i` to `at_i`); outputs in n + 2. Always taken.
`include "check.svh"
module shadow_decision #(
  parameter int unsigned PointBits = 26,  // of Mx and My that are looked at, at least FractionBits
  localparam int unsigned SlotBits = shadow_pkg::SlotBits,
  localparam int unsigned AddrBits = shadow_pkg::RecordAddrBits,
  localparam int unsigned L        = shadow_pkg::LinesPerRecord
) (
  input  logic                                 clk_i,
  input  logic                                 rst_ni,
  input  logic                                 clear_i,  // drops the record under way
  input  shadow_pkg::settings_t                settings_i,
  // a record that was read, and the fragment that asks
  input  logic                                 valid_i,
  input  logic [SlotBits-1:0]                  slot_i,
  input  shadow_pkg::record_t                  record_i,
  input  logic [PointBits-1:0]                 x_i,      // Mx
  input  logic [PointBits:0]                   nx_i,     // 1 - Mx
  input  logic [PointBits-1:0]                 y_i,      // My
  input  logic [shadow_pkg::DepthBits-1:0]     depth_i,
  input  logic [shadow_pkg::IdBits-1:0]        object_i,
  input  logic [2*shadow_pkg::MapBits-1:0]     texel_i,  // {y, x}
  // one cycle later, how that record was asked for
  input  logic                                 first_i,     // as the bucket's own
  input  logic                                 in_entry_i,  // as one more of an entry under way
  input  logic [AddrBits-1:0]                  at_i,        // its address
  // one cycle after the record: whose it is
  output logic                                 middle_valid_o,
  output logic [SlotBits-1:0]                  middle_slot_o,
  // two cycles after the record: verdict or next request
  output logic                                 slot_valid_o,
  output logic [SlotBits-1:0]                  slot_o,
  output logic                                 decided_o,
  output logic                                 dark_o,            // where decided_o; else lit
  output logic                                 next_in_entry_o,   // where not decided_o
  output logic [AddrBits-1:0]                  next_at_o,
  output logic                                 entry_read_o,
  output logic [shadow_pkg::LineCountBits-1:0] lines_read_o
);
  localparam int unsigned LineBits  = shadow_pkg::LineBits;
  localparam int unsigned IndexBits = L > 1 ? $clog2(L) : 1;

  localparam int unsigned F         = shadow_pkg::FractionBits;

  // What an entry under way knows: which line is the candidate, or where one is looked for,
  typedef struct packed {
    logic                 searching;  // behind line `index`
    logic                 all_lines;  // from the record's first line on
    logic [IndexBits-1:0] index;      // of the candidate
    logic [LineBits-1:0]  candidate;
  } choice_t;
  localparam int unsigned ChoiceBits = 2 + IndexBits + LineBits;
  // and where its records are.
  typedef struct packed {
    logic                vertex;     // of the entry
    logic                has_next;
    logic [AddrBits-1:0] next;       // entry behind it
    logic [AddrBits-1:0] head;       // its first record
    logic                uncounted;  // some record has not been counted yet:
    logic [AddrBits-1:0] uncounted_at;
    logic [AddrBits-1:0] candidate_at;  // record of the candidate
    logic                others;        // it has further lines that hold the point
    logic                goes_on;       // it is not the entry's last
    logic [AddrBits-1:0] onward;        // the record behind it
  } context_t;
  localparam int unsigned ContextBits = 5 + 5 * AddrBits;

  // ---- Stage 1: each line and the point ----
  logic [L-1:0] holds;
  for (genvar i = 0; i < L; i++) begin : g_line
    line_test #(.PointBits(PointBits)) line_test (
      .line_i(record_i.lines[i*LineBits +: LineBits]),
      .x_i({1'b0, x_i}), .nx_i, .y_i({1'b0, y_i}), .holds_o(holds[i])
    );
  end

  logic                                 valid_q;
  logic [SlotBits-1:0]                  slot_q;
  logic [L-1:0]                         there_q, holds_q;  // line i exists; holds the point, if so
  logic                                 texels_q;  // the record is of this texel
  logic                                 used_q, beyond_q, own_q, vertex_q, has_more_q, has_next_q;
  logic [AddrBits-1:0]                  more_q, next_q;
  logic [shadow_pkg::LineCountBits-1:0] count_q;
  logic [L*LineBits-1:0]                lines_q;

  always_ff @(posedge clk_i) begin
    slot_q     <= slot_i;
    texels_q   <= record_i.texel == texel_i;
    used_q     <= record_i.used;
    beyond_q   <= depth_i > record_i.nearest;
    own_q      <= record_i.object == object_i;
    vertex_q   <= record_i.vertex;
    has_more_q <= record_i.has_more;
    has_next_q <= record_i.has_next;
    more_q     <= record_i.more;
    next_q     <= record_i.next;
    count_q    <= record_i.count;
    lines_q    <= record_i.lines;
    for (int i = 0; i < L; i++) begin
      there_q[i] <= shadow_pkg::LineCountBits'(i) < record_i.count;
      holds_q[i] <= holds[i];
    end
  end
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) valid_q <= 1'b0;
    else begin
      valid_q <= valid_i && !clear_i;
      `CHECK(few_enough_lines, !valid_q || count_q <= shadow_pkg::LineCountBits'(L))
    end
  end

  // ---- Stage 2: the first line that may be the candidate ----
  choice_t                  choice;
  logic [ChoiceBits-1:0]    choice_bits;
  logic                     searching, found, others;
  logic [IndexBits-1:0]     found_index;
  logic [LineBits-1:0]      candidate;
  logic [L-1:0]             eligible;

  assign choice    = choice_bits;
  assign searching = !in_entry_i || choice.searching;
  always_comb begin
    found       = 1'b0;
    others      = 1'b0;
    found_index = choice.index;
    candidate   = choice.candidate;
    for (int i = L - 1; i >= 0; i--) begin
      eligible[i] = searching && there_q[i] && holds_q[i]
                    && (!in_entry_i || choice.all_lines || IndexBits'(i) > choice.index);
      if (eligible[i]) begin
        others      = found;
        found       = 1'b1;
        found_index = IndexBits'(i);
        candidate   = lines_q[i*LineBits +: LineBits];
      end
    end
  end

  logic                                 end_valid_q;
  logic [SlotBits-1:0]                  end_slot_q;
  logic                                 in_entry_q, match_q, end_beyond_q, end_own_q, end_vertex_q;
  logic                                 end_more_q, end_next_q;
  logic [AddrBits-1:0]                  end_more_at_q, end_next_at_q, at_q;
  logic [shadow_pkg::LineCountBits-1:0] end_count_q;
  logic [L*LineBits-1:0]                end_lines_q;
  logic [L*(F+1)-1:0]                   complements_q;  // 1 - Fraction of each line
  logic [L-1:0]                         misses_q;       // lines that do not hold the point
  logic                                 searching_q, found_q, others_q;
  logic [IndexBits-1:0]                 index_q;
  logic [LineBits-1:0]                  candidate_q;
  logic [F:0]                           candidate_complement_q;

  always_ff @(posedge clk_i) begin
    end_slot_q    <= slot_q;
    in_entry_q    <= in_entry_i;
    match_q       <= texels_q && (!first_i || used_q);
    end_beyond_q  <= beyond_q;
    end_own_q     <= own_q;
    end_vertex_q  <= vertex_q;
    end_more_q    <= has_more_q;
    end_next_q    <= has_next_q;
    end_more_at_q <= more_q;
    end_next_at_q <= next_q;
    at_q          <= at_i;
    end_count_q   <= count_q;
    end_lines_q   <= lines_q;
    misses_q      <= there_q & ~holds_q;
    searching_q   <= searching;
    found_q       <= found;
    others_q      <= others;
    index_q       <= found_index;
    candidate_q   <= candidate;
    candidate_complement_q <= {1'b1, {F{1'b0}}} - {1'b0, candidate[F-1:0]};
    for (int i = 0; i < L; i++) begin
      complements_q[i*(F+1) +: F+1] <= {1'b1, {F{1'b0}}} - {1'b0, lines_q[i*LineBits +: F]};
    end
  end
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) end_valid_q <= 1'b0;
    else end_valid_q <= valid_q && !clear_i;
  end

  // ---- Stage 3: the candidate and the other lines ----
  context_t               was, now;
  choice_t                now_choice;
  logic [ContextBits-1:0] context_bits;
  logic [L-1:0]           ands;
  logic                   killed, vertex;
  logic [AddrBits-1:0]    head;

  assign was    = context_bits;
  assign vertex = in_entry_q ? was.vertex : end_vertex_q;
  assign head   = in_entry_q ? was.head : at_q;
  for (genvar i = 0; i < L; i++) begin : g_combine
    combine combine (
      .vertex_per_entry_i(settings_i.vertex_per_entry), .table7_printed_i(settings_i.table7_printed),
      .a_i(candidate_q), .b_i(end_lines_q[i*LineBits +: LineBits]),
      .a_complement_i(candidate_complement_q), .b_complement_i(complements_q[i*(F+1) +: F+1]),
      .vertex_i(vertex), .and_o(ands[i])
    );
  end
  // The candidate itself holds the point, so it needs no exception.
  assign killed = |(misses_q & ands);

  // ---- Where to go from here ----
  logic asks_lines;  // the record's lines count
  logic has_next, counts;
  logic [AddrBits-1:0] next, around;

  assign asks_lines = in_entry_q || (match_q && end_beyond_q && !end_own_q);
  assign has_next   = in_entry_q ? was.has_next : end_next_q;
  assign next       = in_entry_q ? was.next : end_next_at_q;
  assign around     = end_more_q ? end_more_at_q : head;
  assign counts     = !in_entry_q || (was.uncounted && was.uncounted_at == at_q);

  always_comb begin
    now           = was;
    now.vertex    = vertex;
    now.has_next  = has_next;
    now.next      = next;
    now.head      = head;
    if (counts) begin
      now.uncounted    = end_more_q;
      now.uncounted_at = end_more_at_q;
    end
    if (searching_q) begin
      now.candidate_at = at_q;
      now.others       = others_q;
      now.goes_on      = end_more_q;
      now.onward       = end_more_at_q;
    end
  end

  // Whether the candidate is killed is known last: both ways are worked out, then one is taken.
  logic [1:0]            decided, in_entry, all_lines;  // bit 1: if it is killed
  logic [2*AddrBits-1:0] ways;
  logic                  entry_done, no_candidate;
  assign no_candidate = searching_q && !found_q;
  // Another texel's, or the fragment's own; or nearer entries than the fragment are at an end.
  assign entry_done   = !asks_lines || (no_candidate && !end_more_q);
  always_comb begin
    if (entry_done) begin
      decided  = {2{!has_next || (match_q && !in_entry_q && !end_beyond_q)}};
      in_entry = 2'b00;
      ways     = {2{next}};
    end else if (no_candidate) begin
      decided  = 2'b00;
      in_entry = 2'b11;
      ways     = {2{end_more_at_q}};
    end else begin
      decided[0]  = around == now.candidate_at;  // it has come round
      in_entry[0] = 1'b1;
      decided[1]  = !now.others && !now.goes_on && !has_next;
      in_entry[1] = now.others || now.goes_on;
      ways = {now.others ? now.candidate_at : now.goes_on ? now.onward : next, around};
    end
    all_lines = {no_candidate || !now.others, no_candidate};
  end
  assign decided_o       = killed ? decided[1] : decided[0];
  assign next_in_entry_o = killed ? in_entry[1] : in_entry[0];
  assign next_at_o       = killed ? ways[AddrBits +: AddrBits] : ways[0 +: AddrBits];
  assign dark_o          = !killed && !entry_done;  // where decided_o

  always_comb begin
    now_choice.searching = no_candidate || killed;
    now_choice.all_lines = killed ? all_lines[1] : all_lines[0];
    now_choice.index     = index_q;
    now_choice.candidate = candidate_q;
  end

  logic keep;
  assign keep = end_valid_q && !decided_o && next_in_entry_o;
  ram_1r1w #(.Width(ChoiceBits), .Depth(shadow_pkg::FragmentSlots)) choice_ram (
    .clk_i, .write_i(keep), .write_addr_i(end_slot_q), .write_data_i(now_choice),
    .read_i(valid_i), .read_addr_i(slot_i), .read_data_o(choice_bits)
  );
  ram_1r1w #(.Width(ContextBits), .Depth(shadow_pkg::FragmentSlots)) context_ram (
    .clk_i, .write_i(keep), .write_addr_i(end_slot_q), .write_data_i(now),
    .read_i(valid_q), .read_addr_i(slot_q), .read_data_o(context_bits)
  );

  assign middle_valid_o = valid_q;
  assign middle_slot_o  = slot_q;
  assign slot_valid_o = end_valid_q;
  assign slot_o       = end_slot_q;
  assign entry_read_o = end_valid_q && !in_entry_q && match_q && end_beyond_q;
  assign lines_read_o = end_valid_q && asks_lines && counts ? end_count_q : '0;

  logic unused_fields;
  assign unused_fields = ^{record_i.corner, settings_i};
endmodule

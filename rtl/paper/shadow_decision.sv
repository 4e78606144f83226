// Shadow decision: what the records of a texel's chain say of a fragment (4.2, Tables 4 to 7).
// Twins: decide_by_lines in model/unit/shadow_unit_pass2.cpp, ShadowDecision and Combination.
//
// A record a cycle, of any slot: either the verdict, or which record the slot asks for next. An
// entry is inside iff some line holds the point and every line that it is ANDed with does too. One
// such candidate at a time is held against all lines of the entry: from its own record to the
// entry's last one, then from the first one on, until it is killed (then the next line that holds
// the point is the candidate) or has come round (then the fragment is dark). What must be known
// until the slot's next record comes stands in `context_ram`.
//
// Timing: a record in cycle n (its fragment with it), by what it was asked for in n + 1
//         (`first_i` to `at_i`); outputs in n + 1. Always taken.
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
  // one cycle after the record: verdict or next request
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

  // What an entry under way knows.
  typedef struct packed {
    logic                      vertex;       // of the entry
    logic                      has_next;
    logic [AddrBits-1:0]       next;         // entry behind it
    logic [AddrBits-1:0]       head;         // its first record
    logic                      uncounted;    // some record has not been counted yet:
    logic [AddrBits-1:0]       uncounted_at;
    logic                      searching;    // a candidate is looked for, behind line `index`
    logic                      all_lines;    // or from the record's first line on
    logic [IndexBits-1:0]      index;        // of the candidate, in record `candidate_at`
    logic [AddrBits-1:0]       candidate_at;
    logic                      others;       // that record has further lines that hold the point
    logic                      goes_on;      // it is not the entry's last
    logic [AddrBits-1:0]       onward;       // the record behind it
    logic [LineBits-1:0]       candidate;
  } context_t;
  localparam int unsigned ContextBits = 7 + 5 * AddrBits + IndexBits + LineBits;

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
  logic [L-1:0]                         there_q, holds_q;  // line i exists; and holds the point
  logic                                 texels_q;  // the record is of this texel
  logic                                 used_q, beyond_q, own_q, vertex_q, has_more_q, has_next_q;
  logic [AddrBits-1:0]                  more_q, next_q;
  logic [shadow_pkg::LineCountBits-1:0] count_q;
  logic [L*LineBits-1:0]                lines_q;
  logic [ContextBits-1:0]               context_bits;

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
      holds_q[i] <= shadow_pkg::LineCountBits'(i) < record_i.count && holds[i];
    end
  end
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) valid_q <= 1'b0;
    else begin
      valid_q <= valid_i && !clear_i;
      `CHECK(few_enough_lines, !valid_q || count_q <= shadow_pkg::LineCountBits'(L))
    end
  end

  // ---- Stage 2: the candidate and the other lines ----
  context_t                 was, now;
  logic                     searching, found, others, killed;
  logic [L-1:0]             eligible, ands;
  logic [IndexBits-1:0]     found_index;
  logic [LineBits-1:0]      candidate;
  logic                     vertex;
  logic [AddrBits-1:0]      head;

  assign was       = context_bits;
  assign vertex    = in_entry_i ? was.vertex : vertex_q;
  assign head      = in_entry_i ? was.head : at_i;
  assign searching = !in_entry_i || was.searching;

  // The first line that may be the candidate.
  always_comb begin
    for (int i = 0; i < L; i++) begin
      eligible[i] = holds_q[i]
                    && (!in_entry_i || was.all_lines || IndexBits'(i) > was.index);
    end
    found       = 1'b0;
    others      = 1'b0;
    found_index = '0;
    candidate   = was.candidate;
    for (int i = L - 1; i >= 0; i--) begin
      if (eligible[i] && searching) begin
        others      = found;
        found       = 1'b1;
        found_index = IndexBits'(i);
        candidate   = lines_q[i*LineBits +: LineBits];
      end
    end
  end

  for (genvar i = 0; i < L; i++) begin : g_combine
    combine combine (
      .vertex_per_entry_i(settings_i.vertex_per_entry), .table7_printed_i(settings_i.table7_printed),
      .a_i(candidate), .b_i(lines_q[i*LineBits +: LineBits]), .vertex_i(vertex), .and_o(ands[i])
    );
  end
  // The candidate itself holds the point, so it needs no exception.
  assign killed = |(there_q & ~holds_q & ands);

  // ---- Where to go from here ----
  logic asks_lines;  // the record's lines count
  logic entry_done;  // the entry says nothing: the next one
  logic has_next, last_there, counts;
  logic [AddrBits-1:0] next, around;

  assign asks_lines = in_entry_i || (texels_q && (!first_i || used_q) && beyond_q && !own_q);
  assign has_next   = in_entry_i ? was.has_next : has_next_q;
  assign next       = in_entry_i ? was.next : next_q;
  assign around     = has_more_q ? more_q : head;
  assign counts     = !in_entry_i || (was.uncounted && was.uncounted_at == at_i);

  always_comb begin
    now           = was;
    now.vertex    = vertex;
    now.has_next  = has_next;
    now.next      = next;
    now.head      = head;
    if (counts) begin
      now.uncounted    = has_more_q;
      now.uncounted_at = more_q;
    end
    if (searching) begin
      now.index        = found_index;
      now.candidate_at = at_i;
      now.candidate    = candidate;
      now.others       = others;
      now.goes_on      = has_more_q;
      now.onward       = more_q;
    end
    now.searching = 1'b0;
    now.all_lines = 1'b0;

    dark_o          = 1'b0;
    entry_done      = 1'b0;
    next_in_entry_o = 1'b1;
    next_at_o       = around;
    last_there      = 1'b0;
    if (!asks_lines) begin
      // Another texel's, or the fragment's own; or nearer entries than the fragment are at an end.
      entry_done = 1'b1;
      last_there = texels_q && (!first_i || used_q) && !beyond_q;
    end else if (searching && !found) begin
      now.searching = 1'b1;
      now.all_lines = 1'b1;
      entry_done    = !has_more_q;
    end else if (killed) begin
      now.searching = 1'b1;
      now.all_lines = !now.others;
      next_at_o     = now.others ? now.candidate_at : now.onward;
      entry_done    = !now.others && !now.goes_on;
    end else begin
      dark_o = around == now.candidate_at;  // it has come round
    end
    if (entry_done) begin
      next_in_entry_o = 1'b0;
      next_at_o       = next;
    end
    decided_o = dark_o || (entry_done && (last_there || !has_next));
  end

  ram_1r1w #(.Width(ContextBits), .Depth(shadow_pkg::FragmentSlots)) context_ram (
    .clk_i,
    .write_i(valid_q && !decided_o && next_in_entry_o), .write_addr_i(slot_q), .write_data_i(now),
    .read_i(valid_i), .read_addr_i(slot_i), .read_data_o(context_bits)
  );

  assign slot_valid_o = valid_q;
  assign slot_o       = slot_q;
  assign entry_read_o = valid_q && !in_entry_i && texels_q && (!first_i || used_q) && beyond_q;
  assign lines_read_o = valid_q && asks_lines && counts ? count_q : '0;

  logic unused_fields;
  assign unused_fields = ^{record_i.corner, settings_i};
endmodule

// Silhouette Line Buffer (SLB): carries out visits on the records of the SLB, one after the other.
//
// An operation that finds all in its bucket's own record takes one cycle. The others walk: the bucket's
// chain for the entry, the entry's records for the line, then relink, allocate or free. Each step looks
// a record up, and writes it back or to another place; nothing of a record is kept between two steps.
// Twin:    model/unit/silhouette_buffer.h, and what shadow_unit_pass1.cpp does with it.
// Chains:  a bucket's first entry stands in the bucket's own record. Entries of one texel stand by
//          nearest, from the light outwards; those of several texels in any order.
// Pool:    behind the buckets' own records. Freed ones are linked by `more`, as an entry's records are.
// Timing:  the record and the texel word are looked up in the cycle in which start_i and ready_o are
//          high; the operation begins in the next.
`include "check.svh"
module silhouette_buffer (
  input  logic                  clk_i,
  input  logic                  rst_ni,
  input  logic                  clear_i,
  input  shadow_pkg::settings_t settings_i,
  input  logic                  wipe_i,   // held until wiped_o: empties the buckets and the pool
  output logic                  wiped_o,
  // buckets that visits will ask for soon
  input  logic                  hint_valid_i,
  output logic                  hint_ready_o,
  input  logic [shadow_pkg::RecordAddrBits-1:0] hint_addr_i,
  // an operation; VisitEdgesDone: an entry of the triangle's object that an edge emptied
  input  logic                  start_i,
  output logic                  ready_o,
  input  logic [1:0]            kind_i,
  input  logic [shadow_pkg::MapBits-1:0]        x_i,
  input  logic [shadow_pkg::MapBits-1:0]        y_i,
  input  logic [shadow_pkg::RecordAddrBits-1:0] bucket_i,
  input  logic [shadow_pkg::DepthBits-1:0]      depth_i,  // VisitEdgesDone: at the texel's centre
  // its visit, from the cycle after the start until the next start
  input  shadow_pkg::visit_t     visit_i,
  input  shadow_pkg::visit_tri_t tri_i,
  output logic                  emptied_o,  // a pulse: the entry of texel x_o, y_o has no line now
  output logic [shadow_pkg::MapBits-1:0] x_o,
  output logic [shadow_pkg::MapBits-1:0] y_o,
  // texel_buffers
  input  logic                  texel_hit_i,
  output logic [1:0]            texel_select_o,
  input  shadow_pkg::texel_t    texel_i,
  input  logic [shadow_pkg::TexelsPerWord-1:0] texel_edges_i,
  output logic                  texel_update_o,
  input  logic                  texel_ready_i,
  output logic [shadow_pkg::TexelsPerWord-1:0] texel_cover_o,
  output logic [shadow_pkg::TexelsPerWord*shadow_pkg::DepthBits-1:0] texel_depth_o,
  output logic [shadow_pkg::IdBits-1:0] texel_id_o,
  output logic                  texel_set_edge_o,
  output logic                  texel_edge_o,
  output logic                  texel_set_overflow_o,
  // SLB memory
  output logic                  rd_valid_o,
  input  logic                  rd_ready_i,
  output logic [shadow_pkg::RecordAddrBits-1:0] rd_addr_o,
  output logic [shadow_pkg::TagBits-1:0]        rd_tag_o,
  input  logic                  rsp_valid_i,
  input  logic [shadow_pkg::TagBits-1:0]        rsp_tag_i,
  input  logic [shadow_pkg::RecordBits-1:0]     rsp_data_i,
  output logic                  wr_valid_o,
  input  logic                  wr_ready_i,
  output logic [shadow_pkg::RecordAddrBits-1:0] wr_addr_o,
  output logic [shadow_pkg::RecordBits-1:0]     wr_data_o,
  // for counters
  output logic                  idle_o,
  output logic [3:0]            cause_o,    // of this cycle, if an operation is under way
  output logic [shadow_pkg::LimitBits-1:0] records_o,  // in use
  output shadow_pkg::store_events_t        events_o
);
  localparam int unsigned AddrBits   = shadow_pkg::RecordAddrBits;
  localparam int unsigned DepthBits  = shadow_pkg::DepthBits;
  localparam int unsigned MapBits    = shadow_pkg::MapBits;
  localparam int unsigned LineBits   = shadow_pkg::LineBits;
  localparam int unsigned LimitBits  = shadow_pkg::LimitBits;
  localparam int unsigned CountBits  = shadow_pkg::LineCountBits;
  localparam int unsigned Texels     = shadow_pkg::TexelsPerWord;

  // Whose turn the next cycle is.
  localparam logic [5:0] Idle       = 6'd0;
  localparam logic [5:0] Begin      = 6'd1;   // all in one, if it is simple
  localparam logic [5:0] Find       = 6'd2;   // walks the bucket for the entry, or for its place
  localparam logic [5:0] Scan       = 6'd3;   // walks the entry's records
  localparam logic [5:0] Lift       = 6'd4;   // the next record's first line is to move up
  localparam logic [5:0] Close      = 6'd5;   // it moves up
  localparam logic [5:0] Cut        = 6'd6;   // the last record is gone: its predecessor becomes the last
  localparam logic [5:0] Mark       = 6'd7;   // the entry's flags, after a change in a continuation
  localparam logic [5:0] Nearer     = 6'd8;   // does the entry stay where it is with its new nearest?
  localparam logic [5:0] Behind     = 6'd9;   // what stands behind it in the texel?
  localparam logic [5:0] Stay       = 6'd10;
  localparam logic [5:0] Unlink     = 6'd11;  // takes an entry of the pool out of its chain
  localparam logic [5:0] UnlinkCopy = 6'd12;  // takes an entry out of the bucket's own record: to the pool
  localparam logic [5:0] UnlinkPull = 6'd13;  // and the next entry of the bucket in
  localparam logic [5:0] UnlinkFree = 6'd14;
  localparam logic [5:0] Allocate   = 6'd15;
  localparam logic [5:0] Reuse      = 6'd16;
  localparam logic [5:0] Allocated  = 6'd17;
  localparam logic [5:0] Link       = 6'd18;  // behind another entry
  localparam logic [5:0] LinkWrite  = 6'd19;
  localparam logic [5:0] Push       = 6'd20;  // before the bucket's first entry: that one to the pool
  localparam logic [5:0] PushWrite  = 6'd21;
  localparam logic [5:0] PushFree   = 6'd22;
  localparam logic [5:0] Extend     = 6'd23;  // a continuation record
  localparam logic [5:0] ExtendLink = 6'd24;
  localparam logic [5:0] Length     = 6'd25;  // counts the texel's records
  localparam logic [5:0] LengthMore = 6'd26;
  localparam logic [5:0] Judge      = 6'd27;  // too many?
  localparam logic [5:0] Stored     = 6'd28;
  localparam logic [5:0] Overflow   = 6'd29;
  localparam logic [5:0] Walk       = 6'd30;  // walks the bucket and erases entries of the texel
  localparam logic [5:0] Erase      = 6'd31;  // the entry's records
  localparam logic [5:0] EraseLink  = 6'd32;
  localparam logic [5:0] EraseFree  = 6'd33;
  localparam logic [5:0] Walked     = 6'd34;
  localparam logic [5:0] Spread     = 6'd35;  // next texel of a span that holds lines

  localparam logic [1:0] ForFresh  = 2'd0;  // what an allocated record is for
  localparam logic [1:0] ForExtend = 2'd1;
  localparam logic [1:0] ForUnlink = 2'd2;
  localparam logic [1:0] ForPush   = 2'd3;

  localparam logic [1:0] EraseAll    = 2'd0;  // what Walk erases
  localparam logic [1:0] EraseHidden = 2'd1;
  localparam logic [1:0] EraseNone   = 2'd2;  // just looks whether the texel has entries

  // ---- State ----------------------------------------------------------------------------------
  logic [5:0]           state_q, state_d;
  logic [1:0]           kind_q;
  logic [MapBits-1:0]   x_q, x_d, y_q;
  logic [AddrBits-1:0]  own_q, own_d;        // the bucket's own record
  logic [DepthBits-1:0] depth_q;
  logic [AddrBits-1:0]  at_q;                // of the lookup
  logic [AddrBits-1:0]  before_q, before_d;  // the record before it in its entry; erased: the first of them
  logic [AddrBits-1:0]  prev_q, prev_d;      // the entry before it in its bucket
  logic                 has_prev_q, has_prev_d;
  logic [AddrBits-1:0]  entry_q, entry_d;    // found; or where an unlinked one stands
  logic                 head_q, head_d;      // the lookup is of the entry, not of a continuation
  logic                 is_own_q, is_own_d;  // the entry stands in the bucket's own record
  logic                 is_first_q, is_first_d;  // of its texel
  logic [AddrBits-1:0]  place_q, place_d;    // behind this one a new entry belongs
  logic                 push_q, push_d;      // it belongs before the bucket's first
  logic                 placed_q, placed_d, seen_q, seen_d;  // place found; an entry of the texel met
  logic [AddrBits-1:0]  next_q, next_d;      // of the entry
  logic                 has_next_q, has_next_d;
  logic [AddrBits-1:0]  spot_q, spot_d;      // allocated
  logic [1:0]           for_q, for_d;
  logic                 relink_q, relink_d;  // the entry was unlinked: Find looks for its place
  logic                 settled_q, settled_d;  // the new line is none that cancels, nearest is set
  logic                 nearer_q, nearer_d;
  logic                 gap_q, gap_d;        // the removed line is the record's first
  logic                 grown_q, grown_d;    // a record was allocated
  logic                 storing_q, storing_d;
  logic [LineBits-1:0]  lifted_q, lifted_d;
  logic [AddrBits-1:0]  length_q, length_d;  // records of the texel; Find: entries of the texel
  logic                 more_q, more_d;      // Find: one of them has continuations
  logic [1:0]           mode_q, mode_d;
  logic                 kept_q, kept_d, covered_q, covered_d, emptying_q, emptying_d;
  logic [Texels-1:0]    todo_q, todo_d;
  // allocator
  logic [AddrBits-1:0]  free_q, free_d;      // first freed record
  logic                 has_free_q, has_free_d;
  logic [AddrBits-1:0]  bump_q, bump_d;      // first record never used; while wiping: next to clear
  logic [LimitBits-1:0] used_q, used_d;
  logic                 wiping_q, wiping;
  logic                 follow_q;  // the record behind one that came is to be hinted
  logic [AddrBits-1:0]  follow_addr_q;
  logic                 reuse_q;  // the first freed record, which the next allocation reads, is to be hinted

  // ---- The record cache -------------------------------------------------------------------------
  shadow_pkg::record_t record, new_record, came;
  logic                hit, record_ready, cache_idle;
  logic                lookup, lookup_end;
  logic [AddrBits-1:0] lookup_addr;
  // What the state wants; all of it happens in one cycle, when `fire`.
  logic                act, fire, last, look, write, touch;
  logic [AddrBits-1:0] look_addr, write_addr;
  logic                fresh, unused_record, set_next, link_has, set_more, more_has, set_nearest;
  logic                set_corner, set_vertex, append, remove, refill, emptied;
  logic [AddrBits-1:0] link_addr, more_addr;
  logic [shadow_pkg::LinesPerRecord-1:0] from_first;
  shadow_pkg::store_events_t events;

  line_cache #(
    .Width(shadow_pkg::RecordBits), .AddrBits(AddrBits), .Lines(shadow_pkg::RecordLines),
    .Ways(2), .TagBits(shadow_pkg::TagBits), .Fold(1'b0)  // the bucket spreads them
  ) cache (
    .clk_i, .rst_ni, .clear_i(clear_i || (wipe_i && !wiping_q)),
    .hint_valid_i(hint_valid_i || follow_q || reuse_q), .hint_ready_o,
    .hint_addr_i(hint_valid_i ? hint_addr_i : follow_q ? follow_addr_q : free_q),
    .lookup_i(lookup), .lookup_end_i(lookup_end), .lookup_addr_i(lookup_addr),
    .hit_o(hit), .data_o(record),
    .update_i(wiping || (act && write && (!touch || texel_ready_i))), .update_ready_o(record_ready),
    .update_addr_i(wiping ? bump_q : write_addr), .update_data_i(new_record), .idle_o(cache_idle),
    .rd_valid_o, .rd_ready_i, .rd_addr_o, .rd_tag_o, .rsp_valid_i, .rsp_tag_i, .rsp_data_i,
    .wr_valid_o, .wr_ready_i, .wr_addr_o, .wr_data_o
  );

  assign came = rsp_data_i;
  record_update update (
    .record_i(record), .fresh_i(fresh), .unused_i(unused_record || wiping),
    .texel_i({y_q, x_q}), .object_i(tri_i.object), .nearest_i(visit_i.nearest),
    .set_next_i(set_next), .has_next_i(link_has), .next_i(link_addr),
    .set_more_i(set_more), .has_more_i(more_has), .more_i(more_addr),
    .set_nearest_i(set_nearest), .set_corner_i(set_corner && visit_i.corner), .set_vertex_i(set_vertex),
    .append_i(append), .line_i(visit_i.line),
    .remove_i(remove), .from_i(from_first | {shadow_pkg::LinesPerRecord{gap_q && state_q != Begin}}), .refill_i(refill), .last_i(lifted_q),
    .record_o(new_record)
  );

  assign fire   = act && (!write || record_ready) && (!touch || texel_ready_i);
  assign ready_o = state_q == Idle || (fire && last);
  assign lookup      = start_i && ready_o ? kind_i != shadow_pkg::VisitSpan : fire && look && !last;
  assign lookup_end  = fire && last;
  assign lookup_addr = start_i && ready_o ? bucket_i : look_addr;
  assign texel_update_o = act && touch && (!write || record_ready);
  assign emptied_o = fire && emptied;
  assign x_o = x_q;
  assign y_o = y_q;

  // ---- What the record and the texel say --------------------------------------------------------
  logic same_texel, same_entry, match, hidden, nearer, full, wants_hiding;
  logic [DepthBits-1:0] centre, hide_depth;
  logic [DepthBits+1:0] risen;

  silhouette_detector detector (
    .match_polygon_id_i(settings_i.match_polygon_id), .line_i(visit_i.line),
    .lines_i(record.lines), .count_i(record.count), .found_o(match), .from_first_o(from_first)
  );
  assign same_texel = record.used && record.texel == {y_q, x_q};
  assign same_entry = same_texel && record.object == tri_i.object;
  assign nearer     = record.count == '0 || visit_i.nearest < record.nearest;  // of an entry: nearest changes
  assign hidden     = settings_i.hidden_removal == 2'd1 && texel_i.depth < visit_i.nearest;
  assign full       = used_q == settings_i.record_limit;
  assign wants_hiding = settings_i.hidden_removal != 2'd0;

  // The covering polygon's depth that hides lines behind it.
  always_comb begin
    unique case (x_q[1:0])
      2'd0: centre = visit_i.depth0;
      2'd1: centre = visit_i.depth1;
      2'd2: centre = visit_i.depth2;
      default: centre = visit_i.depth3;
    endcase
    if (kind_q == shadow_pkg::VisitEdgesDone) centre = depth_q;
    risen = (DepthBits + 2)'(centre) + (DepthBits + 2)'(tri_i.rise);
    hide_depth = centre;
    if (settings_i.hidden_removal == 2'd2) begin
      hide_depth = risen > (DepthBits + 2)'(tri_i.most) ? tri_i.most : risen[DepthBits-1:0];
    end
  end

  // ---- One step ---------------------------------------------------------------------------------
  logic in_limit; // with one more entry the texel holds no more records than it may
  logic [LimitBits:0] pool_end;
  logic restart;  // Find begins at the bucket's own record
  logic walk;     // Walk does
  logic [Texels-1:0] selected;
  assign texel_select_o = x_q[1:0];
  assign pool_end       = ((LimitBits + 1)'(1) << settings_i.buckets_log2) + (LimitBits + 1)'(settings_i.record_limit);
  assign in_limit       = !more_q && LimitBits'(length_q) < settings_i.chain_limit;
  assign selected       = Texels'(1) << x_q[1:0];

  always_comb begin
    state_d    = state_q;
    x_d        = x_q;
    own_d      = own_q;
    before_d   = before_q;
    prev_d     = prev_q;
    has_prev_d = has_prev_q;
    entry_d    = entry_q;
    head_d     = head_q;
    is_own_d   = is_own_q;
    is_first_d = is_first_q;
    place_d    = place_q;
    push_d     = push_q;
    placed_d   = placed_q;
    seen_d     = seen_q;
    next_d     = next_q;
    has_next_d = has_next_q;
    spot_d     = spot_q;
    for_d      = for_q;
    relink_d   = relink_q;
    settled_d  = settled_q;
    nearer_d   = nearer_q;
    gap_d      = gap_q;
    grown_d    = grown_q;
    storing_d  = storing_q;
    lifted_d   = lifted_q;
    length_d   = length_q;
    more_d     = more_q;
    mode_d     = mode_q;
    kept_d     = kept_q;
    covered_d  = covered_q;
    emptying_d = emptying_q;
    todo_d     = todo_q;
    free_d     = free_q;
    has_free_d = has_free_q;
    bump_d     = bump_q;
    used_d     = used_q;

    act           = hit;
    last          = 1'b0;
    look          = 1'b0;
    look_addr     = own_q;
    write         = 1'b0;
    write_addr    = at_q;
    touch         = 1'b0;
    fresh         = 1'b0;
    unused_record = 1'b0;
    set_next      = 1'b0;
    link_has      = 1'b1;
    link_addr     = spot_q;
    set_more      = 1'b0;
    more_has      = has_free_q;
    more_addr     = free_q;
    set_nearest   = 1'b0;
    set_corner    = 1'b0;
    set_vertex    = 1'b0;
    append        = 1'b0;
    remove        = 1'b0;
    refill        = 1'b0;
    emptied       = 1'b0;
    restart       = 1'b0;
    walk          = 1'b0;
    events        = '0;

    texel_cover_o        = '0;
    texel_depth_o        = {Texels{visit_i.nearest}};
    texel_id_o           = tri_i.object;
    texel_set_edge_o     = 1'b0;
    texel_edge_o         = 1'b0;
    texel_set_overflow_o = 1'b0;

    unique case (state_q)
      Begin: begin
        relink_d   = 1'b0;
        settled_d  = 1'b0;
        gap_d      = 1'b0;
        grown_d    = 1'b0;
        storing_d  = 1'b0;
        emptying_d = 1'b0;
        covered_d  = 1'b0;
        if (kind_q == shadow_pkg::VisitSpan) begin
          act           = texel_hit_i;
          touch         = 1'b1;
          texel_cover_o = visit_i.mask;
          texel_depth_o = {visit_i.depth3, visit_i.depth2, visit_i.depth1, visit_i.depth0};
          todo_d        = wants_hiding ? visit_i.mask & texel_edges_i : '0;
          last          = todo_d == '0;
          state_d       = Spread;
        end else if (kind_q == shadow_pkg::VisitEdgesDone) begin
          act = texel_hit_i && hit;
          if (same_entry ? record.count != '0 : !record.has_next) begin
            last = 1'b1;
          end else if (same_entry && !record.has_next) begin
            write            = 1'b1;
            unused_record    = 1'b1;
            used_d           = used_q - 1'b1;
            touch            = 1'b1;
            texel_set_edge_o = 1'b1;
            texel_cover_o    = record.corner ? selected : '0;
            texel_depth_o    = {Texels{depth_q}};
            events.emptied_covered = record.corner;
            last             = 1'b1;
          end else begin
            restart = 1'b1;
          end
        end else if (texel_hit_i && texel_i.overflow) begin
          act           = 1'b1;
          touch         = 1'b1;
          texel_cover_o = selected;
          events.overflow_lines = 16'd1;
          last          = 1'b1;
        end else begin
          act = texel_hit_i && hit;
          if (!record.used || (same_entry && !record.has_more)) begin
            if (record.used && match) begin
              write      = 1'b1;
              remove     = 1'b1;
              set_corner = 1'b1;
              emptied    = record.count == CountBits'(1);
              events.line_cancelled = 1'b1;
              last       = 1'b1;
            end else if (hidden) begin
              events.lines_hidden = 16'd1;
              last = 1'b1;
            end else if (record.used ? record.count != CountBits'(shadow_pkg::LinesPerRecord)
                                       && !(nearer && record.has_next)
                                     : !full) begin
              write            = 1'b1;
              fresh            = !record.used;
              append           = 1'b1;
              set_corner       = 1'b1;
              set_vertex       = 1'b1;
              set_nearest      = nearer;
              used_d           = record.used ? used_q : used_q + 1'b1;
              touch            = 1'b1;
              texel_set_edge_o = 1'b1;
              texel_edge_o     = 1'b1;
              texel_cover_o    = settings_i.depth_writes_all ? selected : '0;
              events.line_stored = 1'b1;
              last             = 1'b1;
            end else begin
              restart = 1'b1;
            end
          end else begin
            restart = 1'b1;
          end
        end
      end

      Find: begin
        if (!relink_q && same_entry) begin
          entry_d    = at_q;
          is_own_d   = !has_prev_q;
          is_first_d = !seen_q;
          head_d     = 1'b1;
          state_d    = Scan;
          if (kind_q == shadow_pkg::VisitEdgesDone) begin
            last       = record.count != '0;
            covered_d  = record.corner;
            next_d     = record.next;
            has_next_d = record.has_next;
            emptying_d = 1'b1;
            mode_d     = EraseNone;
            state_d    = Erase;
          end
        end else begin
          if (same_texel) begin
            seen_d   = 1'b1;
            length_d = length_q + 1'b1;
            more_d   = more_q || record.has_more;
            if (!placed_q) begin
              if (record.nearest > visit_i.nearest) begin
                placed_d = 1'b1;
                push_d   = !has_prev_q;
                place_d  = prev_q;
              end else begin
                place_d = at_q;
              end
            end
          end
          prev_d     = at_q;
          has_prev_d = 1'b1;
          look       = record.has_next;
          look_addr  = record.next;
          if (!record.has_next) begin
            if (relink_q) begin
              look      = 1'b1;
              look_addr = place_d;
              state_d   = Link;
              if (push_d) begin
                look    = 1'b0;
                for_d   = ForPush;
                state_d = Allocate;
              end
            end else if (kind_q == shadow_pkg::VisitEdgesDone) begin
              last = 1'b1;
            end else if (hidden) begin
              events.lines_hidden = 16'd1;
              last = 1'b1;
            end else if (full) begin
              state_d = Overflow;
            end else begin
              for_d   = ForFresh;
              state_d = Allocate;
            end
          end
        end
      end

      Scan: begin
        if (head_q) begin
          next_d     = record.next;
          has_next_d = record.has_next;
          nearer_d   = nearer;
        end
        if (gap_q || (!settled_q && match)) begin
          if (record.has_more) begin
            before_d  = at_q;
            look      = 1'b1;
            look_addr = record.more;
            state_d   = Lift;
          end else begin
            events.line_cancelled = 1'b1;
            write = 1'b1;
            look  = 1'b1;
            if (head_q) begin
              remove     = 1'b1;
              set_corner = 1'b1;
              emptied    = record.count == CountBits'(1);
              last       = 1'b1;
            end else if (record.count == CountBits'(1)) begin
              set_more   = 1'b1;
              free_d     = at_q;
              has_free_d = 1'b1;
              used_d     = used_q - 1'b1;
              look_addr  = before_q;
              state_d    = Cut;
            end else begin
              remove    = 1'b1;
              look_addr = entry_q;
              state_d   = Mark;
            end
          end
        end else if (record.has_more) begin
          before_d  = at_q;
          head_d    = 1'b0;
          look      = 1'b1;
          look_addr = record.more;
        end else if (!settled_q && hidden) begin
          events.lines_hidden = 16'd1;
          last = 1'b1;
        end else if (!settled_q && nearer_d) begin
          state_d = Nearer;
        end else if (record.count != CountBits'(shadow_pkg::LinesPerRecord)) begin
          write      = 1'b1;
          append     = 1'b1;
          set_corner = head_q;
          set_vertex = head_q;
          storing_d  = 1'b1;
          look       = 1'b1;
          look_addr  = entry_q;
          state_d    = head_q ? Stored : Mark;
        end else if (full) begin
          state_d = Overflow;
        end else begin
          before_d = at_q;
          for_d    = ForExtend;
          state_d  = Allocate;
        end
      end
      Lift: begin
        lifted_d  = record.lines[LineBits-1:0];
        look      = 1'b1;
        look_addr = before_q;
        state_d   = Close;
      end
      Close: begin
        write      = 1'b1;
        remove     = 1'b1;
        refill     = 1'b1;
        before_d   = at_q;
        head_d     = 1'b0;
        gap_d      = 1'b1;
        look       = 1'b1;
        look_addr  = record.more;
        state_d    = Scan;
      end
      Cut: begin
        write     = 1'b1;
        set_more  = 1'b1;
        more_has  = 1'b0;
        look      = 1'b1;
        look_addr = entry_q;
        state_d   = Mark;
      end
      Mark: begin
        write      = 1'b1;
        set_corner = 1'b1;
        set_vertex = storing_q;
        last       = !storing_q;
        state_d    = grown_q ? Length : Stored;
        look       = 1'b1;
      end

      Nearer: begin
        act = 1'b1;
        look    = 1'b1;
        if (!is_first_q) begin
          look_addr = prev_q;
          state_d   = Unlink;
        end else if (!has_next_q) begin
          look_addr = entry_q;
          state_d   = Stay;
        end else begin
          look_addr = next_q;
          state_d   = Behind;
        end
      end
      Behind: begin
        look      = 1'b1;
        look_addr = entry_q;
        state_d   = Stay;
        if (same_texel && visit_i.nearest > record.nearest) begin
          look_addr = prev_q;
          state_d   = Unlink;
          if (is_own_q) begin
            look    = 1'b0;
            for_d   = ForUnlink;
            state_d = Allocate;
          end
        end else if (!same_texel && record.has_next) begin
          look_addr = record.next;
          state_d   = Behind;
        end
      end
      Stay: begin
        write       = 1'b1;
        set_nearest = 1'b1;
        settled_d   = 1'b1;
        head_d      = 1'b1;
        look        = 1'b1;
        look_addr   = entry_q;
        state_d     = Scan;
      end
      Unlink: begin
        write     = 1'b1;
        set_next  = 1'b1;
        link_has  = has_next_q;
        link_addr = next_q;
        relink_d  = 1'b1;
        restart   = 1'b1;
      end
      UnlinkCopy: begin
        write      = 1'b1;
        write_addr = spot_q;
        look       = 1'b1;
        look_addr  = next_q;
        state_d    = UnlinkPull;
      end
      UnlinkPull: begin
        write      = 1'b1;
        write_addr = own_q;
        state_d    = UnlinkFree;
      end
      UnlinkFree: begin
        act        = 1'b1;
        write      = 1'b1;
        write_addr = next_q;
        set_more   = 1'b1;
        free_d     = next_q;
        has_free_d = 1'b1;
        entry_d    = spot_q;
        relink_d   = 1'b1;
        restart    = 1'b1;
      end

      Allocate: begin
        act     = 1'b1;
        spot_d  = bump_q;
        state_d = Allocated;
        // A freed record has to be read: only when the pool has no other.
        if (has_free_q && (LimitBits + 1)'(bump_q) >= pool_end) begin
          look      = 1'b1;
          look_addr = free_q;
          state_d   = Reuse;
        end else begin
          bump_d = bump_q + 1'b1;
        end
      end
      Reuse: begin
        spot_d     = free_q;
        free_d     = record.more;
        has_free_d = record.has_more;
        state_d    = Allocated;
      end
      Allocated: begin
        act  = 1'b1;
        look = 1'b1;
        unique case (for_q)
          ForFresh: begin
            used_d    = used_q + 1'b1;
            look_addr = push_q ? own_q : place_q;
            state_d   = push_q ? Push : Link;
          end
          ForExtend: begin
            used_d  = used_q + 1'b1;
            look    = 1'b0;
            state_d = Extend;
          end
          ForUnlink: state_d = UnlinkCopy;
          default:   state_d = Push;
        endcase
      end

      Link: begin
        write      = 1'b1;
        set_next   = 1'b1;
        link_addr  = relink_q ? entry_q : spot_q;
        next_d     = record.next;
        has_next_d = record.has_next;
        look       = relink_q;
        look_addr  = entry_q;
        state_d    = LinkWrite;
      end
      LinkWrite: begin
        act         = !relink_q || hit;
        write       = 1'b1;
        write_addr  = relink_q ? entry_q : spot_q;
        fresh       = !relink_q;
        set_next    = 1'b1;
        link_has    = has_next_q;
        link_addr   = next_q;
        set_nearest = 1'b1;
        append      = !relink_q;
        set_corner  = !relink_q;
        set_vertex  = !relink_q;
        is_own_d    = 1'b0;
        look        = 1'b1;
        look_addr   = relink_q ? entry_q : own_q;
        state_d     = relink_q ? Scan : in_limit ? Stored : Length;
      end
      Push: begin
        write      = 1'b1;
        write_addr = spot_q;
        look       = relink_q;
        look_addr  = entry_q;
        state_d    = PushWrite;
      end
      PushWrite: begin
        act         = !relink_q || hit;
        write       = 1'b1;
        write_addr  = own_q;
        fresh       = !relink_q;
        set_next    = 1'b1;
        set_nearest = 1'b1;
        append      = !relink_q;
        set_corner  = !relink_q;
        set_vertex  = !relink_q;
        is_own_d    = 1'b1;
        look        = !relink_q;
        state_d     = relink_q ? PushFree : in_limit ? Stored : Length;
      end
      PushFree: begin
        act        = 1'b1;
        write      = 1'b1;
        write_addr = entry_q;
        set_more   = 1'b1;
        free_d     = entry_q;
        has_free_d = 1'b1;
        entry_d    = own_q;
        look       = 1'b1;
        state_d    = Scan;
      end

      Extend: begin
        act        = 1'b1;
        write      = 1'b1;
        write_addr = spot_q;
        fresh      = 1'b1;
        append     = 1'b1;
        look       = 1'b1;
        look_addr  = before_q;
        state_d    = ExtendLink;
      end
      ExtendLink: begin
        write      = 1'b1;
        set_more   = 1'b1;
        more_has   = 1'b1;
        more_addr  = spot_q;
        storing_d  = 1'b1;
        grown_d    = 1'b1;
        look       = 1'b1;
        look_addr  = entry_q;
        state_d    = Mark;
      end

      Length: begin
        if (same_texel) length_d = length_q + 1'b1;
        next_d     = record.next;
        has_next_d = record.has_next;
        look       = 1'b1;
        look_addr  = record.next;
        if (same_texel && record.has_more) begin
          look_addr = record.more;
          state_d   = LengthMore;
        end else if (!record.has_next) begin
          look    = 1'b0;
          state_d = Judge;
        end
        // No texel holds more records than there are.
        if (used_q <= settings_i.chain_limit) state_d = Stored;
      end
      LengthMore: begin
        length_d  = length_q + 1'b1;
        look      = 1'b1;
        look_addr = record.more;
        if (!record.has_more) begin
          look      = has_next_q;
          look_addr = next_q;
          state_d   = has_next_q ? Length : Judge;
        end
      end
      Judge: begin
        act     = 1'b1;
        state_d = LimitBits'(length_q) > settings_i.chain_limit ? Overflow : Stored;
        storing_d = 1'b1;
      end
      Stored: begin
        act              = texel_hit_i;
        touch            = 1'b1;
        texel_set_edge_o = 1'b1;
        texel_edge_o     = 1'b1;
        texel_cover_o    = settings_i.depth_writes_all ? selected : '0;
        events.line_stored = 1'b1;
        last             = 1'b1;
      end

      Overflow: begin
        act                  = texel_hit_i;
        touch                = 1'b1;
        texel_cover_o        = selected;
        texel_set_edge_o     = 1'b1;
        texel_set_overflow_o = 1'b1;
        events.overflow_texel = 1'b1;
        events.overflow_lines = storing_q ? 16'd0 : 16'd1;
        mode_d               = EraseAll;
        walk                 = 1'b1;
      end
      Walk: begin
        act        = hit && texel_hit_i;
        next_d     = record.next;
        has_next_d = record.has_next;
        if (same_texel && (mode_q == EraseAll || (mode_q == EraseHidden && hide_depth < record.nearest))) begin
          touch         = mode_q == EraseAll;
          texel_cover_o = selected;
          texel_depth_o = {Texels{record.nearest}};
          texel_id_o    = record.object;
          head_d        = 1'b1;
          state_d       = Erase;
        end else begin
          if (same_texel) kept_d = 1'b1;
          prev_d     = at_q;
          has_prev_d = 1'b1;
          look       = record.has_next;
          look_addr  = record.next;
          if (!record.has_next) state_d = Walked;
        end
      end
      Erase: begin
        used_d = used_q - 1'b1;
        if (mode_q == EraseAll) events.overflow_lines = 16'(record.count);
        else events.lines_hidden = 16'(record.count);
        if (head_q) before_d = has_prev_q ? at_q : record.more;
        head_d = 1'b0;
        look   = 1'b1;
        if (record.has_more) begin
          look_addr = record.more;
        end else begin
          // The bucket's own record does not go to the pool, but its continuations do.
          if (!head_q || has_prev_q) begin
            write      = 1'b1;
            set_more   = 1'b1;
            free_d     = before_d;
            has_free_d = 1'b1;
          end
          look_addr = has_prev_q ? prev_q : next_q;
          look      = has_prev_q || has_next_q;
          state_d   = EraseLink;
        end
      end
      EraseLink: begin
        act   = hit || !(has_prev_q || has_next_q);
        write = 1'b1;
        if (has_prev_q) begin
          set_next  = 1'b1;
          link_has  = has_next_q;
          link_addr = next_q;
          look      = has_next_q;
          look_addr = next_q;
          state_d   = has_next_q ? Walk : Walked;
          walk      = emptying_q;
        end else if (has_next_q) begin
          write_addr = own_q;
          state_d    = EraseFree;
        end else begin
          write_addr    = own_q;
          unused_record = 1'b1;
          state_d       = Walked;
        end
      end
      EraseFree: begin
        act        = 1'b1;
        write      = 1'b1;
        write_addr = next_q;
        set_more   = 1'b1;
        free_d     = next_q;
        has_free_d = 1'b1;
        walk       = 1'b1;
      end
      Walked: begin
        act     = texel_hit_i;
        last    = todo_q == '0 || kind_q != shadow_pkg::VisitSpan;
        state_d = Spread;
        if (mode_q != EraseAll) begin
          touch            = 1'b1;
          texel_set_edge_o = 1'b1;
          texel_edge_o     = kept_q;
          texel_cover_o    = covered_q ? selected : '0;
          texel_depth_o    = {Texels{depth_q}};
          events.emptied_covered = covered_q;
        end
      end
      Spread: begin
        act = 1'b1;
        if (todo_q[x_q[1:0]]) begin
          todo_d = todo_q & ~selected;
          mode_d = EraseHidden;
          walk   = 1'b1;
        end else begin
          // The next texel's bucket is the next one: (x + 181 y) mod the buckets.
          x_d[1:0] = x_q[1:0] + 1'b1;
          own_d    = (own_q + 1'b1) & ~({AddrBits{1'b1}} << settings_i.buckets_log2);
        end
      end
      default: act = 1'b0;
    endcase

    if (restart) begin
      look       = 1'b1;
      look_addr  = own_q;
      has_prev_d = 1'b0;
      place_d    = own_q;
      push_d     = 1'b0;
      placed_d   = 1'b0;
      seen_d     = 1'b0;
      length_d   = '0;
      more_d     = 1'b0;
      state_d    = Find;
    end
    if (walk) begin
      look       = 1'b1;
      look_addr  = own_q;
      has_prev_d = 1'b0;
      kept_d     = 1'b0;
      if (emptying_q) mode_d = covered_q && wants_hiding ? EraseHidden : EraseNone;
      emptying_d = 1'b0;
      state_d    = Walk;
    end
    if (state_d == Length && state_q != Length && state_q != LengthMore) begin
      length_d  = '0;
      look_addr = own_q;
    end
    if (state_d == Scan && relink_q) begin
      relink_d  = 1'b0;
      settled_d = 1'b1;
      head_d    = 1'b1;
    end
    if (last) state_d = Idle;
  end

  // ---- Registers --------------------------------------------------------------------------------
  // The buckets' own records are the first ones, so that wiping ends where the pool begins.
  assign wiping  = wiping_q && !bump_q[settings_i.buckets_log2];
  assign wiped_o = wipe_i && wiping_q && !wiping && cache_idle;
  assign idle_o  = state_q == Idle && !wiping && cache_idle;
  assign records_o = used_q;
  assign events_o  = fire ? events : '0;

  always_comb begin
    cause_o = shadow_pkg::StoreChain;
    if (fire && last) begin
      cause_o = kind_q == shadow_pkg::VisitEdge ? shadow_pkg::StoreEdge
              : kind_q == shadow_pkg::VisitSpan ? shadow_pkg::StoreSpan : shadow_pkg::StoreOther;
    end else if (act && !fire) begin
      cause_o = shadow_pkg::StoreWrite;
    end else if (state_q == Begin && !act) begin
      cause_o = texel_hit_i ? shadow_pkg::StoreRecord : shadow_pkg::StoreTexel;
    end
  end

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      state_q    <= Idle;
      wiping_q   <= 1'b0;
      has_free_q <= 1'b0;
      follow_q   <= 1'b0;
      reuse_q    <= 1'b0;
      used_q     <= '0;
    end else begin
      wiping_q <= wipe_i && !clear_i;
      if (clear_i || (wipe_i && !wiping_q)) begin
        state_q    <= Idle;
        has_free_q <= 1'b0;
        follow_q   <= 1'b0;
        reuse_q    <= 1'b0;
        used_q     <= '0;
      end else begin
        if (start_i && ready_o) state_q <= Begin;
        else if (fire) state_q <= state_d;
        if (fire && state_q == Reuse) reuse_q <= record.has_more;
        else if (hint_ready_o && !hint_valid_i && !follow_q) reuse_q <= 1'b0;
        if (rsp_valid_i && (came.has_next || came.has_more)) follow_q <= 1'b1;
        else if (hint_ready_o && !hint_valid_i) follow_q <= 1'b0;
        if (fire) begin
          has_free_q <= has_free_d;
          used_q     <= used_d;
        end
      end
      `CHECK(within_capacity, used_q <= settings_i.record_limit || !fire)
      `CHECK(nothing_while_wiping, !wipe_i || state_q == Idle)
      `CHECK(links_before_used, !(fire && write) || hit || fresh || set_more || unused_record)
    end
  end

  always_ff @(posedge clk_i) begin
    if (!wiping_q) bump_q <= wipe_i ? '0 : fire ? bump_d : bump_q;
    else if (wiping && record_ready) bump_q <= bump_q + 1'b1;
    if (lookup) at_q <= lookup_addr;
    if (rsp_valid_i && (came.has_next || came.has_more)) follow_addr_q <= came.has_next ? came.next : came.more;
    if (start_i && ready_o) begin
      kind_q  <= kind_i;
      y_q     <= y_i;
      depth_q <= depth_i;
    end
    if (start_i && ready_o) begin
      x_q   <= x_i;
      own_q <= bucket_i;
    end else if (fire) begin
      x_q   <= x_d;
      own_q <= own_d;
    end
    if (fire) begin
      before_q   <= before_d;
      prev_q     <= prev_d;
      has_prev_q <= has_prev_d;
      entry_q    <= entry_d;
      head_q     <= head_d;
      is_own_q   <= is_own_d;
      is_first_q <= is_first_d;
      place_q    <= place_d;
      push_q     <= push_d;
      placed_q   <= placed_d;
      seen_q     <= seen_d;
      next_q     <= next_d;
      has_next_q <= has_next_d;
      spot_q     <= spot_d;
      for_q      <= for_d;
      relink_q   <= relink_d;
      settled_q  <= settled_d;
      nearer_q   <= nearer_d;
      gap_q      <= gap_d;
      grown_q    <= grown_d;
      storing_q  <= storing_d;
      lifted_q   <= lifted_d;
      length_q   <= length_d;
      more_q     <= more_d;
      mode_q     <= mode_d;
      kept_q     <= kept_d;
      covered_q  <= covered_d;
      emptying_q <= emptying_d;
      todo_q     <= todo_d;
      free_q     <= free_d;
    end
  end

  logic unused;
  assign unused = &{1'b0, visit_i.kind, visit_i.x, visit_i.y, settings_i, texel_i, came};
endmodule

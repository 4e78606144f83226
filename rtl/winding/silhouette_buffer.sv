// Silhouette buffer: carries out what a visit, or the end of pass 1, does to a texel with a list of clusters, or
// that gets one.
//
// Twins:   model/unit/winding/shadow_unit_store.cpp (hidden, find, open_list, add, cover, drop_hidden, overflow),
//          shadow_unit_pass2.cpp (settle_texel), silhouette_buffer.cpp
// Numbers: records in use and limits as the golden records_.
// Timing:  start_i in a cycle of ready_o; done_o two cycles later for a plane that is new to the texel, or a segment
//          that the first record has room for. Everything else walks the list (docs/rtl.md, what a visit costs).
//
// A walk reads the records of the list one after the other; `mode` says what it does with them. What becomes of the
// cluster of the visit's plane is cluster_update's, which records are free is record_pool's.
`include "check.svh"
module silhouette_buffer (
  input  logic                                  clk_i,
  input  logic                                  rst_ni,
  input  logic                                  clear_i,       // also a new frame: no record is in use
  input  logic                                  paper_i,       // settings_t.paper_semantics
  input  logic [shadow_pkg::LimitBits-1:0]      record_limit_i,
  input  logic [shadow_pkg::LimitBits-1:0]      chain_limit_i,
  // the texel and what happens to it; held from start_i to done_o
  input  logic                                  start_i,
  output logic                                  ready_o,
  input  logic                                  settle_i,      // end of pass 1; the texel has a list
  input  logic                                  span_i,        // the facet covers the texel; else a visit of an edge
  input  logic                                  corner_i,
  input  logic                                  has_segment_i,
  input  logic [shadow_pkg::SegmentBits-1:0]    segment_i,
  input  logic [shadow_pkg::ThresholdBits-1:0]  threshold_i,   // threshold_t of the visit
  input  logic                                  steep_i,       // of its plane
  input  logic [26:0]                           half_i,
  input  logic [shadow_pkg::IdBits-1:0]         object_i,
  input  logic [shadow_pkg::TexelBits-1:0]      texel_i,       // texel_t
  input  logic                                  texel_steep_i, // of its plane, if it is one
  input  logic [26:0]                           texel_half_i,
  output logic                                  done_o,
  output logic                                  changed_o,     // the texel is now texel_o
  output logic [shadow_pkg::TexelBits-1:0]      texel_o,
  output logic                                  texel_steep_o, // of its plane, if it is one
  output logic [26:0]                           texel_half_o,
  // records, in line_cache
  output logic                                  lookup_o,
  output logic [shadow_pkg::RecordAddrBits-1:0] lookup_addr_o,
  input  logic                                  hit_i,
  input  logic [shadow_pkg::RecordBits-1:0]     record_i,
  output logic                                  update_o,
  input  logic                                  update_ready_i,
  output logic [shadow_pkg::RecordAddrBits-1:0] update_addr_o,
  output logic [shadow_pkg::RecordBits-1:0]     update_record_o,
  output logic [3:0]                            cause_o,       // of a cycle between start_i and done_o
  output logic [shadow_pkg::LimitBits-1:0]      records_o,     // in use
  // events
  output logic                                  hidden_o,
  output logic                                  line_stored_o,
  output logic                                  line_cancelled_o,
  output logic                                  emptied_covered_o,
  output logic [15:0]                           lines_hidden_o,
  output logic [15:0]                           overflow_lines_o,
  output logic                                  overflow_texel_o
);
  localparam int unsigned A = shadow_pkg::RecordAddrBits;
  localparam int unsigned S = shadow_pkg::SegmentBits;
  localparam int unsigned CountBits = shadow_pkg::SegmentCountBits;
  localparam int unsigned LimitBits = shadow_pkg::LimitBits;

  localparam logic [3:0] Idle = 4'd0, Take = 4'd1, Taken = 4'd2, Check = 4'd3, Walk = 4'd4, Open = 4'd5,
                         Insert = 4'd6, Work = 4'd7, Erase = 4'd8, Link = 4'd9, Last = 4'd10, Spill = 4'd11,
                         Keep = 4'd12, Done = 4'd13;
  // Find: the visit's cluster. Covers, CoversDrop: the nearest end of a cover of another object than the texel's.
  // Drop: clusters that are hidden. Settle: those without segments. Free: all. Count: records.
  localparam logic [2:0] Find = 3'd0, Covers = 3'd1, CoversDrop = 3'd2, Drop = 3'd3, Settle = 3'd4, Free = 3'd5,
                         Count = 3'd6;
  logic [3:0] state_d, state_q;
  logic [2:0] mode_d, mode_q;
  logic       insert_d, insert_q;  // after Take: Insert, else Check

  // ---- The texel --------------------------------------------------------------------------------
  shadow_pkg::texel_t      texel_in;
  shadow_pkg::texel_list_t texel_list;
  shadow_pkg::threshold_t  texel_plane;
  logic [shadow_pkg::BaseBits-1:0] base;  // of the visit
  logic [1:0]   kind_d, kind_q;
  logic         covered_d, covered_q, bare_d, bare_q, changed_d, changed_q;
  logic [shadow_pkg::IdBits-1:0] object_d, object_q;  // of the cover
  logic [31:0]  depth_d, depth_q;                     // signed; not covered: marks
  logic [31:0]  mark;                                 // of the visit's plane
  logic [A-1:0] first_d, first_q;
  assign texel_in    = texel_i;
  assign texel_list  = texel_in.word[shadow_pkg::ListBits-1:0];
  assign texel_plane = texel_in.word[shadow_pkg::ThresholdBits-1:0];
  assign base        = threshold_i[shadow_pkg::ThresholdBits-1-:shadow_pkg::BaseBits];
  // A list without the mark has no cluster of the plane.
  logic [4:0] mark_number;
  always_comb begin
    mark_number = '0;
    for (int i = 0; i < shadow_pkg::ThresholdBits; i++) mark_number[i%5] = mark_number[i%5] ^ threshold_i[i];
    for (int i = 0; i < shadow_pkg::IdBits; i++) mark_number[i%5] = mark_number[i%5] ^ object_i[i];
  end
  assign mark = 32'd1 << mark_number;

  // ---- Records ----------------------------------------------------------------------------------
  shadow_pkg::record_t record, update;
  logic [A-1:0] at_q, prev_d, prev_q, chain_d, chain_q, next_d, next_q, spare, free, put_addr;
  logic         prev_valid_d, prev_valid_q, next_valid_d, next_valid_q, continued_d, continued_q;
  logic         spare_ready, free_valid, given, released, put, take;
  logic [LimitBits-1:0] used, count_d, count_q;
  logic [31:0]          other_d, other_q;  // nearest end of a cover of another object
  logic                 seen_q, bounded, there, written, full_memory, may_be_long, absent;
  assign record     = record_i;
  assign written    = update_o && update_ready_i;
  assign may_be_long = used > chain_limit_i;
  // Nor can the list be too long.
  assign absent     = !texel_list.covered && (texel_list.cover_depth & mark) == '0 && used < chain_limit_i;

  // ---- Depths -----------------------------------------------------------------------------------
  logic [31:0] visit_nearest, visit_farthest, nearest, farthest, nearest_q, farthest_q, cover_nearest, cover_farthest;
  logic        steep;
  logic [26:0] half;
  plane_bounds visit_bounds (
    .base_i(base), .steep_i, .half_i, .nearest_o(visit_nearest), .farthest_o(visit_farthest)
  );
  plane_steepness steepness (
    .gradient_x_i(record.threshold.gradient_x), .gradient_y_i(record.threshold.gradient_y),
    .steep_o(steep), .half_o(half)
  );
  plane_bounds record_bounds (
    .base_i(record.threshold.base), .steep_i(steep), .half_i(half), .nearest_o(nearest), .farthest_o(farthest)
  );
  plane_bounds cover_bounds (
    .base_i(texel_plane.base), .steep_i(texel_steep_i), .half_i(texel_half_i),
    .nearest_o(cover_nearest), .farthest_o(cover_farthest)
  );
  // At the centre.
  function automatic logic [31:0] depth_of(input logic [shadow_pkg::BaseBits-1:0] steps);
    depth_of = {steps[shadow_pkg::BaseBits-1], steps, {shadow_pkg::PlaneStepBits{1'b0}}};
  endfunction
  function automatic logic nearer(input logic [31:0] a, input logic [31:0] b);
    nearer = $signed(a) < $signed(b);
  endfunction

  logic same_plane, hides, lacks_segments, nothing;
  assign same_plane = record.threshold == threshold_i && record.object == object_i;
  assign hides      = covered_q && !nearer(nearest_q, depth_q)
                      && (!paper_i || record.object == object_q || !nearer(nearest_q, other_q));
  assign lacks_segments = !record.full && record.count == '0;
  assign nothing    = !span_i && !corner_i && !has_segment_i;

  // ---- The visit's cluster ----------------------------------------------------------------------
  logic [A-1:0] work_lookup_addr, work_update_addr, work_put_addr;
  logic         work_lookup, work_update, work_given, work_released, work_put;
  logic         work_done, work_ends, work_covers, work_grown, work_spills, work_bare, work_stored, work_cancelled;
  logic [shadow_pkg::RecordBits-1:0] work_record;
  cluster_update cluster_update (
    .clk_i, .rst_ni, .clear_i, .work_i(state_q == Work),
    .span_i, .corner_i, .has_segment_i, .segment_i, .threshold_i, .object_i,
    .hit_i, .at_i(at_q), .record_i, .lookup_o(work_lookup), .lookup_addr_o(work_lookup_addr),
    .update_o(work_update), .update_ready_i, .update_addr_o(work_update_addr), .update_record_o(work_record),
    .full_memory_i(full_memory), .may_be_long_i(may_be_long), .spare_i(spare), .free_i(free), .free_valid_i(free_valid),
    .given_o(work_given), .released_o(work_released), .put_o(work_put), .put_addr_o(work_put_addr),
    .done_o(work_done), .ends_o(work_ends), .covers_o(work_covers), .grown_o(work_grown), .spills_o(work_spills),
    .bare_o(work_bare), .line_stored_o(work_stored), .line_cancelled_o(work_cancelled)
  );
  record_pool record_pool (
    .clk_i, .rst_ni, .clear_i, .record_limit_i, .given_i(given), .released_i(released),
    .put_i(put), .put_addr_i(put_addr), .take_i(take), .take_next_i(record.next), .take_has_next_i(record.has_next),
    .spare_o(spare), .spare_ready_o(spare_ready), .free_o(free), .free_valid_o(free_valid),
    .full_o(full_memory), .used_o(used)
  );

  // Bounds take a cycle of their own.
  assign bounded = state_q == Walk && (mode_q == Covers || mode_q == CoversDrop || mode_q == Drop || mode_q == Settle);
  assign there   = hit_i && (!bounded || seen_q);

  logic ends;       // the walk is at its end
  logic take_drop;  // clusters that are hidden go next
  logic note;       // a full cluster that ends at note_depth: is it the texel's cover?
  logic note_centre;  // an overflow keeps the nearest depth
  logic [31:0] note_depth;
  logic [shadow_pkg::IdBits-1:0] note_object;

  always_comb begin
    state_d = state_q; mode_d = mode_q; insert_d = insert_q;
    kind_d = kind_q; covered_d = covered_q; bare_d = bare_q; object_d = object_q; depth_d = depth_q; first_d = first_q;
    changed_d = changed_q;
    prev_d = prev_q; prev_valid_d = prev_valid_q; chain_d = chain_q;
    next_d = next_q; next_valid_d = next_valid_q; continued_d = continued_q;
    count_d = count_q; other_d = other_q;
    lookup_o = 1'b0; lookup_addr_o = record.next;
    update_o = 1'b0; update_addr_o = at_q; update = record;
    ends = 1'b0; take_drop = 1'b0; note = 1'b0; note_centre = 1'b0;
    note_depth = visit_farthest; note_object = object_i;
    given = 1'b0; released = 1'b0; put = 1'b0; put_addr = at_q; take = 1'b0;
    hidden_o = 1'b0; line_stored_o = 1'b0; line_cancelled_o = 1'b0; emptied_covered_o = 1'b0;
    lines_hidden_o = '0; overflow_lines_o = '0; overflow_texel_o = 1'b0;

    case (state_q)
      Idle: if (start_i) begin
        kind_d = texel_in.kind; object_d = texel_in.object;
        covered_d = texel_list.covered; depth_d = texel_list.cover_depth; first_d = texel_list.first;
        changed_d = 1'b0; insert_d = 1'b0; count_d = '0; continued_d = 1'b0;
        bare_d  = texel_in.kind == shadow_pkg::TexelList && texel_list.bare;
        mode_d  = Find;
        state_d = Check;
        if (!spare_ready) begin
          state_d = Take;
        end else begin
          case (texel_in.kind)
            shadow_pkg::TexelEmpty:    state_d = Insert;
            shadow_pkg::TexelPlane:    state_d = Open;
            shadow_pkg::TexelOverflow: state_d = Keep;
            shadow_pkg::TexelList: begin
              lookup_addr_o = texel_list.first;
              lookup_o      = settle_i || !absent;
              if (!settle_i && !texel_list.covered && !nothing) state_d = absent ? Insert : Walk;
            end
          endcase
        end
      end

      // ---- A spare record ------------------------------------------------------------------------
      Take: begin
        state_d = insert_q ? Insert : Check;
        if (!spare_ready && free_valid) begin
          lookup_o      = 1'b1;
          lookup_addr_o = free;
          state_d       = Taken;
        end
      end
      Taken: if (there) begin
        take    = 1'b1;
        state_d = insert_q ? Insert : Check;
      end

      // ---- What the texel calls for ----------------------------------------------------------------
      Check: begin
        lookup_addr_o = first_q;
        continued_d   = 1'b0;
        case (kind_q)
          shadow_pkg::TexelEmpty: state_d = Insert;
          shadow_pkg::TexelPlane: state_d = Open;
          shadow_pkg::TexelOverflow: state_d = Keep;
          shadow_pkg::TexelList: begin
            lookup_o = 1'b1;
            state_d  = Walk;
            mode_d   = Find;
            other_d  = 32'h7fff_ffff;
            if (settle_i) begin
              mode_d       = Settle;
              prev_valid_d = 1'b0;
            end else if (covered_q && !nearer(visit_nearest, depth_q)) begin
              mode_d = Covers;
              if (!paper_i || object_q == object_i) begin
                lookup_o = 1'b0;
                hidden_o = 1'b1;
                state_d  = Done;
              end
            end else if (nothing) begin
              lookup_o = 1'b0;
              state_d  = Done;
            end
          end
        endcase
      end
      // The cover becomes a cluster.
      Open: if (full_memory) begin
        state_d = Spill;
      end else begin
        update_o         = 1'b1;
        update_addr_o    = spare;
        update           = '0;
        update.threshold = texel_plane;
        update.object    = object_q;
        update.full      = 1'b1;
        if (written) begin
          given     = 1'b1;
          first_d   = spare;
          kind_d    = shadow_pkg::TexelList;
          covered_d = 1'b1;
          depth_d   = cover_farthest;
          changed_d = 1'b1;
          count_d   = LimitBits'(1);
          insert_d  = 1'b1;
          state_d   = Take;
        end
      end
      // A cluster of the visit's plane, in front.
      Insert: if (count_q >= chain_limit_i || full_memory) begin
        state_d = Spill;
      end else begin
        update_o         = 1'b1;
        update_addr_o    = spare;
        update           = '0;
        update.threshold = threshold_i;
        update.object    = object_i;
        update.corner    = shadow_pkg::CornerBits'(corner_i && !span_i);
        update.full      = span_i;
        update.count     = CountBits'(has_segment_i && !span_i);
        update.segments[S-1:0] = segment_i;
        update.has_next  = kind_q == shadow_pkg::TexelList;
        update.next      = first_q;
        if (written) begin
          given     = 1'b1;
          first_d   = spare;
          if (kind_q == shadow_pkg::TexelEmpty) covered_d = 1'b0;
          if (kind_q == shadow_pkg::TexelEmpty) depth_d = mark;
          else if (!covered_q) depth_d = depth_q | mark;
          if (!span_i && !has_segment_i) bare_d = 1'b1;
          kind_d    = shadow_pkg::TexelList;
          changed_d = 1'b1;
          state_d   = Done;
          line_stored_o = has_segment_i && !span_i;
          note      = span_i;
          take_drop = span_i;
        end
      end

      // ---- Walks -------------------------------------------------------------------------------------
      Walk: if (there) begin
        case (mode_q)
          Find: begin
            count_d = count_q + 1'b1;
            if (!continued_q && same_plane) state_d = Work;
            else ends = 1'b1;
          end
          Covers, CoversDrop: begin
            if (!continued_q && record.full && record.object != object_q && nearer(farthest_q, other_q)) begin
              other_d = farthest_q;
            end
            ends = 1'b1;
          end
          Drop, Settle: begin
            chain_d = at_q;
            if (!continued_q && (mode_q == Drop ? hides : lacks_segments && record.corner == '0)) begin
              state_d = Erase;
            end else if (mode_q == Settle && !continued_q && lacks_segments) begin
              update_o      = 1'b1;
              update.full   = 1'b1;
              update.corner = '0;
              note_depth    = farthest_q;
              note_object   = record.object;
              note          = written;
              emptied_covered_o = written;
              ends          = written;
            end else begin
              ends = 1'b1;
            end
            if (ends) begin
              prev_d       = at_q;
              prev_valid_d = 1'b1;
            end
          end
          Free: begin
            ends = 1'b1;
            if (!record.has_next) begin
              update_o        = 1'b1;
              update.next     = free;
              update.has_next = free_valid;
              update.goes_on  = 1'b0;
              ends            = written;
            end
            if (ends) begin
              released         = 1'b1;
              overflow_lines_o = 16'(record.count);
              note_centre      = !continued_q;
              note_depth       = depth_of(record.threshold.base);
              note_object      = record.object;
            end
          end
          default: begin  // Count
            count_d = count_q + 1'b1;
            ends    = 1'b1;
          end
        endcase
        if (ends && record.has_next) begin
          ends        = 1'b0;
          lookup_o    = 1'b1;
          continued_d = record.goes_on;
        end
      end
      // The cluster goes, its records from chain_q on. Those of an earlier one are linked to what follows.
      Erase: if (there) begin
        if (mode_q == Drop) lines_hidden_o = 16'(record.count);
        if (record.goes_on) begin
          released = 1'b1;
          lookup_o = 1'b1;
        end else begin
          lines_hidden_o  = mode_q == Drop && written ? 16'(record.count) : '0;
          update_o        = 1'b1;
          update.next     = free;
          update.has_next = free_valid;
          if (written) begin
            released      = 1'b1;
            put             = 1'b1;
            put_addr   = chain_q;
            next_d        = record.next;
            next_valid_d  = record.has_next;
            continued_d   = 1'b0;
            lookup_o      = prev_valid_q || record.has_next;
            lookup_addr_o = prev_valid_q ? prev_q : record.next;
            state_d       = prev_valid_q ? Link : Walk;
            if (!prev_valid_q) begin
              first_d   = record.next;
              changed_d = 1'b1;
              if (!record.has_next) begin
                kind_d  = shadow_pkg::TexelEmpty;
                state_d = Done;
              end
            end
          end
        end
      end
      Link: if (there) begin
        update_o        = 1'b1;
        update.next     = next_q;
        update.has_next = next_valid_q;
        if (written) begin
          state_d       = Walk;
          lookup_o      = next_valid_q;
          lookup_addr_o = next_q;
          ends          = !next_valid_q;
        end
      end
      // A cover alone needs no record.
      Last: if (there) begin
        state_d = Done;
        if (record.full && !record.has_next) begin
          update_o        = 1'b1;
          update.next     = free;
          update.has_next = free_valid;
          state_d         = Last;
          if (written) begin
            released     = 1'b1;
            put            = 1'b1;
            put_addr  = at_q;
            state_d      = Idle;
          end
        end
      end

      // ---- The visit's cluster: cluster_update ---------------------------------------------------
      Work: begin
        lookup_o      = work_lookup;
        lookup_addr_o = work_lookup_addr;
        update_o      = work_update;
        update_addr_o = work_update_addr;
        update        = work_record;
        given         = work_given;
        released      = work_released;
        put           = work_put;
        put_addr      = work_put_addr;
        note          = work_covers;
        take_drop     = work_covers;
        line_stored_o    = work_stored;
        line_cancelled_o = work_cancelled;
        if (work_bare) begin
          bare_d    = 1'b1;
          changed_d = changed_q || !bare_q;
        end
        if (work_done) state_d = Done;
        if (work_ends) state_d = Idle;
        if (work_spills) state_d = Spill;
        if (work_grown) begin  // is the list too long now?
          state_d       = Walk;
          mode_d        = Count;
          count_d       = '0;
          continued_d   = 1'b0;
          lookup_o      = 1'b1;
          lookup_addr_o = first_q;
        end
      end

      // ---- No room: the texel keeps the nearest depth ------------------------------------------------
      Spill: begin
        overflow_texel_o = 1'b1;
        changed_d        = 1'b1;
        covered_d        = kind_q == shadow_pkg::TexelPlane;
        depth_d          = depth_of(texel_plane.base);
        kind_d           = shadow_pkg::TexelOverflow;
        state_d          = Keep;
        if (kind_q == shadow_pkg::TexelList) begin
          kind_d        = shadow_pkg::TexelList;
          state_d       = Walk;
          mode_d        = Free;
          continued_d   = 1'b0;
          lookup_o      = 1'b1;
          lookup_addr_o = first_q;
        end
      end
      Keep: begin
        overflow_lines_o = 16'd1;
        note_centre      = 1'b1;
        note_depth       = depth_of(base);
        state_d          = Done;
      end
      Done: state_d = Idle;
      default: state_d = Idle;
    endcase

    if (note || note_centre) begin
      if (!covered_q || nearer(note_depth, depth_q)) begin
        covered_d = 1'b1;
        depth_d   = note_depth;
        object_d  = note_object;
        changed_d = 1'b1;
      end
    end
    if (ends) begin
      lookup_addr_o = first_q;
      continued_d   = 1'b0;
      case (mode_q)
        Find: state_d = Insert;
        Covers: begin
          mode_d = Find;
          if (!nearer(visit_nearest, other_d)) begin
            hidden_o = 1'b1;
            state_d  = Done;
          end else if (nothing) begin
            state_d = Done;
          end else begin
            lookup_o = 1'b1;
          end
        end
        CoversDrop: begin
          mode_d       = Drop;
          prev_valid_d = 1'b0;
          lookup_o     = 1'b1;
        end
        Drop: begin
          state_d  = Last;
          lookup_o = 1'b1;
        end
        Settle: begin
          state_d   = Done;
          take_drop = covered_d;
          bare_d    = 1'b0;
        end
        Free: begin
          put            = 1'b1;
          put_addr  = first_q;
          kind_d       = shadow_pkg::TexelOverflow;
          state_d      = Keep;
        end
        default: begin  // Count
          state_d       = count_d > chain_limit_i ? Spill : Done;
          line_stored_o = count_d <= chain_limit_i;
        end
      endcase
    end
    if (take_drop) begin
      lookup_o      = 1'b1;
      lookup_addr_o = first_d;
      continued_d   = 1'b0;
      prev_valid_d  = 1'b0;
      other_d       = 32'h7fff_ffff;
      mode_d        = paper_i ? CoversDrop : Drop;
      state_d       = Walk;
    end
  end

  // ---- The texel as it becomes ------------------------------------------------------------------
  shadow_pkg::texel_t      result;
  shadow_pkg::texel_list_t result_list;
  always_comb begin
    result_list.covered     = covered_q;
    result_list.bare        = bare_q;
    result_list.cover_depth = depth_q;
    result_list.first       = first_q;
    result.kind   = kind_q;
    result.object = object_q;
    result.word   = shadow_pkg::WordBits'(result_list);
    if (state_q == Last) begin
      result.kind   = shadow_pkg::TexelPlane;
      result.object = record.object;
      result.word   = shadow_pkg::WordBits'(record.threshold);
    end
  end
  assign texel_o   = result;
  assign texel_steep_o = steep;
  assign texel_half_o  = half;
  assign ready_o   = state_q == Idle;
  assign done_o    = state_q != Idle && state_d == Idle;
  assign changed_o = changed_q || state_q == Last;
  assign update_record_o = update;
  assign records_o = used;
  always_comb begin
    cause_o = shadow_pkg::StoreChain;
    if (update_o && !update_ready_i) cause_o = shadow_pkg::StoreWrite;
    else if (state_q == Walk && at_q == first_q && !hit_i) cause_o = shadow_pkg::StoreRecord;
  end

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      state_q <= Idle;
    end else begin
      state_q <= clear_i ? Idle : state_d;
      `CHECK(starts_when_ready, !start_i || ready_o)
      `CHECK(settles_lists, !(start_i && settle_i) || texel_in.kind == shadow_pkg::TexelList)
    end
  end

  always_ff @(posedge clk_i) begin
    mode_q <= mode_d; insert_q <= insert_d;
    kind_q <= kind_d; covered_q <= covered_d; bare_q <= bare_d; object_q <= object_d; depth_q <= depth_d; first_q <= first_d;
    changed_q <= changed_d;
    prev_q <= prev_d; prev_valid_q <= prev_valid_d; chain_q <= chain_d;
    next_q <= next_d; next_valid_q <= next_valid_d; continued_q <= continued_d;
    count_q <= count_d; other_q <= other_d;
    nearest_q <= nearest; farthest_q <= farthest;
    seen_q <= hit_i && !lookup_o;
    if (lookup_o) at_q <= lookup_addr_o;
  end

  // A cover's nearest depth plays no part once it is in a list.
  logic unused;
  assign unused = ^cover_nearest;
endmodule

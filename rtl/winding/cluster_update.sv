// Cluster update: what a visit does to the cluster of its plane.
//
// Twins:   model/unit/winding/silhouette_buffer.cpp (add, drop_segments), shadow_unit_store.cpp (add, cover)
// Numbers: a cluster's first record is the one that is not full; the records behind it are: so a segment is added,
//          and the last one taken away, at the first.
// Timing:  from the cycle on in which the cluster's first record was found; a record is read or written in a cycle.
`include "check.svh"
module cluster_update (
  input  logic                                  clk_i,
  input  logic                                  rst_ni,
  input  logic                                  clear_i,
  input  logic                                  work_i,         // from the found record on, until one of the ends
  // the visit
  input  logic                                  span_i,
  input  logic                                  corner_i,
  input  logic                                  has_segment_i,
  input  logic [shadow_pkg::SegmentBits-1:0]    segment_i,
  input  logic [shadow_pkg::ThresholdBits-1:0]  threshold_i,
  input  logic [shadow_pkg::IdBits-1:0]         object_i,
  // records
  input  logic                                  hit_i,
  input  logic [shadow_pkg::RecordAddrBits-1:0] at_i,           // what was looked up
  input  logic [shadow_pkg::RecordBits-1:0]     record_i,
  output logic                                  lookup_o,
  output logic [shadow_pkg::RecordAddrBits-1:0] lookup_addr_o,
  output logic                                  update_o,
  input  logic                                  update_ready_i,
  output logic [shadow_pkg::RecordAddrBits-1:0] update_addr_o,
  output logic [shadow_pkg::RecordBits-1:0]     update_record_o,
  // record_pool
  input  logic                                  full_memory_i,
  input  logic                                  may_be_long_i,  // a list may have more records than it may
  input  logic [shadow_pkg::RecordAddrBits-1:0] spare_i,
  input  logic [shadow_pkg::RecordAddrBits-1:0] free_i,
  input  logic                                  free_valid_i,
  output logic                                  given_o,
  output logic                                  released_o,
  output logic                                  put_o,
  output logic [shadow_pkg::RecordAddrBits-1:0] put_addr_o,
  // ends, one of them
  output logic                                  done_o,
  output logic                                  ends_o,         // done, and nothing follows
  output logic                                  covers_o,       // the cluster is full now
  output logic                                  grown_o,        // a record more: is the list too long?
  output logic                                  spills_o,       // no room
  // beside them
  output logic                                  bare_o,         // the cluster has lost its last segment
  output logic                                  line_stored_o,
  output logic                                  line_cancelled_o
);
  localparam int unsigned A = shadow_pkg::RecordAddrBits;
  localparam int unsigned S = shadow_pkg::SegmentBits;
  localparam int unsigned L = shadow_pkg::SegmentsPerRecord;
  localparam int unsigned CountBits = shadow_pkg::SegmentCountBits;

  localparam logic [3:0] Found = 4'd0, Append = 4'd1, Grow = 4'd2, Trim = 4'd3, Full = 4'd4, Scan = 4'd5, Corner = 4'd6,
                         Cut = 4'd7, Lift = 4'd8, Patch = 4'd9, Refill = 4'd10, Release = 4'd11;
  logic [3:0] state_d, state_q;

  shadow_pkg::record_t  record, update;
  logic [A-1:0]         head_d, head_q, link_d, link_q, next_d, next_q;
  logic                 next_valid_d, next_valid_q, refill_d, refill_q, room, room_d, room_q, written;
  logic [CountBits-1:0] slot_d, slot_q;
  logic [S-1:0]         moved_d, moved_q;
  logic [shadow_pkg::CornerBits-1:0] corner_d, corner_q, corner_sum;
  assign record     = record_i;
  assign corner_sum = record.corner + shadow_pkg::CornerBits'(corner_i);
  assign room       = record.count < CountBits'(L);
  assign written    = update_o && update_ready_i;
  assign update_record_o = update;

  logic may_meet, same_dot, opposes;
  logic [CountBits-1:0] slot, last;
  silhouette_detector detector (
    .segment_i, .segments_i(record.segments), .count_i(record.count),
    .may_meet_o(may_meet), .same_dot_o(same_dot), .opposes_o(opposes), .slot_o(slot)
  );
  assign last = record.count - 1'b1;
  logic [S-1:0] last_segment;
  always_comb begin
    last_segment = '0;
    for (int i = 0; i < L; i++) if (last == CountBits'(i)) last_segment = record.segments[i*S+:S];
  end

  always_comb begin
    state_d = state_q;
    head_d = head_q; link_d = link_q; next_d = next_q; next_valid_d = next_valid_q; refill_d = refill_q;
    slot_d = slot_q; moved_d = moved_q; corner_d = corner_q; room_d = room_q;
    lookup_o = 1'b0; lookup_addr_o = record.next;
    update_o = 1'b0; update_addr_o = at_i; update = record;
    given_o = 1'b0; released_o = 1'b0; put_o = 1'b0; put_addr_o = at_i;
    done_o = 1'b0; ends_o = 1'b0; covers_o = 1'b0; grown_o = 1'b0; spills_o = 1'b0;
    bare_o = 1'b0; line_stored_o = 1'b0; line_cancelled_o = 1'b0;
    case (state_q)
      Found: if (work_i) begin
        head_d       = at_i;
        corner_d     = corner_sum;
        room_d       = room;
        next_d       = record.next;
        next_valid_d = record.has_next;
        if (hit_i) begin
          if (record.full) begin
            done_o = 1'b1;
          end else if (span_i) begin
            state_d  = record.goes_on ? Trim : Full;
            link_d   = record.next;
            lookup_o = record.goes_on;
          end else if (corner_i && record.corner == '1) begin
            spills_o = 1'b1;
          end else if (has_segment_i && may_meet) begin
            state_d = Scan;
          end else if (!has_segment_i || room) begin
            update_o      = 1'b1;
            update.corner = corner_sum;
            if (has_segment_i) begin
              update.count = record.count + 1'b1;
              for (int i = 0; i < L; i++) if (record.count == CountBits'(i)) update.segments[i*S+:S] = segment_i;
            end
            line_stored_o = has_segment_i && written;
            ends_o        = written;
          end else begin
            state_d = Append;
          end
        end
      end
      Append: if (hit_i) begin
        update_o      = 1'b1;
        update.corner = corner_sum;
        if (room_q) begin
          update.count = record.count + 1'b1;
          for (int i = 0; i < L; i++) if (record.count == CountBits'(i)) update.segments[i*S+:S] = segment_i;
          line_stored_o = written;
          if (written) done_o = 1'b1;
        end else begin
          // The first record's segments move into a new one behind it.
          update_addr_o = spare_i;
          if (full_memory_i) begin
            update_o = 1'b0;
            spills_o = 1'b1;
          end else if (written) begin
            given_o = 1'b1;
            next_d  = spare_i;
            state_d = Grow;
          end
        end
      end
      Grow: if (hit_i) begin
        update_o        = 1'b1;
        update.corner   = corner_sum;
        update.count    = CountBits'(1);
        update.segments[S-1:0] = segment_i;
        update.goes_on  = 1'b1;
        update.has_next = 1'b1;
        update.next     = next_q;
        if (written) begin
          done_o        = !may_be_long_i;
          line_stored_o = !may_be_long_i;
          grown_o       = may_be_long_i;
        end
      end
      // Its records behind the first one, from link_q on, go: the facet covers the texel.
      Trim: if (hit_i) begin
        if (record.goes_on) begin
          released_o = 1'b1;
          lookup_o   = 1'b1;
        end else begin
          update_o        = 1'b1;
          update.next     = free_i;
          update.has_next = free_valid_i;
          if (written) begin
            released_o   = 1'b1;
            put_o        = 1'b1;
            put_addr_o   = link_q;
            next_d       = record.next;
            next_valid_d = record.has_next;
            state_d      = Full;
          end
        end
      end
      Full: begin
        update_o         = 1'b1;
        update_addr_o    = head_q;
        update           = '0;
        update.threshold = threshold_i;
        update.object    = object_i;
        update.full      = 1'b1;
        update.has_next  = next_valid_q;
        update.next      = next_q;
        covers_o         = written;
        if (written) state_d = Found;
      end

      // A segment that others may meet.
      Scan: if (hit_i) begin
        lookup_o      = 1'b1;
        lookup_addr_o = head_q;
        slot_d        = slot;
        link_d        = at_i;
        if (same_dot) begin
          state_d = Corner;
        end else if (opposes) begin
          state_d = at_i == head_q ? Cut : Lift;
        end else if (record.goes_on) begin
          lookup_addr_o = record.next;
        end else begin
          state_d = Append;
        end
      end
      Corner: if (hit_i) begin
        update_o      = 1'b1;
        update.corner = corner_q;
        line_stored_o = written;
        if (written) done_o = 1'b1;
      end
      // The cluster's last segment takes the place of the cancelled one, in the same record or in link_q.
      Cut, Lift: if (hit_i) begin
        update_o      = 1'b1;
        update.corner = corner_q;
        update.count  = last;
        moved_d       = last_segment;
        refill_d      = last == '0 && record.goes_on;
        next_d        = record.next;
        if (state_q == Cut) begin
          for (int i = 0; i < L; i++) if (slot_q == CountBits'(i)) update.segments[i*S+:S] = last_segment;
        end
        if (written) begin
          bare_o           = last == '0 && !record.goes_on;
          lookup_o         = state_q == Lift || refill_d;
          lookup_addr_o    = state_q == Lift ? link_q : record.next;
          state_d          = state_q == Lift ? Patch : refill_d ? Refill : Found;
          done_o           = state_q == Cut && !refill_d;
          line_cancelled_o = state_q == Cut && !refill_d;
        end
      end
      Patch: if (hit_i) begin
        update_o = 1'b1;
        for (int i = 0; i < L; i++) if (slot_q == CountBits'(i)) update.segments[i*S+:S] = moved_q;
        if (written) begin
          lookup_o         = refill_q;
          lookup_addr_o    = next_q;
          state_d          = refill_q ? Refill : Found;
          done_o           = !refill_q;
          line_cancelled_o = !refill_q;
        end
      end
      // The record behind an emptied first one becomes the first.
      Refill: if (hit_i) begin
        update_o         = 1'b1;
        update_addr_o    = head_q;
        update.threshold = threshold_i;
        update.object    = object_i;
        update.corner    = corner_q;
        if (written) state_d = Release;
      end
      Release: if (hit_i) begin
        update_o        = 1'b1;
        update.next     = free_i;
        update.has_next = free_valid_i;
        if (written) begin
          released_o       = 1'b1;
          put_o = 1'b1;
          put_addr_o = at_i;
          line_cancelled_o = 1'b1;
          done_o           = 1'b1;
        end
      end
      default: ;
    endcase
    if (done_o || ends_o || grown_o || spills_o) state_d = Found;
  end

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      state_q <= Found;
    end else begin
      state_q <= clear_i ? Found : state_d;
      `CHECK(works_when_asked, work_i || state_q == Found || clear_i)
    end
  end
  always_ff @(posedge clk_i) begin
    head_q <= head_d; link_q <= link_d; next_q <= next_d; next_valid_q <= next_valid_d; refill_q <= refill_d;
    slot_q <= slot_d; moved_q <= moved_d; corner_q <= corner_d; room_q <= room_d;
  end
endmodule

// List walk: reads the records of a texel's list one after the other; `mode` says what it does with them.
//
// Twins:   model/unit/winding/shadow_unit_store.cpp (hidden, find, drop_hidden, overflow), shadow_unit_pass2.cpp
//          (settle_texel)
// Numbers: depths as list_texel.
// Timing:  the first record is looked up by the owner in the cycle of begin_i. A step a record, or two where its
//          bounds are compared; a cluster that goes takes a step each of its records, and one more that links.
module list_walk (
  input  logic                                  clk_i,
  input  logic                                  rst_ni,
  input  logic                                  paper_i,         // settings_t.paper_semantics
  input  logic [shadow_pkg::LimitBits-1:0]      chain_limit_i,
  // from the cycle after begin_i on, until one of the ends
  input  logic                                  start_i,         // a new texel: nothing is counted yet
  input  logic                                  open_i,          // one record is
  input  logic                                  begin_i,
  input  logic [2:0]                            mode_i,
  input  logic                                  walk_i,
  // the visit
  input  logic                                  nothing_i,       // of an edge, with neither corner nor segment
  input  logic [shadow_pkg::ThresholdBits-1:0]  threshold_i,
  input  logic [shadow_pkg::IdBits-1:0]         object_i,
  input  logic [31:0]                           nearest_i,
  // the texel
  input  logic                                  covered_i,
  input  logic [shadow_pkg::IdBits-1:0]         cover_object_i,
  input  logic [31:0]                           cover_depth_i,
  input  logic [shadow_pkg::RecordAddrBits-1:0] first_i,
  // records
  input  logic                                  hit_i,
  input  logic                                  looked_up_i,     // by anybody
  input  logic [shadow_pkg::RecordAddrBits-1:0] at_i,            // what was looked up
  input  logic [shadow_pkg::RecordBits-1:0]     record_i,
  output logic                                  lookup_o,
  output logic [shadow_pkg::RecordAddrBits-1:0] lookup_addr_o,
  output logic                                  update_o,        // of the record looked up
  input  logic                                  update_ready_i,
  output logic [shadow_pkg::RecordBits-1:0]     update_record_o,
  // record_pool
  input  logic [shadow_pkg::RecordAddrBits-1:0] free_i,
  input  logic                                  free_valid_i,
  output logic                                  released_o,
  output logic                                  put_o,
  output logic [shadow_pkg::RecordAddrBits-1:0] put_addr_o,
  // ends, one of them
  output logic                                  found_o,         // the cluster of the visit's plane
  output logic                                  missed_o,        // there is none
  output logic                                  hidden_o,        // the visit is
  output logic                                  done_o,          // and nothing follows but the texel's way back
  output logic                                  settled_o,
  output logic                                  freed_o,
  output logic                                  counted_o,       // as many as the list may have, or fewer
  output logic                                  too_long_o,
  output logic                                  ends_o,          // the texel is a plane, of the last record
  // beside them
  output logic                                  behead_o,        // the first cluster goes, what follows:
  output logic                                  next_valid_o,
  output logic [shadow_pkg::RecordAddrBits-1:0] next_o,
  output logic                                  note_o,          // a cover
  output logic [31:0]                           note_depth_o,
  output logic [shadow_pkg::IdBits-1:0]         note_object_o,
  output logic                                  long_o,          // the list has as many records as it may
  output logic                                  reads_o,         // the next record of the list
  output logic                                  lasts_o,         // the texel is a plane if its only record is a cover
  output logic                                  steep_o,         // of the record's plane
  output logic [26:0]                           half_o,
  output logic                                  emptied_covered_o,
  output logic [15:0]                           lines_hidden_o,
  output logic [15:0]                           overflow_lines_o
);
  localparam int unsigned A = shadow_pkg::RecordAddrBits;
  localparam int unsigned LimitBits = shadow_pkg::LimitBits;
  localparam logic [31:0] Farthest = 32'h7fff_ffff;

  // Find: the visit's cluster. Covers, CoversDrop: the nearest end of a cover of another object than the texel's.
  // Drop: clusters that are hidden. Settle: those without segments. Free: all. Count: records.
  localparam logic [2:0] Find = 3'd0, Covers = 3'd1, CoversDrop = 3'd2, Drop = 3'd3, Settle = 3'd4, Free = 3'd5;
  localparam logic [1:0] Read = 2'd0, Erase = 2'd1, Link = 2'd2, Last = 2'd3;
  logic [1:0]   step_d, step_q;
  logic [2:0]   mode_d, mode_q;

  shadow_pkg::record_t record, update;
  logic [A-1:0] prev_d, prev_q, chain_d, chain_q, next_d, next_q;
  logic         prev_valid_d, prev_valid_q, next_valid_d, next_valid_q, continued_d, continued_q;
  logic [LimitBits-1:0] count_d, count_q;
  logic [31:0]  other_d, other_q;  // nearest end of a cover of another object
  logic         seen_q, bounded, there;
  assign record  = record_i;
  assign update_record_o = update;
  // Bounds take a cycle of their own.
  assign bounded = step_q == Read && (mode_q == Covers || mode_q == CoversDrop || mode_q == Drop || mode_q == Settle);
  assign there   = walk_i && hit_i && (!bounded || seen_q);

  logic [31:0] nearest, farthest, nearest_q, farthest_q;
  plane_steepness steepness (
    .gradient_x_i(record.threshold.gradient_x), .gradient_y_i(record.threshold.gradient_y), .steep_o, .half_o
  );
  plane_bounds bounds (
    .base_i(record.threshold.base), .steep_i(steep_o), .half_i(half_o), .nearest_o(nearest), .farthest_o(farthest)
  );
  function automatic logic nearer(input logic [31:0] a, input logic [31:0] b);
    nearer = $signed(a) < $signed(b);
  endfunction
  logic same_plane, hides, covers_more, lacks_segments, goes, over;
  assign same_plane = record.threshold == threshold_i && record.object == object_i;
  assign hides      = covered_i && !nearer(nearest_q, cover_depth_i)
                      && (!paper_i || record.object == cover_object_i || !nearer(nearest_q, other_q));
  assign covers_more = !continued_q && record.full && record.object != cover_object_i && nearer(farthest_q, other_q);
  assign lacks_segments = !record.full && record.count == '0;
  assign goes       = mode_q == Drop ? hides : lacks_segments && record.corner == '0;

  always_comb begin
    step_d = step_q; mode_d = mode_q;
    prev_d = prev_q; prev_valid_d = prev_valid_q; chain_d = chain_q;
    next_d = next_q; next_valid_d = next_valid_q; continued_d = continued_q;
    count_d = count_q; other_d = other_q;
    lookup_o = 1'b0; lookup_addr_o = record.next; update_o = 1'b0; update = record;
    released_o = 1'b0; put_o = 1'b0; put_addr_o = at_i;
    over = 1'b0;  // the walk is at its end
    found_o = 1'b0; missed_o = 1'b0; hidden_o = 1'b0; done_o = 1'b0; settled_o = 1'b0; freed_o = 1'b0;
    counted_o = 1'b0; too_long_o = 1'b0; ends_o = 1'b0;
    behead_o = 1'b0; note_o = 1'b0; note_depth_o = farthest_q; note_object_o = record.object;
    emptied_covered_o = 1'b0; lines_hidden_o = '0; overflow_lines_o = '0;

    if (there) begin
      unique case (step_q)
        Read: begin
          over = 1'b1;
          case (mode_q)
            Find: begin
              count_d = count_q + 1'b1;
              found_o = !continued_q && same_plane;
              over    = !found_o;
            end
            Covers, CoversDrop: begin
              if (covers_more) other_d = farthest_q;
            end
            Drop, Settle: begin
              chain_d = at_i;
              if (!continued_q && goes) begin
                step_d = Erase;
                over   = 1'b0;
              end else if (mode_q == Settle && !continued_q && lacks_segments) begin
                update_o      = 1'b1;
                update.full   = 1'b1;
                update.corner = '0;
                note_o        = update_ready_i;
                emptied_covered_o = update_ready_i;
                over          = update_ready_i;
              end
              if (over) begin
                prev_d       = at_i;
                prev_valid_d = 1'b1;
              end
            end
            Free: begin
              if (!record.has_next) begin
                update_o        = 1'b1;
                update.next     = free_i;
                update.has_next = free_valid_i;
                update.goes_on  = 1'b0;
                over            = update_ready_i;
              end
              if (over) begin
                released_o       = 1'b1;
                overflow_lines_o = 16'(record.count);
                note_o           = !continued_q;
                note_depth_o     = {record.threshold.base[shadow_pkg::BaseBits-1], record.threshold.base,
                                    {shadow_pkg::PlaneStepBits{1'b0}}};  // at the centre
              end
            end
            default: count_d = count_q + 1'b1;  // Count
          endcase
          if (over && record.has_next) begin
            over        = 1'b0;
            lookup_o    = 1'b1;
            continued_d = record.goes_on;
          end
        end
        // The cluster goes, its records from chain_q on. Those of an earlier one are linked to what follows.
        Erase: begin
          if (record.goes_on) begin
            released_o = 1'b1;
            lookup_o   = 1'b1;
          end else begin
            update_o        = 1'b1;
            update.next     = free_i;
            update.has_next = free_valid_i;
            if (update_ready_i) begin
              released_o    = 1'b1;
              put_o         = 1'b1;
              put_addr_o    = chain_q;
              next_d        = record.next;
              next_valid_d  = record.has_next;
              continued_d   = 1'b0;
              lookup_o      = prev_valid_q || record.has_next;
              lookup_addr_o = prev_valid_q ? prev_q : record.next;
              step_d        = prev_valid_q ? Link : Read;
              behead_o      = !prev_valid_q;
              done_o        = !prev_valid_q && !record.has_next;
            end
          end
          if (mode_q == Drop && released_o) lines_hidden_o = 16'(record.count);
        end
        Link: begin
          update_o        = 1'b1;
          update.next     = next_q;
          update.has_next = next_valid_q;
          if (update_ready_i) begin
            step_d        = Read;
            lookup_o      = next_valid_q;
            lookup_addr_o = next_q;
            over          = !next_valid_q;
          end
        end
        // A cover alone needs no record.
        default: begin
          if (record.full && !record.has_next) begin
            update_o        = 1'b1;
            update.next     = free_i;
            update.has_next = free_valid_i;
            released_o      = update_ready_i;
            put_o           = update_ready_i;
            ends_o          = update_ready_i;
          end else begin
            done_o = 1'b1;
          end
        end
      endcase
    end

    if (over) begin
      lookup_addr_o = first_i;
      continued_d   = 1'b0;
      case (mode_q)
        Find: missed_o = 1'b1;
        Covers: begin
          mode_d   = Find;
          hidden_o = covers_more ? !nearer(nearest_i, farthest_q) : !nearer(nearest_i, other_q);
          done_o   = hidden_o || nothing_i;
          lookup_o = !done_o;
        end
        CoversDrop: begin
          mode_d       = Drop;
          prev_valid_d = 1'b0;
          lookup_o     = 1'b1;
        end
        Drop: begin
          step_d   = Last;
          lookup_o = 1'b1;
        end
        Settle: settled_o = 1'b1;
        Free: begin
          put_o      = 1'b1;
          put_addr_o = first_i;
          freed_o    = 1'b1;
        end
        default: begin  // Count
          too_long_o = long_o;  // before this one
          counted_o  = !long_o;
        end
      endcase
    end
  end
  assign next_valid_o = record.has_next;
  assign next_o       = record.next;
  assign long_o       = count_q >= chain_limit_i;
  assign reads_o      = walk_i && step_q == Read;
  assign lasts_o      = walk_i && step_q == Last;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      count_q <= '0;  // a sum of its own, but for where it begins
    end else begin
      count_q <= start_i || begin_i ? '0 : open_i ? LimitBits'(1) : count_d;
    end
  end
  always_ff @(posedge clk_i) begin
    step_q       <= begin_i ? Read : step_d;
    mode_q       <= begin_i ? mode_i : mode_d;
    continued_q  <= begin_i ? 1'b0 : continued_d;
    prev_valid_q <= begin_i ? 1'b0 : prev_valid_d;
    other_q      <= begin_i ? Farthest : other_d;
    prev_q <= prev_d; chain_q <= chain_d; next_q <= next_d; next_valid_q <= next_valid_d;
    nearest_q <= nearest; farthest_q <= farthest;
    seen_q <= hit_i && !looked_up_i;
  end
endmodule

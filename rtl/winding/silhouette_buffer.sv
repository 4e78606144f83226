// Silhouette buffer: carries out what a visit, or the end of pass 1, does to a texel with a list of clusters, or
// that gets one.
//
// Twins:   model/unit/winding/shadow_unit_store.cpp (hidden, find, open_list, add, cover, drop_hidden, overflow),
//          shadow_unit_pass2.cpp (settle_texel)
// Numbers: records in use and limits as the golden records_.
// Timing:  start_i in a cycle of ready_o; done_o two cycles later for a plane that is new to the texel, or a segment
//          that the first record has room for. Everything else walks the list (docs/rtl.md, what a visit costs).
//
// What follows what says list_control. The list is walked by list_walk, what becomes of the texel is list_texel's, of the
// cluster of the visit's plane cluster_update's; which records are free is record_pool's.
module silhouette_buffer (
  input  logic                                  clk_i,
  input  logic                                  rst_ni,
  input  logic                                  clear_i,       // also a new frame: no record is in use
  input  logic                                  paper_i,       // settings_t.paper_semantics
  input  logic [shadow_pkg::LimitBits-1:0]      record_limit_i,
  input  logic [shadow_pkg::LimitBits-1:0]      chain_limit_i,
  // the texel and what happens to it; held from start_i to done_o, or
  input  logic                                  start_i,
  output logic                                  ready_o,
  input  logic                                  settle_i,      // end of pass 1; the texel has a list
  input  logic                                  span_i,        // the facet covers the texel; else a visit of an edge
  input  logic                                  corner_i,
  input  logic                                  has_segment_i,
  input  logic [shadow_pkg::SegmentBits-1:0]    segment_i,
  input  logic                                  steep_i,       // of the visit's plane
  input  logic [26:0]                           half_i,
  input  logic [2*shadow_pkg::GradientCodeBits-1:0] gradient_i,
  input  logic [shadow_pkg::IdBits-1:0]         object_i,
  input  logic [shadow_pkg::BaseBits-1:0]       base_i,        // with start_i alone
  input  logic [4:0]                            mark_i,        // with start_i: number of the mark of the visit's plane
  input  logic                                  unmarked_i,    // with start_i: the list has no cluster of that plane
  input  logic [shadow_pkg::TexelBits-1:0]      texel_i,       // with start_i; texel_t
  input  logic                                  texel_steep_i, // after it: of the texel's plane, if it is one
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
  localparam int unsigned Step = shadow_pkg::PlaneStepBits;

  // ---- The visit and its texel ------------------------------------------------------------------
  /* verilator lint_off UNUSEDSIGNAL */  // what becomes of it is list_texel's
  shadow_pkg::texel_t      texel_in;
  shadow_pkg::texel_list_t list_in;
  /* verilator lint_on UNUSEDSIGNAL */
  logic [shadow_pkg::BaseBits-1:0]      base_q;
  logic [shadow_pkg::ThresholdBits-1:0] threshold;  // of the visit
  logic [31:0] visit_nearest, visit_farthest;
  logic        nothing;
  assign texel_in  = texel_i;
  assign list_in   = texel_in.word[shadow_pkg::ListBits-1:0];
  assign threshold = {base_q, gradient_i};
  assign nothing   = !span_i && !corner_i && !has_segment_i;
  plane_bounds visit_bounds (
    .base_i(base_q), .steep_i, .half_i, .nearest_o(visit_nearest), .farthest_o(visit_farthest)
  );

  logic         load, open, insert, spill, keep, behead, next_valid, bare, settled, freed, note;
  logic         covered, covered_next, changed;
  logic [1:0]   kind;
  logic [A-1:0] first, next;
  logic [31:0]  depth, note_depth;
  logic [shadow_pkg::IdBits-1:0]    object, note_object;
  logic [shadow_pkg::TexelBits-1:0] texel;
  logic [shadow_pkg::ThresholdBits-1:0] plane;
  list_texel list_texel (
    .clk_i, .load_i(load), .texel_i, .mark_i, .steep_i(texel_steep_i), .half_i(texel_half_i),
    .open_i(open && written), .insert_i(insert && written), .insert_bare_i(!span_i && !has_segment_i),
    .spare_i(spare), .behead_i(behead), .next_valid_i(next_valid), .next_i(next), .bare_i(bare), .settled_i(settled), .spill_i(spill), .overflow_i(freed),
    .note_i(note), .note_depth_i(note_depth), .note_object_i(note_object),
    .kind_o(kind), .covered_o(covered), .covered_next_o(covered_next), .object_o(object), .depth_o(depth),
    .first_o(first), .changed_o(changed), .plane_o(plane),
    .texel_o(texel)
  );

  // ---- Records ----------------------------------------------------------------------------------
  /* verilator lint_off UNUSEDSIGNAL */  // the rest is list_walk's and cluster_update's
  shadow_pkg::record_t record;
  /* verilator lint_on UNUSEDSIGNAL */
  logic [A-1:0] at_q, spare, free;
  logic         spare_ready, free_valid, take, full_memory, written;
  logic         walk_released, walk_put, work_given, work_released, work_put;
  logic [A-1:0] walk_put_addr, work_put_addr;
  assign record  = record_i;
  assign written = update_o && update_ready_i;
  record_pool record_pool (
    .clk_i, .rst_ni, .clear_i, .record_limit_i, .given_i(((open || insert) && written) || work_given),
    .released_i(walk_released || work_released),
    .put_i(walk_put || work_put), .put_addr_i(walk_put ? walk_put_addr : work_put_addr),
    .take_i(take), .take_next_i(record.next), .take_has_next_i(record.has_next),
    .spare_o(spare), .spare_ready_o(spare_ready), .free_o(free), .free_valid_o(free_valid),
    .full_o(full_memory), .used_o(records_o)
  );

  // ---- What follows what --------------------------------------------------------------------------
  logic         lookup, begins, walks, works, hidden, long_list, found, missed, walk_done, counted, too_long, walk_ends;
  logic         work_done, work_ends, covers, grown, spills;
  logic [2:0]   mode;
  logic [A-1:0] lookup_addr;
  list_control list_control (
    .clk_i, .rst_ni, .clear_i, .paper_i, .start_i, .ready_o, .done_o, .settle_i, .span_i, .nothing_i(nothing),
    .start_kind_i(texel_in.kind), .start_covered_i(list_in.covered),
    .start_absent_i(unmarked_i && records_o < chain_limit_i), .start_first_i(list_in.first),
    .kind_i(kind), .behind_i(covered && $signed(visit_nearest) >= $signed(depth)),
    .own_i(!paper_i || object == object_i), .covered_next_i(covered_next), .first_i(first),
    .load_o(load), .open_o(open), .insert_o(insert), .spill_o(spill), .keep_o(keep),
    .spare_ready_i(spare_ready), .spare_i(spare), .free_valid_i(free_valid), .free_i(free), .full_memory_i(full_memory), .take_o(take),
    .hit_i, .written_i(written), .lookup_o(lookup), .lookup_addr_o(lookup_addr),
    .begin_o(begins), .mode_o(mode), .walk_o(walks), .long_i(long_list), .found_i(found), .missed_i(missed),
    .walk_done_i(walk_done), .settled_i(settled), .freed_i(freed), .counted_i(counted), .too_long_i(too_long),
    .walk_ends_i(walk_ends), .work_o(works), .work_done_i(work_done), .work_ends_i(work_ends), .covers_i(covers),
    .grown_i(grown), .spills_i(spills), .hidden_o(hidden)
  );

  // ---- The list, and the cluster of the visit's plane in it -----------------------------------------
  logic         walk_lookup, walk_update, walk_hidden, walk_note, reads, lasts;
  logic         work_lookup, work_update, work_stored;
  logic [A-1:0] walk_addr, work_addr, work_update_addr;
  logic [31:0]  walk_depth;
  logic [15:0]  walk_lines;
  logic [shadow_pkg::IdBits-1:0]     walk_object;
  logic [shadow_pkg::RecordBits-1:0] walk_record, work_record;
  list_walk list_walk (
    .clk_i, .rst_ni, .paper_i, .chain_limit_i, .start_i(load), .open_i(open && written), .begin_i(begins),
    .mode_i(mode), .walk_i(walks), .nothing_i(nothing), .threshold_i(threshold), .object_i, .nearest_i(visit_nearest),
    .covered_i(covered), .cover_object_i(object), .cover_depth_i(depth), .first_i(first),
    .hit_i, .looked_up_i(lookup_o), .at_i(at_q), .record_i, .lookup_o(walk_lookup), .lookup_addr_o(walk_addr),
    .update_o(walk_update), .update_ready_i, .update_record_o(walk_record),
    .free_i(free), .free_valid_i(free_valid), .released_o(walk_released), .put_o(walk_put), .put_addr_o(walk_put_addr),
    .found_o(found), .missed_o(missed), .hidden_o(walk_hidden), .done_o(walk_done), .settled_o(settled), .freed_o(freed),
    .counted_o(counted), .too_long_o(too_long), .ends_o(walk_ends), .behead_o(behead), .next_valid_o(next_valid),
    .next_o(next), .note_o(walk_note), .note_depth_o(walk_depth), .note_object_o(walk_object), .long_o(long_list),
    .reads_o(reads), .lasts_o(lasts), .steep_o(texel_steep_o), .half_o(texel_half_o),
    .emptied_covered_o, .lines_hidden_o, .overflow_lines_o(walk_lines)
  );
  cluster_update cluster_update (
    .clk_i, .rst_ni, .clear_i, .work_i(works),
    .span_i, .corner_i, .has_segment_i, .segment_i, .threshold_i(threshold), .object_i,
    .hit_i, .at_i(at_q), .record_i, .lookup_o(work_lookup), .lookup_addr_o(work_addr),
    .update_o(work_update), .update_ready_i, .update_addr_o(work_update_addr), .update_record_o(work_record),
    .full_memory_i(full_memory), .may_be_long_i(records_o > chain_limit_i), .spare_i(spare), .free_i(free),
    .free_valid_i(free_valid), .given_o(work_given), .released_o(work_released), .put_o(work_put),
    .put_addr_o(work_put_addr), .done_o(work_done), .ends_o(work_ends), .covers_o(covers), .grown_o(grown),
    .spills_o(spills), .bare_o(bare), .line_stored_o(work_stored), .line_cancelled_o
  );

  // ---- Together: one of them has the records in a cycle ---------------------------------------------
  shadow_pkg::record_t cluster;  // a new one: of the texel's plane, or of the visit's in front
  always_comb begin
    cluster           = '0;
    cluster.threshold = open ? plane : threshold;
    cluster.object    = open ? object : object_i;
    cluster.full      = open || span_i;
    cluster.corner    = shadow_pkg::CornerBits'(!open && corner_i && !span_i);
    cluster.count     = shadow_pkg::SegmentCountBits'(!open && has_segment_i && !span_i);
    cluster.segments[S-1:0] = segment_i;
    cluster.has_next  = !open && kind == shadow_pkg::TexelList;
    cluster.next      = first;

    lookup_o        = lookup || walk_lookup || work_lookup;
    lookup_addr_o   = lookup ? lookup_addr : walks ? walk_addr : work_addr;
    update_o        = open || insert || walk_update || work_update;
    update_addr_o   = open || insert ? spare : works ? work_update_addr : at_q;
    update_record_o = open || insert ? cluster : works ? work_record : walk_record;

    note        = (insert && written && span_i) || walk_note || covers || keep;
    note_depth  = walks ? walk_depth : keep ? {base_q[shadow_pkg::BaseBits-1], base_q, {Step{1'b0}}} : visit_farthest;
    note_object = walks ? walk_object : object_i;

    texel_o = texel;
    if (lasts) texel_o = {shadow_pkg::TexelPlane, record.object, shadow_pkg::WordBits'(record.threshold)};

    cause_o = shadow_pkg::StoreChain;
    if (update_o && !update_ready_i) cause_o = shadow_pkg::StoreWrite;
    else if (reads && at_q == first && !hit_i) cause_o = shadow_pkg::StoreRecord;
  end
  assign changed_o = changed || lasts;
  assign hidden_o  = hidden || walk_hidden;
  assign line_stored_o    = (insert && written && has_segment_i && !span_i) || counted || work_stored;
  assign overflow_lines_o = keep ? 16'd1 : walk_lines;
  assign overflow_texel_o = spill;
  always_ff @(posedge clk_i) begin
    if (lookup_o) at_q <= lookup_addr_o;
    if (load) base_q <= base_i;
  end
endmodule

// Store: carries out the visits of pass 1 on the texel memory and the SLB, strictly in order.
//
// Twins:   model/unit/winding/shadow_unit_pass1.cpp (announce, visit), shadow_unit_store.cpp,
//          shadow_unit_pass2.cpp (settle)
// Numbers: docs/rtl.md draws the words; every address of a record in use is below record_limit.
// Timing:  a visit a cycle in the word held, another word a cycle more, lists a few; whatever the memory's latency,
//          as long as what is needed was fetched while the visits waited.
//
//   visits, fragments, tiles -> window of tile words -> tile_buffer -> window of texel words -> texel_buffers
//                                                                               records <- silhouette_buffer
`include "check.svh"
module store (
  input  logic                                    clk_i,
  input  logic                                    rst_ni,
  input  logic                                    clear_i,       // drops everything; hold until no response is due
  input  shadow_pkg::settings_t                   settings_i,
  // commands, held until done, one at a time
  input  logic                                    wipe_i,        // empty buffers for a new frame
  output logic                                    wiped_o,
  input  logic                                    settle_i,      // end of pass 1
  output logic                                    settled_o,
  // the frame's fragments, before pass 1
  input  logic                                    frag_valid_i,
  output logic                                    frag_ready_o,
  input  shadow_pkg::frag_t                       frag_i,
  // visits of pass 1
  input  logic                                    visit_valid_i,
  output logic                                    visit_ready_o,
  input  shadow_pkg::visit_t                      visit_i,
  input  shadow_pkg::visit_tri_t                  visit_tri_i,
  output logic                                    idle_o,        // nothing inside
  // texel memory
  output logic                                    texel_rd_valid_o,
  input  logic                                    texel_rd_ready_i,
  output logic [shadow_pkg::TexelAddrBits-1:0]    texel_rd_addr_o,
  output logic [shadow_pkg::TagBits-1:0]          texel_rd_tag_o,
  input  logic                                    texel_rsp_valid_i,
  input  logic [shadow_pkg::TagBits-1:0]          texel_rsp_tag_i,
  input  logic [shadow_pkg::TexelDataBits-1:0]    texel_rsp_data_i,
  output logic                                    texel_wr_valid_o,
  input  logic                                    texel_wr_ready_i,
  output logic [shadow_pkg::TexelAddrBits-1:0]    texel_wr_addr_o,
  output logic [shadow_pkg::TexelDataBits-1:0]    texel_wr_data_o,
  output logic [3:0]                              texel_wr_mask_o,
  // SLB memory
  output logic                                    slb_rd_valid_o,
  input  logic                                    slb_rd_ready_i,
  output logic [shadow_pkg::RecordAddrBits-1:0]   slb_rd_addr_o,
  output logic [shadow_pkg::TagBits-1:0]          slb_rd_tag_o,
  input  logic                                    slb_rsp_valid_i,
  input  logic [shadow_pkg::TagBits-1:0]          slb_rsp_tag_i,
  input  logic [shadow_pkg::RecordBits-1:0]       slb_rsp_data_i,
  output logic                                    slb_wr_valid_o,
  input  logic                                    slb_wr_ready_i,
  output logic [shadow_pkg::RecordAddrBits-1:0]   slb_wr_addr_o,
  output logic [shadow_pkg::RecordBits-1:0]       slb_wr_data_o,
  output logic [3:0]                              cause_o,       // shadow_pkg::Store*
  output logic [shadow_pkg::LimitBits-1:0]        records_o,     // in use
  output shadow_pkg::store_events_t               events_o
);
  localparam logic [1:0] VisitTile = 2'd2;  // inside alone: a fragment's place, or a tile to settle
  localparam int unsigned M = shadow_pkg::MapBits;
  localparam int unsigned B = shadow_pkg::BaseBits;
  localparam int unsigned TileAddrBits = 2 * (M - 3);
  localparam int unsigned WordAddrBits = shadow_pkg::TexelAddrBits - 1;
  localparam int unsigned TileLines = 32;
  localparam int unsigned TileLineBits = $clog2(TileLines);
  localparam int unsigned TexelLineBits = $clog2(shadow_pkg::TexelLines);
  localparam int unsigned VisitBits = 2 + 2 * M + 2 + shadow_pkg::SegmentBits + 4 * B + 4;
  localparam int unsigned TagBits = shadow_pkg::TagBits;

  logic drop, wiping;  // forget what is kept on chip

  // ---- Tiles of the map, one after the other: wipe, settle ----------------------------------------
  logic [M-4:0] column, row;
  logic         scan_started, scan_valid, scan_step, scanned;
  tile_scan tile_scan (
    .clk_i, .rst_ni, .clear_i, .map_width_i(settings_i.map_width), .map_height_i(settings_i.map_height),
    .run_i(wipe_i || settle_i), .started_o(scan_started), .tile_valid_o(scan_valid), .step_i(scan_step),
    .column_o(column), .row_o(row), .done_o(scanned)
  );
  assign wiping = wipe_i && scan_valid;
  assign drop   = clear_i || (wipe_i && !scan_started);
  always_ff @(posedge clk_i) begin
    `CHECK(one_command, !(wipe_i && settle_i))
    `CHECK(no_work_while_wiping, !(wipe_i && (visit_valid_i || frag_valid_i)))
  end

  // ---- Work: visits, fragments or tiles ------------------------------------------------------------
  logic               work_valid, work_ready, known, skips;
  logic [M-1:0]       frag_x, frag_y;
  logic [TileAddrBits-1:0] work_tile;
  shadow_pkg::visit_t work;
  address_generator address_generator (
    .settings_i, .frag_i, .known_o(known), .frag_x_o(frag_x), .frag_y_o(frag_y),
    .x_i(work.x), .y_i(work.y), .tile_o(work_tile)
  );
  assign skips = known || !settings_i.skip_receiver_mask;
  always_comb begin
    work = visit_i;
    work_valid = visit_valid_i;
    if (settle_i) begin
      work.kind  = VisitTile;
      work.x     = {column, 3'd0};
      work.y     = {row, 3'd0};
      work_valid = scan_valid;
    end else if (frag_valid_i) begin
      work.kind  = VisitTile;
      work.x     = frag_x;
      work.y     = frag_y;
      {work.base3, work.base2, work.base1, work.base0} = (4 * B)'(frag_i.p.z);
      work_valid = !skips;
    end else if (visit_i.kind == shadow_pkg::VisitBegin) begin
      {work.base3, work.base2, work.base1, work.base0} = (4 * B)'(visit_tri_i);
    end else if (visit_i.kind == shadow_pkg::VisitEdge) begin  // as a span of one texel
      {work.base3, work.base2, work.base1} = {3{visit_i.base0}};
      work.mask = 4'd1 << visit_i.x[1:0];
    end
  end
  assign frag_ready_o  = !settle_i && (work_ready || skips);
  assign visit_ready_o = !settle_i && !frag_valid_i && work_ready;
  assign scan_step     = wiping ? wipe_ready : settle_i && work_valid && work_ready;

  // ---- Tiles ------------------------------------------------------------------------------------
  logic                            tile_valid, tile_fresh, tile_load, tile_pop, tile_clean, tile_keep;
  logic                            tile_keep_ready, tile_window_empty, tile_waits, tile_idle;
  logic                            tile_rd_valid, tile_rd_ready, tile_wr_valid, tile_wr_ready, touch_valid, touch_ready;
  logic [VisitBits-1:0]            tile_work;
  logic [shadow_pkg::TileBits-1:0] tile_data, tile_word, tile_written;
  logic [TileAddrBits-1:0]         tile_held, tile_rd_addr, tile_wr_addr;
  logic [TileLineBits-1:0]         tile_rd_tag;
  logic [WordAddrBits-1:0]         touch_addr;
  logic                            rsp_of_tile;
  assign rsp_of_tile = texel_rsp_tag_i[TagBits-1];

  memory_window #(
    .Width(shadow_pkg::TileBits), .AddrBits(TileAddrBits), .PayloadBits(VisitBits),
    .Lines(TileLines), .Depth(shadow_pkg::VisitFifoDepth), .RowBits(M - 3)
  ) tile_window (
    .clk_i, .rst_ni, .clear_i(drop),
    .in_valid_i(work_valid), .in_ready_o(work_ready), .in_bare_i(work.kind == shadow_pkg::VisitBegin),
    .in_addr_i(work_tile), .in_payload_i(work),
    .out_valid_o(tile_valid), .out_fresh_o(tile_fresh), .out_payload_o(tile_work), .data_o(tile_data),
    .load_i(tile_load), .pop_i(tile_pop), .empty_o(tile_window_empty), .waits_o(tile_waits),
    .held_addr_o(tile_held), .write_i(tile_keep), .write_ready_o(tile_keep_ready),
    .write_data_i(tile_word), .clean_i(tile_clean),
    .rd_valid_o(tile_rd_valid), .rd_ready_i(tile_rd_ready), .rd_addr_o(tile_rd_addr), .rd_tag_o(tile_rd_tag),
    .rsp_valid_i(texel_rsp_valid_i && rsp_of_tile), .rsp_tag_i(texel_rsp_tag_i[TileLineBits-1:0]),
    .rsp_data_i(texel_rsp_data_i[shadow_pkg::TileBits-1:0])
  );

  logic                    visit_valid, visit_ready, visit_bare, sum_valid, sum_ready, sum_covered, sum_several;
  logic [WordAddrBits-1:0] visit_addr;
  shadow_pkg::visit_t      visit;
  logic [shadow_pkg::IdBits-1:0] sum_object;
  logic [24:0]             sum_farthest;
  tile_buffer tile_buffer (
    .clk_i, .rst_ni, .clear_i(drop), .skip_masked_i(settings_i.skip_receiver_mask),
    .settling_i(settle_i),
    .in_valid_i(tile_valid), .in_fresh_i(tile_fresh), .in_i(tile_work), .in_tile_i(tile_data),
    .load_o(tile_load), .pop_o(tile_pop), .clean_o(tile_clean), .keep_o(tile_keep),
    .keep_ready_i(tile_keep_ready), .tile_addr_i(tile_held), .tile_o(tile_word),
    .out_valid_o(visit_valid), .out_ready_i(visit_ready), .out_bare_o(visit_bare),
    .out_addr_o(visit_addr), .out_o(visit),
    .sum_valid_i(sum_valid), .sum_ready_o(sum_ready), .sum_covered_i(sum_covered), .sum_several_i(sum_several),
    .sum_object_i(sum_object), .sum_farthest_i(sum_farthest),
    .wr_valid_o(tile_wr_valid), .wr_ready_i(tile_wr_ready), .wr_addr_o(tile_wr_addr), .wr_tile_o(tile_written),
    .touch_valid_o(touch_valid), .touch_ready_i(touch_ready), .touch_addr_o(touch_addr), .idle_o(tile_idle),
    .visits_o(events_o.texel_visits), .masked_o(events_o.masked_visits), .touched_o(events_o.tile_touched)
  );

  // ---- Texels -----------------------------------------------------------------------------------
  logic                                 texel_valid, texel_fresh, texel_load, texel_pop, texel_clean, texel_keep;
  logic                                 texel_keep_ready, texel_window_empty, texel_waits, texel_idle;
  logic                                 word_rd_valid, word_rd_ready, word_wr_valid, word_wr_ready;
  logic [VisitBits-1:0]                 texel_work;
  logic [shadow_pkg::TexelWordBits-1:0] texel_data, texel_word;
  logic [WordAddrBits-1:0]              texel_held, word_rd_addr;
  logic [TexelLineBits-1:0]             word_rd_tag;
  logic [3:0]                           word_wr_mask;

  memory_window #(
    .Width(shadow_pkg::TexelWordBits), .AddrBits(WordAddrBits), .PayloadBits(VisitBits),
    .Lines(shadow_pkg::TexelLines), .Depth(shadow_pkg::VisitFifoDepth)
  ) texel_window (
    .clk_i, .rst_ni, .clear_i(drop),
    .in_valid_i(visit_valid), .in_ready_o(visit_ready), .in_bare_i(visit_bare),
    .in_addr_i(visit_addr), .in_payload_i(visit),
    .out_valid_o(texel_valid), .out_fresh_o(texel_fresh), .out_payload_o(texel_work), .data_o(texel_data),
    .load_i(texel_load), .pop_i(texel_pop), .empty_o(texel_window_empty), .waits_o(texel_waits),
    .held_addr_o(texel_held), .write_i(texel_keep), .write_ready_o(texel_keep_ready),
    .write_data_i(texel_word), .clean_i(texel_clean),
    .rd_valid_o(word_rd_valid), .rd_ready_i(word_rd_ready), .rd_addr_o(word_rd_addr), .rd_tag_o(word_rd_tag),
    .rsp_valid_i(texel_rsp_valid_i && !rsp_of_tile), .rsp_tag_i(texel_rsp_tag_i[TexelLineBits-1:0]),
    .rsp_data_i(texel_rsp_data_i[shadow_pkg::TexelWordBits-1:0])
  );

  logic                                 start, settles, span, steep, texel_steep, new_steep, done, changed, running;
  logic                                 unmarked;
  logic [4:0]                           mark;
  logic [B-1:0]                         base;
  logic [2*shadow_pkg::GradientCodeBits-1:0] gradient;
  logic [26:0]                          half, texel_half, new_half;
  logic [shadow_pkg::IdBits-1:0]        object;
  logic [shadow_pkg::TexelBits-1:0]     texel, new_texel;
  logic [2:0]                           texels_hidden;
  shadow_pkg::visit_t                   texel_visit;
  assign texel_visit = texel_work;
  texel_buffers texel_buffers (
    .clk_i, .rst_ni, .clear_i(drop), .paper_i(settings_i.paper_semantics),
    .in_valid_i(texel_valid), .in_fresh_i(texel_fresh), .in_i(texel_visit), .in_word_i(texel_data),
    .load_o(texel_load), .pop_o(texel_pop), .clean_o(texel_clean), .keep_o(texel_keep),
    .keep_ready_i(texel_keep_ready), .word_o(texel_word),
    .start_o(start), .settle_o(settles), .span_o(span), .steep_o(steep), .half_o(half), .gradient_o(gradient),
    .object_o(object), .base_o(base), .mark_o(mark), .unmarked_o(unmarked), .texel_o(texel), .texel_steep_o(texel_steep), .texel_half_o(texel_half),
    .done_i(done), .changed_i(changed), .texel_i(new_texel), .texel_steep_i(new_steep), .texel_half_i(new_half),
    .sum_valid_o(sum_valid), .sum_ready_i(sum_ready), .sum_covered_o(sum_covered), .sum_several_o(sum_several),
    .sum_object_o(sum_object), .sum_farthest_o(sum_farthest),
    .wr_valid_o(word_wr_valid), .wr_ready_i(word_wr_ready), .wr_mask_o(word_wr_mask),
    .idle_o(texel_idle), .running_o(running), .hidden_o(texels_hidden)
  );

  // ---- Records ----------------------------------------------------------------------------------
  logic                                  ready, lookup, hit, update, update_ready, hidden, records_idle;
  logic [shadow_pkg::RecordAddrBits-1:0] lookup_addr, update_addr;
  logic [shadow_pkg::RecordBits-1:0]     record, new_record;
  logic [3:0]                            list_cause;
  logic                                  hint_ready;
  silhouette_buffer silhouette_buffer (
    .clk_i, .rst_ni, .clear_i(drop), .paper_i(settings_i.paper_semantics),
    .record_limit_i(settings_i.record_limit), .chain_limit_i(settings_i.chain_limit),
    .start_i(start), .ready_o(ready), .settle_i(settles), .span_i(span),
    .corner_i(texel_visit.corner), .has_segment_i(texel_visit.has_segment), .segment_i(texel_visit.segment),
    .steep_i(steep), .half_i(half), .gradient_i(gradient), .object_i(object), .base_i(base), .mark_i(mark),
    .unmarked_i(unmarked), .texel_i(texel), .texel_steep_i(texel_steep), .texel_half_i(texel_half),
    .done_o(done), .changed_o(changed), .texel_o(new_texel), .texel_steep_o(new_steep), .texel_half_o(new_half),
    .lookup_o(lookup), .lookup_addr_o(lookup_addr), .hit_i(hit), .record_i(record),
    .update_o(update), .update_ready_i(update_ready), .update_addr_o(update_addr), .update_record_o(new_record),
    .cause_o(list_cause), .records_o, .hidden_o(hidden),
    .line_stored_o(events_o.line_stored), .line_cancelled_o(events_o.line_cancelled),
    .emptied_covered_o(events_o.emptied_covered), .lines_hidden_o(events_o.lines_hidden),
    .overflow_lines_o(events_o.overflow_lines), .overflow_texel_o(events_o.overflow_texel)
  );
  logic unused;
  assign unused = hint_ready;
  assign events_o.hidden_visits = texels_hidden + 3'(hidden);
  line_cache #(
    .Width(shadow_pkg::RecordBits), .AddrBits(shadow_pkg::RecordAddrBits),
    .Lines(shadow_pkg::RecordLines), .TagBits(TagBits)
  ) records (
    .clk_i, .rst_ni, .clear_i(drop),
    .hint_valid_i(1'b0), .hint_ready_o(hint_ready), .hint_weak_i(1'b0), .hint_addr_i('0),
    .lookup_i(lookup), .lookup_new_i(1'b0), .lookup_end_i(ready), .lookup_addr_i(lookup_addr), .hit_o(hit), .data_o(record),
    .update_i(update), .update_ready_o(update_ready), .update_addr_i(update_addr), .update_data_i(new_record),
    .idle_o(records_idle),
    .rd_valid_o(slb_rd_valid_o), .rd_ready_i(slb_rd_ready_i), .rd_addr_o(slb_rd_addr_o), .rd_tag_o(slb_rd_tag_o),
    .rsp_valid_i(slb_rsp_valid_i), .rsp_tag_i(slb_rsp_tag_i), .rsp_data_i(slb_rsp_data_i),
    .wr_valid_o(slb_wr_valid_o), .wr_ready_i(slb_wr_ready_i), .wr_addr_o(slb_wr_addr_o), .wr_data_o(slb_wr_data_o)
  );

  // ---- Texel memory -----------------------------------------------------------------------------
  logic wipe_ready;
  texel_port #(.TileAddrBits(TileAddrBits), .TileTagBits(TileLineBits), .WordTagBits(TexelLineBits)) texel_port (
    .clk_i, .rst_ni, .clear_i(drop),
    .word_rd_valid_i(word_rd_valid), .word_rd_ready_o(word_rd_ready), .word_rd_addr_i(word_rd_addr),
    .word_rd_tag_i(word_rd_tag), .tile_rd_valid_i(tile_rd_valid), .tile_rd_ready_o(tile_rd_ready),
    .tile_rd_addr_i(tile_rd_addr), .tile_rd_tag_i(tile_rd_tag),
    .wipe_valid_i(wiping), .wipe_ready_o(wipe_ready), .wipe_addr_i({row, column}),
    .tile_wr_valid_i(tile_wr_valid), .tile_wr_ready_o(tile_wr_ready), .tile_wr_addr_i(tile_wr_addr),
    .tile_wr_data_i(tile_written), .touch_valid_i(touch_valid), .touch_ready_o(touch_ready), .touch_addr_i(touch_addr),
    .word_wr_valid_i(word_wr_valid), .word_wr_ready_o(word_wr_ready), .word_wr_addr_i(texel_held),
    .word_wr_data_i(texel_word), .word_wr_mask_i(word_wr_mask),
    .rd_valid_o(texel_rd_valid_o), .rd_ready_i(texel_rd_ready_i), .rd_addr_o(texel_rd_addr_o),
    .rd_tag_o(texel_rd_tag_o), .wr_valid_o(texel_wr_valid_o), .wr_ready_i(texel_wr_ready_i),
    .wr_addr_o(texel_wr_addr_o), .wr_data_o(texel_wr_data_o), .wr_mask_o(texel_wr_mask_o)
  );

  // ---- How far it is ----------------------------------------------------------------------------
  logic inside_idle;
  assign inside_idle = tile_window_empty && tile_idle && texel_window_empty && texel_idle && ready && records_idle;
  assign idle_o      = inside_idle && !(settle_i && !settled_o) && !wiping;
  assign wiped_o     = wipe_i && scanned && inside_idle;
  assign settled_o   = settle_i && scanned && inside_idle;

  always_comb begin
    cause_o = shadow_pkg::StoreOther;
    if (wiping) cause_o = texel_wr_ready_i ? shadow_pkg::StoreOther : shadow_pkg::StoreWrite;
    else if (running && !done) cause_o = list_cause;
    else if (texel_pop && texel_visit.kind == shadow_pkg::VisitEdge) cause_o = shadow_pkg::StoreEdge;
    else if (texel_pop && texel_visit.kind == shadow_pkg::VisitSpan) cause_o = shadow_pkg::StoreSpan;
    else if (texel_pop || texel_valid) cause_o = word_wr_valid && !word_wr_ready ? shadow_pkg::StoreWrite : shadow_pkg::StoreOther;
    else if (texel_waits) cause_o = shadow_pkg::StoreTexel;
    else if (tile_pop && tile_work[VisitBits-1-:2] == shadow_pkg::VisitEdge) cause_o = shadow_pkg::StoreEdge;
    else if (tile_pop && tile_work[VisitBits-1-:2] == shadow_pkg::VisitSpan) cause_o = shadow_pkg::StoreSpan;
    else if (tile_pop || tile_valid) cause_o = tile_wr_valid && !tile_wr_ready ? shadow_pkg::StoreWrite : shadow_pkg::StoreOther;
    else if (tile_waits) cause_o = shadow_pkg::StoreTexel;
    else if (!visit_valid_i && !frag_valid_i && inside_idle) cause_o = shadow_pkg::StoreInput;
  end
endmodule

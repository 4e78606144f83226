// The store of pass 1: carries out visits strictly in order on the texel and SLB memories, and is alone
// to write them.
//
// A visit's addresses are worked out as it comes; from a short queue it hints its texel word and its
// bucket's record and enters the queue proper, and is carried out by silhouette_buffer and texel_buffers
// when it leaves that. Entries that a triangle's edges leave without a line wait in a list until
// VisitEdgesDone: with what covers them then, they are erased.
// Twin:    model/unit/shadow_unit_pass1.cpp.
// Timing:  docs/rtl.md, "What a visit costs".
`include "check.svh"
module store (
  input  logic                  clk_i,
  input  logic                  rst_ni,
  input  logic                  clear_i,    // drops everything
  input  shadow_pkg::settings_t settings_i,
  // commands, one at a time, held until done
  input  logic                  wipe_i,     // clears memories and allocator for a new frame
  output logic                  wiped_o,
  input  logic                  settle_i,   // end of pass 1
  output logic                  settled_o,
  // winding alone
  input  logic                  frag_valid_i,
  output logic                  frag_ready_o,
  input  shadow_pkg::frag_t     frag_i,
  // visits
  input  logic                  visit_valid_i,
  output logic                  visit_ready_o,
  input  shadow_pkg::visit_t    visit_i,
  input  shadow_pkg::visit_tri_t visit_tri_i,
  output logic                  idle_o,     // no visit inside and nothing under way to or from memory
  // texel memory
  output logic                  texel_rd_valid_o,
  input  logic                  texel_rd_ready_i,
  output logic [shadow_pkg::TexelAddrBits-1:0] texel_rd_addr_o,
  output logic [shadow_pkg::TagBits-1:0]       texel_rd_tag_o,
  input  logic                  texel_rsp_valid_i,
  input  logic [shadow_pkg::TagBits-1:0]       texel_rsp_tag_i,
  input  logic [shadow_pkg::TexelDataBits-1:0] texel_rsp_data_i,
  output logic                  texel_wr_valid_o,
  input  logic                  texel_wr_ready_i,
  output logic [shadow_pkg::TexelAddrBits-1:0] texel_wr_addr_o,
  output logic [shadow_pkg::TexelDataBits-1:0] texel_wr_data_o,
  output logic [3:0]                           texel_wr_mask_o,
  // SLB memory
  output logic                  slb_rd_valid_o,
  input  logic                  slb_rd_ready_i,
  output logic [shadow_pkg::RecordAddrBits-1:0] slb_rd_addr_o,
  output logic [shadow_pkg::TagBits-1:0]        slb_rd_tag_o,
  input  logic                  slb_rsp_valid_i,
  input  logic [shadow_pkg::TagBits-1:0]        slb_rsp_tag_i,
  input  logic [shadow_pkg::RecordBits-1:0]     slb_rsp_data_i,
  output logic                  slb_wr_valid_o,
  input  logic                  slb_wr_ready_i,
  output logic [shadow_pkg::RecordAddrBits-1:0] slb_wr_addr_o,
  output logic [shadow_pkg::RecordBits-1:0]     slb_wr_data_o,
  // for counters
  output logic [3:0]            cause_o,    // of this cycle; StoreInput: no visit, nothing to do
  output logic [shadow_pkg::LimitBits-1:0] records_o,  // SLB records in use
  output shadow_pkg::store_events_t events_o
);
  localparam int unsigned MapBits   = shadow_pkg::MapBits;
  localparam int unsigned DepthBits = shadow_pkg::DepthBits;
  localparam int unsigned Texels    = shadow_pkg::TexelsPerWord;
  localparam int unsigned VisitBits = 2 + 2 * MapBits + shadow_pkg::LineBits + 5 * DepthBits + 1 + Texels;
  localparam int unsigned TriBits   = shadow_pkg::IdBits + 2 * DepthBits + 1;
  // At least what both queues hold.
  localparam int unsigned Depth     = shadow_pkg::VisitFifoDepth < 4 ? 8 : 2 * shadow_pkg::VisitFifoDepth;
  localparam int unsigned AddrBits  = shadow_pkg::RecordAddrBits + shadow_pkg::TexelAddrBits;
  localparam int unsigned PtrBits   = $clog2(Depth);
  // An outline crosses at most so many texels of the map.
  localparam int unsigned EmptiedDepth = 8 << MapBits;
  localparam int unsigned EmptiedAhead = 32;
  localparam int unsigned PlaceBits   = 2 + 2 * MapBits + AddrBits;
  localparam int unsigned EmptiedBits = 2 * MapBits + DepthBits;

  // ---- Queues: what a visit is stands in a memory, read when its turn comes; where it is, ahead of it.
  shadow_pkg::visit_t     visit;
  shadow_pkg::visit_tri_t visit_tri;
  logic [PtrBits-1:0]     head_q, tail_q;
  logic                   push, come_ready, come_valid, come_none, enter;
  logic                   place_ready, place_valid, take_place, places_empty;
  logic [1:0]             come_kind, place_kind;
  logic [MapBits-1:0]     come_x, come_y, place_x, place_y;
  logic [Texels-1:0]      come_mask;
  logic                   texel_hint_ready, record_hint_ready, hints_ready;
  logic                   hint_emptied, edges_done;
  logic [MapBits-1:0]     listed_x, listed_y;
  logic [shadow_pkg::RecordAddrBits-1:0] visit_bucket, come_bucket, listed_bucket, place_bucket, hint_bucket;
  logic [shadow_pkg::TexelAddrBits-1:0]  visit_texel, come_texel, listed_texel, place_texel, hint_texel;

  // Nothing is to be done for VisitBegin: its triangle comes with every visit.
  assign visit_ready_o = come_ready;
  assign push          = visit_valid_i && come_ready && visit_i.kind != shadow_pkg::VisitBegin;
  assign hints_ready   = texel_hint_ready && record_hint_ready;
  assign enter         = come_valid && place_ready && hints_ready && !hint_emptied;
  assign hint_bucket   = hint_emptied ? listed_bucket : come_bucket;
  assign hint_texel    = hint_emptied ? listed_texel : come_texel;

  address_generator visit_address (
    .settings_i, .x_i(visit_i.x), .y_i(visit_i.y), .bucket_o(visit_bucket), .texel_o(visit_texel)
  );
  fifo #(.Width(PlaceBits + Texels), .Depth(2)) coming (
    .clk_i, .rst_ni, .clear_i, .valid_i(push), .ready_o(come_ready),
    .data_i({visit_i.kind, visit_i.x, visit_i.y, visit_bucket, visit_texel, visit_i.mask}),
    .valid_o(come_valid), .ready_i(enter),
    .data_o({come_kind, come_x, come_y, come_bucket, come_texel, come_mask}), .empty_o(come_none)
  );
  fifo #(.Width(PlaceBits), .Depth(shadow_pkg::VisitFifoDepth)) places (
    .clk_i, .rst_ni, .clear_i, .valid_i(enter), .ready_o(place_ready),
    .data_i({come_kind, come_x, come_y, come_bucket, come_texel}),
    .valid_o(place_valid), .ready_i(take_place),
    .data_o({place_kind, place_x, place_y, place_bucket, place_texel}), .empty_o(places_empty)
  );
  ram_1r1w #(.Width(TriBits + VisitBits), .Depth(Depth)) visits (
    .clk_i, .write_i(push), .write_addr_i(tail_q), .write_data_i({visit_tri_i, visit_i}),
    .read_i(take_place), .read_addr_i(head_q), .read_data_o({visit_tri, visit})
  );

  // ---- Emptied entries: a list; from when the triangle's VisitEdgesDone is in the queue on, its first
  // ones are hinted and stand in a short queue of their own.
  logic               emptied, emptied_valid, take_emptied, list_none, soon_none, list_ready, soon_ready;
  logic               listed_valid;
  logic [MapBits-1:0] emptied_x, emptied_y, x, y;
  logic [DepthBits-1:0] emptied_depth, listed_depth;
  logic [shadow_pkg::RecordAddrBits-1:0] emptied_bucket;
  logic [shadow_pkg::TexelAddrBits-1:0]  emptied_texel;
  logic [PtrBits-1:0] closing_q;  // VisitEdgesDone in the queue
  logic               closing, closed;

  fifo #(.Width(EmptiedBits), .Depth(EmptiedDepth)) emptied_list (
    .clk_i, .rst_ni, .clear_i, .valid_i(emptied), .ready_o(list_ready),
    .data_i({x, y, visit.depth0}),
    .valid_o(listed_valid), .ready_i(hint_emptied && hints_ready),
    .data_o({listed_x, listed_y, listed_depth}), .empty_o(list_none)
  );
  address_generator listed_address (
    .settings_i, .x_i(listed_x), .y_i(listed_y), .bucket_o(listed_bucket), .texel_o(listed_texel)
  );
  assign hint_emptied = listed_valid && soon_ready && closing_q != '0;
  fifo #(.Width(EmptiedBits + AddrBits), .Depth(EmptiedAhead)) emptied_soon (
    .clk_i, .rst_ni, .clear_i, .valid_i(hint_emptied && hints_ready), .ready_o(soon_ready),
    .data_i({listed_x, listed_y, listed_depth, listed_bucket, listed_texel}),
    .valid_o(emptied_valid), .ready_i(take_emptied),
    .data_o({emptied_x, emptied_y, emptied_depth, emptied_bucket, emptied_texel}), .empty_o(soon_none)
  );
  assign closing = enter && come_kind == shadow_pkg::VisitEdgesDone;
  assign closed  = take_place && edges_done;

  // ---- The next operation: a visit, or after the edges an emptied entry ---------------------------
  logic               done, ready, start, no_emptied;
  logic [MapBits-1:0] next_x, next_y;
  logic [shadow_pkg::RecordAddrBits-1:0] next_bucket;
  logic [shadow_pkg::TexelAddrBits-1:0]  next_texel;

  assign edges_done   = place_valid && place_kind == shadow_pkg::VisitEdgesDone;
  assign no_emptied   = list_none && soon_none && !emptied;
  assign start        = edges_done ? emptied_valid : place_valid;
  assign take_emptied = edges_done && emptied_valid && ready;
  assign take_place   = edges_done ? no_emptied && ready : place_valid && ready;
  assign next_x       = edges_done ? emptied_x : place_x;
  assign next_y       = edges_done ? emptied_y : place_y;
  assign next_bucket  = edges_done ? emptied_bucket : place_bucket;
  assign next_texel   = edges_done ? emptied_texel : place_texel;

  // ---- The buffers --------------------------------------------------------------------------------
  logic                 texel_hit, texel_update, texel_ready, texel_set_edge, texel_edge, texel_set_overflow;
  logic [1:0]           texel_select;
  shadow_pkg::texel_t   texel;
  logic [Texels-1:0]    texel_edges, texel_cover;
  logic [Texels*DepthBits-1:0] texel_depth;
  logic [shadow_pkg::IdBits-1:0] texel_id;
  logic                 texels_wiped, records_wiped, texels_idle, records_idle, busy_q;
  logic [3:0]           cause;

  texel_buffers texels (
    .clk_i, .rst_ni, .clear_i, .settings_i, .wipe_i, .wiped_o(texels_wiped),
    .hint_valid_i((hint_emptied && hints_ready) || (enter && come_kind != shadow_pkg::VisitEdgesDone)),
    .hint_ready_o(texel_hint_ready),
    .hint_addr_i(hint_texel),
    .lookup_i(start && ready), .lookup_end_i(done), .lookup_addr_i(next_texel), .hit_o(texel_hit),
    .select_i(texel_select), .texel_o(texel), .edges_o(texel_edges),
    .update_i(texel_update), .update_ready_o(texel_ready), .cover_i(texel_cover), .depth_i(texel_depth),
    .id_i(texel_id), .set_edge_i(texel_set_edge), .edge_i(texel_edge), .set_overflow_i(texel_set_overflow),
    .idle_o(texels_idle),
    .rd_valid_o(texel_rd_valid_o), .rd_ready_i(texel_rd_ready_i), .rd_addr_o(texel_rd_addr_o),
    .rd_tag_o(texel_rd_tag_o), .rsp_valid_i(texel_rsp_valid_i), .rsp_tag_i(texel_rsp_tag_i),
    .rsp_data_i(texel_rsp_data_i), .wr_valid_o(texel_wr_valid_o), .wr_ready_i(texel_wr_ready_i),
    .wr_addr_o(texel_wr_addr_o), .wr_data_o(texel_wr_data_o), .wr_mask_o(texel_wr_mask_o)
  );

  logic soon_valid, soon_hint_ready, active;
  logic [shadow_pkg::RecordAddrBits-1:0] soon_addr;
  silhouette_buffer records (
    .clk_i, .rst_ni, .clear_i, .settings_i, .wipe_i, .wiped_o(records_wiped),
    .hint_valid_i((hint_emptied && hints_ready) || (enter && come_kind == shadow_pkg::VisitEdge)),
    .hint_ready_o(record_hint_ready),
    .hint_addr_i(hint_bucket), .soon_valid_i(soon_valid), .soon_ready_o(soon_hint_ready), .soon_addr_i(soon_addr), .active_i(active),
    .start_i(start), .ready_o(ready), .kind_i(place_kind), .x_i(next_x), .y_i(next_y),
    .bucket_i(next_bucket), .depth_i(emptied_depth), .visit_i(visit), .tri_i(visit_tri),
    .emptied_o(emptied), .x_o(x), .y_o(y),
    .texel_hit_i(texel_hit), .texel_select_o(texel_select), .texel_i(texel), .texel_edges_i(texel_edges),
    .texel_update_o(texel_update), .texel_ready_i(texel_ready), .texel_cover_o(texel_cover),
    .texel_depth_o(texel_depth), .texel_id_o(texel_id), .texel_set_edge_o(texel_set_edge),
    .texel_edge_o(texel_edge), .texel_set_overflow_o(texel_set_overflow),
    .rd_valid_o(slb_rd_valid_o), .rd_ready_i(slb_rd_ready_i), .rd_addr_o(slb_rd_addr_o),
    .rd_tag_o(slb_rd_tag_o), .rsp_valid_i(slb_rsp_valid_i), .rsp_tag_i(slb_rsp_tag_i),
    .rsp_data_i(slb_rsp_data_i), .wr_valid_o(slb_wr_valid_o), .wr_ready_i(slb_wr_ready_i),
    .wr_addr_o(slb_wr_addr_o), .wr_data_o(slb_wr_data_o),
    .idle_o(records_idle), .cause_o(cause), .records_o, .events_o
  );

  span_hints spans (
    .clk_i, .rst_ni, .clear_i(clear_i || wipe_i), .settings_i,
    .visit_i(enter && come_kind != shadow_pkg::VisitEdgesDone),
    .visit_span_i(come_kind == shadow_pkg::VisitSpan && settings_i.hidden_removal != 2'd0),
    .visit_addr_i(come_texel), .visit_bucket_i(come_bucket), .visit_mask_i(come_mask),
    .read_i(texel_rd_valid_o && texel_rd_ready_i), .read_addr_i(texel_rd_addr_o), .read_tag_i(texel_rd_tag_o),
    .rsp_valid_i(texel_rsp_valid_i), .rsp_tag_i(texel_rsp_tag_i), .rsp_data_i(texel_rsp_data_i),
    .hint_valid_o(soon_valid), .hint_ready_i(soon_hint_ready), .hint_addr_o(soon_addr)
  );

  assign done         = busy_q && ready;
  assign active       = !(come_none && places_empty && list_none && soon_none) || busy_q;
  assign idle_o       = !active && texels_idle && records_idle;
  assign wiped_o      = texels_wiped && records_wiped;
  assign settled_o    = settle_i && idle_o;
  assign frag_ready_o = 1'b1;

  always_comb begin
    cause_o = shadow_pkg::StoreInput;
    if (wipe_i) cause_o = shadow_pkg::StoreOther;
    else if (busy_q) cause_o = cause;
    else if (edges_done) cause_o = shadow_pkg::StoreOther;
  end

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      head_q <= '0;
      tail_q <= '0;
      closing_q <= '0;
      busy_q <= 1'b0;
    end else if (clear_i) begin
      head_q <= '0;
      tail_q <= '0;
      closing_q <= '0;
      busy_q <= 1'b0;
    end else begin
      if (take_place) head_q <= head_q + 1'b1;
      if (push) tail_q <= tail_q + 1'b1;
      closing_q <= closing_q + PtrBits'(closing) - PtrBits'(closed);
      busy_q <= ready ? start : busy_q;
      `CHECK(emptied_has_room, !emptied || list_ready)
      `CHECK(spans_start_at_words, !(push && visit_i.kind == shadow_pkg::VisitSpan) || visit_i.x[1:0] == 2'd0)
    end
  end

  logic unused;
  assign unused = &{1'b0, frag_valid_i, frag_i};
endmodule

// A lane of pass 2: fragments in, verdicts out, in the same order.
//
// A fragment holds a slot. Its tile and its texel are looked up in order, neighbours sharing words; the
// clusters of lists are read in any order, with at most one read under way for each slot.
// Twins:   model/unit/winding/shadow_unit_pass2.cpp, decide
// Timing:  one fragment a cycle while `FragmentSlots` cover the memories' latency and lists are short;
//          SLB records one a cycle. Responses are always taken.
// Clear:   also at the start of a pass: words that neighbours share must be of one pass.
module shadow_lane (
  input  logic                                  clk_i,
  input  logic                                  rst_ni,     // asynchronous, active low
  input  logic                                  clear_i,
  /* verilator lint_off UNUSEDSIGNAL */  // some are pass 1's; tags have room for more slots
  input  shadow_pkg::settings_t                 settings_i, // constant while fragments are inside
  /* verilator lint_on UNUSEDSIGNAL */
  input  logic                                  frag_valid_i,
  output logic                                  frag_ready_o,
  input  shadow_pkg::frag_t                     frag_i,
  output logic                                  verdict_valid_o,
  input  logic                                  verdict_ready_i,
  output shadow_pkg::verdict_t                  verdict_o,
  output logic                                  idle_o,     // no fragment inside
  // texel memory
  output logic                                  texel_rd_valid_o,
  input  logic                                  texel_rd_ready_i,
  output logic [shadow_pkg::TexelAddrBits-1:0]  texel_rd_addr_o,
  output logic [shadow_pkg::TagBits-1:0]        texel_rd_tag_o,
  input  logic                                  texel_rsp_valid_i,
  input  logic [shadow_pkg::TagBits-1:0]        texel_rsp_tag_i,
  input  logic [shadow_pkg::TexelDataBits-1:0]  texel_rsp_data_i,
  // SLB memory; a tag is a slot
  output logic                                  slb_rd_valid_o,
  input  logic                                  slb_rd_ready_i,
  output logic [shadow_pkg::RecordAddrBits-1:0] slb_rd_addr_o,
  output logic [shadow_pkg::TagBits-1:0]        slb_rd_tag_o,
  input  logic                                  slb_rsp_valid_i,
  /* verilator lint_off UNUSEDSIGNAL */
  input  logic [shadow_pkg::TagBits-1:0]        slb_rsp_tag_i,
  /* verilator lint_on UNUSEDSIGNAL */
  input  logic [shadow_pkg::RecordBits-1:0]     slb_rsp_data_i,
  output logic [3:0]                            cause_o,    // Lane*, of this cycle
  output shadow_pkg::lane_events_t              events_o
);
  localparam int unsigned SlotBits = shadow_pkg::SlotBits;
  localparam int unsigned MapBits = shadow_pkg::MapBits;
  localparam int unsigned Most = shadow_pkg::MaxFraction;
  localparam int unsigned G = shadow_pkg::EndBits;
  localparam int unsigned IdBits = shadow_pkg::IdBits;
  localparam int unsigned DepthBits = shadow_pkg::TraceDepthBits;
  localparam int unsigned VerdictBits = shadow_pkg::VerdictBits;

  // ---- Slots ------------------------------------------------------------------------------------
  logic                free, take, oldest_done;
  logic [SlotBits-1:0] slot, oldest;
  logic                known_valid, known_final, early, early_final, late;
  logic [SlotBits-1:0] early_slot, late_slot;
  logic [VerdictBits-1:0] known_verdict, early_verdict, late_verdict;
  logic                slot1_valid_q, enter;
  logic [SlotBits-1:0] slot1_q;

  lane_slots #(
    .Slots(shadow_pkg::FragmentSlots), .Most(shadow_pkg::FragmentsInFlight), .Width(VerdictBits)
  ) slots (
    .clk_i, .rst_ni, .clear_i, .free_o(free), .take_i(take), .slot_o(slot),
    .known_i(known_valid), .known_slot_i(slot1_q), .known_final_i(known_final),
    .known_verdict_i(known_verdict),
    .early_i(early), .early_slot_i(early_slot), .early_final_i(early_final),
    .early_verdict_i(early_verdict),
    .late_i(late), .late_slot_i(late_slot), .late_verdict_i(late_verdict),
    .verdict_valid_o, .verdict_ready_i, .verdict_o, .oldest_o(oldest), .oldest_done_o(oldest_done),
    .idle_o
  );

  // ---- Entry: where the fragment lies, and whether that decides -----------------------------------
  logic                 on_map_x, on_map_y, on_map1_q, averted1_q, outside1_q, unshadowable1_q;
  logic [MapBits-1:0]   texel_x, texel_y, texel_x1_q, texel_y1_q;
  logic [Most-1:0]      place_x, place_y, place_x1_q, place_y1_q;
  logic [DepthBits-1:0] depth1_q;
  logic [IdBits-1:0]    object1_q;
  logic                 defined, known, lookup, lookup_ready;

  fragment_place place_along_x (
    .texel_bits_i(settings_i.texel_bits), .map_side_i(settings_i.map_width), .position_i(frag_i.p.x),
    .on_map_o(on_map_x), .texel_o(texel_x), .place_o(place_x)
  );
  fragment_place place_along_y (
    .texel_bits_i(settings_i.texel_bits), .map_side_i(settings_i.map_height), .position_i(frag_i.p.y),
    .on_map_o(on_map_y), .texel_o(texel_y), .place_o(place_y)
  );
  assign enter        = slot1_valid_q && (!lookup || lookup_ready);
  assign frag_ready_o = free && (!slot1_valid_q || enter);
  assign take         = frag_valid_i && frag_ready_o;
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) slot1_valid_q <= 1'b0;
    else slot1_valid_q <= (take || (slot1_valid_q && !enter)) && !clear_i;
  end
  always_ff @(posedge clk_i) begin
    if (take) begin
      slot1_q         <= slot;
      on_map1_q       <= on_map_x && on_map_y;
      averted1_q      <= frag_i.averted;
      outside1_q      <= frag_i.outside;
      unshadowable1_q <= frag_i.unshadowable;
      texel_x1_q      <= texel_x;
      texel_y1_q      <= texel_y;
      place_x1_q      <= place_x;
      place_y1_q      <= place_y;
      depth1_q        <= frag_i.p.z;
      object1_q       <= frag_i.object[IdBits-1:0];
    end
  end

  assign defined       = averted1_q || outside1_q || !on_map1_q;
  assign known         = defined || (settings_i.skip_fragments && unshadowable1_q);
  assign lookup        = !known || (!settings_i.skip_fragments && on_map1_q);
  assign known_valid   = enter;
  assign known_final   = !lookup;
  assign known_verdict = averted1_q ? {shadow_pkg::ByDefinition, 1'b1}
                       : {defined ? shadow_pkg::ByOutside : shadow_pkg::ByNothing, 1'b0};

  // ---- Tile and texel -----------------------------------------------------------------------------
  logic                                  list, texel_waits_port, texel_waits_memory, texel_port_busy;
  logic [SlotBits-1:0]                   list_slot;
  logic [shadow_pkg::RecordAddrBits-1:0] list_first;

  early_decision early_stage (
    .clk_i, .rst_ni, .clear_i, .paper_semantics_i(settings_i.paper_semantics),
    .skip_tiles_i(settings_i.skip_tiles), .skip_first_test_i(settings_i.skip_first_test),
    .valid_i(slot1_valid_q && lookup), .ready_o(lookup_ready),
    .slot_i(slot1_q), .defined_i(defined), .averted_i(averted1_q), .texel_x_i(texel_x1_q),
    .texel_y_i(texel_y1_q), .place_x_i(place_x1_q[Most-1-:G]), .place_y_i(place_y1_q[Most-1-:G]),
    .depth_i(depth1_q), .object_i(object1_q),
    .early_o(early), .early_slot_o(early_slot), .early_final_o(early_final),
    .early_verdict_o(early_verdict),
    .list_o(list), .list_slot_o(list_slot), .list_first_o(list_first),
    .rd_valid_o(texel_rd_valid_o), .rd_ready_i(texel_rd_ready_i), .rd_addr_o(texel_rd_addr_o),
    .rd_tag_o(texel_rd_tag_o), .rsp_valid_i(texel_rsp_valid_i), .rsp_tag_i(texel_rsp_tag_i),
    .rsp_data_i(texel_rsp_data_i),
    .tile_lit_o(events_o.tile_lit), .tile_dark_o(events_o.tile_dark),
    .texel_lookup_o(events_o.texel_lookup), .first_test_o(events_o.first_test),
    .waits_port_o(texel_waits_port), .waits_memory_o(texel_waits_memory), .port_busy_o(texel_port_busy)
  );

  // ---- Lists --------------------------------------------------------------------------------------
  logic                late_dark, slb_waits_port, slb_waits_memory, slb_deciding;
  logic [SlotBits-1:0] slb_tag;
  assign slb_rd_tag_o = shadow_pkg::TagBits'(slb_tag);
  list_reader lists (
    .clk_i, .rst_ni, .clear_i, .paper_semantics_i(settings_i.paper_semantics),
    .frag_i(enter), .frag_slot_i(slot1_q), .frag_x_i(place_x1_q), .frag_y_i(place_y1_q),
    .frag_depth_i(depth1_q), .frag_object_i(object1_q),
    .list_i(list), .list_slot_i(list_slot), .list_first_i(list_first),
    .late_o(late), .late_slot_o(late_slot), .late_dark_o(late_dark),
    .rd_valid_o(slb_rd_valid_o), .rd_ready_i(slb_rd_ready_i), .rd_addr_o(slb_rd_addr_o),
    .rd_tag_o(slb_tag), .rsp_valid_i(slb_rsp_valid_i), .rsp_tag_i(slb_rsp_tag_i[SlotBits-1:0]),
    .rsp_data_i(slb_rsp_data_i),
    .entry_read_o(events_o.entry_read), .lines_read_o(events_o.lines_read),
    .oldest_i(oldest), .waits_port_o(slb_waits_port), .waits_memory_o(slb_waits_memory),
    .deciding_o(slb_deciding)
  );
  assign late_verdict        = {late_dark ? shadow_pkg::ByLines : shadow_pkg::ByNothing, late_dark};
  assign events_o.known      = enter && known && settings_i.skip_fragments;
  assign events_o.slb_lookup = list;

  // ---- Where cycles go ----------------------------------------------------------------------------
  // A fragment that has no list, or not yet, is where fragments go in order. No slot is free only if none
  // left in the cycle before: the oldest one is still the one that `lists` tells of.
  always_comb begin
    if (take) cause_o = shadow_pkg::LaneFragment;
    else if (frag_ready_o) cause_o = shadow_pkg::LaneInput;
    else if (verdict_valid_o && !verdict_ready_i) cause_o = shadow_pkg::LaneVerdict;
    else if (free) cause_o = texel_port_busy ? shadow_pkg::LaneTexelPort : shadow_pkg::LaneTexel;
    else if (oldest_done || slb_deciding) cause_o = shadow_pkg::LaneDecision;
    else if (slb_waits_port) cause_o = shadow_pkg::LaneSlbPort;
    else if (slb_waits_memory) cause_o = shadow_pkg::LaneSlb;
    else if (texel_waits_port) cause_o = shadow_pkg::LaneTexelPort;
    else cause_o = texel_waits_memory ? shadow_pkg::LaneTexel : shadow_pkg::LaneDecision;
  end
endmodule

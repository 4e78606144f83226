// The shadow unit: pass 1 (front and store) and pass 2 (lanes) behind registers, streams and memory
// ports. docs/rtl.md has the register map and the rules of the ports.
//
// Source:  IPSJ 2008, 3 and 4; docs/unit.md.
// Twins:   model/unit/shadow_unit.h, model/unit/winding/shadow_unit.h
// Timing:  one pass at a time, started by a register; busy until its last beat has gone.
// Lanes:   fragment i of a pass goes to lane i mod Lanes, whose verdicts come back in order. Lane l
//          has slice l of every vector and a memory port of its own; lane 0's serves pass 1 too.
//          Announced fragments all enter at lane 0.
module shadow_unit (
  input  logic        clk_i,
  input  logic        rst_ni,  // asynchronous, active low; only control is reset
  // Registers, AXI4-Lite
  input  logic        s_awvalid_i,
  output logic        s_awready_o,
  input  logic [7:0]  s_awaddr_i,
  input  logic        s_wvalid_i,
  output logic        s_wready_o,
  input  logic [31:0] s_wdata_i,
  output logic        s_bvalid_o,
  input  logic        s_bready_i,
  input  logic        s_arvalid_i,
  output logic        s_arready_o,
  input  logic [7:0]  s_araddr_i,
  output logic        s_rvalid_o,
  input  logic        s_rready_i,
  output logic [31:0] s_rdata_o,
  output logic        irq_o,  // one cycle: a pass is done
  // Triangles
  input  logic                  tri_valid_i,
  output logic                  tri_ready_o,
  input  shadow_pkg::tri_t      tri_i,
  // Fragments and verdicts, a lane each
  input  logic [shadow_pkg::Lanes-1:0]                         frag_valid_i,
  output logic [shadow_pkg::Lanes-1:0]                         frag_ready_o,
  input  logic [shadow_pkg::Lanes*shadow_pkg::FragBits-1:0]    frag_i,     // frag_t
  output logic [shadow_pkg::Lanes-1:0]                         verdict_valid_o,
  input  logic [shadow_pkg::Lanes-1:0]                         verdict_ready_i,
  output logic [shadow_pkg::Lanes*shadow_pkg::VerdictBits-1:0] verdict_o,  // verdict_t
  // Texel memory
  output logic [shadow_pkg::Lanes-1:0]                           texel_rd_valid_o,
  input  logic [shadow_pkg::Lanes-1:0]                           texel_rd_ready_i,
  output logic [shadow_pkg::Lanes*shadow_pkg::TexelAddrBits-1:0] texel_rd_addr_o,
  output logic [shadow_pkg::Lanes*shadow_pkg::TagBits-1:0]       texel_rd_tag_o,
  input  logic [shadow_pkg::Lanes-1:0]                           texel_rsp_valid_i,
  input  logic [shadow_pkg::Lanes*shadow_pkg::TagBits-1:0]       texel_rsp_tag_i,
  input  logic [shadow_pkg::Lanes*shadow_pkg::TexelDataBits-1:0] texel_rsp_data_i,
  output logic                                                   texel_wr_valid_o,
  input  logic                                                   texel_wr_ready_i,
  output logic [shadow_pkg::TexelAddrBits-1:0]                   texel_wr_addr_o,
  output logic [shadow_pkg::TexelDataBits-1:0]                   texel_wr_data_o,
  output logic [shadow_pkg::TexelsPerWord-1:0]                   texel_wr_mask_o,
  // SLB memory
  output logic [shadow_pkg::Lanes-1:0]                            slb_rd_valid_o,
  input  logic [shadow_pkg::Lanes-1:0]                            slb_rd_ready_i,
  output logic [shadow_pkg::Lanes*shadow_pkg::RecordAddrBits-1:0] slb_rd_addr_o,
  output logic [shadow_pkg::Lanes*shadow_pkg::TagBits-1:0]        slb_rd_tag_o,
  input  logic [shadow_pkg::Lanes-1:0]                            slb_rsp_valid_i,
  input  logic [shadow_pkg::Lanes*shadow_pkg::TagBits-1:0]        slb_rsp_tag_i,
  input  logic [shadow_pkg::Lanes*shadow_pkg::RecordBits-1:0]     slb_rsp_data_i,
  output logic                                                    slb_wr_valid_o,
  input  logic                                                    slb_wr_ready_i,
  output logic [shadow_pkg::RecordAddrBits-1:0]                   slb_wr_addr_o,
  output logic [shadow_pkg::RecordBits-1:0]                       slb_wr_data_o,
  // For profiling; leave open in a chip
  output logic [2:0]                                              pass_o,
  output logic [3:0]                                              store_cause_o,  // of a cycle of pass 1, Store*
  output logic [shadow_pkg::Lanes*4-1:0]                          lane_cause_o,   // of a cycle of pass 2, Lane*
  output shadow_pkg::front_events_t                               front_events_o,
  output shadow_pkg::store_events_t                               store_events_o,
  output logic [shadow_pkg::Lanes*shadow_pkg::LaneEventBits-1:0]  lane_events_o,  // lane_events_t
  output logic [shadow_pkg::LimitBits-1:0]                        records_o       // in use
);
  localparam int unsigned Lanes = shadow_pkg::Lanes;

  // ---- Registers and passes -------------------------------------------------------------------
  logic        start, abort, busy, open, waits, closing, closed, clear, clear_lanes, counter_clear;
  logic [2:0]  pass_written, items;
  logic [31:0] count, cycles, counter_q;
  logic [15:0] increment, increment_q;
  logic [5:0]  counter_select;
  logic        overflow_q;
  logic [4:0]  fraction_bits, buckets_log2;
  logic [12:0] map_width, map_height;
  logic [3:0]  pitch_log2;
  logic [24:0] record_limit, chain_limit;
  logic [16:0] plane_tolerance;
  logic [6:0]  policy;
  shadow_pkg::settings_t settings;
  logic        drawing, announcing, deciding, pass1_active, pass2;
  logic        front_idle, store_idle, wiped, settled;
  logic [Lanes-1:0] lane_idle, texel_outstanding, slb_outstanding;

  unit_registers registers (
    .clk_i, .rst_ni,
    .s_awvalid_i, .s_awready_o, .s_awaddr_i, .s_wvalid_i, .s_wready_o, .s_wdata_i,
    .s_bvalid_o, .s_bready_i, .s_arvalid_i, .s_arready_o, .s_araddr_i,
    .s_rvalid_o, .s_rready_i, .s_rdata_o,
    .start_o(start), .abort_o(abort), .pass_o(pass_written), .count_o(count),
    .fraction_bits_o(fraction_bits), .map_width_o(map_width), .map_height_o(map_height),
    .pitch_log2_o(pitch_log2), .buckets_log2_o(buckets_log2), .record_limit_o(record_limit),
    .chain_limit_o(chain_limit), .plane_tolerance_o(plane_tolerance), .policy_o(policy),
    .counter_select_o(counter_select), .counter_clear_o(counter_clear),
    .busy_i(busy || start), .pass_i(pass_o), .overflow_i(overflow_q), .cycles_i(cycles),
    .records_i(records_o), .counter_i(counter_q)
  );
  unit_settings settings_of_registers (
    .fraction_bits_i(fraction_bits), .map_width_i(map_width), .map_height_i(map_height),
    .pitch_log2_i(pitch_log2), .buckets_log2_i(buckets_log2), .record_limit_i(record_limit),
    .chain_limit_i(chain_limit), .plane_tolerance_i(plane_tolerance), .policy_i(policy),
    .settings_o(settings)
  );
  pass_control control (
    .clk_i, .rst_ni, .start_i(start), .pass_i(pass_written), .count_i(count), .abort_i(abort),
    .items_i(items), .front_idle_i(front_idle), .store_idle_i(store_idle), .wiped_i(wiped),
    .settled_i(settled), .lanes_idle_i(&lane_idle), .closed_i(closed),
    .outstanding_i(|texel_outstanding || |slb_outstanding),
    .pass_o, .pass2_o(pass2), .busy_o(busy), .open_o(open), .waits_o(waits), .close_o(closing), .clear_o(clear),
    .clear_lanes_o(clear_lanes), .done_o(irq_o), .cycles_o(cycles)
  );
  unit_events events (
    .select_i(counter_select), .front_i(front_events_o), .store_i(store_events_o),
    .lanes_i(lane_events_o), .store_cause_i(store_cause_o), .store_active_i(pass1_active),
    .lane_cause_i(lane_cause_o[3:0]), .lane_active_i(deciding), .increment_o(increment)
  );

  assign announcing   = pass_o == shadow_pkg::PassAnnounce;
  assign drawing      = pass_o == shadow_pkg::PassDraw;
  assign deciding     = pass_o == shadow_pkg::PassDecide;
  assign pass1_active = pass_o != shadow_pkg::PassIdle && !deciding;

  always_ff @(posedge clk_i) begin
    overflow_q <= (overflow_q && pass_o != shadow_pkg::PassWipe) || store_events_o.overflow_texel;
    // A cycle late: what counted is known last.
    increment_q <= counter_clear ? '0 : increment;
    counter_q   <= counter_clear ? '0 : counter_q + 32'(increment_q);
  end

  // ---- Pass 1 ---------------------------------------------------------------------------------
  logic                   tri_valid, tri_ready, visit_valid, visit_ready, front_setup;
  logic                   announce_valid, announce_ready;
  shadow_pkg::visit_t     visit;
  shadow_pkg::visit_tri_t visit_tri;
  logic [3:0]             store_cause;

  assign tri_valid   = tri_valid_i && drawing && open;
  assign tri_ready_o = tri_ready && drawing && open;

  front front (
    .clk_i, .rst_ni, .clear_i(clear), .settings_i(settings),
    .tri_valid_i(tri_valid), .tri_ready_o(tri_ready), .tri_i,
    .visit_valid_o(visit_valid), .visit_ready_i(visit_ready), .visit_o(visit),
    .visit_tri_o(visit_tri), .idle_o(front_idle), .setup_o(front_setup), .events_o(front_events_o)
  );

  // Of the store's port, and what is left of it after an abort.
  logic                                   store_texel_rd_valid, store_slb_rd_valid;
  logic                                   store_texel_wr_valid, store_slb_wr_valid;
  logic                                   store_texel_rd_ready, store_slb_rd_ready;
  logic                                   store_texel_wr_ready, store_slb_wr_ready;
  logic [shadow_pkg::TexelAddrBits-1:0]   store_texel_rd_addr;
  logic [shadow_pkg::RecordAddrBits-1:0]  store_slb_rd_addr;
  logic [shadow_pkg::TagBits-1:0]         store_texel_rd_tag, store_slb_rd_tag;

  store store (
    .clk_i, .rst_ni, .clear_i(clear), .settings_i(settings),
    .wipe_i(pass_o == shadow_pkg::PassWipe && !closing), .wiped_o(wiped),
    .settle_i(pass_o == shadow_pkg::PassSettle && !closing), .settled_o(settled),
    .frag_valid_i(announce_valid), .frag_ready_o(announce_ready),
    .frag_i(frag_i[shadow_pkg::FragBits-1:0]),
    .visit_valid_i(visit_valid), .visit_ready_o(visit_ready), .visit_i(visit),
    .visit_tri_i(visit_tri), .idle_o(store_idle),
    .texel_rd_valid_o(store_texel_rd_valid), .texel_rd_ready_i(store_texel_rd_ready),
    .texel_rd_addr_o(store_texel_rd_addr), .texel_rd_tag_o(store_texel_rd_tag),
    .texel_rsp_valid_i(texel_rsp_valid_i[0] && !pass2),
    .texel_rsp_tag_i(texel_rsp_tag_i[shadow_pkg::TagBits-1:0]),
    .texel_rsp_data_i(texel_rsp_data_i[shadow_pkg::TexelDataBits-1:0]),
    .texel_wr_valid_o(store_texel_wr_valid), .texel_wr_ready_i(store_texel_wr_ready),
    .texel_wr_addr_o, .texel_wr_data_o, .texel_wr_mask_o,
    .slb_rd_valid_o(store_slb_rd_valid), .slb_rd_ready_i(store_slb_rd_ready),
    .slb_rd_addr_o(store_slb_rd_addr), .slb_rd_tag_o(store_slb_rd_tag),
    .slb_rsp_valid_i(slb_rsp_valid_i[0] && !pass2),
    .slb_rsp_tag_i(slb_rsp_tag_i[shadow_pkg::TagBits-1:0]),
    .slb_rsp_data_i(slb_rsp_data_i[shadow_pkg::RecordBits-1:0]),
    .slb_wr_valid_o(store_slb_wr_valid), .slb_wr_ready_i(store_slb_wr_ready),
    .slb_wr_addr_o, .slb_wr_data_o,
    .cause_o(store_cause), .records_o, .events_o(store_events_o)
  );

  // The store knows only that nothing was offered; the front knows why.
  always_comb begin
    store_cause_o = store_cause;
    if (store_cause == shadow_pkg::StoreInput && drawing && !front_idle) begin
      store_cause_o = front_setup ? shadow_pkg::StoreSetup : shadow_pkg::StoreWalk;
    end
  end

  // ---- Pass 2 ---------------------------------------------------------------------------------
  logic [Lanes-1:0]   frag_valid, frag_ready, verdict_valid, verdict_ready;
  logic [Lanes-1:0]   lane_texel_valid, lane_texel_ready, lane_slb_valid, lane_slb_ready;
  logic [Lanes-1:0]   texel_valid, texel_ready, slb_valid, slb_ready;
  logic [Lanes*shadow_pkg::TexelAddrBits-1:0]  lane_texel_addr;
  logic [Lanes*shadow_pkg::RecordAddrBits-1:0] lane_slb_addr;
  logic [Lanes*shadow_pkg::TagBits-1:0]        lane_texel_tag, lane_slb_tag;

  assign frag_valid     = frag_valid_i & {Lanes{deciding && open}};
  assign announce_valid = frag_valid_i[0] && announcing && open;
  always_comb begin
    frag_ready_o = frag_ready & {Lanes{deciding && open}};
    if (announcing) frag_ready_o[0] = announce_ready && open;
  end

  for (genvar l = 0; l < Lanes; l++) begin : g_lane
    logic [3:0] cause;
    shadow_pkg::verdict_t     verdict;
    shadow_pkg::lane_events_t lane_events;

    shadow_lane lane (
      .clk_i, .rst_ni, .clear_i(clear_lanes), .settings_i(settings),
      .frag_valid_i(frag_valid[l]), .frag_ready_o(frag_ready[l]),
      .frag_i(frag_i[l*shadow_pkg::FragBits+:shadow_pkg::FragBits]),
      .verdict_valid_o(verdict_valid[l]), .verdict_ready_i(verdict_ready[l]), .verdict_o(verdict),
      .idle_o(lane_idle[l]),
      .texel_rd_valid_o(lane_texel_valid[l]), .texel_rd_ready_i(lane_texel_ready[l]),
      .texel_rd_addr_o(lane_texel_addr[l*shadow_pkg::TexelAddrBits+:shadow_pkg::TexelAddrBits]),
      .texel_rd_tag_o(lane_texel_tag[l*shadow_pkg::TagBits+:shadow_pkg::TagBits]),
      .texel_rsp_valid_i(texel_rsp_valid_i[l] && deciding),
      .texel_rsp_tag_i(texel_rsp_tag_i[l*shadow_pkg::TagBits+:shadow_pkg::TagBits]),
      .texel_rsp_data_i(texel_rsp_data_i[l*shadow_pkg::TexelDataBits+:shadow_pkg::TexelDataBits]),
      .slb_rd_valid_o(lane_slb_valid[l]), .slb_rd_ready_i(lane_slb_ready[l]),
      .slb_rd_addr_o(lane_slb_addr[l*shadow_pkg::RecordAddrBits+:shadow_pkg::RecordAddrBits]),
      .slb_rd_tag_o(lane_slb_tag[l*shadow_pkg::TagBits+:shadow_pkg::TagBits]),
      .slb_rsp_valid_i(slb_rsp_valid_i[l] && deciding),
      .slb_rsp_tag_i(slb_rsp_tag_i[l*shadow_pkg::TagBits+:shadow_pkg::TagBits]),
      .slb_rsp_data_i(slb_rsp_data_i[l*shadow_pkg::RecordBits+:shadow_pkg::RecordBits]),
      .cause_o(cause), .events_o(lane_events)
    );
    assign verdict_o[l*shadow_pkg::VerdictBits+:shadow_pkg::VerdictBits] = verdict;
    assign lane_events_o[l*shadow_pkg::LaneEventBits+:shadow_pkg::LaneEventBits] = lane_events;
    assign lane_cause_o[l*4+:4] =
        cause == shadow_pkg::LaneInput && !waits ? shadow_pkg::LaneDrain : cause;

    memory_reads texel_reads (
      .clk_i, .rst_ni, .request_i(texel_rd_valid_o[l] && texel_rd_ready_i[l]),
      .response_i(texel_rsp_valid_i[l]), .outstanding_o(texel_outstanding[l])
    );
    memory_reads slb_reads (
      .clk_i, .rst_ni, .request_i(slb_rd_valid_o[l] && slb_rd_ready_i[l]),
      .response_i(slb_rsp_valid_i[l]), .outstanding_o(slb_outstanding[l])
    );
  end

  // Port 0 serves the store until pass 2.
  always_comb begin
    texel_valid        = lane_texel_valid;
    slb_valid          = lane_slb_valid;
    texel_rd_addr_o    = lane_texel_addr;
    texel_rd_tag_o     = lane_texel_tag;
    slb_rd_addr_o      = lane_slb_addr;
    slb_rd_tag_o       = lane_slb_tag;
    lane_texel_ready   = texel_ready;
    lane_slb_ready     = slb_ready;
    if (!deciding) begin
      texel_valid[0] = store_texel_rd_valid;
      slb_valid[0]   = store_slb_rd_valid;
      texel_rd_addr_o[shadow_pkg::TexelAddrBits-1:0] = store_texel_rd_addr;
      texel_rd_tag_o[shadow_pkg::TagBits-1:0]        = store_texel_rd_tag;
      slb_rd_addr_o[shadow_pkg::RecordAddrBits-1:0]  = store_slb_rd_addr;
      slb_rd_tag_o[shadow_pkg::TagBits-1:0]          = store_slb_rd_tag;
      lane_texel_ready[0] = 1'b0;
      lane_slb_ready[0]   = 1'b0;
    end
  end
  assign store_texel_rd_ready = texel_ready[0] && !deciding;
  assign store_slb_rd_ready   = slb_ready[0] && !deciding;

  abort_guard #(.Channels(3 * Lanes + 2)) guard (
    .clk_i, .rst_ni, .close_i(closing),
    .valid_i({store_texel_wr_valid, store_slb_wr_valid, verdict_valid, texel_valid, slb_valid}),
    .ready_o({store_texel_wr_ready, store_slb_wr_ready, verdict_ready, texel_ready, slb_ready}),
    .valid_o({texel_wr_valid_o, slb_wr_valid_o, verdict_valid_o, texel_rd_valid_o, slb_rd_valid_o}),
    .ready_i({texel_wr_ready_i, slb_wr_ready_i, verdict_ready_i, texel_rd_ready_i, slb_rd_ready_i}),
    .closed_o(closed)
  );

  // Fragments of all lanes, or the triangle: what counts toward COUNT.
  always_comb begin
    items = '0;
    for (int l = 0; l < Lanes; l++) items = items + 3'(frag_valid_i[l] && frag_ready_o[l]);
    if (tri_valid_i && tri_ready_o && !tri_i.is_plane) items = items + 3'd1;
  end
endmodule

// The unit with scalar ports, for a bench in C++: structs taken apart, all else as shadow_unit's.
module shadow_bench (
  input  logic        clk_i,
  input  logic        rst_ni,
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
  output logic        irq_o,
  // Triangles
  input  logic        tri_valid_i,
  output logic        tri_ready_o,
  input  logic [4:0]  tri_kind_i,  // is_plane, shares, inner
  input  logic [23:0] tri_polygon_i,
  input  logic [23:0] tri_object_i,
  input  logic [27:0] tri_x0_i,
  input  logic [27:0] tri_y0_i,
  input  logic [23:0] tri_z0_i,
  input  logic [27:0] tri_x1_i,
  input  logic [27:0] tri_y1_i,
  input  logic [23:0] tri_z1_i,
  input  logic [27:0] tri_x2_i,
  input  logic [27:0] tri_y2_i,
  input  logic [23:0] tri_z2_i,
  // Fragments and verdicts: lane l has slice l
  input  logic [shadow_pkg::Lanes-1:0]    frag_valid_i,
  output logic [shadow_pkg::Lanes-1:0]    frag_ready_o,
  input  logic [shadow_pkg::Lanes*3-1:0]  frag_flags_i,  // unshadowable, outside, averted
  input  logic [shadow_pkg::Lanes*24-1:0] frag_object_i,
  input  logic [shadow_pkg::Lanes*28-1:0] frag_x_i,
  input  logic [shadow_pkg::Lanes*28-1:0] frag_y_i,
  input  logic [shadow_pkg::Lanes*24-1:0] frag_z_i,
  output logic [shadow_pkg::Lanes-1:0]    verdict_valid_o,
  input  logic [shadow_pkg::Lanes-1:0]    verdict_ready_i,
  output logic [shadow_pkg::Lanes-1:0]    verdict_dark_o,
  output logic [shadow_pkg::Lanes*3-1:0]  verdict_by_o,
  // Memories
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
  // Profiling
  output logic [2:0]                                              pass_o,
  output logic [3:0]                                              cause1_o,
  output logic [shadow_pkg::Lanes*4-1:0]                          cause2_o,
  output logic [shadow_pkg::FrontEventBits-1:0]                   front_events_o,
  output logic [shadow_pkg::StoreEventBits-1:0]                   store_events_o,
  output logic [shadow_pkg::Lanes*shadow_pkg::LaneEventBits-1:0]  lane_events_o,
  output logic [shadow_pkg::LimitBits-1:0]                        records_o
);
  shadow_pkg::tri_t                                        triangle;
  shadow_pkg::front_events_t                               front_events;
  shadow_pkg::store_events_t                               store_events;
  logic [shadow_pkg::Lanes*shadow_pkg::FragBits-1:0]       frags;
  logic [shadow_pkg::Lanes*shadow_pkg::VerdictBits-1:0]    verdicts;

  assign triangle = {tri_kind_i, tri_polygon_i, tri_object_i, tri_x0_i, tri_y0_i, tri_z0_i,
                     tri_x1_i, tri_y1_i, tri_z1_i, tri_x2_i, tri_y2_i, tri_z2_i};
  for (genvar l = 0; l < shadow_pkg::Lanes; l++) begin : g_lane
    assign frags[l*shadow_pkg::FragBits+:shadow_pkg::FragBits] =
        {frag_flags_i[l*3+:3], frag_object_i[l*24+:24], frag_x_i[l*28+:28], frag_y_i[l*28+:28],
         frag_z_i[l*24+:24]};
    assign verdict_dark_o[l]     = verdicts[l*shadow_pkg::VerdictBits];
    assign verdict_by_o[l*3+:3]  = verdicts[l*shadow_pkg::VerdictBits+1+:3];
  end
  assign front_events_o = front_events;
  assign store_events_o = store_events;

  shadow_unit unit (
    .tri_i(triangle), .frag_i(frags), .verdict_o(verdicts), .store_cause_o(cause1_o),
    .lane_cause_o(cause2_o), .front_events_o(front_events), .store_events_o(store_events), .*
  );
endmodule

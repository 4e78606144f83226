// SLB records on chip: the cache of the SLB memory, what is fetched ahead, and how a record changes.
// Part of silhouette_buffer.
//
// Hints come from visits in the queue, which know their bucket; of a record that has come, its chain's
// next one is hinted, or else the entry's continuation.
// Timing:  a record looked up in cycle n is there from n + 1 on, if it is on chip (line_cache). An
//          update is carried out in the cycle in which update_i and update_ready_o are high.
`include "check.svh"
module record_buffer (
  input  logic                  clk_i,
  input  logic                  rst_ni,
  input  logic                  clear_i,
  input  shadow_pkg::settings_t settings_i,
  input  logic                  wipe_i,   // held until wiped_o: clears the buckets' own records
  output logic                  wiped_o,
  output logic                  wiping_o,
  output logic [shadow_pkg::RecordAddrBits-1:0] wipe_addr_o,
  input  logic                  hint_valid_i,
  output logic                  hint_ready_o,
  input  logic [shadow_pkg::RecordAddrBits-1:0] hint_addr_i,
  // the record being worked on
  input  logic                  lookup_i,
  input  logic                  lookup_new_i,
  input  logic                  lookup_end_i,
  input  logic [shadow_pkg::RecordAddrBits-1:0] lookup_addr_i,
  output logic                  hit_o,
  output shadow_pkg::record_t   record_o,
  // a new one, at any place
  input  logic                  update_i,
  output logic                  update_ready_o,
  input  logic [shadow_pkg::RecordAddrBits-1:0] update_addr_i,
  input  shadow_pkg::record_t   update_record_i,
  output logic                  idle_o,
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
  output logic [shadow_pkg::RecordBits-1:0]     wr_data_o
);
  localparam int unsigned AddrBits = shadow_pkg::RecordAddrBits;

  shadow_pkg::record_t came;
  logic                follow_q, follows, wiping_q, wiping, cache_idle;
  logic [AddrBits-1:0] follow_addr_q, wipe_q;

  assign came    = rsp_data_i;
  assign follows = rsp_valid_i && (came.has_next || came.has_more);

  line_cache #(
    .Width(shadow_pkg::RecordBits), .AddrBits(AddrBits), .Lines(shadow_pkg::RecordLines),
    .Ways(2), .TagBits(shadow_pkg::TagBits), .Fold(1'b0)  // the bucket spreads them
  ) cache (
    .clk_i, .rst_ni, .clear_i(clear_i || (wipe_i && !wiping_q)),
    .hint_valid_i(hint_valid_i || follow_q), .hint_ready_o,
    .hint_addr_i(hint_valid_i ? hint_addr_i : follow_addr_q),
    .lookup_i, .lookup_new_i, .lookup_end_i, .lookup_addr_i, .hit_o, .data_o(record_o),
    .update_i(wiping || update_i), .update_ready_o, .update_addr_i(wiping ? wipe_q : update_addr_i),
    .update_data_i(wiping ? '0 : update_record_i), .idle_o(cache_idle),
    .rd_valid_o, .rd_ready_i, .rd_addr_o, .rd_tag_o, .rsp_valid_i, .rsp_tag_i, .rsp_data_i,
    .wr_valid_o, .wr_ready_i, .wr_addr_o, .wr_data_o
  );

  // The buckets' own records are the first ones.
  assign wiping      = wiping_q && !wipe_q[settings_i.buckets_log2];
  assign wiped_o     = wipe_i && wiping_q && !wiping && cache_idle;
  assign wiping_o    = wiping_q;
  assign wipe_addr_o = wipe_q;
  assign idle_o      = !wiping && cache_idle;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      wiping_q <= 1'b0;
      follow_q <= 1'b0;
    end else begin
      wiping_q <= wipe_i && !clear_i;
      if (clear_i || wipe_i) follow_q <= 1'b0;
      else if (follows) follow_q <= 1'b1;
      else if (hint_ready_o && !hint_valid_i) follow_q <= 1'b0;
      `CHECK(nothing_while_wiping, !wipe_i || !update_i)
    end
  end

  always_ff @(posedge clk_i) begin
    if (!wiping_q) wipe_q <= '0;
    else if (wiping && update_ready_o) wipe_q <= wipe_q + 1'b1;
    if (follows) follow_addr_q <= came.has_next ? came.next : came.more;
  end

  logic unused;
  assign unused = &{1'b0, settings_i, came};
endmodule

// SLB records on chip: the cache of the SLB memory, what is fetched ahead, and how a record changes.
// Part of silhouette_buffer.
//
// Hints come from visits in the queue, which know their bucket. Of each record that comes or is hinted
// again, its chain's next one is hinted too, or else the entry's continuation: where a link of what
// was worked on leads to, a table of them tells.
// Timing:  a record looked up in cycle n is there from n + 1 on, if it is on chip (line_cache). An
//          update is carried out in the cycle in which update_i and update_ready_o are high.
`include "check.svh"
module record_buffer (
  input  logic                  clk_i,
  input  logic                  rst_ni,
  input  logic                  clear_i,
  input  shadow_pkg::settings_t settings_i,
  input  logic                  wipe_i,   // held until wiped_o: clears the buckets' own records, and all links
  output logic                  wiped_o,
  output logic                  wiping_o,
  output logic [shadow_pkg::RecordAddrBits-1:0] wipe_addr_o,
  input  logic                  hint_valid_i,
  output logic                  hint_ready_o,
  input  logic [shadow_pkg::RecordAddrBits-1:0] hint_addr_i,
  input  logic                  soon_valid_i,  // the same, less urgent
  output logic                  soon_ready_o,
  input  logic [shadow_pkg::RecordAddrBits-1:0] soon_addr_i,
  input  logic                  active_i,  // visits are inside; else links are not followed, or a pass would not end
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

  localparam int unsigned Links    = 2 * shadow_pkg::RecordLines;
  localparam int unsigned LinkBits = $clog2(Links);
  localparam int unsigned KeyBits  = AddrBits - LinkBits;

  shadow_pkg::record_t came, linking;
  logic                wiping_q, wiping, unlinking, cache_idle;
  logic [LinkBits:0]   unlinked_q;  // links wiped
  logic [AddrBits-1:0] wipe_q;

  // ---- Links: followed ahead, if nothing more urgent is to be hinted ------------------------------
  logic                hint, hint_ready, followed, follow_ready, follow_valid, unused_none;
  logic [AddrBits-1:0] hint_addr, follow_addr, linking_addr, link_addr, lookup_q;
  logic                asked_q, link_has;
  logic [KeyBits-1:0]  asked_key_q, link_key;

  assign came         = rsp_data_i;
  assign linking      = update_i ? update_record_i : record_o;
  assign linking_addr = update_i ? update_addr_i : lookup_q;
  // Not of an update that waits: what it links to may never have been written.
  ram_1r1w #(.Width(1 + KeyBits + AddrBits), .Depth(Links)) links (
    .clk_i, .write_i(unlinking || (update_i ? update_ready_o : hit_o)),
    .write_addr_i(unlinking ? unlinked_q[LinkBits-1:0] : linking_addr[LinkBits-1:0]),
    .write_data_i(unlinking ? '0 : {linking.has_next || linking.has_more, linking_addr[AddrBits-1:LinkBits],
                   linking.has_next ? linking.next : linking.more}),
    .read_i(1'b1), .read_addr_i(hint_addr[LinkBits-1:0]), .read_data_o({link_has, link_key, link_addr})
  );
  assign followed = rsp_valid_i ? came.has_next || came.has_more
                  : asked_q && link_has && link_key == asked_key_q;
  fifo #(.Width(AddrBits), .Depth(16)) follow (
    .clk_i, .rst_ni, .clear_i(clear_i || !active_i), .valid_i(followed || soon_valid_i), .ready_o(follow_ready),
    .data_i(!followed ? soon_addr_i : !rsp_valid_i ? link_addr : came.has_next ? came.next : came.more),
    .valid_o(follow_valid), .ready_i(!hint_valid_i && hint_ready), .data_o(follow_addr), .empty_o(unused_none)
  );
  assign hint         = hint_valid_i || (follow_valid && active_i);
  assign hint_addr    = hint_valid_i ? hint_addr_i : follow_addr;
  assign hint_ready_o = hint_ready;
  assign soon_ready_o = follow_ready && !followed;

  line_cache #(
    .Width(shadow_pkg::RecordBits), .AddrBits(AddrBits), .Lines(shadow_pkg::RecordLines),
    .Ways(2), .TagBits(shadow_pkg::TagBits), .Fold(1'b0)  // the bucket spreads them
  ) cache (
    .clk_i, .rst_ni, .clear_i(clear_i || (wipe_i && !wiping_q)),
    .hint_valid_i(hint), .hint_ready_o(hint_ready), .hint_weak_i(!hint_valid_i), .hint_addr_i(hint_addr),
    .lookup_i, .lookup_new_i, .lookup_end_i, .lookup_addr_i, .hit_o, .data_o(record_o),
    .update_i(wiping || update_i), .update_ready_o, .update_addr_i(wiping ? wipe_q : update_addr_i),
    .update_data_i(wiping ? '0 : update_record_i), .idle_o(cache_idle),
    .rd_valid_o, .rd_ready_i, .rd_addr_o, .rd_tag_o, .rsp_valid_i, .rsp_tag_i, .rsp_data_i,
    .wr_valid_o, .wr_ready_i, .wr_addr_o, .wr_data_o
  );

  // The buckets' own records are the first ones.
  assign wiping      = wiping_q && !wipe_q[settings_i.buckets_log2];
  assign unlinking   = wiping_q && !unlinked_q[LinkBits];
  assign wiped_o     = wipe_i && wiping_q && !wiping && !unlinking && cache_idle;
  assign wiping_o    = wiping_q;
  assign wipe_addr_o = wipe_q;
  assign idle_o      = !wiping && cache_idle;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      wiping_q <= 1'b0;
    end else begin
      wiping_q <= wipe_i && !clear_i;
      `CHECK(nothing_while_wiping, !wipe_i || !update_i)
    end
  end

  always_ff @(posedge clk_i) begin
    if (!wiping_q) wipe_q <= '0;
    else if (wiping && update_ready_o) wipe_q <= wipe_q + 1'b1;
    if (!wiping_q) unlinked_q <= '0;
    else if (unlinking) unlinked_q <= unlinked_q + 1'b1;
    if (lookup_i) lookup_q <= lookup_addr_i;
    asked_q     <= hint && hint_ready;
    asked_key_q <= hint_addr[AddrBits-1:LinkBits];
  end

  logic unused;
  assign unused = &{1'b0, settings_i, came, linking, unused_none};
endmodule

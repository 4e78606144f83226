// Texel buffers: the shadow (depth), ID and edge buffers, four texels a word; covers up to four at once.
// Twin:    model/unit/texel_buffers.h.
// Timing:  a word looked up in cycle n is there from n + 1 on, if it is on chip (line_cache). An update
//          is carried out in the cycle in which update_i and update_ready_o are high.
`include "check.svh"
module texel_buffers (
  input  logic                  clk_i,
  input  logic                  rst_ni,
  input  logic                  clear_i,
  input  shadow_pkg::settings_t settings_i,
  input  logic                  wipe_i,    // held until wiped_o: clears every word of the map
  output logic                  wiped_o,
  // words that visits will ask for soon
  input  logic                  hint_valid_i,
  output logic                  hint_ready_o,
  input  logic [shadow_pkg::TexelAddrBits-1:0] hint_addr_i,
  // the word being worked on
  input  logic                  lookup_i,
  input  logic                  lookup_end_i,
  input  logic [shadow_pkg::TexelAddrBits-1:0] lookup_addr_i,
  output logic                  hit_o,
  input  logic [1:0]            select_i,  // texel of the word
  output shadow_pkg::texel_t    texel_o,   // that texel
  output logic [shadow_pkg::TexelsPerWord-1:0] edges_o,  // edge flags of the word
  // its update
  input  logic                  update_i,
  output logic                  update_ready_o,
  input  logic [shadow_pkg::TexelsPerWord-1:0] cover_i,  // texels that keep the nearer depth and its ID
  input  logic [shadow_pkg::TexelsPerWord*shadow_pkg::DepthBits-1:0] depth_i,
  input  logic [shadow_pkg::IdBits-1:0] id_i,
  input  logic                  set_edge_i,  // the selected texel's edge flag becomes edge_i
  input  logic                  edge_i,
  input  logic                  set_overflow_i,  // of the selected texel
  output logic                  idle_o,
  // texel memory
  output logic                  rd_valid_o,
  input  logic                  rd_ready_i,
  output logic [shadow_pkg::TexelAddrBits-1:0] rd_addr_o,
  output logic [shadow_pkg::TagBits-1:0]       rd_tag_o,
  input  logic                  rsp_valid_i,
  input  logic [shadow_pkg::TagBits-1:0]       rsp_tag_i,
  input  logic [shadow_pkg::TexelDataBits-1:0] rsp_data_i,
  output logic                  wr_valid_o,
  input  logic                  wr_ready_i,
  output logic [shadow_pkg::TexelAddrBits-1:0] wr_addr_o,
  output logic [shadow_pkg::TexelDataBits-1:0] wr_data_o,
  output logic [shadow_pkg::TexelsPerWord-1:0] wr_mask_o
);
  localparam int unsigned AddrBits  = shadow_pkg::TexelAddrBits;
  localparam int unsigned TexelBits = shadow_pkg::TexelBits;
  localparam int unsigned DepthBits = shadow_pkg::DepthBits;

  logic [shadow_pkg::TexelWordBits-1:0] word, new_word;
  shadow_pkg::texel_t  old_texel, new_texel, cleared;
  logic [AddrBits:0]   wipe_q, wipe_end;  // words wiped, words to wipe
  logic [AddrBits-1:0] addr_q;            // of the lookup
  logic                wiping_q, wiping, cache_idle;

  assign texel_o = word[select_i*TexelBits +: TexelBits];
  for (genvar i = 0; i < shadow_pkg::TexelsPerWord; i++) begin : gen_edges
    assign edges_o[i] = word[i*TexelBits + shadow_pkg::IdBits + DepthBits + 1];
  end
  always_comb begin
    cleared       = '0;
    cleared.depth = '1;
    old_texel     = '0;
    new_texel     = '0;
    new_word      = '0;
    for (int unsigned i = 0; i < shadow_pkg::TexelsPerWord; i++) begin
      old_texel  = word[i*TexelBits +: TexelBits];
      new_texel  = old_texel;
      if (cover_i[i] && depth_i[i*DepthBits +: DepthBits] < old_texel.depth) begin
        new_texel.covered = 1'b1;
        new_texel.id      = id_i;
        new_texel.depth   = depth_i[i*DepthBits +: DepthBits];
      end
      if (select_i == 2'(i)) begin
        if (set_edge_i) new_texel.edge_flag = edge_i;
        if (set_overflow_i) new_texel.overflow = 1'b1;
      end
      new_word[i*TexelBits +: TexelBits] = wiping ? cleared : new_texel;
    end
  end

  // Rows follow each other without a gap, so the map's words are the first ones of the memory.
  assign wipe_end = (AddrBits + 1)'(settings_i.map_height) << settings_i.pitch_log2;
  assign wiping   = wiping_q && wipe_q != wipe_end;
  assign wiped_o  = wipe_i && wiping_q && !wiping && cache_idle;
  assign idle_o   = !wiping && cache_idle;

  line_cache #(
    .Width(shadow_pkg::TexelDataBits), .AddrBits(AddrBits), .Lines(shadow_pkg::TexelLines),
    .Ways(2), .TagBits(shadow_pkg::TagBits)
  ) cache (
    .clk_i, .rst_ni, .clear_i(clear_i || (wipe_i && !wiping_q)),
    .hint_valid_i, .hint_ready_o, .hint_weak_i(1'b0), .hint_addr_i,
    .lookup_i, .lookup_new_i(1'b0), .lookup_end_i, .lookup_addr_i, .hit_o, .data_o(word),
    .update_i(update_i || wiping), .update_ready_o,
    .update_addr_i(wiping ? wipe_q[AddrBits-1:0] : addr_q), .update_data_i(new_word), .idle_o(cache_idle),
    .rd_valid_o, .rd_ready_i, .rd_addr_o, .rd_tag_o, .rsp_valid_i, .rsp_tag_i, .rsp_data_i,
    .wr_valid_o, .wr_ready_i, .wr_addr_o, .wr_data_o
  );
  assign wr_mask_o = '1;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      wiping_q <= 1'b0;
    end else begin
      wiping_q <= wipe_i && !clear_i;
      `CHECK(no_visit_while_wiping, !(wipe_i && update_i))
      `CHECK(update_of_the_word, !update_i || hit_o)
    end
  end
  always_ff @(posedge clk_i) begin
    if (lookup_i) addr_q <= lookup_addr_i;
    if (!wiping_q) wipe_q <= '0;
    else if (wiping && update_ready_o) wipe_q <= wipe_q + 1'b1;
  end

  logic unused;
  assign unused = &{1'b0, settings_i};
endmodule

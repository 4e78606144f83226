// Texel port: reads and writes of tiles and of texel words, merged for the one memory.
//
// Address: the uppermost bit tells a tile from a texel word, and so does a read's tag.
// Timing:  of port_merge; a write passes one, or two if it is a tile's or an empty word's.
module texel_port #(
  parameter int unsigned TileAddrBits = 8,
  parameter int unsigned TileTagBits  = 4,
  parameter int unsigned WordTagBits  = 4,
  localparam int unsigned A    = shadow_pkg::TexelAddrBits - 1,
  localparam int unsigned Tag  = shadow_pkg::TagBits,
  localparam int unsigned Data = shadow_pkg::TexelDataBits
) (
  input  logic                                  clk_i,
  input  logic                                  rst_ni,
  input  logic                                  clear_i,
  // reads
  input  logic                                  word_rd_valid_i,
  output logic                                  word_rd_ready_o,
  input  logic [A-1:0]                          word_rd_addr_i,
  input  logic [WordTagBits-1:0]                word_rd_tag_i,
  input  logic                                  tile_rd_valid_i,
  output logic                                  tile_rd_ready_o,
  input  logic [TileAddrBits-1:0]               tile_rd_addr_i,
  input  logic [TileTagBits-1:0]                tile_rd_tag_i,
  // writes, most urgent first
  input  logic                                  wipe_valid_i,   // a tile without anything
  output logic                                  wipe_ready_o,
  input  logic [TileAddrBits-1:0]               wipe_addr_i,
  input  logic                                  tile_wr_valid_i,
  output logic                                  tile_wr_ready_o,
  input  logic [TileAddrBits-1:0]               tile_wr_addr_i,
  input  logic [shadow_pkg::TileBits-1:0]       tile_wr_data_i,
  input  logic                                  touch_valid_i,  // a word of empty texels
  output logic                                  touch_ready_o,
  input  logic [A-1:0]                          touch_addr_i,
  input  logic                                  word_wr_valid_i,
  output logic                                  word_wr_ready_o,
  input  logic [A-1:0]                          word_wr_addr_i,
  input  logic [shadow_pkg::TexelWordBits-1:0]  word_wr_data_i,
  input  logic [3:0]                            word_wr_mask_i,
  // memory
  output logic                                  rd_valid_o,
  input  logic                                  rd_ready_i,
  output logic [A:0]                            rd_addr_o,
  output logic [Tag-1:0]                        rd_tag_o,
  output logic                                  wr_valid_o,
  input  logic                                  wr_ready_i,
  output logic [A:0]                            wr_addr_o,
  output logic [Data-1:0]                       wr_data_o,
  output logic [3:0]                            wr_mask_o
);
  localparam int unsigned WriteBits = 4 + A + 1 + Data;
  port_merge #(.Width(Tag + A + 1)) reads (
    .clk_i, .rst_ni, .clear_i,
    .valid0_i(word_rd_valid_i), .ready0_o(word_rd_ready_o), .data0_i({Tag'(word_rd_tag_i), 1'b0, word_rd_addr_i}),
    .valid1_i(tile_rd_valid_i), .ready1_o(tile_rd_ready_o),
    .data1_i({1'b1, (Tag - 1)'(tile_rd_tag_i), 1'b1, A'(tile_rd_addr_i)}),
    .valid_o(rd_valid_o), .ready_i(rd_ready_i), .data_o({rd_tag_o, rd_addr_o})
  );

  logic                            tile_ready, side_valid, side_ready;
  logic [WriteBits-1:0]            side;
  logic [shadow_pkg::TileBits-1:0] empty_tile;
  // touched, slot, several, object_valid, object: all 0, in whatever order.
  assign empty_tile = {3'd0, {(shadow_pkg::TileSlotBits + shadow_pkg::IdBits){1'b0}},
                       25'h0ffffff, 25'h0ffffff, 24'd0, 64'd0};
  assign wipe_ready_o    = tile_ready;
  assign tile_wr_ready_o = tile_ready && !wipe_valid_i;
  port_merge #(.Width(WriteBits)) tile_writes (
    .clk_i, .rst_ni, .clear_i,
    .valid0_i(wipe_valid_i || tile_wr_valid_i), .ready0_o(tile_ready),
    .data0_i({4'hf, 1'b1, wipe_valid_i ? A'(wipe_addr_i) : A'(tile_wr_addr_i),
              wipe_valid_i ? Data'(empty_tile) : Data'(tile_wr_data_i)}),
    .valid1_i(touch_valid_i), .ready1_o(touch_ready_o),
    .data1_i({4'hf, 1'b0, touch_addr_i, {Data{1'b0}}}),  // TexelEmpty
    .valid_o(side_valid), .ready_i(side_ready), .data_o(side)
  );
  port_merge #(.Width(WriteBits)) writes (
    .clk_i, .rst_ni, .clear_i,
    .valid0_i(side_valid), .ready0_o(side_ready), .data0_i(side),
    .valid1_i(word_wr_valid_i), .ready1_o(word_wr_ready_o),
    .data1_i({word_wr_mask_i, 1'b0, word_wr_addr_i, Data'(word_wr_data_i)}),
    .valid_o(wr_valid_o), .ready_i(wr_ready_i), .data_o({wr_mask_o, wr_addr_o, wr_data_o})
  );
endmodule

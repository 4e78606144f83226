// Early decision: verdicts that a fragment's tile or its texel give, or the head of the list to read.
//
// Twins:   model/unit/winding/shadow_unit_pass2.cpp, look_up, and read_texel up to the lists
// Timing:  in order, one a cycle while the words come in time; ten cycles and both memory latencies.
//          Tiles and words of texels that were read lately are not read again.
module early_decision #(
  localparam int unsigned SlotBits = shadow_pkg::SlotBits
) (
  input  logic                                  clk_i,
  input  logic                                  rst_ni,
  input  logic                                  clear_i,
  input  logic                                  paper_semantics_i,
  input  logic                                  skip_tiles_i,
  input  logic                                  skip_first_test_i,
  // fragments on the map
  input  logic                                  valid_i,
  output logic                                  ready_o,
  input  logic [SlotBits-1:0]                   slot_i,
  input  logic                                  defined_i,  // its verdict is known: looked up to be counted
  input  logic                                  averted_i,
  input  logic [shadow_pkg::MapBits-1:0]        texel_x_i,
  input  logic [shadow_pkg::MapBits-1:0]        texel_y_i,
  input  logic [shadow_pkg::EndBits-1:0]        place_x_i,  // UQ0.G in the texel
  input  logic [shadow_pkg::EndBits-1:0]        place_y_i,
  input  logic [shadow_pkg::TraceDepthBits-1:0] depth_i,
  input  logic [shadow_pkg::IdBits-1:0]         object_i,
  // verdicts; not final: the list decides
  output logic                                  early_o,
  output logic [SlotBits-1:0]                   early_slot_o,
  output logic                                  early_final_o,
  output logic [shadow_pkg::VerdictBits-1:0]    early_verdict_o,
  // lists, two cycles ahead of that
  output logic                                  list_o,
  output logic [SlotBits-1:0]                   list_slot_o,
  output logic [shadow_pkg::RecordAddrBits-1:0] list_first_o,
  // texel memory
  output logic                                  rd_valid_o,
  input  logic                                  rd_ready_i,
  output logic [shadow_pkg::TexelAddrBits-1:0]  rd_addr_o,
  output logic [shadow_pkg::TagBits-1:0]        rd_tag_o,
  input  logic                                  rsp_valid_i,
  input  logic [shadow_pkg::TagBits-1:0]        rsp_tag_i,
  input  logic [shadow_pkg::TexelDataBits-1:0]  rsp_data_i,
  // what happened
  output logic                                  tile_lit_o,
  output logic                                  tile_dark_o,
  output logic                                  texel_lookup_o,
  output logic                                  first_test_o,
  // why the oldest fragment here waits, if it does; and why none is taken
  output logic                                  waits_port_o,
  output logic                                  waits_memory_o,
  output logic                                  port_busy_o
);
  localparam int unsigned Slots = shadow_pkg::FragmentSlots;
  localparam int unsigned G = shadow_pkg::EndBits;
  localparam int unsigned MapBits = shadow_pkg::MapBits;
  localparam int unsigned IdBits = shadow_pkg::IdBits;
  localparam int unsigned DepthBits = shadow_pkg::TraceDepthBits;
  localparam int unsigned VerdictBits = shadow_pkg::VerdictBits;
  localparam int unsigned Words = 32;  // of each kind that are under way
  localparam int unsigned IndexBits = $clog2(Words);
  localparam int unsigned Lines = 64;  // of each kind that are kept
  localparam int unsigned TileAddrBits = 2 * (MapBits - 3);
  localparam int unsigned TexelWordAddrBits = shadow_pkg::TexelAddrBits - 1;
  localparam int unsigned KeptTileBits = shadow_pkg::TileBits - 24 - 64;  // without the receiver mask

  // ---- Tile -------------------------------------------------------------------------------------
  logic                    tile_next, tile_valid, tile_ready, tile_rd_valid, tile_rd_ready;
  logic [SlotBits-1:0]     tile_next_slot, tile_slot;
  logic                    defined, averted;
  logic [TileAddrBits-1:0] tile_rd_addr;
  logic [IndexBits-1:0]    tile_rd_tag;
  logic [KeptTileBits-1:0] tile_data;
  logic [IdBits-1:0]       tile_object;
  logic [DepthBits-1:0]    tile_depth;
  logic [3:0]              tile_word;  // in the tile
  /* verilator lint_off UNUSEDSIGNAL */  // object_valid: where it is 0, nothing lies beyond `farthest`
  shadow_pkg::tile_t       tile;
  /* verilator lint_on UNUSEDSIGNAL */

  logic tile_waits_port, tile_waits_memory;
  /* verilator lint_off PINCONNECTEMPTY */  // where the oldest is if not later is here
  shared_reads #(
    .Width(KeptTileBits), .AddrBits(TileAddrBits), .Words(Words), .Lines(Lines), .Slots(Slots), .SideBits(2)
  ) tiles (
    .clk_i, .rst_ni, .clear_i, .valid_i, .ready_o, .needs_i(1'b1),
    .addr_i({texel_y_i[MapBits-1:3], texel_x_i[MapBits-1:3]}), .slot_i,
    .side_i({defined_i, averted_i}),
    .next_o(tile_next), .next_slot_o(tile_next_slot), .valid_o(tile_valid), .ready_i(tile_ready),
    .slot_o(tile_slot), .side_o({defined, averted}), .data_o(tile_data),
    .rd_valid_o(tile_rd_valid), .rd_ready_i(tile_rd_ready), .rd_addr_o(tile_rd_addr),
    .rd_tag_o(tile_rd_tag), .rsp_valid_i(rsp_valid_i && rsp_tag_i[IndexBits]),
    .rsp_tag_i(rsp_tag_i[IndexBits-1:0]), .rsp_data_i(rsp_data_i[shadow_pkg::TileBits-1-:KeptTileBits]),
    .empty_o(), .waits_port_o(tile_waits_port), .waits_memory_o(tile_waits_memory)
  );
  /* verilator lint_on PINCONNECTEMPTY */
  ram_1r1w #(.Width(IdBits + DepthBits + 4), .Depth(Slots)) tile_fragments (
    .clk_i, .write_i(valid_i), .write_addr_i(slot_i),
    .write_data_i({object_i, depth_i, texel_y_i[2:0], texel_x_i[2]}),
    .read_i(tile_next), .read_addr_i(tile_next_slot),
    .read_data_o({tile_object, tile_depth, tile_word})
  );

  logic lit, dark, texel_needed;
  logic [VerdictBits-1:0] tile_verdict;
  assign tile = {tile_data, 24'd0, 64'd0};
  assign lit  = skip_tiles_i && $signed({1'b0, tile_depth}) <= $signed(tile.nearest);
  assign dark = skip_tiles_i && $signed({1'b0, tile_depth}) > $signed(tile.farthest) && !lit &&
                (!paper_semantics_i || (!tile.several && tile.object != tile_object));
  assign texel_needed = !defined && !lit && !dark && tile.touched;
  always_comb begin
    tile_verdict = {shadow_pkg::ByNothing, 1'b0};
    if (lit || dark) tile_verdict = {shadow_pkg::ByTile, dark};
    if (defined) tile_verdict = {averted ? shadow_pkg::ByDefinition : shadow_pkg::ByOutside, averted};
  end
  assign tile_lit_o     = tile_valid && tile_ready && !defined && lit;
  assign tile_dark_o    = tile_valid && tile_ready && !defined && dark;
  assign texel_lookup_o = tile_valid && tile_ready && !lit && !dark;

  // ---- Texel word -------------------------------------------------------------------------------
  logic                                 word_next, word_valid, word_rd_valid, word_rd_ready, word_needed;
  logic [SlotBits-1:0]                  word_next_slot, word_slot;
  logic [VerdictBits-1:0]               word_verdict;
  logic [TexelWordAddrBits-1:0]         word_rd_addr;
  logic [IndexBits-1:0]                 word_rd_tag;
  logic [shadow_pkg::TexelWordBits-1:0] word;
  logic [IdBits-1:0]                    word_object;
  logic [DepthBits-1:0]                 word_depth;
  logic [1:0]                           word_texel;
  logic [G-1:0]                         word_x, word_y;

  logic words_empty, word_waits_port, word_waits_memory;
  shared_reads #(
    .Width(shadow_pkg::TexelWordBits), .AddrBits(TexelWordAddrBits), .Words(Words), .Lines(Lines),
    .Slots(Slots), .SideBits(1 + VerdictBits)
  ) texel_words (
    .clk_i, .rst_ni, .clear_i, .valid_i(tile_valid), .ready_o(tile_ready), .needs_i(texel_needed),
    .addr_i(TexelWordAddrBits'({tile.slot, tile_word})), .slot_i(tile_slot),
    .side_i({texel_needed, tile_verdict}),
    .next_o(word_next), .next_slot_o(word_next_slot), .valid_o(word_valid), .ready_i(1'b1),
    .slot_o(word_slot), .side_o({word_needed, word_verdict}), .data_o(word),
    .rd_valid_o(word_rd_valid), .rd_ready_i(word_rd_ready), .rd_addr_o(word_rd_addr),
    .rd_tag_o(word_rd_tag), .rsp_valid_i(rsp_valid_i && !rsp_tag_i[IndexBits]),
    .rsp_tag_i(rsp_tag_i[IndexBits-1:0]), .rsp_data_i(rsp_data_i[shadow_pkg::TexelWordBits-1:0]),
    .empty_o(words_empty), .waits_port_o(word_waits_port), .waits_memory_o(word_waits_memory)
  );
  ram_1r1w #(.Width(IdBits + DepthBits + 2 + 2 * G), .Depth(Slots)) texel_fragments (
    .clk_i, .write_i(valid_i), .write_addr_i(slot_i),
    .write_data_i({object_i, depth_i, texel_x_i[1:0], place_x_i, place_y_i}),
    .read_i(word_next), .read_addr_i(word_next_slot),
    .read_data_o({word_object, word_depth, word_texel, word_x, word_y})
  );

  // Reads of both kinds share the port. A request stays once it is offered.
  logic choose_word, held_q, held_word_q;
  assign choose_word   = held_q ? held_word_q : word_rd_valid;
  assign rd_valid_o    = word_rd_valid || tile_rd_valid;
  assign rd_addr_o     = choose_word ? {1'b0, word_rd_addr} : {1'b1, TexelWordAddrBits'(tile_rd_addr)};
  assign rd_tag_o      = shadow_pkg::TagBits'({!choose_word, choose_word ? word_rd_tag : tile_rd_tag});
  assign word_rd_ready = rd_ready_i && choose_word;
  assign tile_rd_ready = rd_ready_i && !choose_word;
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) held_q <= 1'b0;
    else held_q <= rd_valid_o && !rd_ready_i && !clear_i;
  end
  always_ff @(posedge clk_i) held_word_q <= choose_word;

  // ---- Texel: 1, what it is ---------------------------------------------------------------------
  shadow_pkg::texel_t      texel;
  /* verilator lint_off UNUSEDSIGNAL */  // what pass 1 notes for itself
  shadow_pkg::texel_list_t list;
  /* verilator lint_on UNUSEDSIGNAL */
  logic                    valid1_q;
  logic [IdBits-1:0]       object1_q, texel_object1_q;
  logic [SlotBits-1:0]     slot1_q;
  logic [VerdictBits-1:0]  verdict1_q;
  logic [1:0]              kind1_q;
  logic [shadow_pkg::WordBits-1:0] word1_q;
  logic [DepthBits-1:0]    depth1_q;
  logic [G-1:0]            x1_q, y1_q;

  assign texel = word[word_texel*shadow_pkg::TexelBits+:shadow_pkg::TexelBits];
  always_ff @(posedge clk_i) begin
    slot1_q    <= word_slot;
    verdict1_q <= word_needed ? {shadow_pkg::ByNothing, 1'b0} : word_verdict;
    kind1_q    <= word_needed ? texel.kind : shadow_pkg::TexelEmpty;
    object1_q  <= word_object;
    texel_object1_q <= texel.object;
    word1_q    <= texel.word;
    depth1_q   <= word_depth;
    x1_q       <= word_x;
    y1_q       <= word_y;
  end

  // 2: its cover's depth; a list is read unless that decides
  logic other, covered, behind, first_test;
  assign other        = !paper_semantics_i || texel_object1_q != object1_q;
  assign list         = word1_q[shadow_pkg::ListBits-1:0];
  assign covered      = other && list.covered;
  assign behind       = $signed({9'd0, depth1_q}) > $signed({list.cover_depth[shadow_pkg::CoverBits-1], list.cover_depth});
  assign first_test   = kind1_q == shadow_pkg::TexelList && skip_first_test_i && covered && behind;
  assign first_test_o = valid1_q && first_test;
  assign list_o       = valid1_q && kind1_q == shadow_pkg::TexelList && !first_test;
  assign list_slot_o  = slot1_q;
  assign list_first_o = list.first;

  logic                   valid2_q, valid3_q, list2_q, list3_q, plane2_q, plane3_q, beyond;
  logic [SlotBits-1:0]    slot2_q, slot3_q;
  logic [VerdictBits-1:0] verdict2_q, verdict3_q;
  threshold plane (
    .clk_i, .threshold_i(word1_q[shadow_pkg::ThresholdBits-1:0]), .x_i(x1_q), .y_i(y1_q),
    .depth_i(depth1_q), .beyond_o(beyond)
  );
  always_ff @(posedge clk_i) begin
    slot2_q    <= slot1_q;
    slot3_q    <= slot2_q;
    list2_q    <= list_o;
    list3_q    <= list2_q;
    plane2_q   <= kind1_q == shadow_pkg::TexelPlane && other;
    plane3_q   <= plane2_q;
    verdict2_q <= first_test || (kind1_q == shadow_pkg::TexelOverflow && covered && behind)
                  ? {shadow_pkg::ByBuffer, 1'b1} : verdict1_q;
    verdict3_q <= verdict2_q;
  end
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      valid1_q <= 1'b0;
      valid2_q <= 1'b0;
      valid3_q <= 1'b0;
    end else begin
      valid1_q <= word_valid && !clear_i;
      valid2_q <= valid1_q && !clear_i;
      valid3_q <= valid2_q && !clear_i;
    end
  end

  // 4: the verdict
  assign early_o         = valid3_q;
  assign early_slot_o    = slot3_q;
  assign early_final_o   = !list3_q;
  assign early_verdict_o = plane3_q && beyond ? {shadow_pkg::ByBuffer, 1'b1} : verdict3_q;

  // ---- Where the oldest is: as far as anybody ------------------------------------------------------
  logic deciding;
  assign deciding       = word_valid || valid1_q || valid2_q || valid3_q;
  assign waits_port_o   = !deciding && (words_empty ? !tile_valid && tile_waits_port : word_waits_port);
  assign waits_memory_o = !deciding && (words_empty ? !tile_valid && tile_waits_memory : word_waits_memory);
  assign port_busy_o    = (word_rd_valid && !word_rd_ready) || (tile_rd_valid && !tile_rd_ready);
endmodule

// Tiles of 8 x 8 texels: receiver mask, allocation of texels, nearest depth, and the sum of what a tile holds.
//
// Twins:   model/unit/winding/shadow_unit_pass1.cpp (announce, visit up to the texel), shadow_unit_pass2.cpp
//          (sum_up's result), texel_buffers.h (touch)
// Numbers: bounds are clamped to -1 .. 2^24 - 1, signed.
// Timing:  a visit or an announced fragment a cycle, in whatever tile, once its word is there. A tile's first visit
//          has its texels written empty, in 16 cycles from its own word on; visits of words still to be written
//          wait. A tile to settle takes a cycle, if it is touched one for each word.
//
// A visit that passes goes on with the address of its texel word; what the mask refuses ends here. With
// settling_i the visits of kind VisitTile name tiles to settle: each goes on as the 16 words of a touched tile;
// the tile waits in a queue until its sum comes back. Otherwise they are announced fragments.
`include "check.svh"
module tile_buffer (
  input  logic                                  clk_i,
  input  logic                                  rst_ni,
  input  logic                                  clear_i,       // also a new frame: tile slots are given from 0 on
  input  logic                                  skip_masked_i, // settings_t.skip_receiver_mask
  input  logic                                  settling_i,
  // work and its tile word, from memory_window
  input  logic                                  in_valid_i,
  input  logic                                  in_fresh_i,
  input  shadow_pkg::visit_t                    in_i,          // mask: texels visited, each with its base; of edges too
  input  logic [shadow_pkg::TileBits-1:0]       in_tile_i,
  output logic                                  load_o,
  output logic                                  pop_o,
  output logic                                  clean_o,       // the tile held is as in the memory
  output logic                                  keep_o,        // writes the tile back to the window
  input  logic                                  keep_ready_i,
  input  logic [2*(shadow_pkg::MapBits-3)-1:0]  tile_addr_i,   // of the tile held
  output logic [shadow_pkg::TileBits-1:0]       tile_o,
  // visits that go on
  output logic                                  out_valid_o,
  input  logic                                  out_ready_i,
  output logic                                  out_bare_o,    // needs no texel word
  output logic [shadow_pkg::TexelAddrBits-2:0]  out_addr_o,
  output shadow_pkg::visit_t                    out_o,         // mask: texels visited that pass
  // the sum of a settled tile
  input  logic                                  sum_valid_i,   // held until sum_ready_o
  output logic                                  sum_ready_o,
  input  logic                                  sum_covered_i, // every texel is
  input  logic                                  sum_several_i,
  input  logic [shadow_pkg::IdBits-1:0]         sum_object_i,
  input  logic [24:0]                           sum_farthest_i,
  // memory writes: of a tile
  output logic                                  wr_valid_o,
  input  logic                                  wr_ready_i,
  output logic [2*(shadow_pkg::MapBits-3)-1:0]  wr_addr_o,
  output logic [shadow_pkg::TileBits-1:0]       wr_tile_o,
  // of an empty texel word
  output logic                                  touch_valid_o,
  input  logic                                  touch_ready_i,
  output logic [shadow_pkg::TexelAddrBits-2:0]  touch_addr_o,
  output logic                                  idle_o,
  // events
  output logic [2:0]                            visits_o,
  output logic [2:0]                            masked_o,
  output logic                                  touched_o
);
  localparam logic [1:0] VisitTile = 2'd2;
  localparam int unsigned B = shadow_pkg::BaseBits;
  localparam int unsigned Step = shadow_pkg::PlaneStepBits;
  localparam int unsigned CodeBits = shadow_pkg::GradientCodeBits;
  localparam logic [24:0] None = 25'h0ffffff;

  localparam int unsigned AddrBits = 2 * (shadow_pkg::MapBits - 3);
  logic              dirty_q, unkept_q, flush_q, steep_q;
  logic [3:0]        word_d, word_q;  // of the tile's 16: the next to settle
  logic              touching_q;      // the texels of slot_q are written empty:
  logic [3:0]        first_q, written_q;  // words from first_q on
  logic [26:0]       half_q;
  logic [shadow_pkg::TileSlotBits-1:0] slot_q;
  shadow_pkg::tile_t tile_d, tile_q, data, tile;

  logic        begins, announces, at_work, change, settled_back, mem_done, keep_done;
  logic [3:0]  texels, masked, passing;
  assign begins     = in_i.kind == shadow_pkg::VisitBegin;
  assign announces  = in_i.kind == VisitTile && !settling_i;
  // A visit is carried out as its tile is loaded.
  assign at_work    = in_valid_i && (in_fresh_i ? load_o : !flush_q);
  assign data       = in_tile_i;
  assign tile       = in_fresh_i ? data : tile_q;

  // ---- The triangle's planes: a begin carries their gradients in place of the bases -------------
  logic [4*B-1:0] body;
  logic           steep;
  logic [26:0]    half;
  assign body = {in_i.base3, in_i.base2, in_i.base1, in_i.base0};
  plane_steepness steepness (
    .gradient_x_i(body[CodeBits+:CodeBits]), .gradient_y_i(body[CodeBits-1:0]),
    .steep_o(steep), .half_o(half)
  );

  // ---- Receiver mask ----------------------------------------------------------------------------
  // Nearest depth at or beyond the last fragment: base * 2^Step - half - 1 >= last.
  logic [28:0]           least;
  logic signed [B-1:0]   limit;
  logic [5:0]            texel;
  logic [3:0]            in_mask, received;  // a fragment lies there; and the visit
  assign least  = 29'(tile.last) + 29'(half_q) + 29'(1 << Step);
  assign limit  = $signed(B'(least >> Step));
  assign texel  = {in_i.y[2:0], in_i.x[2:0]};
  assign texels = in_i.mask;
  assign in_mask  = tile.mask[{texel[5:2], 2'd0}+:4];
  assign received = texels & (in_mask | {4{!skip_masked_i}});
  always_comb begin
    for (int i = 0; i < 4; i++) begin
      passing[i] = received[i] && !(skip_masked_i && !steep_q && $signed(body[i*B+:B]) >= limit);
    end
  end
  assign masked = texels & ~passing;

  // ---- Nearest depth ----------------------------------------------------------------------------
  // The nearest of those that pass is the nearest of those received, or none passes. All pairs are compared beside
  // each other: bit 4 j + i of `behind` says that texel j does not lie before texel i.
  logic [B-1:0] lowest;
  logic [3:0]   nearest_of;
  logic [15:0]  behind;
  always_comb begin
    behind = '0;
    for (int j = 1; j < 4; j++) begin
      for (int i = 0; i < j; i++) begin
        behind[4*j+i] = $signed(body[j*B+:B]) >= $signed(body[i*B+:B]);
        behind[4*i+j] = !behind[4*j+i];
      end
    end
    lowest = '0;
    for (int j = 0; j < 4; j++) begin
      nearest_of[j] = received[j] && (behind[4*j+:4] & received) == '0;
      lowest = lowest | (body[j*B+:B] & {B{nearest_of[j]}});
    end
  end
  logic [31:0] nearest, farthest_unused;
  logic [24:0] nearest_clamped;
  plane_bounds bounds (
    .base_i(lowest), .steep_i(steep_q), .half_i(half_q), .nearest_o(nearest), .farthest_o(farthest_unused)
  );
  assign nearest_clamped = nearest[31] ? '1 : |nearest[30:24] ? None : {1'b0, nearest[23:0]};

  // ---- What becomes of the work -----------------------------------------------------------------
  logic       pending, awaits;
  logic [3:0] place;  // the visit's word of the tile
  assign place   = {texel[5:3], texel[2]};
  assign awaits  = touching_q && tile.slot == slot_q && place - first_q >= written_q;
  always_comb begin
    word_d      = word_q;
    tile_d      = tile;
    change      = 1'b0;
    pop_o       = 1'b0;
    out_valid_o = 1'b0;
    touched_o   = 1'b0;
    pending     = 1'b0;
    out_o       = in_i;
    out_o.mask  = passing;
    out_addr_o  = {tile.slot, place};
    if (at_work && announces) begin
      tile_d.mask[texel] = 1'b1;
      if (body[23:0] > tile.last) tile_d.last = body[23:0];
      change = 1'b1;
      pop_o  = 1'b1;
    end else if (at_work && begins) begin
      out_valid_o = 1'b1;
      pop_o       = out_ready_i;
    end else if (at_work && settling_i) begin
      out_valid_o = tile.touched && pending_ready;
      out_o.mask  = '1;
      out_o.x     = shadow_pkg::MapBits'(word_q == '1);  // the tile's last
      out_addr_o  = {tile.slot, word_q};
      if (out_valid_o && out_ready_i) word_d = word_q + 1'b1;
      pending     = out_valid_o && out_ready_i && word_q == '1;
      pop_o       = pending || !tile.touched;
    end else if (at_work && passing == '0) begin
      pop_o = 1'b1;
    end else if (at_work && !tile.touched) begin
      touched_o = !touching_q;
      change    = touched_o;
      if (touched_o) begin
        tile_d.touched = 1'b1;
        tile_d.slot    = slot_q;
      end
    end else if (at_work && !awaits) begin
      out_valid_o = 1'b1;
      pop_o       = out_ready_i;
      change      = out_ready_i && $signed(nearest_clamped) < $signed(tile.nearest);
      if (change) tile_d.nearest = nearest_clamped;
    end
  end

  // ---- Tiles whose sums are due -----------------------------------------------------------------
  logic                pending_ready, summed_valid, pending_empty;
  logic [AddrBits-1:0] summed_addr;
  shadow_pkg::tile_t   waiting, summed;
  fifo #(.Width(AddrBits + shadow_pkg::TileBits), .Depth(4)) tiles (
    .clk_i, .rst_ni, .clear_i, .valid_i(pending), .ready_o(pending_ready), .data_i({tile_addr_i, tile_q}),
    .valid_o(summed_valid), .ready_i(sum_valid_i && wr_ready_i), .data_o({summed_addr, waiting}),
    .empty_o(pending_empty)
  );
  always_comb begin
    summed              = waiting;
    summed.object_valid = sum_covered_i;
    summed.several      = sum_covered_i && sum_several_i;
    summed.object       = sum_covered_i ? sum_object_i : '0;
    summed.farthest     = sum_covered_i ? sum_farthest_i : None;
  end
  assign sum_ready_o = wr_ready_i;
  assign out_bare_o = begins;
  assign visits_o   = pop_o && !begins && in_i.kind != VisitTile ? count(texels) : '0;
  assign masked_o   = pop_o && !begins && in_i.kind != VisitTile ? count(masked) : '0;

  function automatic logic [2:0] count(input logic [3:0] bits);
    count = 3'(bits[0]) + 3'(bits[1]) + 3'(bits[2]) + 3'(bits[3]);
  endfunction

  // ---- Back to the window and the memory: before another tile is loaded, or with nothing to do --------
  assign touch_valid_o = touching_q;
  assign touch_addr_o  = {slot_q, first_q + written_q};
  assign settled_back = flush_q || (in_valid_i && in_fresh_i);
  // A tile to settle is as in the memory: no sum meets the tile held on its way.
  assign wr_valid_o   = (dirty_q && settled_back) || sum_valid_i;
  assign wr_addr_o    = sum_valid_i ? summed_addr : tile_addr_i;
  assign wr_tile_o    = sum_valid_i ? summed : tile_q;
  assign keep_o       = unkept_q && settled_back;
  assign mem_done     = !dirty_q || wr_ready_i;
  assign keep_done    = !unkept_q || keep_ready_i;
  assign load_o       = in_valid_i && in_fresh_i && mem_done && keep_done;
  assign clean_o      = !dirty_q && !unkept_q;
  assign idle_o       = clean_o && !in_valid_i && !touching_q && pending_empty;
  assign tile_o       = tile_q;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      dirty_q    <= 1'b0;
      unkept_q   <= 1'b0;
      flush_q    <= 1'b0;
      touching_q <= 1'b0;
      word_q     <= '0;
      slot_q     <= '0;
    end else if (clear_i) begin
      dirty_q    <= 1'b0;
      unkept_q   <= 1'b0;
      flush_q    <= 1'b0;
      touching_q <= 1'b0;
      word_q     <= '0;
      slot_q     <= '0;
    end else begin
      word_q     <= word_d;
      dirty_q    <= change || (dirty_q && !(wr_valid_o && wr_ready_i));
      unkept_q   <= change || (unkept_q && !(keep_o && keep_ready_i));
      flush_q    <= flush_q ? !(mem_done && keep_done) : !in_valid_i && !clean_o;
      touching_q <= touched_o || (touching_q && !(touch_ready_i && written_q == '1));
      if (touching_q && touch_ready_i && written_q == '1) slot_q <= slot_q + 1'b1;
      `CHECK(sums_in_order, !sum_valid_i || (summed_valid && !dirty_q))
      `CHECK(passes_within_its_tile, !(out_valid_o && !out_bare_o) || tile.touched)
    end
  end

  always_ff @(posedge clk_i) begin
    if (change || load_o) tile_q <= tile_d;
    if (touched_o) begin
      first_q   <= place;
      written_q <= '0;
    end else if (touch_ready_i) begin
      written_q <= written_q + 1'b1;
    end
    if (at_work && begins) begin
      half_q  <= half;
      steep_q <= steep;
    end
  end
endmodule

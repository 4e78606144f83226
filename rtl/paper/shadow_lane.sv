// A lane of pass 2: fragments in, verdicts out in their order.
// Twin: decide_one and decide_by_lines in model/unit/shadow_unit_pass2.cpp.
//
//   frag -> place -> texel read ... texel word -> early decision -> lookup --+
//             |                                      |                       v
//             +------------- verdict <---------------+         SLB read ... record -> shadow_decision
//                               ^-------------------------------------------------------+    |
//                                                              ^---- next record ------------+
//
// Each fragment has a slot and at most one read under way, so that a response always finds room,
// and queues as long as there are slots never overflow. Reads of fragments that began to read the
// SLB go before those of fragments that begin.
// Timing: a fragment a cycle where the SLB is not read; besides the memories' latency 2 cycles from
//         fragment to texel read, 3 from texel word to SLB read, 5 from record to the next read,
//         2 to 3 from a decision to the verdict.
`include "check.svh"
module shadow_lane (
  input  logic                                 clk_i,
  input  logic                                 rst_ni,
  input  logic                                 clear_i,  // drops all fragments; no response is due then
  input  shadow_pkg::settings_t                settings_i,
  // fragments, and their verdicts in the same order
  input  logic                                 frag_valid_i,
  output logic                                 frag_ready_o,
  input  shadow_pkg::frag_t                    frag_i,
  output logic                                 verdict_valid_o,
  input  logic                                 verdict_ready_i,
  output shadow_pkg::verdict_t                 verdict_o,
  output logic                                 idle_o,  // no fragment is inside
  // texel memory
  output logic                                 texel_rd_valid_o,
  input  logic                                 texel_rd_ready_i,
  output logic [shadow_pkg::TexelAddrBits-1:0] texel_rd_addr_o,
  output logic [shadow_pkg::TagBits-1:0]       texel_rd_tag_o,   // {texel of the word, slot}
  input  logic                                 texel_rsp_valid_i,
  input  logic [shadow_pkg::TagBits-1:0]       texel_rsp_tag_i,
  input  logic [shadow_pkg::TexelDataBits-1:0] texel_rsp_data_i,
  // SLB memory
  output logic                                  slb_rd_valid_o,
  input  logic                                  slb_rd_ready_i,
  output logic [shadow_pkg::RecordAddrBits-1:0] slb_rd_addr_o,
  output logic [shadow_pkg::TagBits-1:0]        slb_rd_tag_o,    // slot
  input  logic                                  slb_rsp_valid_i,
  input  logic [shadow_pkg::TagBits-1:0]        slb_rsp_tag_i,
  input  logic [shadow_pkg::RecordBits-1:0]     slb_rsp_data_i,
  // where cycles go (Lane*), and what happened
  output logic [3:0]                            cause_o,
  output shadow_pkg::lane_events_t              events_o
);
  localparam int unsigned Slots     = shadow_pkg::FragmentSlots;
  localparam int unsigned SlotBits  = shadow_pkg::SlotBits;
  localparam int unsigned MapBits   = shadow_pkg::MapBits;
  localparam int unsigned DepthBits = shadow_pkg::DepthBits;
  localparam int unsigned IdBits    = shadow_pkg::IdBits;
  localparam int unsigned AddrBits  = shadow_pkg::RecordAddrBits;
  localparam int unsigned TexelBits = shadow_pkg::TexelBits;
  localparam int unsigned TagBits   = shadow_pkg::TagBits;
  localparam int unsigned RowIndexBits = shadow_pkg::RowIndexBits;
  // Mx and My need the bits of Fraction.
  localparam int unsigned PointBits = shadow_pkg::PositionBits > shadow_pkg::FractionBits
                                      ? shadow_pkg::PositionBits : shadow_pkg::FractionBits;
  localparam int unsigned WordBits  = $clog2(shadow_pkg::TexelsPerWord);
  localparam int unsigned FixedBits = shadow_pkg::MaxFraction + 12;  // any coordinate, 26 after the point

  // ---- Slots and verdicts ---------------------------------------------------------------------
  logic                slot_free, take;
  logic [SlotBits-1:0] slot;
  logic                known, known_final, early, early_final, late_final;
  logic [SlotBits-1:0] early_slot, late_slot;
  shadow_pkg::verdict_t known_verdict, early_verdict, late_verdict;
  logic [SlotBits-1:0] oldest;
  logic                oldest_done;

  // The fragment that is being placed.
  logic                   place_valid_q;
  logic [SlotBits-1:0]    place_slot_q;
  logic [FixedBits-1:0]   place_x_q, place_y_q;
  logic [DepthBits-1:0]   place_depth_q;
  logic [IdBits-1:0]      place_object_q;
  logic                   place_averted_q, place_outside_q;
  logic                   place_moves;

  lane_slots #(.Slots(Slots), .Most(shadow_pkg::FragmentsInFlight), .Width(shadow_pkg::VerdictBits)) slots (
    .clk_i, .rst_ni, .clear_i,
    .free_o(slot_free), .take_i(take), .slot_o(slot),
    .known_i(known), .known_slot_i(place_slot_q), .known_final_i(known_final),
    .known_verdict_i(known_verdict),
    .early_i(early), .early_slot_i(early_slot), .early_final_i(early_final),
    .early_verdict_i(early_verdict),
    .late_i(late_final), .late_slot_i(late_slot), .late_verdict_i(late_verdict),
    .verdict_valid_o, .verdict_ready_i, .verdict_o,
    .oldest_o(oldest), .oldest_done_o(oldest_done), .idle_o
  );

  // ---- A fragment comes: 26 bits after the point ----------------------------------------------
  logic [4:0]           align;
  logic [FixedBits-1:0] fixed_x, fixed_y;

  assign frag_ready_o = slot_free && (!place_valid_q || place_moves);
  assign take         = frag_valid_i && frag_ready_o;
  assign align        = 5'(shadow_pkg::MaxFraction) - settings_i.texel_bits;
  assign fixed_x = {{(FixedBits - shadow_pkg::CoordBits){frag_i.p.x[shadow_pkg::CoordBits-1]}}, frag_i.p.x}
                   << align;
  assign fixed_y = {{(FixedBits - shadow_pkg::CoordBits){frag_i.p.y[shadow_pkg::CoordBits-1]}}, frag_i.p.y}
                   << align;

  always_ff @(posedge clk_i) begin
    if (take) begin
      place_slot_q    <= slot;
      place_x_q       <= fixed_x;
      place_y_q       <= fixed_y;
      place_depth_q   <= frag_i.p.z[shadow_pkg::TraceDepthBits-1 -: DepthBits];
      place_object_q  <= frag_i.object[IdBits-1:0];
      place_averted_q <= frag_i.averted;
      place_outside_q <= frag_i.outside;
    end
  end

  // ---- Place: its texel -----------------------------------------------------------------------
  logic [RowIndexBits-1:0] row_x, row_y;  // from the map's corner; off the map: beyond its sides
  logic                    on_map;
  logic [MapBits-1:0]      texel_x, texel_y;
  logic [PointBits-1:0]    point_x, point_y;
  logic [PointBits:0]      point_nx;  // 1 - Mx

  assign row_x = {{(RowIndexBits - 12){place_x_q[FixedBits-1]}}, place_x_q[FixedBits-1 -: 12]}
                 + RowIndexBits'(settings_i.map_width[MapBits:1]);
  assign row_y = {{(RowIndexBits - 12){place_y_q[FixedBits-1]}}, place_y_q[FixedBits-1 -: 12]}
                 + RowIndexBits'(settings_i.map_height[MapBits:1]);
  assign on_map   = row_x < RowIndexBits'(settings_i.map_width)
                    && row_y < RowIndexBits'(settings_i.map_height);
  assign texel_x  = row_x[MapBits-1:0];
  assign texel_y  = row_y[MapBits-1:0];
  assign point_x  = place_x_q[shadow_pkg::MaxFraction-1 -: PointBits];
  assign point_y  = place_y_q[shadow_pkg::MaxFraction-1 -: PointBits];
  assign point_nx = {1'b1, {PointBits{1'b0}}} - {1'b0, point_x};

  logic texel_valid_q;
  logic [shadow_pkg::TexelAddrBits-1:0] texel_addr_q;
  // The texel within its word travels with the tag where there is room for it.
  localparam int unsigned TexelTagBits = SlotBits + WordBits <= TagBits ? SlotBits + WordBits : SlotBits;
  logic [TexelTagBits-1:0]              texel_tag_q;

  assign known_final        = place_averted_q || place_outside_q || !on_map;
  assign known_verdict.dark = place_averted_q;
  assign known_verdict.by   = place_averted_q ? shadow_pkg::ByDefinition : shadow_pkg::ByOutside;
  assign place_moves        = known_final || !texel_valid_q || texel_rd_ready_i;
  assign known              = place_valid_q && place_moves;
  assign texel_rd_valid_o   = texel_valid_q;
  assign texel_rd_addr_o    = texel_addr_q;
  assign texel_rd_tag_o     = TagBits'(texel_tag_q);

  always_ff @(posedge clk_i) begin
    if (known && !known_final) begin
      texel_addr_q <= (shadow_pkg::TexelAddrBits'(texel_y) << settings_i.pitch_log2)
                      | shadow_pkg::TexelAddrBits'(texel_x[MapBits-1:WordBits]);
      texel_tag_q  <= TexelTagBits'({texel_x[WordBits-1:0], place_slot_q});
    end
  end

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      place_valid_q <= 1'b0;
      texel_valid_q <= 1'b0;
    end else if (clear_i) begin
      place_valid_q <= 1'b0;
      texel_valid_q <= 1'b0;
    end else begin
      place_valid_q <= take || (place_valid_q && !place_moves);
      texel_valid_q <= (known && !known_final) || (texel_valid_q && !texel_rd_ready_i);
    end
  end

  // ---- What a fragment is known by while it is under way ---------------------------------------
  localparam int unsigned LookBits = 2 * MapBits + DepthBits + IdBits;  // {y, x, depth, object}
  localparam int unsigned FragBits = LookBits + 3 * PointBits + 1;      // and nx, x, y
  logic [LookBits-1:0] look;
  logic [FragBits-1:0] frag;

  ram_1r1w #(.Width(LookBits), .Depth(Slots)) look_ram (
    .clk_i, .write_i(known), .write_addr_i(place_slot_q),
    .write_data_i({texel_y, texel_x, place_depth_q, place_object_q}),
    .read_i(texel_rsp_valid_i), .read_addr_i(texel_rsp_tag_i[SlotBits-1:0]), .read_data_o(look)
  );
  ram_1r1w #(.Width(FragBits), .Depth(Slots)) frag_ram (
    .clk_i, .write_i(known), .write_addr_i(place_slot_q),
    .write_data_i({texel_y, texel_x, place_depth_q, place_object_q, point_nx, point_x, point_y}),
    .read_i(slb_rsp_valid_i), .read_addr_i(slb_rsp_tag_i[SlotBits-1:0]), .read_data_o(frag)
  );

  // ---- Texel word: early decision (Table 4) -----------------------------------------------------
  logic                 early_q;
  logic [SlotBits-1:0]  early_slot_q;
  shadow_pkg::texel_t   early_texel;  // of the word that came
  logic [MapBits-1:0]   look_x, look_y;
  logic [DepthBits-1:0] look_depth;
  logic [IdBits-1:0]    look_object;
  logic                 own, covered_dark, lookup;
  logic [AddrBits-1:0]  hash, bucket;

  always_ff @(posedge clk_i) early_slot_q <= texel_rsp_tag_i[SlotBits-1:0];
  // Which of the word's texels it is comes back with the tag; or, without room there, a cycle later.
  if (SlotBits + WordBits <= TagBits) begin : g_texel_by_tag
    always_ff @(posedge clk_i) begin
      early_texel <= texel_rsp_data_i[texel_rsp_tag_i[SlotBits +: WordBits] * TexelBits +: TexelBits];
    end
  end else begin : g_texel_by_slot
    logic [shadow_pkg::TexelDataBits-1:0] word_q;
    always_ff @(posedge clk_i) word_q <= texel_rsp_data_i;
    assign early_texel = word_q[look_x[WordBits-1:0] * TexelBits +: TexelBits];
  end
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) early_q <= 1'b0;
    else early_q <= texel_rsp_valid_i && !clear_i;
  end

  assign {look_y, look_x, look_depth, look_object} = look;
  assign own          = early_texel.covered && early_texel.id == look_object;
  assign covered_dark = !own && look_depth > early_texel.depth;
  assign early        = early_q;
  assign early_slot   = early_slot_q;
  assign early_final  = covered_dark || !early_texel.edge_flag || (own && settings_i.own_id_literal);
  assign early_verdict.dark = covered_dark;
  assign early_verdict.by   = covered_dark ? shadow_pkg::ByBuffer : shadow_pkg::ByNothing;
  assign lookup       = early && !early_final;

  // x + 181 y, wrapped: 181 = 128 + 32 + 16 + 4 + 1.
  assign hash   = AddrBits'(look_x) + AddrBits'(look_y) + (AddrBits'(look_y) << 2)
                  + (AddrBits'(look_y) << 4) + (AddrBits'(look_y) << 5) + (AddrBits'(look_y) << 7);
  assign bucket = hash & ~({AddrBits{1'b1}} << settings_i.buckets_log2);

  // ---- SLB reads: of fragments that go on, else of those that begin -----------------------------
  logic                         more_ready, lookup_ready, more_valid, lookup_valid;
  logic                         late, late_decided, late_dark, late_in_entry;
  logic [AddrBits-1:0]          late_at;
  logic                         middle;  // decision's stage before the last
  logic [SlotBits-1:0]          middle_slot;
  logic                         entry_read;
  logic [shadow_pkg::LineCountBits-1:0] lines_read;
  logic [SlotBits+AddrBits:0]   more_request;    // {in entry, slot, address}
  logic [SlotBits+AddrBits-1:0] lookup_request;  // {slot, address}
  logic                         more_empty, lookup_empty;
  logic                         held_q, held_more_q, from_more;  // a read that waits stays as it is
  logic [SlotBits-1:0]          read_slot;
  logic                         read_taken;

  fifo #(.Width(SlotBits + AddrBits + 1), .Depth(Slots)) more_fifo (
    .clk_i, .rst_ni, .clear_i,
    .valid_i(late && !late_decided), .ready_o(more_ready),
    .data_i({late_in_entry, late_slot, late_at}),
    .valid_o(more_valid), .ready_i(from_more && slb_rd_ready_i), .data_o(more_request),
    .empty_o(more_empty)
  );
  fifo #(.Width(SlotBits + AddrBits), .Depth(Slots)) lookup_fifo (
    .clk_i, .rst_ni, .clear_i,
    .valid_i(lookup), .ready_o(lookup_ready), .data_i({early_slot, bucket}),
    .valid_o(lookup_valid), .ready_i(!from_more && slb_rd_ready_i), .data_o(lookup_request),
    .empty_o(lookup_empty)
  );

  assign from_more      = held_q ? held_more_q : more_valid;
  assign slb_rd_valid_o = more_valid || lookup_valid;
  assign {read_slot, slb_rd_addr_o} = from_more ? more_request[SlotBits+AddrBits-1:0] : lookup_request;
  assign slb_rd_tag_o   = TagBits'(read_slot);
  assign read_taken     = slb_rd_valid_o && slb_rd_ready_i;

  always_ff @(posedge clk_i) held_more_q <= from_more;
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) held_q <= 1'b0;
    else begin
      held_q <= slb_rd_valid_o && !slb_rd_ready_i && !clear_i;
      `CHECK(room_for_every_read, (more_ready || !late || late_decided) && (lookup_ready || !lookup))
    end
  end

  // How each slot's record was asked for; read a cycle after the record has come.
  logic                record_valid_q;
  logic [SlotBits-1:0] record_slot_q;
  shadow_pkg::record_t record_q;
  logic                asked_first, asked_in_entry;
  logic [AddrBits-1:0] asked_at;

  ram_1r1w #(.Width(AddrBits + 2), .Depth(Slots)) asked_ram (
    .clk_i, .write_i(read_taken), .write_addr_i(read_slot),
    .write_data_i({!from_more, from_more && more_request[SlotBits+AddrBits], slb_rd_addr_o}),
    .read_i(record_valid_q), .read_addr_i(record_slot_q),
    .read_data_o({asked_first, asked_in_entry, asked_at})
  );

  // ---- A record: decision ------------------------------------------------------------------------
  always_ff @(posedge clk_i) begin
    record_slot_q <= slb_rsp_tag_i[SlotBits-1:0];
    record_q      <= slb_rsp_data_i;
  end
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) record_valid_q <= 1'b0;
    else record_valid_q <= slb_rsp_valid_i && !clear_i;
  end

  shadow_decision #(.PointBits(PointBits)) decision (
    .clk_i, .rst_ni, .clear_i, .settings_i,
    .valid_i(record_valid_q), .slot_i(record_slot_q), .record_i(record_q),
    .x_i(frag[PointBits +: PointBits]), .nx_i(frag[2*PointBits +: PointBits+1]),
    .y_i(frag[0 +: PointBits]),
    .depth_i(frag[3*PointBits+1+IdBits +: DepthBits]),
    .object_i(frag[3*PointBits+1 +: IdBits]),
    .texel_i(frag[FragBits-1 -: 2*MapBits]),
    .first_i(asked_first), .in_entry_i(asked_in_entry), .at_i(asked_at),
    .middle_valid_o(middle), .middle_slot_o(middle_slot),
    .slot_valid_o(late), .slot_o(late_slot), .decided_o(late_decided), .dark_o(late_dark),
    .next_in_entry_o(late_in_entry), .next_at_o(late_at),
    .entry_read_o(entry_read), .lines_read_o(lines_read)
  );

  assign late_final        = late && late_decided;
  assign late_verdict.dark = late_dark;
  assign late_verdict.by   = late_dark ? shadow_pkg::ByLines : shadow_pkg::ByNothing;

  assign events_o.slb_lookup = lookup;
  assign events_o.entry_read = entry_read;
  assign events_o.lines_read = lines_read;

  // ---- Where the cycle goes -----------------------------------------------------------------------
  // Without a free slot the two youngest fragments alone can wait for the texel port, so that of
  // the oldest one it is enough to know whether it reads the SLB, and whether that read was taken.
  logic [Slots-1:0] looking_d, looking_q, reading_d, reading_q;  // of taken slots alone
  logic             being_decided;

  always_comb begin
    looking_d = looking_q;
    reading_d = reading_q;
    if (take) {looking_d[slot], reading_d[slot]} = 2'b00;
    if (lookup) looking_d[early_slot] = 1'b1;
    if (read_taken) reading_d[read_slot] = 1'b1;
    if (slb_rsp_valid_i) reading_d[slb_rsp_tag_i[SlotBits-1:0]] = 1'b0;
  end
  always_ff @(posedge clk_i) begin
    looking_q <= looking_d;
    reading_q <= reading_d;
  end
  assign being_decided = (early && early_slot == oldest) || (record_valid_q && record_slot_q == oldest)
                         || (middle && middle_slot == oldest) || (late && late_slot == oldest);

  always_comb begin
    if (take) cause_o = shadow_pkg::LaneFragment;
    else if (frag_ready_o) cause_o = shadow_pkg::LaneInput;
    else if (slot_free) cause_o = shadow_pkg::LaneTexelPort;
    else if (oldest_done) cause_o = shadow_pkg::LaneVerdict;
    else if (being_decided) cause_o = shadow_pkg::LaneDecision;
    else if (!looking_q[oldest]) cause_o = shadow_pkg::LaneTexel;
    else if (reading_q[oldest]) cause_o = shadow_pkg::LaneSlb;
    else cause_o = shadow_pkg::LaneSlbPort;
  end

  logic unused_fields;
  assign unused_fields = ^{frag_i, settings_i, texel_rsp_tag_i, slb_rsp_tag_i, early_texel.overflow,
                           more_empty, lookup_empty};
endmodule

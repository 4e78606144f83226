// Silhouette Line Buffer (SLB): carries out visits on the records of the SLB, one after the other.
//
// An operation that finds all in one record takes one cycle, one that walks a cycle a record. A step
// looks a record up, and writes it back or to another place; nothing of a record is kept between two
// steps. What a step does is said by four blocks, by the state: chain_find, entry_lines, entry_move,
// chain_erase; it is carried out here, on record_buffer, slb_pool and texel_buffers.
// Twin:    model/unit/silhouette_buffer.h, and what shadow_unit_pass1.cpp does with it.
// Chains:  a bucket's first entry stands in the bucket's own record. Entries of one texel stand by
//          nearest, from the light outwards; a texel's first one behind the bucket's first.
// Timing:  the record and the texel word are looked up in the cycle in which start_i and ready_o are
//          high; the operation begins in the next.
`include "check.svh"
module silhouette_buffer (
  input  logic                  clk_i,
  input  logic                  rst_ni,
  input  logic                  clear_i,
  input  shadow_pkg::settings_t settings_i,
  input  logic                  wipe_i,   // held until wiped_o: empties the buckets and the pool
  output logic                  wiped_o,
  // buckets that visits will ask for soon
  input  logic                  hint_valid_i,
  output logic                  hint_ready_o,
  input  logic [shadow_pkg::RecordAddrBits-1:0] hint_addr_i,
  input  logic                  soon_valid_i,  // less urgent
  output logic                  soon_ready_o,
  input  logic [shadow_pkg::RecordAddrBits-1:0] soon_addr_i,
  input  logic                  active_i,      // visits are inside
  // an operation; VisitEdgesDone: an entry of the triangle's object that an edge emptied
  input  logic                  start_i,
  output logic                  ready_o,
  input  logic [1:0]            kind_i,
  input  logic [shadow_pkg::MapBits-1:0]        x_i,
  input  logic [shadow_pkg::MapBits-1:0]        y_i,
  input  logic [shadow_pkg::RecordAddrBits-1:0] bucket_i,
  input  logic [shadow_pkg::DepthBits-1:0]      depth_i,  // VisitEdgesDone: at the texel's centre
  // its visit, from the cycle after the start until the next start
  input  shadow_pkg::visit_t     visit_i,
  input  shadow_pkg::visit_tri_t tri_i,
  output logic                  emptied_o,  // a pulse: the entry of texel x_o, y_o has no line now
  output logic [shadow_pkg::MapBits-1:0] x_o,
  output logic [shadow_pkg::MapBits-1:0] y_o,
  // texel_buffers
  input  logic                  texel_hit_i,
  output logic [1:0]            texel_select_o,
  input  shadow_pkg::texel_t    texel_i,
  input  logic [shadow_pkg::TexelsPerWord-1:0] texel_edges_i,
  output logic                  texel_update_o,
  input  logic                  texel_ready_i,
  output logic [shadow_pkg::TexelsPerWord-1:0] texel_cover_o,
  output logic [shadow_pkg::TexelsPerWord*shadow_pkg::DepthBits-1:0] texel_depth_o,
  output logic [shadow_pkg::IdBits-1:0] texel_id_o,
  output logic                  texel_set_edge_o,
  output logic                  texel_edge_o,
  output logic                  texel_set_overflow_o,
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
  output logic [shadow_pkg::RecordBits-1:0]     wr_data_o,
  // for counters
  output logic                  idle_o,
  output logic [3:0]            cause_o,    // of this cycle, if an operation is under way
  output logic [shadow_pkg::LimitBits-1:0] records_o,  // in use
  output shadow_pkg::store_events_t        events_o
);
  localparam int unsigned AddrBits  = shadow_pkg::RecordAddrBits;
  localparam int unsigned DepthBits = shadow_pkg::DepthBits;
  localparam int unsigned MapBits   = shadow_pkg::MapBits;
  localparam int unsigned LimitBits = shadow_pkg::LimitBits;
  localparam int unsigned Texels    = shadow_pkg::TexelsPerWord;

  logic [4:0]             state_q, state_d, find_state, lines_state, move_state, erase_state;
  shadow_pkg::slb_walk_t  walk_q, walk_d, find_walk, lines_walk, move_walk, erase_walk;
  shadow_pkg::slb_step_t  step, find_step, lines_step, move_step, erase_step;
  shadow_pkg::slb_facts_t facts;
  shadow_pkg::record_t    record, new_record;
  logic [1:0]             kind_q;
  logic [MapBits-1:0]     x_q, y_q;  // a span: of its first texel
  logic [DepthBits-1:0]   depth_q;
  logic [AddrBits-1:0]    at_q;      // of the lookup
  logic                   start, touch, fire, last, look, record_ready, wiping, records_idle;
  logic [AddrBits-1:0]    look_addr, wipe_addr;

  // ---- What is so -------------------------------------------------------------------------------
  logic [shadow_pkg::LinesPerRecord-1:0] from_first;
  logic [LimitBits-1:0] used;
  logic                 hit, has_spot, dry, has_free;
  logic [AddrBits-1:0]  spot, free;

  slb_facts known (
    .settings_i, .hit_i(hit), .at_i(at_q), .record_i(record), .walk_i(walk_q),
    .kind_i(kind_q), .x_i(x_q), .y_i(y_q), .depth_i(depth_q), .visit_i, .tri_i,
    .texel_hit_i, .texel_i, .texel_edges_i,
    .used_i(used), .spot_i(spot), .has_spot_i(has_spot), .dry_i(dry), .free_i(free), .has_free_i(has_free),
    .facts_o(facts), .from_first_o(from_first)
  );

  // ---- What is done -----------------------------------------------------------------------------
  chain_find find (
    .state_i(state_q), .walk_i(walk_q), .facts_i(facts), .record_i(record),
    .state_o(find_state), .walk_o(find_walk), .step_o(find_step)
  );
  entry_lines lines (
    .state_i(state_q), .walk_i(walk_q), .facts_i(facts), .record_i(record),
    .state_o(lines_state), .walk_o(lines_walk), .step_o(lines_step)
  );
  entry_move move (
    .state_i(state_q), .walk_i(walk_q), .facts_i(facts), .record_i(record),
    .state_o(move_state), .walk_o(move_walk), .step_o(move_step)
  );
  chain_erase erase (
    .state_i(state_q), .walk_i(walk_q), .facts_i(facts), .record_i(record),
    .state_o(erase_state), .walk_o(erase_walk), .step_o(erase_step)
  );

  logic [1:0]          next_x, steps;  // of the texels that are still to be walked; from this one
  logic [AddrBits-1:0] mask;
  assign mask   = ~({AddrBits{1'b1}} << settings_i.buckets_log2);

  // Where the steps of the blocks meet.
  logic [4:0]            chosen_state;
  shadow_pkg::slb_walk_t chosen_walk;
  always_comb begin
    unique case (state_q[4:3])
      2'd0:    {chosen_state, chosen_walk, step} = {find_state, find_walk, find_step};
      2'd1:    {chosen_state, chosen_walk, step} = {lines_state, lines_walk, lines_step};
      2'd2:    {chosen_state, chosen_walk, step} = {move_state, move_walk, move_step};
      default: {chosen_state, chosen_walk, step} = {erase_state, erase_walk, erase_step};
    endcase
  end
  assign next_x = chosen_walk.todo[0] ? 2'd0 : chosen_walk.todo[1] ? 2'd1 : chosen_walk.todo[2] ? 2'd2 : 2'd3;
  assign steps  = next_x - walk_q.word_x;
  always_comb begin
    state_d   = chosen_state;
    walk_d    = chosen_walk;
    last      = step.last;
    look      = step.look;
    look_addr = step.look_addr;
    if (step.restart) begin
      state_d         = shadow_pkg::SlbFind;
      look_addr       = walk_q.own;
      walk_d.has_prev = 1'b0;
      walk_d.place    = walk_q.own;
      walk_d.push     = 1'b0;
      walk_d.placed   = 1'b0;
      walk_d.seen     = 1'b0;
      walk_d.length   = '0;
      walk_d.continued = 1'b0;
    end
    if (step.spread) begin
      last            = chosen_walk.todo == '0;
      // The next texel's bucket is the next one: (x + 181 y) mod the buckets.
      walk_d.word_x   = next_x;
      walk_d.own      = (walk_q.own + AddrBits'(steps)) & mask;
      walk_d.mode     = shadow_pkg::EraseHidden;
    end
    if (step.walk || step.spread) begin
      state_d         = shadow_pkg::SlbWalk;
      look            = 1'b1;
      look_addr       = walk_d.own;
      walk_d.has_prev = 1'b0;
      walk_d.kept     = 1'b0;
    end
    for (int unsigned i = 0; i < Texels; i++) begin
      if (step.spread && next_x == 2'(i)) walk_d.todo[i] = 1'b0;
    end
    if (last) state_d = shadow_pkg::SlbIdle;
  end

  assign touch = step.touch || step.stored;
  assign fire  = step.act && (!step.write || record_ready) && (!touch || (texel_hit_i && texel_ready_i));
  assign ready_o   = state_q == shadow_pkg::SlbIdle || (fire && last);
  assign start     = start_i && ready_o;
  assign emptied_o = fire && step.emptied;
  assign x_o       = x_q;
  assign y_o       = y_q;
  assign events_o  = fire ? events : '0;

  // ---- Texel ------------------------------------------------------------------------------------
  shadow_pkg::store_events_t events;
  logic [Texels-1:0]         selected;
  assign texel_select_o       = walk_q.word_x;
  assign selected             = Texels'(1) << walk_q.word_x;
  assign texel_update_o       = step.act && touch && texel_hit_i && (!step.write || record_ready);
  assign texel_set_edge_o     = step.set_edge || step.stored;
  assign texel_edge_o         = step.edge_flag || step.stored;
  assign texel_set_overflow_o = step.set_overflow;
  assign texel_id_o           = step.cover_record ? record.object : tri_i.object;
  always_comb begin
    events = step.events;
    events.line_stored = step.stored;
    texel_cover_o = selected & {Texels{step.cover_texel || step.cover_record || step.cover_centre
                                       || (step.stored && settings_i.depth_writes_all)}};
    if (step.cover_span) texel_cover_o = visit_i.mask;
    texel_depth_o = {Texels{step.cover_record ? record.nearest : step.cover_centre ? depth_q : visit_i.nearest}};
    if (step.cover_span) texel_depth_o = {visit_i.depth3, visit_i.depth2, visit_i.depth1, visit_i.depth0};
  end

  // ---- Records ----------------------------------------------------------------------------------
  record_update update (
    .record_i(record), .fresh_i(step.fresh), .unused_i(step.unused_record),
    .texel_i({y_q, x_q}), .object_i(tri_i.object), .nearest_i(visit_i.nearest),
    .set_next_i(step.set_next), .has_next_i(step.link_has), .next_i(step.link_addr),
    .set_more_i(step.set_more), .has_more_i(step.more_has), .more_i(step.more_addr),
    .set_nearest_i(step.set_nearest), .set_corner_i(step.set_corner && visit_i.corner),
    .set_vertex_i(step.set_vertex), .append_i(step.append), .line_i(visit_i.line),
    .remove_i(step.remove), .from_i(from_first | {shadow_pkg::LinesPerRecord{step.remove_first}}),
    .refill_i(step.refill), .last_i(walk_q.lifted), .record_o(new_record)
  );
  record_buffer records (
    .clk_i, .rst_ni, .clear_i, .settings_i, .wipe_i, .wiped_o, .wiping_o(wiping), .wipe_addr_o(wipe_addr),
    .hint_valid_i, .hint_ready_o, .hint_addr_i, .soon_valid_i, .soon_ready_o, .soon_addr_i, .active_i,
    .lookup_i(start ? kind_i != shadow_pkg::VisitSpan : fire && look && !last),
    .lookup_new_i(!start && step.look_new), .lookup_end_i(fire && last),
    .lookup_addr_i(start ? bucket_i : look_addr), .hit_o(hit), .record_o(record),
    .update_i(step.act && step.write && (!touch || (texel_hit_i && texel_ready_i))),
    .update_ready_o(record_ready), .update_addr_i(step.write_addr), .update_record_i(new_record),
    .idle_o(records_idle),
    .rd_valid_o, .rd_ready_i, .rd_addr_o, .rd_tag_o, .rsp_valid_i, .rsp_tag_i, .rsp_data_i,
    .wr_valid_o, .wr_ready_i, .wr_addr_o, .wr_data_o
  );
  slb_pool pool (
    .clk_i, .rst_ni, .clear_i(clear_i || wipe_i), .settings_i,
    .begin_i(wiping), .begin_addr_i(wipe_addr),
    .take_i(fire && step.take), .keep_i(fire && step.keep), .free_i(fire && step.free),
    .reuse_i(fire && step.reuse), .addr_i(step.free_addr),
    .next_valid_i(record.has_more), .next_i(record.more),
    .more_i(fire && step.used_more), .less_i(fire && step.used_less),
    .spot_o(spot), .kept_o(has_spot), .dry_o(dry), .free_o(free), .has_free_o(has_free), .used_o(used)
  );
  assign idle_o    = state_q == shadow_pkg::SlbIdle && records_idle;
  assign records_o = used;

  // ---- Where the cycle goes ---------------------------------------------------------------------
  logic first;  // nothing was done yet
  assign first = state_q == shadow_pkg::SlbSpan
              || (state_q == shadow_pkg::SlbFind && !walk_q.has_prev && !walk_q.relink);
  always_comb begin
    cause_o = shadow_pkg::StoreChain;
    if (fire && last) begin
      cause_o = kind_q == shadow_pkg::VisitEdge ? shadow_pkg::StoreEdge
              : kind_q == shadow_pkg::VisitSpan ? shadow_pkg::StoreSpan : shadow_pkg::StoreOther;
    end else if (first && !step.act) begin
      cause_o = texel_hit_i ? shadow_pkg::StoreRecord : shadow_pkg::StoreTexel;
    end else if (step.act && !fire) begin
      cause_o = shadow_pkg::StoreWrite;
    end
  end

  // ---- Registers --------------------------------------------------------------------------------
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      state_q <= shadow_pkg::SlbIdle;
    end else begin
      if (clear_i || wipe_i) state_q <= shadow_pkg::SlbIdle;
      else if (start) state_q <= kind_i == shadow_pkg::VisitSpan ? shadow_pkg::SlbSpan : shadow_pkg::SlbFind;
      else if (fire) state_q <= state_d;
      `CHECK(links_before_used, !(fire && step.write) || hit || step.fresh || step.set_more || step.unused_record)
    end
  end

  always_ff @(posedge clk_i) begin
    if (start || (fire && look && !last)) at_q <= start ? bucket_i : look_addr;
    if (start) begin
      kind_q  <= kind_i;
      x_q     <= x_i;
      y_q     <= y_i;
      depth_q <= depth_i;
      walk_q          <= '0;
      walk_q.word_x   <= x_i[1:0];
      walk_q.own      <= bucket_i;
      walk_q.place    <= bucket_i;
    end else if (fire) begin
      walk_q <= walk_d;
    end
  end

  logic unused;
  assign unused = &{1'b0, visit_i.kind, visit_i.x, visit_i.y, settings_i, texel_i};
endmodule

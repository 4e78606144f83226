// What is so in a cycle of silhouette_buffer: the record and the texel beside the visit. Part of it.
// Timing:  combinational.
module slb_facts (
  input  shadow_pkg::settings_t settings_i,
  input  logic                  hit_i,
  input  logic [shadow_pkg::RecordAddrBits-1:0] at_i,
  input  shadow_pkg::record_t   record_i,
  input  shadow_pkg::slb_walk_t walk_i,
  input  logic [1:0]            kind_i,
  input  logic [shadow_pkg::MapBits-1:0]        x_i,
  input  logic [shadow_pkg::MapBits-1:0]        y_i,
  input  logic [shadow_pkg::DepthBits-1:0]      depth_i,  // at an emptied texel's centre
  input  shadow_pkg::visit_t     visit_i,
  input  shadow_pkg::visit_tri_t tri_i,
  input  logic                  texel_hit_i,
  input  shadow_pkg::texel_t    texel_i,
  input  logic [shadow_pkg::TexelsPerWord-1:0]  texel_edges_i,
  // slb_pool
  input  logic [shadow_pkg::LimitBits-1:0]      used_i,
  input  logic [shadow_pkg::RecordAddrBits-1:0] spot_i,
  input  logic                  has_spot_i,
  input  logic                  dry_i,
  input  logic [shadow_pkg::RecordAddrBits-1:0] free_i,
  input  logic                  has_free_i,
  output shadow_pkg::slb_facts_t facts_o,
  output logic [shadow_pkg::LinesPerRecord-1:0] from_first_o  // of the line that cancels (silhouette_detector)
);
  localparam int unsigned DepthBits = shadow_pkg::DepthBits;
  localparam int unsigned MapBits   = shadow_pkg::MapBits;
  localparam int unsigned LimitBits = shadow_pkg::LimitBits;
  localparam int unsigned CountBits = shadow_pkg::LineCountBits;

  shadow_pkg::slb_facts_t facts;
  logic [DepthBits-1:0]   centre;
  logic                   match, erasable;
  assign facts_o = facts;

  silhouette_detector detector (
    .match_polygon_id_i(settings_i.match_polygon_id), .line_i(visit_i.line),
    .lines_i(record_i.lines), .count_i(record_i.count), .found_o(match), .from_first_o
  );
  hide_depth hiding (
    .farthest_i(settings_i.hidden_removal == 2'd2), .centre_i(centre), .most_i(tri_i.most),
    .rise_i(tri_i.rise), .nearest_i(record_i.nearest), .hides_o(erasable)
  );
  always_comb begin
    unique case (walk_i.word_x)
      2'd0: centre = visit_i.depth0;
      2'd1: centre = visit_i.depth1;
      2'd2: centre = visit_i.depth2;
      default: centre = visit_i.depth3;
    endcase
    if (kind_i == shadow_pkg::VisitEdgesDone) centre = depth_i;

    facts.hit          = hit_i;
    facts.texel_hit    = texel_hit_i;
    facts.at           = at_i;
    facts.is_edge      = kind_i == shadow_pkg::VisitEdge;
    facts.edge_flag    = texel_i.edge_flag;
    facts.overflow     = texel_i.overflow;
    facts.same_texel   = record_i.used && record_i.texel == {y_i, x_i[MapBits-1:2], walk_i.word_x};
    facts.same_entry   = facts.same_texel && record_i.object == tri_i.object;
    facts.match        = match;
    facts.hidden       = settings_i.hidden_removal == 2'd1 && texel_i.depth < visit_i.nearest;
    facts.beyond_it    = record_i.nearest > visit_i.nearest;
    facts.before_it    = record_i.nearest < visit_i.nearest;
    facts.nearer       = record_i.count == '0 || facts.beyond_it;
    facts.new_corner   = visit_i.corner && !record_i.corner;
    facts.new_vertex   = (visit_i.line.start_here || visit_i.line.end_here) && !record_i.vertex;
    facts.room         = record_i.count != CountBits'(shadow_pkg::LinesPerRecord);
    facts.erasable     = erasable;
    facts.full         = used_i == settings_i.record_limit;
    facts.few          = used_i < settings_i.chain_limit;
    facts.short_chain  = facts.few || (!walk_i.continued && LimitBits'(walk_i.length) < settings_i.chain_limit);
    facts.too_long     = LimitBits'(walk_i.length) > settings_i.chain_limit;
    facts.edges        = visit_i.mask & texel_edges_i;
    facts.wants_hiding = settings_i.hidden_removal != 2'd0;
    facts.spot         = spot_i;
    facts.has_spot     = has_spot_i;
    facts.dry          = dry_i;
    facts.free         = free_i;
    facts.has_free     = has_free_i;
  end

  logic unused;
  assign unused = &{1'b0, settings_i, record_i, walk_i, visit_i, tri_i, texel_i, x_i[1:0]};
endmodule

// The front with a port for each field, for front_test.
module front_bench (
  input  logic        clk_i,
  input  logic        rst_ni,
  input  logic        clear_i,
  input  logic [4:0]  texel_bits_i,
  input  logic [10:0] map_width_i,
  input  logic [10:0] map_height_i,
  input  logic        farthest_i,
  input  logic        tri_valid_i,
  output logic        tri_ready_o,
  input  logic        is_plane_i,
  input  logic [23:0] polygon_i,
  input  logic [23:0] object_i,
  input  logic [27:0] x0_i, x1_i, x2_i,
  input  logic [27:0] y0_i, y1_i, y2_i,
  input  logic [23:0] z0_i, z1_i, z2_i,
  output logic        visit_valid_o,
  input  logic        visit_ready_i,
  output logic [1:0]  kind_o,
  output logic [9:0]  x_o,
  output logic [9:0]  y_o,
  output logic [5:0]  flags_o,  // of Line in model/unit/line.h
  output logic [31:0] polygon_o,
  output logic [31:0] slope_o,
  output logic [31:0] fraction_o,
  output logic [31:0] nearest_o,
  output logic        corner_o,
  output logic [31:0] depth0_o, depth1_o, depth2_o, depth3_o,
  output logic [3:0]  mask_o,
  output logic [31:0] object_o,
  output logic [31:0] most_o,
  output logic [31:0] rise_o,
  output logic        idle_o,
  output logic        setup_o,
  output logic        caster_o,
  output logic        edge_begun_o,
  output logic        edge_texel_o,
  output logic [2:0]  span_texels_o
);
  shadow_pkg::settings_t     settings;
  shadow_pkg::tri_t          tri_beat;
  shadow_pkg::visit_t        visit;
  shadow_pkg::visit_tri_t    visit_tri;
  shadow_pkg::front_events_t events;
  always_comb begin
    settings                = '0;
    settings.texel_bits     = texel_bits_i;
    settings.map_width      = map_width_i;
    settings.map_height     = map_height_i;
    settings.hidden_removal = farthest_i ? 2'd2 : 2'd1;
    tri_beat          = '0;
    tri_beat.is_plane = is_plane_i;
    tri_beat.polygon  = polygon_i;
    tri_beat.object   = object_i;
    tri_beat.v0 = {x0_i, y0_i, z0_i};
    tri_beat.v1 = {x1_i, y1_i, z1_i};
    tri_beat.v2 = {x2_i, y2_i, z2_i};
  end
  front front (
    .clk_i, .rst_ni, .clear_i, .settings_i(settings), .tri_valid_i, .tri_ready_o, .tri_i(tri_beat),
    .visit_valid_o, .visit_ready_i, .visit_o(visit), .visit_tri_o(visit_tri), .idle_o, .setup_o, .events_o(events)
  );
  assign kind_o     = visit.kind;
  assign x_o        = visit.x;
  assign y_o        = visit.y;
  assign flags_o    = {visit.line.end_here, visit.line.start_here, visit.line.x_positive, visit.line.x_major,
                       visit.line.cross_flag, visit.line.left};
  assign polygon_o  = 32'(visit.line.polygon);
  assign slope_o    = 32'(visit.line.slope);
  assign fraction_o = 32'(visit.line.fraction);
  assign nearest_o  = 32'(visit.nearest);
  assign corner_o   = visit.corner;
  assign depth0_o   = 32'(visit.depth0);
  assign depth1_o   = 32'(visit.depth1);
  assign depth2_o   = 32'(visit.depth2);
  assign depth3_o   = 32'(visit.depth3);
  assign mask_o     = visit.mask;
  assign object_o   = 32'(visit_tri.object);
  assign most_o     = 32'(visit_tri.most);
  assign rise_o     = 32'(visit_tri.rise);
  assign caster_o      = events.caster;
  assign edge_begun_o  = events.edge_begun;
  assign edge_texel_o  = events.edge_texel;
  assign span_texels_o = events.span_texels;
endmodule

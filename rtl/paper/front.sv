// Front: triangles in, visits of texels out, in the golden model's order.
//
// Twin:    ShadowUnit::draw in model/unit/shadow_unit_pass1.cpp.
// Timing:  the next edge, also of the next triangle, is set up while one is walked; then one texel of an
//          outline a cycle.
`include "check.svh"
module front (
  input  logic                      clk_i,
  input  logic                      rst_ni,
  input  logic                      clear_i,        // drops everything in flight
  input  shadow_pkg::settings_t     settings_i,     // constant while not idle
  input  logic                      tri_valid_i,
  output logic                      tri_ready_o,    // when the last of a triangle's edges is set up
  input  shadow_pkg::tri_t          tri_i,
  output logic                      visit_valid_o,
  input  logic                      visit_ready_i,
  output shadow_pkg::visit_t        visit_o,
  output shadow_pkg::visit_tri_t    visit_tri_o,    // of the visit's triangle
  output logic                      idle_o,         // no triangle inside
  output logic                      setup_o,        // an edge or a triangle is being set up and nothing walked
  output shadow_pkg::front_events_t events_o
);
  localparam int unsigned D = shadow_pkg::DepthBits;
  localparam int unsigned C = shadow_pkg::CoordBits;
  localparam int unsigned F = shadow_pkg::MaxFraction;
  localparam int unsigned R = shadow_pkg::RowIndexBits;
  localparam int unsigned M = shadow_pkg::MapBits;
  localparam int unsigned L = shadow_pkg::TexelsPerWord;
  localparam int unsigned P = 2 * ((D + C + F + 3) / 2) + 1;  // of a plane's whole part, signed
  localparam int unsigned AreaBits = 2 * C;
  localparam int unsigned E = C + 1;  // of a difference of coordinates, signed
  localparam int unsigned CornerBits = 2 * C - 14;

  // ---- Setup ----
  logic                    caster, setup_busy, edge_valid, edge_ready, take;
  logic [1:0]              edge_index;
  logic [3*E-1:0]          dx, dy;
  logic                    clockwise;
  logic [AreaBits-1:0]     area, plane_x_rest, plane_y_rest;
  logic [AreaBits:0]       plane_rest;
  logic [P-2:0]            plane_x_whole, plane_y_whole;
  logic [P-1:0]            plane_whole;
  logic                    plane_x_less, plane_y_less, plane_busy, plane_ready;
  logic [D-1:0]            least, most, first_depth, last_depth;
  logic [D:0]              rise_bound;
  logic                    left, x_major, x_positive;
  logic [R-1:0]            first_x, first_y, last_x, last_y;
  logic [C-1:0]            length, rise, minor_rest, minor_step_rest;
  logic [F+2:0]            minor_whole;
  logic [F+1:0]            minor_step_whole;
  logic                    depth_less;
  logic [D:0]              major_depth_whole, minor_depth_whole;
  logic [C:0]              major_depth_rest, minor_depth_rest;
  logic [D-1:0]            major_depth_step_whole, minor_depth_step_whole;
  logic [C-1:0]            major_depth_step_rest, minor_depth_step_rest;
  logic [3*CornerBits-1:0] corner_start;
  logic [2:0]              corner_inexact;
  edge_setup setup (
    .clk_i, .rst_ni, .clear_i, .settings_i, .tri_valid_i, .tri_ready_o, .tri_i,
    .caster_o(caster), .busy_o(setup_busy), .edge_valid_o(edge_valid), .edge_ready_i(take), .index_o(edge_index),
    .dx_o(dx), .dy_o(dy), .clockwise_o(clockwise), .area_o(area),
    .plane_x_less_o(plane_x_less), .plane_x_whole_o(plane_x_whole), .plane_x_rest_o(plane_x_rest),
    .plane_y_less_o(plane_y_less), .plane_y_whole_o(plane_y_whole), .plane_y_rest_o(plane_y_rest),
    .least_o(least), .most_o(most), .rise_bound_o(rise_bound),
    .left_o(left), .x_major_o(x_major), .x_positive_o(x_positive),
    .first_x_o(first_x), .first_y_o(first_y), .last_x_o(last_x), .last_y_o(last_y),
    .length_o(length), .rise_o(rise), .minor_whole_o(minor_whole), .minor_rest_o(minor_rest),
    .minor_step_whole_o(minor_step_whole), .minor_step_rest_o(minor_step_rest),
    .first_depth_o(first_depth), .last_depth_o(last_depth), .depth_less_o(depth_less),
    .major_depth_whole_o(major_depth_whole), .major_depth_rest_o(major_depth_rest),
    .major_depth_step_whole_o(major_depth_step_whole), .major_depth_step_rest_o(major_depth_step_rest),
    .minor_depth_whole_o(minor_depth_whole), .minor_depth_rest_o(minor_depth_rest),
    .minor_depth_step_whole_o(minor_depth_step_whole), .minor_depth_step_rest_o(minor_depth_step_rest),
    .plane_busy_i(plane_busy), .plane_ready_i(plane_ready), .plane_whole_o(plane_whole), .plane_rest_o(plane_rest),
    .corner_o(corner_start), .corner_inexact_o(corner_inexact)
  );

  // ---- Which part of a triangle is drawn ----
  localparam logic [1:0] Idle = 2'd0, Edges = 2'd1, Spans = 2'd2;
  logic [1:0] phase_q;
  logic [1:0] left_q;        // edges that the walker has not taken
  logic       advance;       // the output register is free or becomes so: everything moves
  logic       begins, edges_done, gaps_busy, walking;
  assign advance    = !visit_valid_o || visit_ready_i;
  assign begins     = advance && phase_q == Idle && edge_valid;
  assign edges_done = advance && phase_q == Edges && left_q == '0 && !walking;
  assign take       = edge_valid && edge_ready && (begins || (phase_q == Edges && left_q != '0));

  shadow_pkg::visit_tri_t   tri_q;
  logic [shadow_pkg::PolygonBits-1:0] polygon_q;
  logic [3*E-1:0]           dx_q, dy_q;
  logic                     clockwise_q;
  logic [D-1:0]             least_q;
  logic [AreaBits-1:0]      area_q, plane_x_rest_q, plane_y_rest_q;
  logic [P-2:0]             plane_x_whole_q, plane_y_whole_q;
  logic                     plane_x_less_q, plane_y_less_q;
  logic [2:0]               corner_inexact_q;
  always_ff @(posedge clk_i) begin
    if (begins) begin
      tri_q.object    <= tri_i.object[shadow_pkg::IdBits-1:0];
      tri_q.most      <= most;
      tri_q.rise      <= rise_bound;
      polygon_q       <= tri_i.polygon[shadow_pkg::PolygonBits-1:0];
      dx_q            <= dx;
      dy_q            <= dy;
      clockwise_q     <= clockwise;
      least_q         <= least;
      area_q          <= area;
      plane_x_less_q  <= plane_x_less;
      plane_y_less_q  <= plane_y_less;
      plane_x_whole_q <= plane_x_whole;
      plane_x_rest_q  <= plane_x_rest;
      plane_y_whole_q <= plane_y_whole;
      plane_y_rest_q  <= plane_y_rest;
    end
    if (take) corner_inexact_q <= corner_inexact;
  end
  assign visit_tri_o = tri_q;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      phase_q <= Idle;
      left_q  <= '0;
    end else if (clear_i) begin
      phase_q <= Idle;
      left_q  <= '0;
    end else begin
      case (phase_q)
        Idle:    if (begins) phase_q <= Edges;
        Edges:   if (edges_done) phase_q <= Spans;
        default: if (!gaps_busy) phase_q <= Idle;
      endcase
      if (begins) left_q <= 2'd2;
      else if (take) left_q <= left_q - 1'b1;
      `CHECK(edges_in_order, !take || edge_index == (begins ? 2'd0 : 2'd3 - left_q))
    end
  end

  // ---- Walk ----
  logic         texel_valid, fresh, walk_x, walk_y, walk_back;
  logic [1:0]   walk_index;
  logic [R-1:0] walk_at_x, walk_at_y;
  shadow_pkg::line_t line;
  logic [D-1:0] nearest, entry;
  assign line.polygon = '0;  // a cycle later
  edge_walker walker (
    .clk_i, .rst_ni, .clear_i, .texel_bits_i(settings_i.texel_bits),
    .edge_valid_i(take), .edge_ready_o(edge_ready), .index_i(edge_index), .left_i(left), .x_major_i(x_major),
    .x_positive_i(x_positive), .first_x_i(first_x), .first_y_i(first_y), .last_x_i(last_x), .last_y_i(last_y),
    .length_i(length), .rise_i(rise), .minor_whole_i(minor_whole), .minor_rest_i(minor_rest),
    .minor_step_whole_i(minor_step_whole), .minor_step_rest_i(minor_step_rest),
    .first_depth_i(first_depth), .last_depth_i(last_depth), .depth_less_i(depth_less),
    .major_depth_whole_i(major_depth_whole), .major_depth_rest_i(major_depth_rest),
    .major_depth_step_whole_i(major_depth_step_whole), .major_depth_step_rest_i(major_depth_step_rest),
    .minor_depth_whole_i(minor_depth_whole), .minor_depth_rest_i(minor_depth_rest),
    .minor_depth_step_whole_i(minor_depth_step_whole), .minor_depth_step_rest_i(minor_depth_step_rest),
    .texel_valid_o(texel_valid), .ready_i(advance), .index_o(walk_index), .x_o(walk_at_x), .y_o(walk_at_y),
    .left_o(line.left), .cross_flag_o(line.cross_flag), .x_major_o(line.x_major), .x_positive_o(line.x_positive),
    .start_here_o(line.start_here), .end_here_o(line.end_here), .slope_o(line.slope), .fraction_o(line.fraction),
    .nearest_o(nearest), .move_x_o(walk_x), .move_y_o(walk_y), .back_o(walk_back), .fresh_o(fresh), .entry_o(entry), .busy_o(walking)
  );
  logic on_row, on_map, corner;
  assign on_row = !walk_at_y[R-1] && walk_at_y < R'(settings_i.map_height);
  assign on_map = on_row && !walk_at_x[R-1] && walk_at_x < R'(settings_i.map_width);
  corner_functions #(.DeltaBits(E), .Bits(CornerBits), .Diagonal(1'b0)) corners (
    .clk_i, .restart_i(fresh), .start_i(corner_start), .inexact_i(corner_inexact_q), .dx_i(dx_q), .dy_i(dy_q),
    .clockwise_i(clockwise_q), .move_x_i(walk_x), .back_i(walk_back), .move_y_i(walk_y), .inside_o(corner)
  );

  // ---- Spans ----
  logic                gap_valid, gap_ready, word_valid, fill_load, fill_x, fill_y, fill_back;
  logic [M-1:0]        gap_y, gap_from, gap_to, word_x, word_y;
  logic                fill_two;
  logic [D-1:0]        fill_whole, next_whole;
  logic [AreaBits:0]   fill_rest, ramp_rest;
  logic [P-1:0]        ramp_whole;
  logic [L*D-1:0]      word_depth;
  logic [L-1:0]        word_mask;
  logic                not_looked_up, loading;
  visited_rows #(.MapBits(M), .RowIndexBits(R)) rows (
    .clk_i, .rst_ni, .clear_i, .map_width_i(settings_i.map_width), .begin_i(begins),
    .visit_i(texel_valid && advance && on_row), .edge_i(walk_index), .x_i(walk_at_x), .y_i(walk_at_y[M-1:0]),
    .lookup_i(1'b0), .passed_i(3'b0), .visited_o(not_looked_up),
    .gaps_i(edges_done), .gap_valid_o(gap_valid), .gap_ready_i(gap_ready), .gap_y_o(gap_y), .gap_from_o(gap_from),
    .gap_to_o(gap_to), .gaps_busy_o(gaps_busy)
  );
  span_filler filler (
    .clk_i, .rst_ni, .clear_i, .anchor_i(texel_valid && line.start_here && advance),
    .first_i(walk_index == '0), .anchor_x_i(walk_at_x), .anchor_y_i(walk_at_y), .start_i(edges_done),
    .gap_valid_i(gap_valid), .gap_ready_o(gap_ready), .gap_y_i(gap_y), .gap_from_i(gap_from), .gap_to_i(gap_to),
    .load_o(fill_load), .whole_o(fill_whole), .rest_o(fill_rest), .move_x_o(fill_x), .move_y_o(fill_y),
    .back_o(fill_back), .two_o(fill_two), .next_whole_i(next_whole), .whole_i(ramp_whole[D-1:0]), .rest_i(ramp_rest),
    .word_valid_o(word_valid), .ready_i(advance), .x_o(word_x), .y_o(word_y), .depth_o(word_depth), .mask_o(word_mask)
  );
  // Spans only look at the D lowest bits of its whole part.
  assign plane_busy  = fresh || loading;
  assign plane_ready = loading && advance;
  plane_walk #(.WholeBits(P), .RestBits(AreaBits), .DepthBits(D)) plane (
    .clk_i, .rst_ni, .clear_i, .ready_i(advance), .load_i(fresh), .rest_i(plane_rest), .whole_i(plane_whole),
    .depth_i(entry), .loading_o(loading), .reload_i(fill_load), .reload_rest_i(fill_rest), .reload_whole_i(fill_whole),
    .move_x_i(walk_x || fill_x), .move_y_i(walk_y || fill_y), .back_i(walk_x ? walk_back : fill_back), .two_i(fill_two),
    .prepare_i(fresh),
    .x_less_i(plane_x_less_q), .x_whole_i(plane_x_whole_q), .x_rest_i(plane_x_rest_q),
    .y_less_i(plane_y_less_q), .y_whole_i(plane_y_whole_q), .y_rest_i(plane_y_rest_q), .base_i(area_q),
    .rest_o(ramp_rest), .whole_o(ramp_whole), .next_whole_o(next_whole)
  );
  logic [D-1:0] centre;  // the plane's depth, clamped to the triangle's
  logic         below, above;
  assign below  = ramp_whole[P-1] || (ramp_whole[P-2:D] == '0 && ramp_whole[D-1:0] < least_q);
  assign above  = ramp_whole[P-2:D] != '0 || ramp_whole[D-1:0] > tri_q.most;  // if not below
  assign centre = below ? least_q : above ? tri_q.most : ramp_whole[D-1:0];

  // ---- Visits ----
  shadow_pkg::visit_t visit, visit_q;
  logic               visit_valid_q, visits;
  assign visits        = begins || edges_done || word_valid || (texel_valid && on_map);
  assign visit.kind    = begins ? shadow_pkg::VisitBegin : edges_done ? shadow_pkg::VisitEdgesDone
                       : word_valid ? shadow_pkg::VisitSpan : shadow_pkg::VisitEdge;
  assign visit.x       = word_valid ? word_x : walk_at_x[M-1:0];
  assign visit.y       = word_valid ? word_y : walk_at_y[M-1:0];
  assign visit.line    = line;
  assign visit.nearest = nearest;
  assign visit.corner  = corner;
  assign visit.mask    = word_mask;
  assign {visit.depth0, visit.depth1, visit.depth2, visit.depth3} = '0;  // a cycle later
  always_comb begin
    visit_o        = visit_q;
    visit_o.line.polygon = polygon_q;
    visit_o.depth0 = visit_q.kind == shadow_pkg::VisitSpan ? word_depth[D-1:0] : centre;
    visit_o.depth1 = word_depth[D +: D];
    visit_o.depth2 = word_depth[2*D +: D];
    visit_o.depth3 = word_depth[3*D +: D];
  end
  assign visit_valid_o = visit_valid_q;
  always_ff @(posedge clk_i) if (advance) visit_q <= visit;
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) visit_valid_q <= 1'b0;
    else if (clear_i) visit_valid_q <= 1'b0;
    else if (advance) visit_valid_q <= visits;
  end

  assign idle_o  = phase_q == Idle && !visit_valid_q && !setup_busy;
  assign setup_o = !walking && ((phase_q == Idle && setup_busy) || (phase_q == Edges && left_q != '0));
  assign events_o.caster      = caster;
  assign events_o.edge_begun  = take;
  assign events_o.edge_texel  = advance && texel_valid && on_map;
  assign events_o.span_texels = advance && word_valid ? 3'(word_mask[0]) + 3'(word_mask[1]) + 3'(word_mask[2])
                                                      + 3'(word_mask[3]) : '0;
  logic unused;
  assign unused = &{1'b0, not_looked_up, tri_i, settings_i};
endmodule

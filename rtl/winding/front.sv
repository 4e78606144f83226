// Front of the winding profile: from triangles to visits, in exactly the golden model's order.
//
// Twin:    ShadowUnit::draw, walk_edge, pass_inner_edge in model/unit/winding/shadow_unit_pass1.cpp; the
//          order is also that of tests/rtl/winding/golden_visits.h.
// Walk:    one place moves over the map, texel by texel, with the triangle's corner functions and depth. It
//          goes to an edge's first texel (from the lowest vertex's, or from where the edge before ended)
//          and along with the edge's walker. A row of an inner edge that runs to -x is passed to its left
//          end first; if a corner is to be counted in it, the place comes back to the right, and visits.
// Timing:  edge_setup works on the first edge beside plane_setup, and on the next one while one is walked.
//          A texel of an edge a cycle, two texels of a span a cycle, as long as visits are taken.
`include "check.svh"
module front (
  input  logic                      clk_i,
  input  logic                      rst_ni,
  input  logic                      clear_i,
  /* verilator lint_off UNUSEDSIGNAL */ // what capacities and other skips there are is the store's
  input  shadow_pkg::settings_t     settings_i,
  /* verilator lint_on UNUSEDSIGNAL */
  input  logic                      tri_valid_i,
  output logic                      tri_ready_o,
  input  shadow_pkg::tri_t          tri_i,
  output logic                      visit_valid_o,
  input  logic                      visit_ready_i,
  output shadow_pkg::visit_t        visit_o,
  output shadow_pkg::visit_tri_t    visit_tri_o,  // of the visit at the output
  output logic                      idle_o,       // no triangle inside
  output logic                      setup_o,      // an edge or a triangle is being set up, nothing is walked
  output shadow_pkg::front_events_t events_o
);
  localparam int unsigned C     = shadow_pkg::CoordBits;
  localparam int unsigned T     = shadow_pkg::RowIndexBits;
  localparam int unsigned E     = shadow_pkg::EndWidth;
  localparam int unsigned Depth = shadow_pkg::DepthRange;
  localparam int unsigned B     = shadow_pkg::BaseBits;
  localparam int unsigned M     = shadow_pkg::MapBits;
  localparam int unsigned D     = 57;
  localparam int unsigned K     = 42;

  localparam logic [2:0] Idle = 3'd0, Begin = 3'd1, Edge = 3'd2, Walk = 3'd3, Judge = 3'd4, Return = 3'd5,
                         Gaps = 3'd6, Fill = 3'd7;
  logic [2:0] state_q;

  // ---- Products for edges ----
  logic           edge_factors, product_done;
  logic [C:0]     edge_a;
  logic [C-1:0]   edge_b;
  logic [2*C-1:0] product;

  // ---- The triangle: its setup keeps it until the last span is out ----
  logic                   out_held, out_free;     // the output register holds a visit; takes one
  logic                   tri_valid, tri_done, take_tri, has_area, clockwise, plane_idle;
  logic [6*C-1:0]         vertices;
  logic [3*(C+1)-1:0]     edge_dx, edge_dy;
  logic [2:0]             inner, upward, inexact;
  logic [D-1:0]           base, step_x_rest, step_y_rest, start_rest;
  logic [Depth-1:0]       step_x, step_y, start;
  logic [3*K-1:0]         corners;
  plane_setup plane (
    .clk_i, .rst_ni, .clear_i, .texel_bits_i(settings_i.texel_bits),
    .plane_tolerance_i(settings_i.plane_tolerance), .tri_valid_i, .tri_ready_o, .tri_i,
    .edge_valid_i(edge_factors), .edge_a_i(edge_a), .edge_b_i(edge_b), .edge_done_o(product_done),
    .product_o(product), .area_o(has_area),
    .valid_o(tri_valid), .ready_i(tri_done), .keep_i(fill_keep), .whole_i(depth), .rest_i(rest), .vertices_o(vertices), .edge_dx_o(edge_dx), .edge_dy_o(edge_dy),
    .inner_o(inner), .upward_o(upward), .clockwise_o(clockwise), .visit_tri_o, .base_o(base),
    .step_x_whole_o(step_x), .step_x_rest_o(step_x_rest), .step_y_whole_o(step_y),
    .step_y_rest_o(step_y_rest), .start_whole_o(start), .start_rest_o(start_rest),
    .corner_start_o(corners), .corner_inexact_o(inexact), .caster_o(events_o.caster),
    .idle_o(plane_idle));
  assign take_tri = state_q == Idle && tri_valid && out_free;

  // ---- The next edge ----
  logic [1:0] edge_number, from_vertex, to_vertex;
  logic       edge_valid, load_edge, edge_busy, edge_passes, all_set_up;
  edge_order order (
    .clk_i, .rst_ni, .clear_i, .begin_i(has_area), .passes_i(inner & {3{settings_i.skip_edges}}), .upward_i(upward),
    .load_i(load_edge), .valid_o(edge_busy), .edge_o(edge_number), .passes_o(edge_passes),
    .from_vertex_o(from_vertex), .to_vertex_o(to_vertex), .none_left_o(all_set_up)
  );

  logic           x_positive, on_border, from_u_zero, from_v_zero, to_u_full, to_v_zero;
  logic [T-1:0]   first_u, first_v, last_u, last_v;
  logic [E-1:0]   from_u, from_v, to_u, to_v;
  logic [C:0]     v_whole, u_whole;
  logic [C-1:0]   v_rest, v_step, v_step_rest, du, u_rest, u_step, u_step_rest, dv;
  edge_setup edges (
    .clk_i, .rst_ni, .clear_i, .texel_bits_i(settings_i.texel_bits),
    .edge_valid_i(edge_busy),
    .from_x_i(vertices[2*from_vertex*C +: C]), .from_y_i(vertices[2*from_vertex*C+C +: C]),
    .to_x_i(vertices[2*to_vertex*C +: C]), .to_y_i(vertices[2*to_vertex*C+C +: C]),
    .upward_i(upward[edge_number]), .dx_i(edge_dx[edge_number*(C+1) +: C+1]), .dy_i(edge_dy[edge_number*(C+1) +: C+1]),
    .factors_valid_o(edge_factors), .factor_a_o(edge_a), .factor_b_o(edge_b), .product_done_i(product_done),
    .product_i(product),
    .valid_o(edge_valid), .ready_i(load_edge), .x_positive_o(x_positive), .on_border_o(on_border),
    .first_u_o(first_u), .first_v_o(first_v), .last_u_o(last_u), .last_v_o(last_v), .from_u_o(from_u),
    .from_v_o(from_v), .from_u_zero_o(from_u_zero), .from_v_zero_o(from_v_zero), .to_u_o(to_u), .to_v_o(to_v),
    .to_u_full_o(to_u_full), .to_v_zero_o(to_v_zero), .v_whole_o(v_whole), .v_rest_o(v_rest),
    .v_step_o(v_step), .v_step_rest_o(v_step_rest), .du_o(du), .u_whole_o(u_whole), .u_rest_o(u_rest),
    .u_step_o(u_step), .u_step_rest_o(u_step_rest), .dv_o(dv));

  // ---- The edge that is walked ----
  logic       walk_step, on_edge, edge_last, along_x, walk_right, row_ends, has_segment, dot;
  logic [T-1:0] walk_x, walk_y;        // texel of the walker, from the origin
  logic [T-1:0] texel_x_q, texel_y_q;  // from the map's corner, where the walker was a cycle ago
  shadow_pkg::segment_t piece;
  logic [1:0] walked_q;      // edge
  logic       passes_q;      // it is an inner edge that is not walked
  logic [2:0] passed_q;      // edges before
  edge_walker walker (
    .clk_i, .texel_bits_i(settings_i.texel_bits), .load_i(load_edge),
    .positive_i(clockwise == upward[edge_number]),
    .x_positive_i(x_positive), .on_border_i(on_border), .first_u_i(first_u), .first_v_i(first_v),
    .last_u_i(last_u), .last_v_i(last_v), .from_u_i(from_u), .from_v_i(from_v), .from_u_zero_i(from_u_zero),
    .from_v_zero_i(from_v_zero), .to_u_i(to_u), .to_v_i(to_v), .to_u_full_i(to_u_full), .to_v_zero_i(to_v_zero),
    .v_whole_i(v_whole), .v_rest_i(v_rest), .v_step_i(v_step), .v_step_rest_i(v_step_rest), .du_i(du),
    .u_whole_i(u_whole), .u_rest_i(u_rest), .u_step_i(u_step), .u_step_rest_i(u_step_rest), .dv_i(dv),
    .step_i(walk_step), .x_o(walk_x), .y_o(walk_y), .on_edge_o(on_edge), .last_o(edge_last),
    .along_x_o(along_x), .x_positive_o(walk_right), .row_ends_o(row_ends), .has_segment_o(has_segment),
    .dot_o(dot), .segment_o(piece));
  always_ff @(posedge clk_i) begin
    texel_x_q <= walk_x + centre_x;
    texel_y_q <= walk_y + centre_y;
  end

  // ---- The place ----
  logic         fresh_q;      // the walker has just got an edge;
  logic         restart_q;    // and the place goes to the lowest vertex's texel first
  logic         reached_q;    // it is the walker's texel, and moves with it
  logic         approaches, arrives;
  logic         move_x, move_y, along_y, move_back, load_place;
  logic [T-1:0] place_x, place_y, low_x, low_y, centre_x, centre_y;
  logic         covers, on_map, y_on_map;
  logic         fill_load, fill_x, fill_y, fill_back, filling;
  logic         fill_keep;
  logic [Depth-1:0] depth, fill_step;
  logic [D-1:0] rest, fill_step_rest;
  assign filling  = state_q == Fill;
  assign tri_done = filling && !gaps_busy && !out_held;
  walk_place place (
    .clk_i, .texel_bits_i(settings_i.texel_bits[3:0]), .map_width_i(settings_i.map_width),
    .map_height_i(settings_i.map_height), .vertices_i(vertices), .upward_i(upward), .edge_dx_i(edge_dx),
    .edge_dy_i(edge_dy), .clockwise_i(clockwise), .corners_i(corners), .inexact_i(inexact), .start_i(start),
    .start_rest_i(start_rest), .step_x_i(step_x), .step_x_rest_i(step_x_rest), .step_y_i(step_y),
    .step_y_rest_i(step_y_rest), .base_i(base), .load_i(load_place), .move_x_i(move_x), .move_y_i(move_y),
    .along_y_i(along_y), .back_i(move_back), .filling_i(filling), .fill_load_i(fill_load), .fill_x_i(fill_x), .fill_y_i(fill_y),
    .fill_back_i(fill_back), .fill_step_i(fill_step), .fill_step_rest_i(fill_step_rest),
    .centre_x_o(centre_x), .centre_y_o(centre_y), .low_x_o(low_x), .low_y_o(low_y), .x_o(place_x), .y_o(place_y),
    .covers_o(covers), .depth_o(depth), .rest_o(rest), .on_map_o(on_map), .row_on_map_o(y_on_map));

  // ---- Visited rows and gaps ----
  logic         look, mark, visited, gap_valid, gap_ready, gaps_busy;
  logic [M-1:0] gap_y, gap_from, gap_to;
  visited_rows #(.MapBits(M), .RowIndexBits(T)) rows (
    .clk_i, .rst_ni, .clear_i, .map_width_i(settings_i.map_width), .begin_i(state_q == Begin),
    .visit_i(mark), .edge_i(walked_q), .x_i(place_x), .y_i(place_y[M-1:0]),
    .lookup_i(look), .passed_i(passed_q), .visited_o(visited), .gaps_i(state_q == Gaps),
    .gap_valid_o(gap_valid), .gap_ready_i(gap_ready), .gap_y_o(gap_y), .gap_from_o(gap_from),
    .gap_to_o(gap_to), .gaps_busy_o(gaps_busy));

  logic           word_valid, pair_upper;
  logic [M-1:0]   word_x, word_y;
  logic [3:0]     word_mask;
  logic [2*B-1:0] pair_bases;
  span_filler filler (
    .clk_i, .rst_ni, .clear_i, .start_i(state_q == Gaps), .start_x_i(low_x), .start_y_i(low_y),
    .gap_valid_i(gap_valid), .gap_ready_o(gap_ready), .gap_y_i(gap_y), .gap_from_i(gap_from), .gap_to_i(gap_to),
    .step_x_whole_i(step_x), .step_x_rest_i(step_x_rest), .base_i(base), .whole_i(depth), .rest_i(rest),
    .keep_o(fill_keep), .load_o(fill_load), .move_x_o(fill_x), .move_y_o(fill_y), .back_o(fill_back),
    .step_whole_o(fill_step), .step_rest_o(fill_step_rest), .word_valid_o(word_valid),
    .pair_ready_i(out_free), .upper_o(pair_upper), .x_o(word_x), .y_o(word_y), .mask_o(word_mask),
    .bases_o(pair_bases));

  // ---- Walk ----
  logic         row_starts_q;   // the walker's texel is the first one of its row
  logic         row_done_q;     // its row was visited
  logic         leftward;       // of a row that is passed before it is visited
  logic         probe_due_q, probe_hit_q;  // of such a row's texel: the look-up is answered; it has a corner
  logic         wanted_q, wanted;          // a corner of the row is to be counted
  logic [T-1:0] row_x_q;        // the row's first texel
  logic [1:0]   last_vertex_q;  // that the edge before ended in; 3: none
  logic         ready, probe, visit_it, comes_back, row_over, judged, step_on, edge_ends;
  assign approaches = state_q == Walk && !reached_q && !fresh_q;
  assign arrives    = approaches && place_x == texel_x_q && place_y == texel_y_q;
  assign leftward   = passes_q && !walk_right && !(row_starts_q && row_ends);
  assign ready      = state_q == Walk && reached_q && on_edge && !row_done_q && out_free;
  assign probe      = ready && leftward;
  assign comes_back = state_q == Return && out_free;
  assign visit_it   = (ready && !leftward) || comes_back;
  assign look       = probe || visit_it;
  assign mark       = ready && y_on_map;
  assign wanted     = wanted_q || (probe_due_q && probe_hit_q && !visited);
  assign judged     = state_q == Judge && !probe_due_q;  // the last look-up's answer is in wanted_q
  assign row_over   = judged && !wanted_q;
  assign step_on    = (ready && !(leftward && row_ends)) || row_over
                   || (state_q == Walk && reached_q && (!on_edge || row_done_q));
  assign edge_ends  = step_on && edge_last && on_edge;
  assign walk_step  = step_on && !edge_ends;
  assign load_place = state_q == Walk && restart_q;
  assign load_edge  = edge_valid && (state_q == Edge || edge_ends);

  // Which way a step goes is known before whether it is made.
  logic seeks, moves;
  assign seeks     = state_q == Walk && !reached_q;
  assign moves     = walk_step || (approaches && !arrives) || (comes_back && place_x != row_x_q);
  assign along_y   = seeks ? place_y != texel_y_q : state_q != Return && !along_x;
  assign move_back = !along_y && (seeks ? $signed(place_x) > $signed(texel_x_q) : state_q != Return && !walk_right);
  assign move_x    = moves && !along_y;
  assign move_y    = moves && along_y;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      state_q <= Idle;
    end else if (clear_i) begin
      state_q <= Idle;
    end else begin
      unique case (state_q)
        Idle:    if (take_tri) state_q <= Begin;
        Begin:   state_q <= Edge;
        Edge:    if (edge_valid) state_q <= Walk;
                 else if (all_set_up && out_free) state_q <= Gaps;
        Walk:    if (edge_ends) state_q <= edge_valid ? Walk : Edge;
                 else if (probe && row_ends) state_q <= Judge;
        Judge:   if (judged) state_q <= wanted_q ? Return : edge_ends && !edge_valid ? Edge : Walk;
        Return:  if (comes_back && place_x == row_x_q) state_q <= Walk;
        Gaps:    state_q <= Fill;
        default: if (tri_done) state_q <= Idle;
      endcase
      `CHECK(from_below, !approaches || $signed(place_y) <= $signed(texel_y_q))
      `CHECK(together, !(state_q == Walk && reached_q) || (place_x == walk_x + centre_x && place_y == walk_y + centre_y))
    end
  end
  always_ff @(posedge clk_i) begin
    if (load_edge) begin
      walked_q      <= edge_number;
      passes_q      <= edge_passes;
      restart_q     <= from_vertex != last_vertex_q;
      last_vertex_q <= to_vertex;
    end else if (load_place) begin
      restart_q     <= 1'b0;
    end
    fresh_q <= load_edge;
    // A row that is passed before it is visited leaves the place at its first texel.
    if (load_edge || state_q == Return) reached_q <= 1'b0;
    else if (arrives) reached_q <= 1'b1;
    if (state_q == Begin) last_vertex_q <= 2'd3;

    if (state_q == Begin) passed_q <= '0;
    else if (edge_ends) passed_q[walked_q] <= 1'b1;

    if (load_edge || walk_step) begin
      row_starts_q <= load_edge || !along_x;
      row_done_q   <= 1'b0;
    end else if (comes_back) begin
      row_done_q   <= 1'b1;
    end
    if (probe && row_starts_q) row_x_q <= place_x;
    probe_due_q <= probe;
    probe_hit_q <= covers && on_map;
    wanted_q    <= !(load_edge || (walk_step && !along_x)) && wanted;
  end

  // ---- Visits ----
  shadow_pkg::visit_t out;
  always_comb begin
    out.kind          = state_q == Begin ? shadow_pkg::VisitBegin
                      : filling ? shadow_pkg::VisitSpan : shadow_pkg::VisitEdge;
    out.x             = filling ? word_x : place_x[M-1:0];
    out.y             = filling ? word_y : place_y[M-1:0];
    out.mask          = word_mask;
    out.corner        = 1'b0;  // known a cycle later
    out.has_segment   = !filling && has_segment && !passes_q && !(inner[walked_q] && dot);
    out.segment       = piece;
    out.segment.inner = inner[walked_q];
    {out.base1, out.base0} = pair_bases;  // the first one is the place's own
    {out.base3, out.base2} = pair_bases;
  end
  visit_output visits (
    .clk_i, .rst_ni, .clear_i, .valid_i(state_q == Begin || (visit_it && on_map) || word_valid), .free_o(out_free),
    .visit_i(out), .upper_i(filling && pair_upper), .passes_i(visit_it && passes_q), .covers_i(visit_it && covers),
    .visited_i(visited), .held_o(out_held), .valid_o(visit_valid_o), .ready_i(visit_ready_i), .visit_o
  );

  assign idle_o  = plane_idle && state_q == Idle && !out_held;
  assign setup_o = !visit_valid_o && ((state_q == Idle && !plane_idle) || state_q == Begin
                                      || state_q == Edge);
  assign events_o.edge_begun  = load_edge && !edge_passes;
  assign events_o.edge_texel  = visit_it && on_map && !passes_q;
  assign events_o.inner_texel = ready && on_map && passes_q;
  assign events_o.span_texels = word_valid && out_free
    ? 3'(word_mask[0]) + 3'(word_mask[1]) + 3'(word_mask[2]) + 3'(word_mask[3]) : 3'd0;
endmodule

// Edge setup: takes a triangle and offers its edges one after the other, with all that walking needs.
//
// Source:  3.3.1. Twins: setup_edge in model/unit/edge_setup.cpp; Polygon in model/unit/span_filler.cpp.
// Numbers: ramps are whole + rest / base as in ExactRamp; base is length, rise or twice the area. Quotients
//          fit: depth ramps are used only where the walk crosses a border (offset) or two (step), and so are
//          at most the edge's own difference; what no border uses may be anything.
// Timing:  a program of products on one multiplier (pc_q), dividers beside it. The triangle stays at the
//          input until its last edge was taken; the next edge is set up while one is walked.
`include "check.svh"
module edge_setup #(
  localparam int unsigned D = shadow_pkg::DepthBits,
  localparam int unsigned C = shadow_pkg::CoordBits,
  localparam int unsigned F = shadow_pkg::MaxFraction,
  localparam int unsigned R = shadow_pkg::RowIndexBits,
  localparam int unsigned P = 2 * ((D + C + F + 3) / 2) + 1,  // of a plane's whole part, signed
  localparam int unsigned AreaBits = 2 * C,
  localparam int unsigned CornerBits = 2 * C - 14  // of a corner function, signed: 2^(2C+1) / 2^16
) (
  input  logic                        clk_i,
  input  logic                        rst_ni,
  input  logic                        clear_i,
  input  shadow_pkg::settings_t       settings_i,
  input  logic                        tri_valid_i,
  output logic                        tri_ready_o,
  input  shadow_pkg::tri_t            tri_i,
  output logic                        caster_o,      // a triangle is taken
  output logic                        busy_o,        // a triangle is being set up
  output logic                        edge_valid_o,  // everything below holds until it is taken
  input  logic                        edge_ready_i,
  output logic [1:0]                  index_o,       // of the edge, 0 to 2
  // of the triangle
  output logic [3*(C+1)-1:0]          dx_o,          // edge i at i * (C + 1)
  output logic [3*(C+1)-1:0]          dy_o,
  output logic                        clockwise_o,
  output logic [AreaBits-1:0]         area_o,        // twice the area, > 0
  output logic                        plane_x_less_o,  // steps, see plane_walk
  output logic [P-2:0]                plane_x_whole_o,
  output logic [AreaBits-1:0]         plane_x_rest_o,
  output logic                        plane_y_less_o,
  output logic [P-2:0]                plane_y_whole_o,
  output logic [AreaBits-1:0]         plane_y_rest_o,
  output logic [D-1:0]                least_o,       // depths
  output logic [D-1:0]                most_o,
  output logic [D:0]                  rise_bound_o,
  // of the edge: see edge_geometry
  output logic                        left_o,
  output logic                        x_major_o,
  output logic                        x_positive_o,
  output logic [R-1:0]                first_x_o,
  output logic [R-1:0]                first_y_o,
  output logic [R-1:0]                last_x_o,
  output logic [R-1:0]                last_y_o,
  output logic [C-1:0]                length_o,
  output logic [C-1:0]                rise_o,
  output logic [F+2:0]                minor_whole_o,  // signed; minor coordinate at the first texel's near side
  output logic [C-1:0]                minor_rest_o,
  output logic [F+1:0]                minor_step_whole_o,
  output logic [C-1:0]                minor_step_rest_o,
  output logic [D-1:0]                first_depth_o,
  output logic [D-1:0]                last_depth_o,
  output logic                        depth_less_o,         // it falls; ramps of depth are as in depth_ramp
  output logic [D:0]                  major_depth_whole_o,  // at the first border along the major axis
  output logic [C:0]                  major_depth_rest_o,
  output logic [D-1:0]                major_depth_step_whole_o,
  output logic [C-1:0]                major_depth_step_rest_o,
  output logic [D:0]                  minor_depth_whole_o,  // and along the minor one
  output logic [C:0]                  minor_depth_rest_o,
  output logic [D-1:0]                minor_depth_step_whole_o,
  output logic [C-1:0]                minor_depth_step_rest_o,
  // the plane at the first texel's centre, less first_depth
  input  logic                        plane_busy_i,   // not taken with the edge, but in the end by
  input  logic                        plane_ready_i,  // this; it waits for the next edge's
  output logic [P-1:0]                plane_whole_o,
  output logic [AreaBits:0]           plane_rest_o,
  output logic [3*CornerBits-1:0]     corner_o,       // functions at the first texel's corner, over 2^f
  output logic [2:0]                  corner_inexact_o
);
  localparam int unsigned E = C + 1;         // of a difference of coordinates, signed
  localparam int unsigned Q = 2 * ((D + 1) / 2) + 1;  // of a depth ramp's quotient, signed, odd
  localparam int unsigned N = D + F + 2;     // of a depth ramp's numerator, signed
  localparam int unsigned GradientBits = D + C + 2;

  // ---- Program ----
  // Steps take two cycles and issue products; what they are is there in the first cycle two steps later.
  localparam logic [4:0] PcGradients = 5'd0;   // 0, 1: area; 2, 3: gradient x; 4, 5: y
  localparam logic [4:0] PcEdge      = 5'd8;   // the edge's direction and its extent along x
  localparam logic [4:0] PcAxes      = 5'd9;   // its axes, length and rise
  localparam logic [4:0] PcSteps     = 5'd10;  // the ramps' steps go to their dividers
  localparam logic [4:0] PcOffset    = 5'd10;  // 10 to 13: start of the plane; first texel
  localparam logic [4:0] PcCorner    = 5'd14;  // 14, 15: corner function 0
  localparam logic [4:0] PcRamps     = 5'd16;  // 16: offset of minor; 17, 18: of depth along major, minor
  localparam logic [4:0] PcInto      = 5'd19;  // minor coordinate of the start
  localparam logic [4:0] PcCorners   = 5'd20;  // 20 to 23: corner functions 1 and 2
  localparam logic [4:0] PcLast      = 5'd24;  // 24, 25: last texel
  localparam logic [4:0] PcWait      = 5'd27;  // until the edge is taken
  logic [4:0] pc_q;
  logic       second_q;  // of a step's cycles
  logic [1:0] edge_q;
  logic       run, flat, last_taken;
  logic [AreaBits-1:0] area_q;
  logic       offset_full_q;  // the plane's numerator waits for its division

  assign run        = tri_valid_i && !tri_i.is_plane;
  assign flat       = pc_q == PcEdge && area_q == '0;
  assign last_taken = edge_valid_o && edge_ready_i && edge_q == 2'd2;
  assign tri_ready_o = tri_valid_i && (tri_i.is_plane || flat || last_taken);
  assign caster_o    = tri_ready_o && !tri_i.is_plane;
  assign busy_o      = run;
  assign index_o     = edge_q;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      pc_q     <= '0;
      second_q <= 1'b0;
      edge_q   <= '0;
    end else if (clear_i || !run) begin
      pc_q     <= '0;
      second_q <= 1'b0;
      edge_q   <= '0;
    end else if (pc_q == PcWait) begin
      if (edge_valid_o && edge_ready_i) begin
        pc_q   <= edge_q == 2'd2 ? PcGradients : PcEdge;
        edge_q <= edge_q == 2'd2 ? '0 : edge_q + 1'b1;
      end
    end else if (flat) begin
      pc_q     <= PcGradients;
      second_q <= 1'b0;
    end else if (pc_q != PcEdge || !plane_busy_i) begin
      second_q <= !second_q;
      pc_q     <= pc_q + 5'(second_q);
    end
  end

  // ---- Triangle ----
  logic [D-1:0] z0, z1, z2, low01, high01;
  logic [E-1:0] dx0, dx1, dx2, dy0, dy1, dy2;
  logic [D:0]   dz0, dz1;
  assign z0  = tri_i.v0.z[shadow_pkg::TraceDepthBits-1 -: D];
  assign z1  = tri_i.v1.z[shadow_pkg::TraceDepthBits-1 -: D];
  assign z2  = tri_i.v2.z[shadow_pkg::TraceDepthBits-1 -: D];
  assign dx0 = {tri_i.v1.x[C-1], tri_i.v1.x} - {tri_i.v0.x[C-1], tri_i.v0.x};
  assign dx1 = {tri_i.v2.x[C-1], tri_i.v2.x} - {tri_i.v1.x[C-1], tri_i.v1.x};
  assign dx2 = {tri_i.v0.x[C-1], tri_i.v0.x} - {tri_i.v2.x[C-1], tri_i.v2.x};
  assign dy0 = {tri_i.v1.y[C-1], tri_i.v1.y} - {tri_i.v0.y[C-1], tri_i.v0.y};
  assign dy1 = {tri_i.v2.y[C-1], tri_i.v2.y} - {tri_i.v1.y[C-1], tri_i.v1.y};
  assign dy2 = {tri_i.v0.y[C-1], tri_i.v0.y} - {tri_i.v2.y[C-1], tri_i.v2.y};
  assign dz0 = {1'b0, z1} - {1'b0, z0};
  assign dz1 = {1'b0, z2} - {1'b0, z1};
  assign dx_o = {dx2, dx1, dx0};
  assign dy_o = {dy2, dy1, dy0};
  assign low01   = z0 < z1 ? z0 : z1;
  assign high01  = z0 < z1 ? z1 : z0;
  always_ff @(posedge clk_i) begin
    least_o <= low01 < z2 ? low01 : z2;
    most_o  <= high01 > z2 ? high01 : z2;
  end

  // ---- Edge ----
  // It goes up along y, a horizontal one up along x: from a vertex to another one.
  logic         swap_q, swap, rises, x_major;
  logic [1:0]   next_vertex, from_vertex, to_vertex;
  logic [E-1:0] edge_dx, edge_dy, difference_q;
  logic [C-1:0] extent, length_q, rise_q;
  logic [D:0]   dz;
  assign next_vertex = edge_q == 2'd2 ? 2'd0 : edge_q + 1'b1;
  assign from_vertex = swap_q ? next_vertex : edge_q;
  assign to_vertex   = swap_q ? edge_q : next_vertex;
  assign edge_dx     = edge_q == 2'd0 ? dx0 : edge_q == 2'd1 ? dx1 : dx2;
  assign edge_dy     = edge_q == 2'd0 ? dy0 : edge_q == 2'd1 ? dy1 : dy2;
  assign swap        = edge_dy[E-1] || (edge_dy == '0 && edge_dx[E-1]);
  assign extent      = (difference_q[C-1:0] ^ {C{difference_q[E-1]}}) + C'(difference_q[E-1]);
  assign x_major     = length_q > rise_q;
  always_ff @(posedge clk_i) begin
    difference_q <= pc_q == PcEdge && !second_q ? edge_dx : edge_dy;
    if (pc_q == PcEdge) begin
      swap_q       <= swap;
      x_positive_o <= edge_dx == '0 || edge_dx[E-1] == swap;
      length_q     <= extent;
    end
    if (pc_q == PcAxes && !second_q) rise_q <= extent;
    if (pc_q == PcAxes && second_q) begin
      x_major_o <= x_major;
      if (!x_major) begin
        length_q <= rise_q;
        rise_q   <= length_q;
      end
    end
  end
  assign rises         = rise_q != '0;
  assign length_o      = length_q;
  assign rise_o        = rise_q;
  assign left_o        = swap_q != clockwise_o;
  assign first_depth_o = from_vertex == 2'd0 ? z0 : from_vertex == 2'd1 ? z1 : z2;
  assign last_depth_o  = to_vertex == 2'd0 ? z0 : to_vertex == 2'd1 ? z1 : z2;
  assign dz            = {1'b0, last_depth_o} - {1'b0, first_depth_o};

  // ---- Its ends' texels, one coordinate a step ----
  // An end on a border belongs to the texel before it, a start to the one after; on an axis without
  // extent both do to the one after.
  logic         at_end, along_y, on_before;
  logic [1:0]   vertex;
  logic [C-1:0] x, y;
  logic [R-1:0] index;
  logic [F:0]   units, units_q, into_minor_q;
  assign at_end = pc_q >= PcLast;
  assign vertex = at_end ? to_vertex : from_vertex;
  assign x      = vertex == 2'd0 ? tri_i.v0.x : vertex == 2'd1 ? tri_i.v1.x : tri_i.v2.x;
  assign y      = vertex == 2'd0 ? tri_i.v0.y : vertex == 2'd1 ? tri_i.v1.y : tri_i.v2.y;
  assign on_before = along_y ? at_end && (!x_major_o || rises)
                : at_end ? x_positive_o && (x_major_o || rises) : !x_positive_o;
  edge_geometry geometry (
    .texel_bits_i(settings_i.texel_bits), .map_size_i(along_y ? settings_i.map_height : settings_i.map_width),
    .coordinate_i(along_y ? y : x), .before_i(on_before), .index_o(index), .inside_o(units));
  always_ff @(posedge clk_i) begin
    units_q <= units;
    if (pc_q == PcOffset) first_x_o <= index;
    if (pc_q == PcOffset + 5'd1) first_y_o <= index;
    if (pc_q == PcLast) last_x_o <= index;
    if (pc_q == PcLast + 5'd1) last_y_o <= index;
    if (pc_q == PcInto) into_minor_q <= way[F:0];
  end

  // ---- Products ----
  // Ways from the start, inside its texel: to the centre, to the corner, to the texel's sides. Along x they
  // may go down: what is before the start then is the rest of the texel. Ways are there in a step's second cycle.
  logic [E-1:0]            factor_a, factor_b, way, way_base;
  logic [2*E-1:0]          product;
  logic [GradientBits-1:0] gradient_x, gradient_y;
  logic [F:0]              texel;
  logic                    down, way_less;
  assign texel = (F + 1)'(1) << settings_i.texel_bits;
  assign down  = !along_y && !x_positive_o;
  always_comb begin
    way_base = '0;
    way_less = 1'b0;
    case (pc_q)
      5'd10, 5'd11, 5'd12, 5'd13: begin way_base = E'(texel[F:1]); way_less = 1'b1; end
      5'd16: if (down) way_base = ~(E'(texel) - 1'b1); else way_less = 1'b1;             // back, negative
      5'd17, 5'd18: if (!down) begin way_base = E'(texel); way_less = 1'b1; end         // on
      5'd19: if (down) begin way_base = E'(texel); way_less = 1'b1; end                 // back
      default: ;
    endcase
    case (pc_q)
      5'd10, 5'd13, 5'd14, 5'd20, 5'd22, PcLast: along_y = 1'b0;
      5'd16, 5'd17: along_y = !x_major_o;
      5'd18, 5'd19: along_y = x_major_o;
      default: along_y = 1'b1;
    endcase
  end
  assign way = way_base + (E'(units_q) ^ {E{way_less}}) + E'(way_less);
  two_pass_multiplier #(.ABits(E), .BBits(E)) multiplier (
    .clk_i, .take_i(second_q), .a_i(factor_a), .b_i(factor_b), .product_o(product));
  always_comb begin
    case (pc_q)
      5'd0, 5'd15:  factor_a = dx0;
      5'd1, 5'd21:  factor_a = dx1;
      5'd2, 5'd5:   factor_a = E'($signed(dz0));
      5'd3, 5'd4:   factor_a = E'($signed(dz1));
      5'd10:        factor_a = E'(gradient_x[C-2:0]);
      5'd11:        factor_a = E'(gradient_y[C-2:0]);
      5'd12:        factor_a = E'($signed(gradient_y[GradientBits-1:C-1]));
      5'd13:        factor_a = E'($signed(gradient_x[GradientBits-1:C-1]));
      5'd14:        factor_a = dy0;
      5'd16:        factor_a = E'(rise_q);
      5'd17, 5'd18: factor_a = E'($signed(dz));
      5'd20:        factor_a = dy1;
      5'd22:        factor_a = dy2;
      default:      factor_a = dx2;
    endcase
    case (pc_q)
      5'd0, 5'd2: factor_b = dy1;
      5'd1, 5'd3: factor_b = dy0;
      5'd4:       factor_b = dx0;
      5'd5:       factor_b = dx1;
      default:    factor_b = way;
    endcase
  end

  // ---- Area and corner functions, in one accumulator ----
  // A corner function is that of the start, which is the area for the edge opposite and else 0, and
  // what the way to the corner adds.
  logic [2*E-1:0] sum_q, sum_from;
  logic           clockwise_q, sum_area_q;
  logic [1:0]     corner;
  logic [2:0]     corner_done;
  logic           corner_opposite;
  assign corner          = pc_q == PcCorner + 5'd1 ? 2'd0 : pc_q == PcCorners + 5'd1 ? 2'd1 : 2'd2;  // function of a first product
  assign corner_done     = {pc_q == PcCorners + 5'd6, pc_q == PcCorners + 5'd4, pc_q == PcCorner + 5'd4};
  assign corner_opposite = corner == (from_vertex == 2'd2 ? 2'd0 : from_vertex + 1'b1);
  // First products come in even steps, those that are subtracted in odd ones.
  assign sum_from        = pc_q[0] ? sum_q : {2'b0, area_q & {AreaBits{sum_area_q}}} ^ {(2*E){sum_area_q && clockwise_q}};
  assign clockwise_o     = clockwise_q;
  assign area_o          = area_q;
  always_ff @(posedge clk_i) begin
    sum_area_q <= pc_q >= PcCorner && corner_opposite;  // what it says in even steps is of the odd one before
    if (!second_q) sum_q <= sum_from + (product ^ {(2*E){pc_q[0]}}) + (2*E)'(pc_q[0] || (sum_area_q && clockwise_q));
    if (pc_q == 5'd3 && second_q) begin
      clockwise_q <= sum_q[2*E-1];
      area_q      <= (sum_q[AreaBits-1:0] ^ {AreaBits{sum_q[2*E-1]}}) + AreaBits'(sum_q[2*E-1]);
    end
    for (int i = 0; i < 3; i++) begin
      if (corner_done[i] && !second_q) begin
        corner_o[i*CornerBits +: CornerBits] <= CornerBits'($signed(sum_q) >>> settings_i.texel_bits);
        corner_inexact_o[i]                  <= (sum_q[F:0] & (texel - 1'b1)) != '0;
      end
    end
  end

  // ---- Plane ----
  // What the next step's product is, in that step's first cycle.
  logic gradient_x_step_q, gradient_y_step_q, offset_step_q, first_q, less_q, high_q;
  always_ff @(posedge clk_i) begin
    gradient_x_step_q <= second_q && (pc_q == 5'd3 || pc_q == 5'd4);
    gradient_y_step_q <= second_q && (pc_q == 5'd5 || pc_q == 5'd6);
    offset_step_q     <= second_q && pc_q >= PcOffset + 5'd1 && pc_q < PcOffset + 5'd5;
    first_q           <= pc_q == 5'd3 || pc_q == 5'd5 || pc_q == PcOffset + 5'd1;
    less_q            <= !pc_q[0] != (pc_q == 5'd3 ? sum_q[2*E-1] : clockwise_q);
    high_q            <= pc_q >= PcOffset + 5'd3;
  end
  logic         plane_valid, offset_taken;
  plane_setup plane (
    .clk_i, .rst_ni, .clear_i, .texel_bits_i(settings_i.texel_bits), .farthest_i(settings_i.hidden_removal == 2'd2),
    .product_i(product),
    .gradient_x_i(gradient_x_step_q), .gradient_y_i(gradient_y_step_q), .offset_i(offset_step_q),
    .first_i(first_q), .less_i(less_q), .high_i(high_q),
    .start_i(pc_q == PcEdge && edge_q == 2'd0 && second_q && !flat && run),
    .offset_ready_i(offset_full_q), .offset_taken_o(offset_taken),
    .area_i(area_q), .range_i(most_o - least_o),
    .gradient_x_o(gradient_x), .gradient_y_o(gradient_y),
    .x_less_o(plane_x_less_o), .x_whole_o(plane_x_whole_o), .x_rest_o(plane_x_rest_o),
    .y_less_o(plane_y_less_o), .y_whole_o(plane_y_whole_o), .y_rest_o(plane_y_rest_o),
    .rise_o(rise_bound_o),
    .start_valid_o(plane_valid), .start_ready_i(plane_ready_i),
    .start_whole_o(plane_whole_o), .start_rest_o(plane_rest_o)
  );
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) offset_full_q <= 1'b0;
    else if (clear_i) offset_full_q <= 1'b0;
    else begin
      offset_full_q <= (pc_q == PcOffset + 5'd5 && !second_q) || (offset_full_q && !offset_taken);
      `CHECK(triangle_stays, run || pc_q == '0)
      `CHECK(dividers_free, (ramp_start & ~ramp_ready) == '0 && (pc_q != PcOffset || !offset_full_q))
    end
  end

  // ---- Ramps ----
  // A divider each for the minor coordinate, depth along major and along minor: first the step, which
  // goes to its registers, then the offset, which stays in the divider.
  logic [2:0]   ramp_valid, ramp_ready, ramp_start, ramp_taken;
  logic         steps, steps_kept;  // steps: now; kept: all are in their registers
  logic [F+2:0] minor_quotient;
  logic [Q-1:0] major_quotient, minor_depth_quotient;
  logic [C-1:0] major_remainder, minor_depth_remainder;
  logic [C-1:0] rise_divisor;
  logic [N-1:0] depth_numerator;
  assign steps           = pc_q == PcSteps && !second_q;
  assign rise_divisor    = rises ? rise_q : C'(1);  // nothing moves along the minor axis
  assign depth_numerator = steps ? N'($signed(dz)) << settings_i.texel_bits : product[N-1:0];
  for (genvar i = 0; i < 3; i++) begin : g_ramp
    assign ramp_start[i] = steps || (pc_q == PcRamps + 5'd2 + 5'(i) && !second_q);
    assign ramp_taken[i] = edge_valid_o ? edge_ready_i : !steps_kept;
  end
  divider #(.NumeratorBits(C+F+1), .DivisorBits(C), .QuotientBits(F+3)) minor_divider (
    .clk_i, .rst_ni, .clear_i, .valid_i(ramp_start[0]), .ready_o(ramp_ready[0]),
    .numerator_i(steps ? {1'b0, (C+F)'(rise_q)} << settings_i.texel_bits : product[C+F:0]), .divisor_i(length_q),
    .valid_o(ramp_valid[0]), .ready_i(ramp_taken[0]), .quotient_o(minor_quotient), .remainder_o(minor_rest_o));
  divider #(.NumeratorBits(N), .DivisorBits(C), .QuotientBits(Q), .Floor(1'b0)) major_divider (
    .clk_i, .rst_ni, .clear_i, .valid_i(ramp_start[1]), .ready_o(ramp_ready[1]),
    .numerator_i(depth_numerator), .divisor_i(length_q),
    .valid_o(ramp_valid[1]), .ready_i(ramp_taken[1]), .quotient_o(major_quotient), .remainder_o(major_remainder));
  divider #(.NumeratorBits(N), .DivisorBits(C), .QuotientBits(Q), .Floor(1'b0)) minor_depth_divider (
    .clk_i, .rst_ni, .clear_i, .valid_i(ramp_start[2]), .ready_o(ramp_ready[2]),
    .numerator_i(depth_numerator), .divisor_i(rise_divisor),
    .valid_o(ramp_valid[2]), .ready_i(ramp_taken[2]), .quotient_o(minor_depth_quotient),
    .remainder_o(minor_depth_remainder));
  // Steps are done after at most 1 + (F + 2) / 2 cycles, before PcRamps + 2.
  assign steps_kept = pc_q >= PcRamps + 5'd2;
  always_ff @(posedge clk_i) begin
    if (!steps_kept) begin
      if (ramp_valid[0]) begin
        minor_step_whole_o <= minor_quotient[F+1:0];
        minor_step_rest_o  <= minor_rest_o;
      end
      if (ramp_valid[1]) begin
        major_depth_step_whole_o <= major_quotient[D-1:0];
        major_depth_step_rest_o  <= major_remainder;
      end
      if (ramp_valid[2]) begin
        minor_depth_step_whole_o <= minor_depth_quotient[D-1:0];
        minor_depth_step_rest_o  <= minor_depth_remainder;
      end
    end
  end
  assign minor_whole_o            = minor_quotient + (F + 3)'(into_minor_q);
  always_ff @(posedge clk_i) depth_less_o <= dz[D];
  assign major_depth_whole_o = ({1'b0, major_quotient[D-1:0]} ^ {(D+1){depth_less_o}}) + {1'b0, first_depth_o};
  assign minor_depth_whole_o = ({1'b0, minor_depth_quotient[D-1:0]} ^ {(D+1){depth_less_o}}) + {1'b0, first_depth_o};
  assign major_depth_rest_o  = {1'b0, major_remainder} ^ {(C+1){depth_less_o}};
  assign minor_depth_rest_o  = {1'b0, minor_depth_remainder} ^ {(C+1){depth_less_o}};

  assign edge_valid_o = pc_q == PcWait && ramp_valid == 3'b111 && plane_valid;

  logic unused;
  assign unused = &{1'b0, major_quotient, minor_depth_quotient, tri_i, settings_i};
endmodule

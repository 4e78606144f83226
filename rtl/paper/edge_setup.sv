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
  output logic [D:0]                  major_depth_whole_o,  // at the first border along the major axis
  output logic [C-1:0]                major_depth_rest_o,
  output logic [D:0]                  major_depth_step_whole_o,
  output logic [C-1:0]                major_depth_step_rest_o,
  output logic [D:0]                  minor_depth_whole_o,  // and along the minor one
  output logic [C-1:0]                minor_depth_rest_o,
  output logic [D:0]                  minor_depth_step_whole_o,
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
  // Steps issue products; what they are is there two steps later.
  localparam logic [4:0] PcGradients = 5'd0;   // 0, 1: area; 2, 3: gradient x; 4, 5: y
  localparam logic [4:0] PcEdge      = 5'd8;   // the edge's direction goes to its register
  localparam logic [4:0] PcAxes      = 5'd9;   // then its axes, length and rise
  localparam logic [4:0] PcSteps     = 5'd10;  // the ramps' steps go to their dividers
  localparam logic [4:0] PcOffset    = 5'd10;  // 10 to 13: start of the plane
  localparam logic [4:0] PcCorners   = 5'd14;  // 14 to 19: corner functions
  localparam logic [4:0] PcRamps     = 5'd24;  // 24: offset of minor; 25, 26: of depth along major, minor
  localparam logic [4:0] PcWait      = 5'd29;  // until the edge is taken
  logic [4:0] pc_q;
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
      pc_q   <= '0;
      edge_q <= '0;
    end else if (clear_i || !run) begin
      pc_q   <= '0;
      edge_q <= '0;
    end else if (pc_q == PcWait) begin
      if (edge_valid_o && edge_ready_i) begin
        pc_q   <= edge_q == 2'd2 ? PcGradients : PcEdge;
        edge_q <= edge_q == 2'd2 ? '0 : edge_q + 1'b1;
      end
    end else if (flat) begin
      pc_q <= PcGradients;
    end else if (pc_q != PcEdge || !plane_busy_i) begin
      pc_q <= pc_q + 1'b1;
    end
  end

  // ---- Triangle ----
  shadow_pkg::point_t a, b;
  logic [D-1:0] z0, z1, z2, low01, high01;
  logic [E-1:0] dx0, dx1, dx2, dy0, dy1, dy2;
  logic [D:0]   dz0, dz2;
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
  assign dz2 = {1'b0, z0} - {1'b0, z2};
  assign dx_o = {dx2, dx1, dx0};
  assign dy_o = {dy2, dy1, dy0};
  assign low01   = z0 < z1 ? z0 : z1;
  assign high01  = z0 < z1 ? z1 : z0;
  assign least_o = low01 < z2 ? low01 : z2;
  assign most_o  = high01 > z2 ? high01 : z2;

  always_comb begin
    case (edge_q)
      2'd0:    {a, b} = {tri_i.v0, tri_i.v1};
      2'd1:    {a, b} = {tri_i.v1, tri_i.v2};
      default: {a, b} = {tri_i.v2, tri_i.v0};
    endcase
  end

  // ---- Edge ----
  logic         swap, swap_q, x_major, x_positive, rises;
  logic [F:0]   start_x, start_y, into_major, into_minor, to_major, to_minor, texel;
  logic [C-1:0] length, rise, length_q, rise_q;
  logic [D:0]   dz;
  edge_geometry geometry (
    .texel_bits_i(settings_i.texel_bits), .map_width_i(settings_i.map_width), .map_height_i(settings_i.map_height),
    .a_i(a), .b_i(b),
    .swap_o(swap), .swap_i(swap_q), .x_major_o(x_major), .x_positive_o(x_positive),
    .x_major_i(x_major_o), .x_positive_i(x_positive_o), .rises_i(rises),
    .first_x_o, .first_y_o, .last_x_o, .last_y_o, .start_x_o(start_x), .start_y_o(start_y),
    .into_major_o(into_major), .into_minor_o(into_minor), .length_o(length), .rise_o(rise),
    .first_depth_o, .last_depth_o
  );
  assign texel  = (F + 1)'(1) << settings_i.texel_bits;
  assign to_major = texel - into_major;  // to the next border
  assign to_minor = texel - into_minor;
  assign dz     = {1'b0, last_depth_o} - {1'b0, first_depth_o};
  assign left_o = swap_q != clockwise_o;
  always_ff @(posedge clk_i) begin
    if (pc_q == PcEdge) swap_q <= swap;
    if (pc_q == PcAxes) begin
      x_major_o    <= x_major;
      x_positive_o <= x_positive;
      length_q     <= length;
      rise_q       <= rise;
    end
  end
  assign rises    = rise_q != '0;
  assign length_o = length_q;
  assign rise_o   = rise_q;

  // ---- Products ----
  logic [E-1:0]            factor_a, factor_b;
  logic [2*E-1:0]          product;
  logic [GradientBits-1:0] gradient_x, gradient_y;
  logic [F+1:0]            centre_x, centre_y;  // signed, from the start to the first texel's centre
  assign centre_x = {2'b0, texel[F:1]} - {1'b0, start_x};
  assign centre_y = {2'b0, texel[F:1]} - {1'b0, start_y};
  multiplier #(.ABits(E), .BBits(E)) multiplier (.clk_i, .a_i(factor_a), .b_i(factor_b), .product_o(product));
  always_comb begin
    case (pc_q)
      5'd0:    begin factor_a = dx2; factor_b = dy0; end
      5'd1:    begin factor_a = dx0; factor_b = dy2; end
      5'd2:    begin factor_a = E'($signed(dz2)); factor_b = dy0; end
      5'd3:    begin factor_a = E'($signed(dz0)); factor_b = dy2; end
      5'd4:    begin factor_a = E'($signed(dz0)); factor_b = dx2; end
      5'd5:    begin factor_a = E'($signed(dz2)); factor_b = dx0; end
      5'd10:   begin factor_a = E'($signed(gradient_x[GradientBits-1:C-1])); factor_b = E'($signed(centre_x)); end
      5'd11:   begin factor_a = E'(gradient_x[C-2:0]); factor_b = E'($signed(centre_x)); end
      5'd12:   begin factor_a = E'($signed(gradient_y[GradientBits-1:C-1])); factor_b = E'($signed(centre_y)); end
      5'd13:   begin factor_a = E'(gradient_y[C-2:0]); factor_b = E'($signed(centre_y)); end
      5'd14:   begin factor_a = dy0; factor_b = E'(start_x); end
      5'd15:   begin factor_a = dx0; factor_b = E'(start_y); end
      5'd16:   begin factor_a = dy1; factor_b = E'(start_x); end
      5'd17:   begin factor_a = dx1; factor_b = E'(start_y); end
      5'd18:   begin factor_a = dy2; factor_b = E'(start_x); end
      5'd19:   begin factor_a = dx2; factor_b = E'(start_y); end
      5'd24:   begin factor_a = E'(rise_q); factor_b = E'(0) - E'(into_major); end
      5'd25:   begin factor_a = E'($signed(dz)); factor_b = E'(to_major); end
      default: begin factor_a = E'($signed(dz)); factor_b = E'(to_minor); end
    endcase
  end

  // ---- Area and corner functions, in one accumulator ----
  // A corner function is that of the start, which is the area for the edge opposite and else 0, and
  // what the way to the corner adds.
  logic [2*E-1:0] sum_q, sum_from;
  logic           clockwise_q, clockwise, sum_first, sum_less, sum_area;
  logic [1:0]     start_vertex, corner;
  logic           corner_opposite;
  assign corner          = pc_q == PcCorners + 5'd2 ? 2'd0 : pc_q == PcCorners + 5'd4 ? 2'd1 : 2'd2;  // function of a first product
  assign start_vertex    = swap_q ? (edge_q == 2'd2 ? 2'd0 : edge_q + 1'b1) : edge_q;
  assign corner_opposite = corner == (start_vertex == 2'd2 ? 2'd0 : start_vertex + 1'b1);
  assign sum_first       = !pc_q[0];
  assign sum_less        = pc_q[0];
  assign sum_area        = sum_first && pc_q >= PcCorners && corner_opposite;
  assign sum_from        = !sum_first ? sum_q : sum_area ? {2'b0, area_q} ^ {(2*E){clockwise_q}} : '0;
  assign clockwise       = pc_q == 5'd4 ? sum_q[2*E-1] : clockwise_q;
  assign clockwise_o     = clockwise_q;
  assign area_o          = area_q;
  always_ff @(posedge clk_i) begin
    sum_q <= sum_from + (product ^ {(2*E){sum_less}}) + {{(2*E-1){1'b0}}, sum_less || (sum_area && clockwise_q)};
    if (pc_q == 5'd4) begin
      clockwise_q <= clockwise;
      area_q      <= clockwise ? -sum_q[AreaBits-1:0] : sum_q[AreaBits-1:0];
    end
    for (int i = 0; i < 3; i++) begin
      if (pc_q == PcCorners + 5'd4 + 5'(2 * i)) begin
        corner_o[i*CornerBits +: CornerBits] <= CornerBits'($signed(sum_q) >>> settings_i.texel_bits);
        corner_inexact_o[i]                  <= (sum_q[F:0] & (texel - 1'b1)) != '0;
      end
    end
  end

  // ---- Plane ----
  logic         plane_valid, offset_taken;
  plane_setup plane (
    .clk_i, .rst_ni, .clear_i, .texel_bits_i(settings_i.texel_bits), .farthest_i(settings_i.hidden_removal == 2'd2),
    .product_i(product),
    .gradient_x_i(pc_q == 5'd4 || pc_q == 5'd5), .gradient_y_i(pc_q == 5'd6 || pc_q == 5'd7),
    .offset_i(pc_q >= PcOffset + 5'd2 && pc_q < PcOffset + 5'd6),
    .first_i(pc_q == 5'd4 || pc_q == 5'd6 || pc_q == PcOffset + 5'd2),
    .less_i(pc_q[0] != clockwise), .high_i(!pc_q[0]),
    .start_i(pc_q == PcEdge && edge_q == 2'd0 && !flat && run && !plane_busy_i),
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
      offset_full_q <= pc_q == PcOffset + 5'd5 || (offset_full_q && !offset_taken);
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
  logic [C-1:0] rise_divisor;
  logic [N-1:0] depth_numerator;
  assign steps           = pc_q == PcSteps;
  assign rise_divisor    = rises ? rise_q : C'(1);  // nothing moves along the minor axis
  assign depth_numerator = steps ? N'($signed(dz)) << settings_i.texel_bits : product[N-1:0];
  for (genvar i = 0; i < 3; i++) begin : g_ramp
    assign ramp_start[i] = steps || pc_q == PcRamps + 5'd2 + 5'(i);
    assign ramp_taken[i] = edge_valid_o ? edge_ready_i : !steps_kept;
  end
  divider #(.NumeratorBits(C+F+1), .DivisorBits(C), .QuotientBits(F+3)) minor_divider (
    .clk_i, .rst_ni, .clear_i, .valid_i(ramp_start[0]), .ready_o(ramp_ready[0]),
    .numerator_i(steps ? {1'b0, (C+F)'(rise_q)} << settings_i.texel_bits : product[C+F:0]), .divisor_i(length_q),
    .valid_o(ramp_valid[0]), .ready_i(ramp_taken[0]), .quotient_o(minor_quotient), .remainder_o(minor_rest_o));
  divider #(.NumeratorBits(N), .DivisorBits(C), .QuotientBits(Q)) major_divider (
    .clk_i, .rst_ni, .clear_i, .valid_i(ramp_start[1]), .ready_o(ramp_ready[1]),
    .numerator_i(depth_numerator), .divisor_i(length_q),
    .valid_o(ramp_valid[1]), .ready_i(ramp_taken[1]), .quotient_o(major_quotient), .remainder_o(major_depth_rest_o));
  divider #(.NumeratorBits(N), .DivisorBits(C), .QuotientBits(Q)) minor_depth_divider (
    .clk_i, .rst_ni, .clear_i, .valid_i(ramp_start[2]), .ready_o(ramp_ready[2]),
    .numerator_i(depth_numerator), .divisor_i(rise_divisor),
    .valid_o(ramp_valid[2]), .ready_i(ramp_taken[2]), .quotient_o(minor_depth_quotient),
    .remainder_o(minor_depth_rest_o));
  // Steps are done after at most 1 + (F + 2) / 2 cycles, before PcRamps + 2.
  assign steps_kept = pc_q >= PcRamps + 5'd2;
  always_ff @(posedge clk_i) begin
    if (!steps_kept) begin
      if (ramp_valid[0]) begin
        minor_step_whole_o <= minor_quotient[F+1:0];
        minor_step_rest_o  <= minor_rest_o;
      end
      if (ramp_valid[1]) begin
        major_depth_step_whole_o <= major_quotient[D:0];
        major_depth_step_rest_o  <= major_depth_rest_o;
      end
      if (ramp_valid[2]) begin
        minor_depth_step_whole_o <= minor_depth_quotient[D:0];
        minor_depth_step_rest_o  <= minor_depth_rest_o;
      end
    end
  end
  assign minor_whole_o            = minor_quotient + (F + 3)'(into_minor);
  assign major_depth_whole_o      = major_quotient[D:0] + {1'b0, first_depth_o};
  assign minor_depth_whole_o      = minor_depth_quotient[D:0] + {1'b0, first_depth_o};

  assign edge_valid_o = pc_q == PcWait && ramp_valid == 3'b111 && plane_valid;

  logic unused;
  assign unused = &{1'b0, major_quotient, minor_depth_quotient, tri_i, settings_i};
endmodule

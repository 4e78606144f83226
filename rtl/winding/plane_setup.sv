// Plane setup: from a triangle to all that walking it needs: its plane as stored and as a ramp, its corner
// functions at the lowest vertex, and whether it has an area at all.
//
// Twins:   FacetPlane in model/unit/winding/plane.cpp, Polygon in model/unit/span_filler.cpp.
// Numbers: exact. Differences of coordinates take 29 bits, twice an area 56, squared lengths 57, gradients
//          times the area 54. A triangle whose longest edge is L and whose height over it is h has
//          |gradient| <= 2^24 / h; h > 2^(f-F-2) where the plane counts, and so it is where it is
//          replaced by the longest edge's slope. Hence a texel's step takes F + 27 bits, and a step
//          over the whole range QuotientBits. Depths are modular: DepthRange bits of them are kept.
//          f is 16 to 26, so that its uppermost bit is always set.
// Timing:  a program of sums of products (plane_program), a product's digit a cycle, and three divisions that it
//          runs beside; about 70 to 110 cycles a triangle, which then stays at the output. Products that
//          edge_setup wants are worked out between two sums, and whenever nothing else is.
`include "check.svh"
module plane_setup #(
  localparam int unsigned C     = shadow_pkg::CoordBits,
  localparam int unsigned Z     = shadow_pkg::TraceDepthBits,
  localparam int unsigned Depth = shadow_pkg::DepthRange,
  localparam int unsigned F     = shadow_pkg::FractionBits,
  localparam int unsigned D     = 57,  // denominator
  localparam int unsigned G     = 54,  // gradients times the area, signed
  localparam int unsigned K     = 42   // corner functions / 2^f, signed
) (
  input  logic                   clk_i,
  input  logic                   rst_ni,
  input  logic                   clear_i,
  input  logic [4:0]             texel_bits_i,     // f; constant, as is
  input  logic [16:0]            plane_tolerance_i,
  // triangles
  input  logic                   tri_valid_i,
  output logic                   tri_ready_o,
  /* verilator lint_off UNUSEDSIGNAL */ // the polygon's number is the paper profile's
  input  shadow_pkg::tri_t       tri_i,
  /* verilator lint_on UNUSEDSIGNAL */
  // products for edge_setup
  input  logic                   edge_valid_i,   // with its factors, until it is done
  input  logic [C:0]             edge_a_i,       // signed
  input  logic [C-1:0]           edge_b_i,       // unsigned
  output logic                   edge_done_o,    // the product is there in this cycle
  output logic [2*C-1:0]         product_o,
  output logic                   area_o,         // pulse: it has an area; vertices and edges hold from now on
  // to the walk: a triangle with an area. All that follows belongs to it and holds until it is done with
  output logic                   valid_o,
  input  logic                   ready_i,
  input  logic                   keep_i,         // this value as the start
  input  logic [Depth-1:0]       whole_i,
  input  logic [D-1:0]           rest_i,
  output logic [6*C-1:0]         vertices_o,     // x, y of vertex i at 2 i C and (2 i + 1) C
  output logic [3*C+2:0]         edge_dx_o,      // edge i to i + 1 at i (C + 1), signed
  output logic [3*C+2:0]         edge_dy_o,
  output logic [2:0]             inner_o,        // as in tri_t
  output logic [2:0]             upward_o,       // edge i to i + 1 goes up, or right where it is level
  output logic                   clockwise_o,    // negative area
  output shadow_pkg::visit_tri_t visit_tri_o,
  output logic [D-1:0]           base_o,         // of the ramp: depth plus bias, rounded up to a step
  output logic [Depth-1:0]       step_x_whole_o, // a texel's step
  output logic [D-1:0]           step_x_rest_o,
  output logic [Depth-1:0]       step_y_whole_o,
  output logic [D-1:0]           step_y_rest_o,
  output logic [Depth-1:0]       start_whole_o,  // in the texel of the lowest vertex
  output logic [D-1:0]           start_rest_o,
  output logic [3*K-1:0]         corner_start_o, // corner functions there, see corner_functions
  output logic [2:0]             corner_inexact_o,
  output logic                   caster_o,       // event: a triangle was taken
  output logic                   idle_o          // no triangle inside
);
  localparam int unsigned QuotientBits = 2 * ((F + 41) / 2) + 1;  // odd
  localparam int unsigned NumeratorBits = 83;
  // Twice an area of so many bits or more is never that of a narrow triangle.
  localparam int unsigned SmallBits = (D + 2 * (shadow_pkg::MaxFraction - F) - 3) / 2;
  // A narrow one has 16 area^2 <= length^2 r^2, r = 2^(f-F). Both sides are taken times 2^(2 Scale), and the
  // power of two on the right comes in digits of plane_sums and one factor.
  localparam int unsigned Digit      = 15;
  localparam int unsigned A          = 31;
  localparam int unsigned Scale      = F <= 3 ? (F > 1 ? F - 1 : 0) : F > 8 ? F - 8 : 0;
  localparam int unsigned RadiusLess = 2 * F + (F <= 3 ? 2 : 1) * Digit - 2 * Scale;
  localparam int unsigned SumBits    = A + Digit + 2 + 3 * Digit;

  // ---- The triangle ----
  localparam logic [2:0] Idle = 3'd0, Differences = 3'd1, Run = 3'd2, Judge = 3'd3,
                         Done = 3'd4;
  logic [2:0] state_q;
  logic [1:0] index_q;  // of the vertex whose edge is computed
  logic       is_plane_q, shares_q;
  logic [2:0] inner_q;
  logic [shadow_pkg::IdBits-1:0] object_q;
  shadow_pkg::point_t v0_q, v1_q, v2_q;
  // Edge i to i + 1. As vectors: synthesis would round an array up to four words.
  logic [3*C+2:0] edge_x_q, edge_y_q;
  logic [3*Z+2:0] edge_z_q;
  logic [C:0] ex[3], ey[3];
  logic [Z:0] ez[3];
  for (genvar i = 0; i < 3; i++) begin : g_edge
    assign ex[i] = edge_x_q[i*(C+1) +: C+1];
    assign ey[i] = edge_y_q[i*(C+1) +: C+1];
    assign ez[i] = edge_z_q[i*(Z+1) +: Z+1];
  end
  logic [C-1:0] origin_x_q, origin_y_q;
  logic [Z+2:0] origin_z_q;
  logic [C-1:0] vx[3], vy[3];
  logic [Z-1:0] vz[3];
  assign {vx[0], vy[0], vz[0]} = v0_q;
  assign {vx[1], vy[1], vz[1]} = v1_q;
  assign {vx[2], vy[2], vz[2]} = v2_q;
  logic [K-1:0] corner_q[3];
  logic [2:0]   inexact_q;
  logic [1:0] next_index;
  assign next_index = index_q == 2'd2 ? 2'd0 : index_q + 2'd1;

  logic [2:0] up, precedes;  // vertex i is before i + 1: by y, x; by x, y, z
  for (genvar i = 0; i < 3; i++) begin : g_order
    assign up[i] = ey[i] == '0 ? !ex[i][C] : !ey[i][C];
    assign precedes[i] = ex[i] != '0 ? !ex[i][C] : ey[i] != '0 ? !ey[i][C] : !ez[i][Z];
  end
  logic [1:0]   low_q;  // lowest vertex
  logic [C-1:0] low_x, low_y;
  always_ff @(posedge clk_i) low_q <= up[0] && !up[2] ? 2'd0 : up[1] && !up[0] ? 2'd1 : 2'd2;
  assign low_x = vx[low_q];
  assign low_y = vy[low_q];

  // Texel, half a texel, and what lies below a texel.
  logic [C-2:0] texel, half, below;
  assign texel = (C-1)'(1) << {1'b1, texel_bits_i[3:0]};
  assign half  = texel >> 1;
  assign below = texel - 1'b1;

  // ---- The program ----
  localparam logic [4:0] PcArea = 5'd0, PcCorner1 = 5'd4, PcStepX = 5'd5, PcCorner2 = 5'd6,
                         PcSquare = 5'd10, PcStepY = 5'd11, PcEnd = 5'd13, PcNarrow = 5'd16,
                         PcNarrowDepth = 5'd19, PcNarrowEnd = 5'd20;
  localparam logic [2:0] AEdge = 3'd0, ACorner = 3'd1, ACentre = 3'd2, ATexel = 3'd3, ARadius = 3'd4,
                         AAreaLow = 3'd5;
  localparam logic [1:0] BEdge = 2'd0, BGradient = 2'd1, BBest = 2'd2;
  localparam logic [1:0] Zz = 2'd2;
  localparam logic [3:0] ToNone = 4'd0, ToArea = 4'd1, ToCorner = 4'd2, ToGradX = 4'd3, ToGradY = 4'd4,
                         ToLength = 4'd5, ToSquare = 4'd6, ToAlong = 4'd7, ToDivider = 4'd8, ToEdge = 4'd9;
  localparam logic [1:0] DivStepX = 2'd0, DivStepY = 2'd1, DivStart = 2'd2, DivNarrow = 2'd3;
  logic [4:0] pc_q, pc_next;
  logic [1:0] term_q;
  logic [2:0] digit_q, b_digit, next_a_kind;
  logic       last_term, last_digit, minus, by_area, b_axis;
  logic [3:0] op_to;
  logic [1:0] op_index, next_a_axis, a_index, b_kind, b_index;
  logic [1:0] longest_q, longest_back;  // edge, and the one before it
  assign longest_back = longest_q == 2'd0 ? 2'd2 : longest_q - 2'd1;
  plane_program program_of (
    .pc_i(pc_q), .term_i(term_q), .digit_i(digit_q), .longest_i(longest_q), .last_term_o(last_term),
    .last_digit_o(last_digit), .minus_o(minus), .by_area_o(by_area), .to_o(op_to), .index_o(op_index),
    .a_kind_o(next_a_kind), .a_axis_o(next_a_axis), .a_index_o(a_index), .b_kind_o(b_kind), .b_axis_o(b_axis),
    .b_index_o(b_index), .b_digit_o(b_digit));

  // ---- Factors ----
  logic [G-1:0]       grad_x_q, grad_y_q;
  logic [D-1:0]       den_q, best_q;  // best_q: the longest edge's square; then where the third vertex is along it
  logic [4*Digit-1:0] area, b_long;
  logic [C:0]         a_edge, a_from, a_to, b_edge;
  logic [4:0]         power;
  logic [C:0]         difference_q;
  logic [2:0]         a_kind_q, b_digit_q;
  logic [1:0]         a_axis_q, a_index_q, b_kind_q, b_index_q;
  logic               b_axis_q, minus_q, by_area_q, first_q, move_q;
  logic               is_edge_q, edge_high_q;  // a product for edge_setup
  logic [A-1:0]       factor_a;
  logic [Digit:0]     factor_b;
  logic               edge_digit_q, edge_issue;
  assign area  = (4*Digit)'(den_q) << (2 + Scale);
  assign power = a_kind_q == ARadius ? 5'({texel_bits_i, 1'b0} - 6'(RadiusLess)) : {1'b1, texel_bits_i[3:0]};
  // Differences, and what picks the other factors, a cycle ahead.
  always_comb begin
    a_to = next_a_axis[0] ? {low_y[C-1], low_y & {1'b1, ~below}} : {low_x[C-1], low_x & {1'b1, ~below}};
    if (next_a_kind == ACentre) begin
      a_to   = a_to | {2'b0, half};
      a_from = next_a_axis[0] ? {origin_y_q[C-1], origin_y_q} : {origin_x_q[C-1], origin_x_q};
    end else begin
      a_from = next_a_axis[0] ? {vy[b_index][C-1], vy[b_index]} : {vx[b_index][C-1], vx[b_index]};
    end
  end
  always_ff @(posedge clk_i) begin
    difference_q <= a_to - a_from;
    a_kind_q     <= next_a_kind;
    a_axis_q     <= next_a_axis;
    a_index_q    <= a_index;
    b_kind_q     <= b_kind;
    b_axis_q     <= b_axis;
    b_index_q    <= b_index;
    b_digit_q    <= b_digit;
    is_edge_q    <= edge_issue;
    edge_high_q  <= edge_digit_q;
    minus_q      <= minus;
    by_area_q    <= by_area;
    first_q      <= edge_issue ? !edge_digit_q : term_q == '0 && digit_q == '0;
    move_q       <= edge_issue ? !edge_digit_q : last_term && !last_digit;
  end
  always_comb begin
    unique case (a_axis_q)
      Zz:      a_edge = {{(C-Z){ez[a_index_q][Z]}}, ez[a_index_q]};
      2'd1:    a_edge = ey[a_index_q];
      default: a_edge = ex[a_index_q];
    endcase
    unique case (a_kind_q)
      AEdge:            factor_a = A'($signed(a_edge));
      ACorner, ACentre: factor_a = A'($signed(difference_q));
      ATexel, ARadius:  factor_a = A'(1) << power;
      AAreaLow:         factor_a = {1'b0, area[A-2:0]};
      default:          factor_a = A'(area[4*Digit-1:A-1]);
    endcase
    if (is_edge_q) factor_a = A'($signed(edge_a_i));

    b_edge = b_axis_q ? ey[b_index_q] : ex[b_index_q];
    unique case (b_kind_q)
      BEdge:     b_long = (4*Digit)'($signed(b_edge));
      BGradient: b_long = (4*Digit)'($signed(b_axis_q ? grad_y_q : grad_x_q));
      BBest:     b_long = (4*Digit)'(best_q);
      default:   b_long = area;
    endcase
    unique case (b_digit_q)
      3'd0:    factor_b = {1'b0, b_long[Digit-1:0]};
      3'd1:    factor_b = {b_kind_q == BEdge && b_edge[C], b_long[Digit +: Digit]};
      3'd2:    factor_b = {1'b0, b_long[2*Digit +: Digit]};
      3'd3:    factor_b = {b_kind_q == BGradient && b_long[4*Digit-1], b_long[3*Digit +: Digit]};
      default: factor_b = '0;
    endcase
    if (is_edge_q) factor_b = edge_high_q ? (Digit+1)'(edge_b_i[C-1:Digit]) : {1'b0, edge_b_i[Digit-1:0]};
  end

  // ---- Sums: factors, sum ----
  logic               issue, flush, hold_q;  // hold_q: the sum is for the divider, which has not taken it
  logic               last_issue;            // of a sum
  logic               issue_q;
  logic [3:0]         to_next, to1_q, to2_q, to_q;
  logic [1:0]         index1_q, index2_q, op_index_q;
  logic               clockwise_q;
  logic               edge_waits_q;          // its product is on the way
  logic [SumBits-1:0] sum;
  logic [2*C+1:0]     short_sum;             // of two digits
  plane_sums #(.ABits(A), .DigitBits(Digit), .Digits(4)) sums (
    .clk_i, .valid_i(issue_q), .a_i(factor_a), .digit_i(factor_b),
    .minus_i(!is_edge_q && (minus_q ^ (by_area_q && clockwise_q))), .first_i(first_q), .move_i(move_q),
    .sum_o(sum));
  assign short_sum  = sum[2*Digit +: 2*C+2];
  assign product_o  = short_sum[2*C-1:0];
  assign last_issue = issue && last_term && last_digit;
  assign to_next    = last_issue ? op_to : edge_issue && edge_digit_q ? ToEdge : ToNone;
  always_ff @(posedge clk_i) begin
    index1_q   <= op_index;
    index2_q   <= index1_q;
    op_index_q <= index2_q;
    issue_q    <= issue || edge_issue;
  end
  assign edge_issue = edge_valid_i && !edge_waits_q
                   && (edge_digit_q || (!hold_q && (state_q != Run || (term_q == '0 && digit_q == '0))));
  assign edge_done_o = to_q == ToEdge;
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      to1_q        <= ToNone;
      to2_q        <= ToNone;
      to_q         <= ToNone;
      edge_digit_q <= 1'b0;
      edge_waits_q <= 1'b0;
    end else if (clear_i) begin
      to1_q        <= ToNone;
      to2_q        <= ToNone;
      to_q         <= ToNone;
      edge_digit_q <= 1'b0;
      edge_waits_q <= 1'b0;
    end else begin
      to1_q        <= no_area ? ToNone : to_next;
      to2_q        <= no_area ? ToNone : to1_q;
      to_q         <= no_area ? ToNone : to2_q;
      edge_digit_q <= edge_issue && !edge_digit_q;
      edge_waits_q <= (edge_issue && edge_digit_q) || (edge_waits_q && !edge_done_o);
    end
  end

  logic no_area;
  assign no_area = to_q == ToArea && short_sum == '0 && !is_plane_q;

  // ---- Divisions ----
  logic                    div_valid, div_ready, div_done, div_take, div_clear;
  /* verilator lint_off UNUSEDSIGNAL */ // depths are modular: what is above is cut off
  logic [QuotientBits-1:0] quotient;
  /* verilator lint_on UNUSEDSIGNAL */
  logic [D-1:0]            remainder;
  logic [1:0]              division_q;
  logic                    encoder_ready, encoder_done;
  divider #(.NumeratorBits(NumeratorBits), .DivisorBits(D), .QuotientBits(QuotientBits), .SkipBits(8)) division (
    .clk_i, .rst_ni, .clear_i(clear_i || div_clear),
    .valid_i(div_valid), .ready_o(div_ready), .numerator_i(sum[NumeratorBits-1:0]), .divisor_i(den_q),
    .valid_o(div_done), .ready_i(div_take), .quotient_o(quotient), .remainder_o(remainder));
  logic       waiting_q;  // the sum for the divider is complete
  logic [1:0] waits_for, waits_for_q;
  assign div_valid = (to_q == ToDivider || waiting_q) && !flush;
  always_comb begin
    unique case (division_q)
      DivStepX, DivStepY: div_take = encoder_ready;
      DivStart:           div_take = encoder_done && state_q == Run;
      default:            div_take = 1'b1;
    endcase
  end
  always_ff @(posedge clk_i) begin
    waits_for_q <= waits_for;
    if (div_valid && div_ready) division_q <= waits_for;
  end
  assign waits_for = to_q == ToDivider ? op_index_q : waits_for_q;

  // ---- Is it narrow? ----
  logic       narrow, tiny, narrow_q, start_narrow;
  logic [1:0] rank, best_rank_q;  // of equally long edges: the least
  logic [2:0] opposite_last, opposite_first;
  for (genvar i = 0; i < 3; i++) begin : g_rank
    assign opposite_last[i]  = precedes[(i+1)%3] && !precedes[(i+2)%3];
    assign opposite_first[i] = !precedes[(i+1)%3] && precedes[(i+2)%3];
  end
  assign rank = opposite_last[op_index_q] ? 2'd0 : opposite_first[op_index_q] ? 2'd1 : 2'd2;
  logic longer;
  assign longer = op_index_q == 2'd0 || short_sum[D-1:0] > best_q || (short_sum[D-1:0] == best_q && rank < best_rank_q);
  assign narrow = !sum[SumBits-1];
  assign tiny   = best_q <= D'(1) << (6'(texel_bits_i - 5'(F + 2)) << 1);
  assign start_narrow = to_q == ToSquare && narrow;
  logic small_area;
  assign small_area = den_q[D-1:SmallBits] == '0;

  // ---- Control ----
  logic wait_here, last_of_plane;
  logic [Z-1:0] highest_01, highest;
  assign highest_01 = vz[0] > vz[1] ? vz[0] : vz[1];
  assign highest    = highest_01 > vz[2] ? highest_01 : vz[2];
  assign last_of_plane = is_plane_q && pc_q == PcCorner1;
  always_comb begin
    pc_next = pc_q + 5'd1;
    if (pc_q == PcArea + 5'd1 && shares_q && !is_plane_q) pc_next = PcCorner1;
    if (pc_q == PcStepX && narrow_q) pc_next = PcStepY;
    if (pc_q == PcCorner2 && (shares_q || !small_area)) pc_next = PcStepY;
  end
  // Sums that a product's factor needs, or that must stay, are waited for.
  logic in_flight;
  assign in_flight = to1_q != ToNone || to2_q != ToNone || to_q != ToNone;
  always_comb begin
    unique case (pc_q)
      PcEnd, PcNarrowEnd: wait_here = 1'b1;
      PcNarrowDepth:      wait_here = in_flight;
      default:            wait_here = hold_q || last_of_plane;
    endcase
  end
  assign issue = state_q == Run && !wait_here && !flush && !edge_issue;
  assign flush = no_area || start_narrow;
  assign div_clear = flush;

  logic [Depth-1:0] bias, offset;  // offset: origin's depth, and what rounds up to a step
  logic         finish_start, finish_narrow;
  logic         third_due_q;  // the third vertex's depth, carried to the edge beside it, is there
  logic [Z+2:0] third_z_q;
  assign finish_start  = div_done && div_take && division_q == DivStart;
  assign finish_narrow = div_done && division_q == DivNarrow;
  assign tri_ready_o = state_q == Idle;
  assign valid_o     = state_q == Done;
  assign idle_o      = state_q == Idle;
  assign area_o      = to_q == ToArea && !is_plane_q && !no_area;
  assign caster_o    = tri_valid_i && tri_ready_o && !tri_i.is_plane;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      state_q   <= Idle;
      hold_q    <= 1'b0;
      waiting_q <= 1'b0;
    end else if (clear_i) begin
      state_q   <= Idle;
      hold_q    <= 1'b0;
      waiting_q <= 1'b0;
    end else begin
      unique case (state_q)
        Idle: if (tri_valid_i) state_q <= Differences;
        Differences: if (index_q == 2'd2) state_q <= Run;
        Run: begin
          if (no_area || (last_of_plane && !in_flight)) state_q <= Idle;
          else if (last_issue && pc_q == PcSquare) state_q <= Judge;
          else if (finish_start) state_q <= Done;
        end
        Judge: if (to_q == ToSquare) state_q <= Run;
        default: if (ready_i) state_q <= Idle;
      endcase
      if (flush) hold_q <= 1'b0;
      else if (last_issue && op_to == ToDivider) hold_q <= 1'b1;
      else if (div_valid && div_ready) hold_q <= 1'b0;
      waiting_q <= div_valid && !div_ready && !flush;
      `CHECK(divisor_stays, to_q != ToArea || div_ready)
    end
  end
  always_ff @(posedge clk_i) begin
    unique case (state_q)
      Idle: if (tri_valid_i) begin
        is_plane_q <= tri_i.is_plane;
        shares_q   <= tri_i.shares;
        inner_q    <= tri_i.inner;
        object_q   <= tri_i.object[shadow_pkg::IdBits-1:0];
        v0_q       <= tri_i.v0;
        v1_q       <= tri_i.v1;
        v2_q       <= tri_i.v2;
        index_q    <= 2'd0;
      end
      Differences: begin
        index_q       <= next_index;
        for (int i = 0; i < 3; i++) begin
          if (index_q == 2'(i)) begin
            edge_x_q[i*(C+1) +: C+1] <= {vx[next_index][C-1], vx[next_index]} - {vx[index_q][C-1], vx[index_q]};
            edge_y_q[i*(C+1) +: C+1] <= {vy[next_index][C-1], vy[next_index]} - {vy[index_q][C-1], vy[index_q]};
            edge_z_q[i*(Z+1) +: Z+1] <= {1'b0, vz[next_index]} - {1'b0, vz[index_q]};
          end
        end
        pc_q          <= '0;
        narrow_q      <= 1'b0;
        term_q        <= '0;
        digit_q       <= '0;
        if (is_plane_q || !shares_q) begin
          origin_x_q <= vx[0];
          origin_y_q <= vy[0];
          origin_z_q <= {3'b0, vz[0]};
        end
      end
      Run: begin
        if (issue) begin
          term_q <= last_term ? '0 : term_q + 1'b1;
          if (last_term) digit_q <= last_digit ? '0 : digit_q + 1'b1;
          if (last_issue) pc_q <= pc_next;
        end
        if (finish_narrow) pc_q <= PcStepX;
        // As far as the third vertex, if that lies beyond the edge beside it.
        if (third_due_q && $signed(third_z_q) > $signed(origin_z_q)) origin_z_q <= third_z_q;
      end
      Judge: if (start_narrow) begin
        narrow_q <= 1'b1;
        pc_q     <= tiny ? PcStepX : PcNarrow;
        if (tiny) begin
          origin_z_q <= {3'b0, highest};
        end else begin
          den_q      <= best_q;
          origin_x_q <= vx[longest_q];
          origin_y_q <= vy[longest_q];
          origin_z_q <= {3'b0, vz[longest_q]};
        end
      end
      default: ;
    endcase

    third_z_q   <= {3'b0, vz[longest_back]} - quotient[Z+2:0];
    third_due_q <= finish_narrow;
    unique case (to_q)
      ToArea: begin
        clockwise_q <= short_sum[D];
        if (is_plane_q || !shares_q) begin
          den_q <= (short_sum[D-1:0] ^ {D{short_sum[D]}}) + D'(short_sum[D]);
        end
      end
      ToGradX: grad_x_q <= short_sum[G-1:0];
      ToGradY: grad_y_q <= short_sum[G-1:0];
      ToCorner: begin
        corner_q[op_index_q]  <= K'($signed(short_sum[2*C+1:16]) >>> texel_bits_i[3:0]);
        inexact_q[op_index_q] <= (short_sum[C-2:0] & below) != '0;
      end
      ToLength: if (longer) begin
        best_q      <= short_sum[D-1:0];
        best_rank_q <= rank;
        longest_q   <= op_index_q;
      end
      ToAlong: best_q <= short_sum[D-1:0];
      default: ;
    endcase
    if (start_narrow && tiny) begin
      grad_x_q <= '0;
      grad_y_q <= '0;
    end

    if (keep_i) begin
      start_whole_o <= whole_i;
      start_rest_o  <= rest_i;
    end else if (div_done && div_take) begin
      unique case (division_q)
        DivStepX: begin
          step_x_whole_o <= quotient[Depth-1:0];
          step_x_rest_o  <= remainder;
        end
        DivStepY: begin
          step_y_whole_o <= quotient[Depth-1:0];
          step_y_rest_o  <= remainder;
        end
        DivStart: begin
          start_whole_o <= quotient[Depth-1:0] + bias;
          start_rest_o  <= remainder;
        end
        default: ;
      endcase
    end
  end

  // ---- What is stored ----
  shadow_pkg::visit_tri_t visit_tri;
  gradient_encoder encoder (
    .clk_i, .rst_ni, .clear_i(clear_i || flush || state_q == Differences),
    .valid_i(div_done && (division_q == DivStepX || division_q == DivStepY)), .ready_o(encoder_ready),
    .gradient_i(quotient[F+27:0]), .offset_i(offset), .code_x_o(visit_tri.gradient_x), .code_y_o(visit_tri.gradient_y),
    .done_o(encoder_done), .bias_o(bias));
  assign offset = Depth'(origin_z_q) + (shares_q ? Depth'(plane_tolerance_i) : '0)
                + Depth'((1 << shadow_pkg::PlaneStepBits) - 1);
  assign visit_tri.object = object_q;
  assign visit_tri_o      = visit_tri;
  assign base_o           = den_q;
  assign vertices_o       = {vy[2], vx[2], vy[1], vx[1], vy[0], vx[0]};
  assign edge_dx_o        = edge_x_q;
  assign edge_dy_o        = edge_y_q;
  assign inner_o          = inner_q;
  assign upward_o         = up;
  assign clockwise_o      = clockwise_q;
  assign corner_start_o   = {corner_q[2], corner_q[1], corner_q[0]};
  assign corner_inexact_o = inexact_q;
endmodule

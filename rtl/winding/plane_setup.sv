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
  input  shadow_pkg::tri_t       tri_i,
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
  localparam int unsigned Digit      = 15;
  localparam int unsigned A          = 31;
  localparam int unsigned SumBits    = A + Digit + 2 + 3 * Digit;

  // ---- The triangle ----
  localparam logic [2:0] Idle = 3'd0, Differences = 3'd1, Run = 3'd2, Judge = 3'd3,
                         Done = 3'd4;
  logic [2:0] state_q;
  logic         last_difference, is_plane, shares;
  logic [shadow_pkg::IdBits-1:0] object;
  logic [3*Z-1:0] depths;
  logic [3*Z+2:0] edge_z;
  logic [2:0]   precedes;  // vertex i is before i + 1 by x, y, z
  logic [C-1:0] low_x, low_y, origin_x, origin_y;
  logic [Z+2:0] origin_z;
  plane_triangle triangle (
    .clk_i, .take_i(tri_valid_i && tri_ready_o), .tri_i, .differences_i(state_q == Differences),
    .last_o(last_difference), .is_plane_o(is_plane), .shares_o(shares), .inner_o, .object_o(object),
    .vertices_o, .depths_o(depths), .edge_x_o(edge_dx_o), .edge_y_o(edge_dy_o), .edge_z_o(edge_z),
    .up_o(upward_o), .precedes_o(precedes), .low_x_o(low_x), .low_y_o(low_y));
  logic [K-1:0] corner_q[3];
  logic [2:0]   inexact_q;

  logic [C-2:0] texel, below;  // a texel, and what lies below
  assign texel = (C-1)'(1) << {1'b1, texel_bits_i[3:0]};
  assign below = texel - 1'b1;

  // ---- The program ----
  localparam logic [4:0] PcArea = 5'd0, PcCorner1 = 5'd4, PcStepX = 5'd5, PcCorner2 = 5'd6,
                         PcSquare = 5'd10, PcStepY = 5'd11, PcEnd = 5'd13, PcNarrow = 5'd16,
                         PcNarrowDepth = 5'd19, PcNarrowEnd = 5'd20;
  localparam logic [3:0] ToArea = 4'd1, ToCorner = 4'd2, ToGradX = 4'd3, ToGradY = 4'd4,
                         ToLength = 4'd5, ToSquare = 4'd6, ToAlong = 4'd7, ToDivider = 4'd8;
  logic [4:0] pc_q, pc_next;
  logic [1:0] term_q;
  logic [2:0] digit_q, b_digit, a_kind;
  logic       last_term, last_digit, minus, by_area, b_axis;
  logic [3:0] op_to;
  logic [1:0] op_index, a_axis, a_index, b_kind, b_index;
  logic [1:0] longest;  // edge
  plane_program program_of (
    .pc_i(pc_q), .term_i(term_q), .digit_i(digit_q), .longest_i(longest), .last_term_o(last_term),
    .last_digit_o(last_digit), .minus_o(minus), .by_area_o(by_area), .to_o(op_to), .index_o(op_index),
    .a_kind_o(a_kind), .a_axis_o(a_axis), .a_index_o(a_index), .b_kind_o(b_kind), .b_axis_o(b_axis),
    .b_index_o(b_index), .b_digit_o(b_digit));

  // ---- Factors ----
  logic [G-1:0]       grad_x_q, grad_y_q;
  logic [D-1:0]       den_q, best;  // best: the longest edge's square; then where the third vertex is along it
  logic               clockwise_q;
  logic               issue, flush, hold_q;  // hold_q: the sum is for the divider, which has not taken it
  logic               edge_digit, edge_issue;  // a product for edge_setup: which digit
  logic               sum_valid, sum_minus, sum_first, sum_move;
  logic [A-1:0]       factor_a;
  logic [Digit:0]     factor_b;
  plane_factors factors (
    .clk_i, .texel_bits_i, .vertices_i(vertices_o), .low_x_i(low_x), .low_y_i(low_y), .edge_x_i(edge_dx_o),
    .edge_y_i(edge_dy_o), .edge_z_i(edge_z), .origin_x_i(origin_x), .origin_y_i(origin_y),
    .grad_x_i(grad_x_q), .grad_y_i(grad_y_q), .den_i(den_q), .best_i(best), .clockwise_i(clockwise_q),
    .valid_i(issue || edge_issue), .a_kind_i(a_kind), .a_axis_i(a_axis), .a_index_i(a_index),
    .b_kind_i(b_kind), .b_axis_i(b_axis), .b_index_i(b_index), .b_digit_i(b_digit), .minus_i(minus),
    .by_area_i(by_area), .first_i(edge_issue ? !edge_digit : term_q == '0 && digit_q == '0),
    .move_i(edge_issue ? !edge_digit : last_term && !last_digit), .edge_i(edge_issue),
    .edge_high_i(edge_digit), .edge_a_i, .edge_b_i, .valid_o(sum_valid), .a_o(factor_a), .digit_o(factor_b),
    .minus_o(sum_minus), .first_o(sum_first), .move_o(sum_move));

  // ---- Sums: factors, sum ----
  logic               last_issue, in_flight;  // of a sum; sums are on their way
  logic [3:0]         to;
  logic [1:0]         sum_index;
  logic [SumBits-1:0] sum;
  logic [2*C+1:0]     short_sum;             // of two digits
  plane_sums #(.ABits(A), .DigitBits(Digit), .Digits(4)) sums (
    .clk_i, .valid_i(sum_valid), .a_i(factor_a), .digit_i(factor_b), .minus_i(sum_minus), .first_i(sum_first),
    .move_i(sum_move), .sum_o(sum));
  assign short_sum  = sum[2*Digit +: 2*C+2];
  assign product_o  = short_sum[2*C-1:0];
  assign last_issue = issue && last_term && last_digit;
  plane_stages stages (
    .clk_i, .rst_ni, .clear_i, .flush_i(no_area), .issue_i(last_issue), .to_i(op_to), .index_i(op_index), .to_o(to),
    .index_o(sum_index), .in_flight_o(in_flight), .edge_valid_i,
    .edge_may_i(!hold_q && (state_q != Run || (term_q == '0 && digit_q == '0))),
    .edge_issue_o(edge_issue), .edge_digit_o(edge_digit), .edge_done_o);

  logic no_area;
  assign no_area = to == ToArea && short_sum == '0 && !is_plane;

  // ---- Divisions ----
  logic                    div_taken, div_ready, gradient_valid, encoder_ready, encoder_done, finish_start, finish_narrow;
  logic [Depth-1:0]        bias, offset;  // offset: origin's depth, and what rounds up to a step
  /* verilator lint_off UNUSEDSIGNAL */ // depths are modular: what is above is cut off
  logic [QuotientBits-1:0] quotient;
  /* verilator lint_on UNUSEDSIGNAL */
  plane_quotients #(.NumeratorBits(NumeratorBits), .QuotientBits(QuotientBits)) quotients (
    .clk_i, .rst_ni, .clear_i, .flush_i(flush), .valid_i(to == ToDivider), .taken_o(div_taken), .ready_o(div_ready),
    .division_i(sum_index), .numerator_i(sum[NumeratorBits-1:0]), .divisor_i(den_q),
    .gradient_valid_o(gradient_valid), .encoder_ready_i(encoder_ready), .quotient_o(quotient),
    .bias_ready_i(encoder_done && state_q == Run), .bias_i(bias), .start_done_o(finish_start),
    .narrow_done_o(finish_narrow), .keep_i, .whole_i, .rest_i, .step_x_whole_o, .step_x_rest_o, .step_y_whole_o,
    .step_y_rest_o, .start_whole_o, .start_rest_o);

  // ---- Is it narrow? ----
  logic narrow, tiny, narrow_q, start_narrow;
  logic third_due_q;  // the third vertex's depth, carried to the edge beside it, is there
  plane_longest longest_edge (
    .clk_i, .vertices_i(vertices_o), .depths_i(depths), .precedes_i(precedes), .length_i(to == ToLength),
    .index_i(sum_index), .sum_i(short_sum[D-1:0]), .along_i(to == ToAlong), .longest_o(longest), .best_o(best),
    .first_i(state_q == Differences && (is_plane || !shares)), .flat_i(state_q == Judge && start_narrow && tiny),
    .edge_i(state_q == Judge && start_narrow), .third_due_i(state_q == Run && third_due_q), .carry_i(quotient[Z+2:0]),
    .origin_x_o(origin_x), .origin_y_o(origin_y), .origin_z_o(origin_z));
  assign narrow = !sum[SumBits-1];
  assign tiny   = best <= D'(1) << (6'(texel_bits_i - 5'(F + 2)) << 1);
  assign start_narrow = to == ToSquare && narrow;
  logic small_area;
  assign small_area = den_q[D-1:SmallBits] == '0;

  // ---- Control ----
  logic wait_here, last_of_plane;
  assign last_of_plane = is_plane && pc_q == PcCorner1;
  always_comb begin
    pc_next = pc_q + 5'd1;
    if (pc_q == PcArea + 5'd1 && shares && !is_plane) pc_next = PcCorner1;
    if (pc_q == PcStepX && narrow_q) pc_next = PcStepY;
    if (pc_q == PcCorner2 && (shares || !small_area)) pc_next = PcStepY;
  end
  // Sums that a product's factor needs, or that must stay, are waited for.
  always_comb begin
    unique case (pc_q)
      PcEnd, PcNarrowEnd: wait_here = 1'b1;
      PcNarrowDepth:      wait_here = in_flight;
      default:            wait_here = hold_q || last_of_plane;
    endcase
  end
  assign issue = state_q == Run && !wait_here && !flush && !edge_issue;
  assign flush = no_area || start_narrow;

  assign tri_ready_o = state_q == Idle;
  assign valid_o     = state_q == Done;
  assign idle_o      = state_q == Idle;
  assign area_o      = to == ToArea && !is_plane && !no_area;
  assign caster_o    = tri_valid_i && tri_ready_o && !tri_i.is_plane;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      state_q <= Idle;
      hold_q  <= 1'b0;
    end else if (clear_i) begin
      state_q <= Idle;
      hold_q  <= 1'b0;
    end else begin
      unique case (state_q)
        Idle: if (tri_valid_i) state_q <= Differences;
        Differences: if (last_difference) state_q <= Run;
        Run: begin
          if (no_area || (last_of_plane && !in_flight)) state_q <= Idle;
          else if (last_issue && pc_q == PcSquare) state_q <= Judge;
          else if (finish_start) state_q <= Done;
        end
        Judge: if (to == ToSquare) state_q <= Run;
        default: if (ready_i) state_q <= Idle;
      endcase
      if (flush) hold_q <= 1'b0;
      else if (last_issue && op_to == ToDivider) hold_q <= 1'b1;
      else if (div_taken) hold_q <= 1'b0;
      `CHECK(divisor_stays, to != ToArea || div_ready)
    end
  end
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      {pc_q, narrow_q, term_q, digit_q} <= '0;
    end else begin
      unique case (state_q)
        Differences: {pc_q, narrow_q, term_q, digit_q} <= '0;
        Run: begin
          if (issue) begin
            term_q <= last_term ? '0 : term_q + 1'b1;
            if (last_term) digit_q <= last_digit ? '0 : digit_q + 1'b1;
            if (last_issue) pc_q <= pc_next;
          end
          if (finish_narrow) pc_q <= PcStepX;
        end
        Judge: if (start_narrow) begin
          narrow_q <= 1'b1;
          pc_q     <= tiny ? PcStepX : PcNarrow;
        end
        default: ;
      endcase
    end
  end
  always_ff @(posedge clk_i) begin
    if (state_q == Judge && start_narrow && !tiny) den_q <= best;
    third_due_q <= finish_narrow;
    unique case (to)
      ToArea: begin
        clockwise_q <= short_sum[D];
        if (is_plane || !shares) begin
          den_q <= (short_sum[D-1:0] ^ {D{short_sum[D]}}) + D'(short_sum[D]);
        end
      end
      ToGradX: grad_x_q <= short_sum[G-1:0];
      ToGradY: grad_y_q <= short_sum[G-1:0];
      ToCorner: begin
        corner_q[sum_index]  <= K'($signed(short_sum[2*C+1:16]) >>> texel_bits_i[3:0]);
        inexact_q[sum_index] <= (short_sum[C-2:0] & below) != '0;
      end
      default: ;
    endcase
    if (start_narrow && tiny) begin
      grad_x_q <= '0;
      grad_y_q <= '0;
    end
  end

  // ---- What is stored ----
  shadow_pkg::visit_tri_t visit_tri;
  gradient_encoder encoder (
    .clk_i, .rst_ni, .clear_i(clear_i || flush || state_q == Differences),
    .valid_i(gradient_valid), .ready_o(encoder_ready),
    .gradient_i(quotient[F+27:0]), .offset_i(offset), .code_x_o(visit_tri.gradient_x), .code_y_o(visit_tri.gradient_y),
    .done_o(encoder_done), .bias_o(bias));
  assign offset = Depth'(origin_z) + (shares ? Depth'(plane_tolerance_i) : '0)
                + Depth'((1 << shadow_pkg::PlaneStepBits) - 1);
  assign visit_tri.object = object;
  assign visit_tri_o      = visit_tri;
  assign base_o           = den_q;
  assign clockwise_o      = clockwise_q;
  assign corner_start_o   = {corner_q[2], corner_q[1], corner_q[0]};
  assign corner_inexact_o = inexact_q;
endmodule

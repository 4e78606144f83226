// Plane setup: from a triangle to all that walking it needs: its plane as stored and as a ramp, its corner
// functions at the lowest vertex, and whether it has an area at all.
//
// Twins:   FacetPlane in model/unit/winding/plane.cpp, Polygon in model/unit/span_filler.cpp.
// Numbers: exact. Differences of coordinates take 29 bits, twice an area 56, squared lengths 57, gradients
//          times the area 54. A triangle whose longest edge is L and whose height over it is h has
//          |gradient| <= 2^24 / h; h > 2^(f-F-2) where the plane counts, and so it is where it is
//          replaced by the longest edge's slope. Hence a texel's step takes F + 27 bits, and a step
//          over the whole range QuotientBits. Depths are modular: DepthRange bits of them are kept.
// Timing:  a program of products, one a cycle, on the front's multiplier, and three divisions that it runs
//          beside; about 45 to 80 cycles a triangle, which then waits at the output.
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
  // the front's multiplier: a product's factors, and whether they are taken; the product two cycles later
  input  logic                   factors_ready_i,
  output logic [C+1:0]           factor_a_o,     // signed
  output logic [C:0]             factor_b_o,     // signed
  input  logic [2*C+2:0]         product_i,
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
  localparam int unsigned AccBits   = 2 * SmallBits > NumeratorBits ? 2 * SmallBits : NumeratorBits;

  // ---- The triangle ----
  localparam logic [2:0] Idle = 3'd0, Differences = 3'd1, Run = 3'd2, Compare = 3'd3, Judge = 3'd4,
                         Done = 3'd5;
  logic [2:0] state_q;
  logic [1:0] index_q;  // of the vertex whose edge is computed
  logic       is_plane_q, shares_q;
  logic [2:0] inner_q;
  logic [shadow_pkg::IdBits-1:0] object_q;
  shadow_pkg::point_t v0_q, v1_q, v2_q;
  logic [C:0] ex_q[3], ey_q[3];  // edge i to i + 1
  logic [Z:0] ez_q[3];
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
    assign up[i] = ey_q[i] == '0 ? !ex_q[i][C] : !ey_q[i][C];
    assign precedes[i] = ex_q[i] != '0 ? !ex_q[i][C] : ey_q[i] != '0 ? !ey_q[i][C] : !ez_q[i][Z];
  end
  logic [C-1:0] low_x, low_y;  // lowest vertex
  assign low_x = up[0] && !up[2] ? vx[0] : up[1] && !up[0] ? vx[1] : vx[2];
  assign low_y = up[0] && !up[2] ? vy[0] : up[1] && !up[0] ? vy[1] : vy[2];

  // Texel, half a texel, and what lies below a texel.
  logic [C-2:0] texel, half, below;
  assign texel = (C-1)'(1) << texel_bits_i;
  assign half  = texel >> 1;
  assign below = texel - 1'b1;

  // ---- The program ----
  localparam logic [5:0] PcGradients = 6'd4, PcCorner1 = 6'd8, PcStepX = 6'd10,
                         PcLengths = 6'd14, PcSquare = 6'd20, PcStepY = 6'd23, PcEnd = 6'd29, PcNarrow = 6'd32, PcAlong = 6'd36,
                         PcNarrowEnd = 6'd38;
  localparam logic [2:0] AEdge = 3'd0, AGradLow = 3'd1, AGradHigh = 3'd2, ADenLow = 3'd3, ADenHigh = 3'd4,
                         ABestLow = 3'd5, ABestHigh = 3'd6;
  localparam logic [2:0] BEdge = 3'd0, BCorner = 3'd1, BCentre = 3'd2, BTexel = 3'd3, BDenLow = 3'd4,
                         BDenHigh = 3'd5;
  localparam logic [1:0] X = 2'd0, Y = 2'd1, Zz = 2'd2;
  localparam logic [3:0] ToNone = 4'd0, ToArea = 4'd1, ToCorner = 4'd2, ToGradX = 4'd3, ToGradY = 4'd4,
                         ToLength = 4'd5, ToSquare = 4'd6, ToAlong = 4'd7, ToDivider = 4'd8;
  localparam logic [1:0] DivStepX = 2'd0, DivStepY = 2'd1, DivStart = 2'd2, DivNarrow = 2'd3;
  typedef struct packed {
    logic       first;   // of a sum of products
    logic       minus;
    logic       signed_by_area;
    logic [1:0] shift;   // by 0, C, C + 1 or 2 C
    logic [3:0] to;      // where the sum goes, after its last product
    logic [1:0] index;   // corner, length; division
  } op_t;

  logic [5:0] pc_q, pc_next;
  op_t        op;
  logic [2:0] a_kind, b_kind;
  logic [1:0] a_index, a_axis, b_index, b_axis;
  logic [1:0] longest_q, longest_back;  // edge, and the one before it
  assign longest_back = longest_q == 2'd0 ? 2'd2 : longest_q - 2'd1;

  always_comb begin
    op      = '0;
    a_kind  = AEdge;
    b_kind  = BEdge;
    a_index = 2'd0;
    b_index = 2'd0;
    a_axis  = X;
    b_axis  = Y;
    unique case (pc_q)
      6'd8, 6'd9, 6'd16, 6'd17, 6'd23, 6'd24: op.index = 2'd1;
      6'd12, 6'd13, 6'd18, 6'd19, 6'd25, 6'd26, 6'd27, 6'd28: op.index = 2'd2;
      6'd36, 6'd37: op.index = DivNarrow;
      default: op.index = 2'd0;
    endcase
    op.first = !pc_q[0];
    op.minus = pc_q[0];
    unique case (pc_q)
      // twice the area
      6'd0: begin a_index = 2'd2; end
      6'd1: begin b_index = 2'd2; op.to = ToArea; end
      // gradients times it
      6'd4: begin a_index = 2'd2; a_axis = Zz; end
      6'd5: begin a_axis = Zz; b_index = 2'd2; op.to = ToGradX; end
      6'd6: begin a_index = 2'd2; b_axis = Zz; end
      6'd7: begin b_index = 2'd2; b_axis = Zz; op.to = ToGradY; end
      // corner functions
      6'd2, 6'd8, 6'd12: begin a_index = op.index; b_kind = BCorner; end
      6'd3, 6'd9, 6'd13: begin a_index = op.index; a_axis = Y; b_kind = BCorner; b_axis = X; op.to = ToCorner; end
      // steps for a texel
      6'd10: begin a_kind = AGradLow; b_kind = BTexel; end
      6'd11: begin a_kind = AGradHigh; b_kind = BTexel; op.minus = 1'b0; op.shift = 2'd1; op.to = ToDivider; end
      6'd23: begin a_kind = AGradLow; a_axis = Y; b_kind = BTexel; op.first = 1'b1; op.minus = 1'b0; end
      6'd24: begin a_kind = AGradHigh; a_axis = Y; b_kind = BTexel; op.first = 1'b0; op.shift = 2'd1;
                   op.to = ToDivider; end
      // squared lengths
      6'd14, 6'd16, 6'd18: begin a_index = op.index; b_index = op.index; b_axis = X; end
      6'd15, 6'd17, 6'd19: begin a_index = op.index; b_index = op.index; a_axis = Y; op.minus = 1'b0;
                                 op.to = ToLength; end
      // the area squared
      6'd20: begin a_kind = ADenLow; b_kind = BDenLow; end
      6'd21: begin a_kind = ADenLow; b_kind = BDenHigh; op.minus = 1'b0; op.shift = 2'd2; end
      6'd22: begin a_kind = ADenHigh; b_kind = BDenHigh; op.first = 1'b0; op.shift = 2'd3; op.to = ToSquare; end
      // start
      6'd25: begin a_kind = AGradLow; b_kind = BCentre; b_axis = X; op.first = 1'b1; op.minus = 1'b0; end
      6'd26: begin a_kind = AGradHigh; b_kind = BCentre; b_axis = X; op.first = 1'b0; op.shift = 2'd1; end
      6'd27: begin a_kind = AGradLow; a_axis = Y; b_kind = BCentre; op.minus = 1'b0; end
      6'd28: begin a_kind = AGradHigh; a_axis = Y; b_kind = BCentre; op.first = 1'b0; op.shift = 2'd1;
                   op.to = ToDivider; end
      // the plane along the longest edge
      6'd32: begin a_index = longest_q; b_index = longest_q; a_axis = Zz; b_axis = X; op.to = ToGradX; end
      6'd33: begin a_index = longest_q; b_index = longest_q; a_axis = Zz; op.first = 1'b1; op.minus = 1'b0;
                   op.to = ToGradY; end
      6'd34: begin a_index = longest_q; b_index = longest_back; b_axis = X; op.minus = 1'b1; end
      6'd35: begin a_index = longest_q; b_index = longest_back; a_axis = Y; op.to = ToAlong; end
      6'd36: begin a_kind = ABestLow; b_index = longest_q; b_axis = Zz; end
      6'd37: begin a_kind = ABestHigh; b_index = longest_q; b_axis = Zz; op.minus = 1'b0; op.shift = 2'd1;
                   op.to = ToDivider; end
      default: ;
    endcase
    op.signed_by_area = pc_q[5:2] == PcGradients[5:2];
  end

  // ---- Factors ----
  logic [G-1:0] grad_x_q, grad_y_q, grad;
  logic [D-1:0] den_q, best_q;  // best_q: the longest edge's square; then where the third vertex is along it
  logic [C:0]   a_edge, b_edge, b_from, b_to;
  assign grad = a_axis == Y ? grad_y_q : grad_x_q;
  always_comb begin
    unique case (a_axis)
      X: a_edge = ex_q[a_index];
      Y: a_edge = ey_q[a_index];
      default: a_edge = {{(C-Z){ez_q[a_index][Z]}}, ez_q[a_index]};
    endcase
    unique case (b_axis)
      X: b_edge = ex_q[b_index];
      Y: b_edge = ey_q[b_index];
      default: b_edge = {{(C-Z){ez_q[b_index][Z]}}, ez_q[b_index]};
    endcase
    b_to = b_axis == Y ? {low_y[C-1], low_y & {1'b1, ~below}} : {low_x[C-1], low_x & {1'b1, ~below}};
    if (b_kind == BCentre) begin
      b_to   = b_to | {2'b0, half};
      b_from = b_axis == Y ? {origin_y_q[C-1], origin_y_q} : {origin_x_q[C-1], origin_x_q};
    end else begin
      b_from = b_axis == Y ? {vy[op.index][C-1], vy[op.index]} : {vx[op.index][C-1], vx[op.index]};
    end
    unique case (a_kind)
      AEdge:     factor_a_o = {a_edge[C], a_edge};
      AGradLow:  factor_a_o = {2'b0, grad[C-1:0]};
      AGradHigh: factor_a_o = {{(2*C+2-G){grad[G-1]}}, grad[G-1:C]};
      ADenLow:   factor_a_o = {2'b0, den_q[C-1:0]};
      ADenHigh:  factor_a_o = {1'b0, den_q[D-1:C]};
      ABestLow:  factor_a_o = {2'b0, best_q[C-1:0]};
      default:   factor_a_o = {1'b0, best_q[D-1:C]};
    endcase
    unique case (b_kind)
      BEdge:   factor_b_o = b_edge;
      BTexel:  factor_b_o = {2'b0, texel};
      BDenLow: factor_b_o = {1'b0, den_q[C-1:0]};
      BDenHigh: factor_b_o = {1'b0, den_q[D-2:C]};
      default: factor_b_o = b_to - b_from;
    endcase
  end

  // ---- Sums of products: factors, product, sum ----
  logic               issue, flush, hold_q;  // hold_q: the sum is for the divider, which has not taken it
  logic [2:0]         valid_q;               // an operation is in stage 1, 2, 3
  op_t                op1_q, op2_q;
  logic [3:0]         to_q;     // of the third stage
  logic [1:0]         op_index_q;
  logic               clockwise_q;
  logic [AccBits-1:0] acc_q, addend, sum;
  logic               subtract, shift_acc;
  assign subtract = op2_q.minus ^ (op2_q.signed_by_area && clockwise_q);
  always_comb begin
    addend = AccBits'($signed(product_i));
    unique case (op2_q.shift)
      2'd0: ;
      2'd1: addend = addend << C;
      2'd2: addend = addend << (C + 1);
      default: addend = addend << (2 * C);
    endcase
  end
  assign sum = (op2_q.first ? '0 : acc_q) + (addend ^ {AccBits{subtract}}) + AccBits'(subtract);
  always_ff @(posedge clk_i) begin
    if (valid_q[1]) acc_q <= sum;
    else if (shift_acc) acc_q <= {2'b0, acc_q[AccBits-1:2]};
    op1_q <= op;
    op2_q <= op1_q;
    to_q       <= op2_q.to;
    op_index_q <= op2_q.index;
  end
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) valid_q <= '0;
    else if (clear_i || flush) valid_q <= '0;
    else valid_q <= {valid_q[1:0], issue};
  end

  logic       arrives;  // a sum is complete
  logic [3:0] to;
  logic       no_area;
  assign arrives = valid_q[2] && to_q != ToNone;
  assign to      = arrives ? to_q : ToNone;
  assign no_area = to == ToArea && acc_q[D:0] == '0 && !is_plane_q;

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
    .valid_i(div_valid), .ready_o(div_ready), .numerator_i(acc_q[NumeratorBits-1:0]), .divisor_i(den_q),
    .valid_o(div_done), .ready_i(div_take), .quotient_o(quotient), .remainder_o(remainder));
  logic       waiting_q;  // the sum for the divider is complete
  logic [1:0] waits_for, waits_for_q;
  assign div_valid = (to == ToDivider || waiting_q) && !flush;
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
  assign waits_for = to == ToDivider ? op_index_q : waits_for_q;

  // ---- Is it narrow? ----
  logic [4:0] shifts_q;  // of two bits that are left
  logic       sticky_q, narrow, tiny, narrow_q, start_narrow;
  logic [1:0] rank, best_rank_q;  // of equally long edges: the least
  logic [2:0] opposite_last, opposite_first;
  for (genvar i = 0; i < 3; i++) begin : g_rank
    assign opposite_last[i]  = precedes[(i+1)%3] && !precedes[(i+2)%3];
    assign opposite_first[i] = !precedes[(i+1)%3] && precedes[(i+2)%3];
  end
  assign rank = opposite_last[op_index_q] ? 2'd0 : opposite_first[op_index_q] ? 2'd1 : 2'd2;
  logic longer;
  assign longer = op_index_q == 2'd0 || acc_q[D-1:0] > best_q || (acc_q[D-1:0] == best_q && rank < best_rank_q);
  assign narrow = acc_q < AccBits'(best_q) || (acc_q == AccBits'(best_q) && !sticky_q);
  assign tiny   = best_q <= D'(1) << (6'(texel_bits_i - 5'(F + 2)) << 1);
  assign start_narrow = state_q == Judge && narrow;
  assign shift_acc    = state_q == Compare && valid_q == '0 && shifts_q != '0;
  logic small_area;
  assign small_area = den_q[D-1:SmallBits] == '0;

  // ---- Control ----
  logic wait_here, last_of_plane;
  logic [Z-1:0] highest_01, highest;
  assign highest_01 = vz[0] > vz[1] ? vz[0] : vz[1];
  assign highest    = highest_01 > vz[2] ? highest_01 : vz[2];
  assign last_of_plane = is_plane_q && pc_q == PcCorner1;
  always_comb begin
    pc_next = pc_q + 6'd1;
    if (pc_q == PcGradients - 6'd1 && shares_q && !is_plane_q) pc_next = PcCorner1;
    if (pc_q == PcStepX + 6'd1 && narrow_q) pc_next = PcStepY;
    if (pc_q == PcLengths - 6'd1 && (shares_q || !small_area)) pc_next = PcStepY;
  end
  // Sums that a product's factor needs, or that must stay, are waited for.
  always_comb begin
    unique case (pc_q)
      PcEnd, PcNarrowEnd: wait_here = 1'b1;
      PcAlong:            wait_here = valid_q != '0;
      default:            wait_here = hold_q || last_of_plane;
    endcase
  end
  assign issue = state_q == Run && !wait_here && !flush && factors_ready_i;
  assign flush = no_area || start_narrow;
  assign div_clear = flush;

  logic [Depth-1:0] bias, full_bias;  // origin's depth, bias, and what rounds up to a step
  logic         finish_start, finish_narrow;
  logic [Z+2:0] third_z;
  assign third_z        = {3'b0, vz[longest_back]} - quotient[Z+2:0];
  assign finish_start  = div_done && div_take && division_q == DivStart;
  assign finish_narrow = div_done && division_q == DivNarrow;
  assign tri_ready_o = state_q == Idle;
  assign valid_o     = state_q == Done;
  assign idle_o      = state_q == Idle;
  assign area_o      = to == ToArea && !is_plane_q && !no_area;
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
          if (no_area || (last_of_plane && valid_q == '0)) state_q <= Idle;
          else if (issue && pc_q == PcSquare + 6'd2) state_q <= Compare;
          else if (finish_start) state_q <= Done;
        end
        Compare: if (valid_q == '0 && shifts_q == '0) state_q <= Judge;
        Judge: state_q <= Run;
        default: if (ready_i) state_q <= Idle;
      endcase
      if (flush) hold_q <= 1'b0;
      else if (issue && op.to == ToDivider) hold_q <= 1'b1;
      else if (div_valid && div_ready) hold_q <= 1'b0;
      waiting_q <= div_valid && !div_ready && !flush;
      `CHECK(divisor_stays, to != ToArea || div_ready)
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
        ex_q[index_q] <= {vx[next_index][C-1], vx[next_index]} - {vx[index_q][C-1], vx[index_q]};
        ey_q[index_q] <= {vy[next_index][C-1], vy[next_index]} - {vy[index_q][C-1], vy[index_q]};
        ez_q[index_q] <= {1'b0, vz[next_index]} - {1'b0, vz[index_q]};
        pc_q          <= '0;
        narrow_q      <= 1'b0;
        shifts_q      <= texel_bits_i - 5'(F + 2);
        sticky_q      <= 1'b0;
        if (is_plane_q || !shares_q) begin
          origin_x_q <= vx[0];
          origin_y_q <= vy[0];
          origin_z_q <= {3'b0, vz[0]};
        end
      end
      Run: begin
        if (issue) pc_q <= pc_next;
        if (finish_narrow) begin
          pc_q <= PcStepX;
          // As far as the third vertex, if that lies beyond the edge beside it.
          if ($signed(third_z) > $signed(origin_z_q)) origin_z_q <= third_z;
        end
      end
      Compare: if (shift_acc) begin
        shifts_q <= shifts_q - 1'b1;
        sticky_q <= sticky_q || acc_q[1:0] != '0;
      end
      Judge: if (narrow) begin
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

    unique case (to)
      ToArea: begin
        clockwise_q <= acc_q[D];
        if (is_plane_q || !shares_q) begin
          den_q <= (acc_q[D-1:0] ^ {D{acc_q[D]}}) + D'(acc_q[D]);
        end
      end
      ToGradX: grad_x_q <= acc_q[G-1:0];
      ToGradY: grad_y_q <= acc_q[G-1:0];
      ToCorner: begin
        corner_q[op_index_q]  <= K'($signed(acc_q[2*C+1:0]) >>> texel_bits_i);
        inexact_q[op_index_q] <= (acc_q[C-2:0] & below) != '0;
      end
      ToLength: if (longer) begin
        best_q      <= acc_q[D-1:0];
        best_rank_q <= rank;
        longest_q   <= op_index_q;
      end
      ToAlong: best_q <= acc_q[D-1:0];
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
          start_whole_o <= quotient[Depth-1:0] + full_bias;
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
    .gradient_i(quotient[F+27:0]), .code_x_o(visit_tri.gradient_x), .code_y_o(visit_tri.gradient_y),
    .done_o(encoder_done), .bias_o(bias));
  assign full_bias = Depth'(origin_z_q) + bias
                   + (shares_q ? Depth'(plane_tolerance_i) : '0)
                   + Depth'((1 << shadow_pkg::PlaneStepBits) - 1);
  assign visit_tri.object = object_q;
  assign visit_tri_o      = visit_tri;
  assign base_o           = den_q;
  assign vertices_o       = {vy[2], vx[2], vy[1], vx[1], vy[0], vx[0]};
  assign edge_dx_o        = {ex_q[2], ex_q[1], ex_q[0]};
  assign edge_dy_o        = {ey_q[2], ey_q[1], ey_q[0]};
  assign inner_o          = inner_q;
  assign upward_o         = up;
  assign clockwise_o      = clockwise_q;
  assign corner_start_o   = {corner_q[2], corner_q[1], corner_q[0]};
  assign corner_inexact_o = inexact_q;
endmodule

// Plane factors: what plane_program names, for plane_sums.
//
// Numbers: as plane_setup, of whose registers the factors are read.
// Timing:  factors of what is named in cycle n leave in n + 1; all but differences are read then.
module plane_factors #(
  localparam int unsigned C     = shadow_pkg::CoordBits,
  localparam int unsigned Z     = shadow_pkg::TraceDepthBits,
  localparam int unsigned F     = shadow_pkg::FractionBits,
  localparam int unsigned D     = 57,  // denominator
  localparam int unsigned G     = 54,  // gradients times the area, signed
  localparam int unsigned A     = 31,  // first factor
  localparam int unsigned Digit = 15   // of the second
) (
  input  logic           clk_i,
  input  logic [4:0]     texel_bits_i,  // f, 16 to 26: its uppermost bit is set
  // the triangle
  input  logic [6*C-1:0] vertices_i,    // x, y of vertex i at 2 i C and (2 i + 1) C
  input  logic [C-1:0]   low_x_i,       // lowest vertex
  input  logic [C-1:0]   low_y_i,
  input  logic [3*C+2:0] edge_x_i,      // edge i to i + 1, signed
  input  logic [3*C+2:0] edge_y_i,
  input  logic [3*Z+2:0] edge_z_i,
  input  logic [C-1:0]   origin_x_i,    // of the plane
  input  logic [C-1:0]   origin_y_i,
  input  logic [G-1:0]   grad_x_i,
  input  logic [G-1:0]   grad_y_i,
  input  logic [D-1:0]   den_i,
  input  logic [D-1:0]   best_i,
  input  logic           clockwise_i,
  // which; plane_program has the values
  input  logic           valid_i,
  input  logic [2:0]     a_kind_i,
  input  logic [1:0]     a_axis_i,
  input  logic [1:0]     a_index_i,
  input  logic [1:0]     b_kind_i,
  input  logic           b_axis_i,
  input  logic [1:0]     b_index_i,
  input  logic [2:0]     b_digit_i,
  input  logic           minus_i,
  input  logic           by_area_i,
  input  logic           first_i,
  input  logic           move_i,
  // a product for edge_setup instead
  input  logic           edge_i,
  input  logic           edge_high_i,   // the second digit
  input  logic [C:0]     edge_a_i,      // both constant until after the second digit
  input  logic [C-1:0]   edge_b_i,
  // to plane_sums
  output logic           valid_o,
  output logic [A-1:0]   a_o,
  output logic [Digit:0] digit_o,
  output logic           minus_o,
  output logic           first_o,
  output logic           move_o
);
  // A narrow triangle has 16 area^2 <= length^2 r^2, r = 2^(f-F). Both sides are taken times 2^(2 Scale), and
  // the power of two on the right comes in digits of plane_sums and one factor.
  localparam int unsigned Scale      = F <= 3 ? (F > 1 ? F - 1 : 0) : F > 8 ? F - 8 : 0;
  localparam int unsigned RadiusLess = 2 * F + (F <= 3 ? 2 : 1) * Digit - 2 * Scale;
  localparam logic [2:0] AEdge = 3'd0, ACorner = 3'd1, ACentre = 3'd2, ATexel = 3'd3, ARadius = 3'd4,
                         AAreaLow = 3'd5;
  localparam logic [1:0] BEdge = 2'd0, BGradient = 2'd1, BBest = 2'd2;
  localparam logic [1:0] Zz = 2'd2;

  logic [C-1:0] vx[3], vy[3];
  logic [C:0]   ex[3], ey[3];
  logic [Z:0]   ez[3];
  for (genvar i = 0; i < 3; i++) begin : g_vertex
    assign vx[i] = vertices_i[2*i*C +: C];
    assign vy[i] = vertices_i[2*i*C+C +: C];
    assign ex[i] = edge_x_i[i*(C+1) +: C+1];
    assign ey[i] = edge_y_i[i*(C+1) +: C+1];
    assign ez[i] = edge_z_i[i*(Z+1) +: Z+1];
  end
  // Half a texel, and what lies below a texel.
  logic [C-2:0] texel, half, below;
  assign texel = (C-1)'(1) << {1'b1, texel_bits_i[3:0]};
  assign half  = texel >> 1;
  assign below = texel - 1'b1;

  logic [4*Digit-1:0] area, b_long;
  logic [C:0]         a_edge, a_from, a_to, b_edge, difference_q;
  logic [4:0]         power;
  logic [2:0]         a_kind_q, b_digit_q;
  logic [1:0]         a_axis_q, a_index_q, b_kind_q, b_index_q;
  logic               b_axis_q, minus_q, by_area_q, is_edge_q, edge_high_q;
  assign area  = (4*Digit)'(den_i) << (2 + Scale);
  assign power = a_kind_q == ARadius ? 5'({texel_bits_i, 1'b0} - 6'(RadiusLess)) : {1'b1, texel_bits_i[3:0]};
  // Differences, and what picks the other factors, a cycle ahead.
  always_comb begin
    a_to = a_axis_i[0] ? {low_y_i[C-1], low_y_i & {1'b1, ~below}} : {low_x_i[C-1], low_x_i & {1'b1, ~below}};
    if (a_kind_i == ACentre) begin
      a_to   = a_to | {2'b0, half};
      a_from = a_axis_i[0] ? {origin_y_i[C-1], origin_y_i} : {origin_x_i[C-1], origin_x_i};
    end else begin
      a_from = a_axis_i[0] ? {vy[b_index_i][C-1], vy[b_index_i]} : {vx[b_index_i][C-1], vx[b_index_i]};
    end
  end
  always_ff @(posedge clk_i) begin
    difference_q <= a_to - a_from;
    a_kind_q     <= a_kind_i;
    a_axis_q     <= a_axis_i;
    a_index_q    <= a_index_i;
    b_kind_q     <= b_kind_i;
    b_axis_q     <= b_axis_i;
    b_index_q    <= b_index_i;
    b_digit_q    <= b_digit_i;
    is_edge_q    <= edge_i;
    valid_o      <= valid_i;
    edge_high_q  <= edge_high_i;
    minus_q      <= minus_i;
    by_area_q    <= by_area_i;
    first_o      <= first_i;
    move_o       <= move_i;
  end
  always_comb begin
    unique case (a_axis_q)
      Zz:      a_edge = {{(C-Z){ez[a_index_q][Z]}}, ez[a_index_q]};
      2'd1:    a_edge = ey[a_index_q];
      default: a_edge = ex[a_index_q];
    endcase
    unique case (a_kind_q)
      AEdge:            a_o = A'($signed(a_edge));
      ACorner, ACentre: a_o = A'($signed(difference_q));
      ATexel, ARadius:  a_o = A'(1) << power;
      AAreaLow:         a_o = {1'b0, area[A-2:0]};
      default:          a_o = A'(area[4*Digit-1:A-1]);
    endcase
    if (is_edge_q) a_o = A'($signed(edge_a_i));

    b_edge = b_axis_q ? ey[b_index_q] : ex[b_index_q];
    unique case (b_kind_q)
      BEdge:     b_long = (4*Digit)'($signed(b_edge));
      BGradient: b_long = (4*Digit)'($signed(b_axis_q ? grad_y_i : grad_x_i));
      BBest:     b_long = (4*Digit)'(best_i);
      default:   b_long = area;
    endcase
    unique case (b_digit_q)
      3'd0:    digit_o = {1'b0, b_long[Digit-1:0]};
      3'd1:    digit_o = {b_kind_q == BEdge && b_edge[C], b_long[Digit +: Digit]};
      3'd2:    digit_o = {1'b0, b_long[2*Digit +: Digit]};
      3'd3:    digit_o = {b_kind_q == BGradient && b_long[4*Digit-1], b_long[3*Digit +: Digit]};
      default: digit_o = '0;
    endcase
    if (is_edge_q) digit_o = edge_high_q ? (Digit+1)'(edge_b_i[C-1:Digit]) : {1'b0, edge_b_i[Digit-1:0]};
  end
  assign minus_o = !is_edge_q && (minus_q ^ (by_area_q && clockwise_i));
endmodule

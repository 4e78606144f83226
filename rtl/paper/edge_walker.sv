// Edge walker: visits every texel that an outline crosses, one a cycle.
//
// Source:  IPSJ 2008, 3.3.1, Fig. 5, Tables 2 and 3. Twin: model/unit/edge_walker.h.
// Numbers: the minor coordinate at a texel's near and far major side, and the depth at the next borders,
//          are exact ramps; only Fraction is rounded.
// Timing:  an edge is taken in cycle n, its first texel is valid in n + 2, then one follows a cycle, and the
//          next edge is taken with the last one; a step through a texel's corner costs one cycle more.
`include "check.svh"
module edge_walker #(
  localparam int unsigned D = shadow_pkg::DepthBits,
  localparam int unsigned C = shadow_pkg::CoordBits,
  localparam int unsigned F = shadow_pkg::MaxFraction,
  localparam int unsigned R = shadow_pkg::RowIndexBits
) (
  input  logic                   clk_i,
  input  logic                   rst_ni,
  input  logic                   clear_i,
  input  logic [4:0]             texel_bits_i,
  // from edge_setup, which says what they are
  input  logic                   edge_valid_i,
  output logic                   edge_ready_o,
  input  logic [1:0]             index_i,
  input  logic                   left_i,
  input  logic                   x_major_i,
  input  logic                   x_positive_i,
  input  logic [R-1:0]           first_x_i,
  input  logic [R-1:0]           first_y_i,
  input  logic [R-1:0]           last_x_i,
  input  logic [R-1:0]           last_y_i,
  input  logic [C-1:0]           length_i,
  input  logic [C-1:0]           rise_i,
  input  logic [F+2:0]           minor_whole_i,
  input  logic [C-1:0]           minor_rest_i,
  input  logic [F+1:0]           minor_step_whole_i,
  input  logic [C-1:0]           minor_step_rest_i,
  input  logic [D-1:0]           first_depth_i,
  input  logic [D-1:0]           last_depth_i,
  input  logic                   depth_less_i,
  input  logic [D:0]             major_depth_whole_i,
  input  logic [C:0]             major_depth_rest_i,
  input  logic [D-1:0]           major_depth_step_whole_i,
  input  logic [C-1:0]           major_depth_step_rest_i,
  input  logic [D:0]             minor_depth_whole_i,
  input  logic [C:0]             minor_depth_rest_i,
  input  logic [D-1:0]           minor_depth_step_whole_i,
  input  logic [C-1:0]           minor_depth_step_rest_i,
  // A texel of the outline, off the map too
  output logic                   texel_valid_o,
  input  logic                   ready_i,       // without it nothing moves, whether valid or not
  output logic [1:0]             index_o,       // of the edge
  output logic [R-1:0]           x_o,           // signed, from the map's corner
  output logic [R-1:0]           y_o,
  output logic                   left_o,        // fields of line_t, but for the polygon
  output logic                   cross_flag_o,
  output logic                   x_major_o,
  output logic                   x_positive_o,
  output logic                   start_here_o,
  output logic                   end_here_o,
  output logic [shadow_pkg::SlopeBits-1:0]    slope_o,
  output logic [shadow_pkg::FractionBits-1:0] fraction_o,
  output logic [D-1:0]           nearest_o,     // least depth of the edge in the texel
  output logic                   move_x_o,      // the walk goes to the neighbour; one of both a cycle
  output logic                   move_y_o,
  output logic                   back_o,        // along x it goes down
  output logic                   fresh_o,       // the cycle before an edge's first texel
  output logic [D-1:0]           entry_o,       // the edge's depth where the texel is entered
  output logic                   busy_o
);
  localparam int unsigned W = F + 3;  // of the minor coordinate, signed

  logic         busy_q, fresh_q, corner_q;  // corner_q: between the two halves of a step through a corner
  logic [1:0]   index_q;
  logic         less_q, left_q, x_major_q, x_positive_q, start_q;
  logic [R-1:0] x_q, y_q, last_x_q, last_y_q;
  logic [C-1:0] length_q, rise_q;
  logic [W-1:0] near_q, far_q;          // whole parts
  logic [C-1:0] far_rest_q;           // the near side's is not looked at
  logic [F+1:0] step_q;
  logic [C-1:0] step_rest_q;
  logic [D-1:0] entry_q, last_depth_q;

  // ---- How the texel is left (Table 2) ----
  logic [W-1:0] texel, units;
  logic         last, along_major, vertex, along_minor, take, emit;
  assign texel       = W'(1) << texel_bits_i;
  assign last        = x_q == last_x_q && y_q == last_y_q;
  assign units       = texel - 1'b1;
  assign along_major = far_q[W-1] || (far_q & ~units) == '0;
  assign vertex      = far_q == texel && far_rest_q == '0;
  assign along_minor = !along_major && !vertex;

  assign texel_valid_o = busy_q && !fresh_q && !corner_q;
  assign emit          = texel_valid_o && ready_i;
  assign take          = edge_valid_i && edge_ready_o;
  assign edge_ready_o  = ready_i && (!busy_q || (texel_valid_o && last));
  assign busy_o        = busy_q;
  assign fresh_o       = fresh_q;
  assign entry_o       = entry_q;

  // ---- Minor coordinate ----
  // A fresh edge's near side comes into the far side's registers first.
  logic [W-1:0] far_next;
  logic [C-1:0] far_rest_next;
  exact_step #(.WholeBits(W), .RestBits(C)) far_step (
    .whole_i(far_q), .rest_i(far_rest_q), .step_whole_i({1'b0, step_q}), .step_rest_i(step_rest_q), .base_i(length_q),
    .whole_o(far_next), .rest_o(far_rest_next));
  always_ff @(posedge clk_i) begin
    if (take) begin
      far_q      <= minor_whole_i;
      far_rest_q <= minor_rest_i;
    end else if (emit || (fresh_q && ready_i)) begin
      if (along_minor && !fresh_q) begin
        near_q <= near_q - texel;
        far_q  <= far_q - texel;
      end else begin
        near_q     <= vertex && !fresh_q ? '0 : far_q;
        far_q      <= vertex && !fresh_q ? W'(step_q) : far_next;
        far_rest_q <= far_rest_next;
      end
    end
  end

  // ---- Depths ----
  logic [D-1:0] exit_depth;
  logic [D:0]   major_depth, minor_depth;
  depth_ramp major_ramp (
    .clk_i, .load_i(take), .whole_i(major_depth_whole_i), .rest_i(major_depth_rest_i),
    .step_whole_i(major_depth_step_whole_i), .step_rest_i(major_depth_step_rest_i), .less_i(less_q), .base_i(length_q),
    .ahead_i(fresh_q && ready_i), .advance_i(emit && !along_minor), .whole_o(major_depth));
  depth_ramp minor_ramp (
    .clk_i, .load_i(take), .whole_i(minor_depth_whole_i), .rest_i(minor_depth_rest_i),
    .step_whole_i(minor_depth_step_whole_i), .step_rest_i(minor_depth_step_rest_i), .less_i(less_q), .base_i(rise_q),
    .ahead_i(fresh_q && ready_i), .advance_i(emit && !along_major), .whole_o(minor_depth));
  assign exit_depth = last ? last_depth_q : along_minor ? minor_depth[D-1:0] : major_depth[D-1:0];
  assign nearest_o  = exit_depth < entry_q ? exit_depth : entry_q;

  // ---- Place ----
  logic step_x, step_y;  // along which the texel is left
  assign step_x   = vertex || (x_major_q == along_major);
  assign step_y   = vertex || (x_major_q != along_major);
  assign move_x_o = ready_i && texel_valid_o && !last && step_x;
  assign move_y_o = ready_i && (corner_q || (texel_valid_o && !last && step_y && !vertex));
  assign back_o   = !x_positive_q && !corner_q && step_x;
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      busy_q   <= 1'b0;
      fresh_q  <= 1'b0;
      corner_q <= 1'b0;
    end else if (clear_i) begin
      busy_q   <= 1'b0;
      fresh_q  <= 1'b0;
      corner_q <= 1'b0;
    end else begin
      if (take) busy_q <= 1'b1;
      else if (emit && last) busy_q <= 1'b0;
      if (ready_i) fresh_q <= take;
      if (ready_i) corner_q <= emit && !last && vertex;
      `CHECK(depth_fits, !emit || last || !(along_minor ? minor_depth[D] : major_depth[D]))
    end
  end
  always_ff @(posedge clk_i) begin
    if (take) begin
      index_q      <= index_i;
      left_q       <= left_i;
      less_q       <= depth_less_i;
      x_major_q    <= x_major_i;
      x_positive_q <= x_positive_i;
      start_q      <= 1'b1;
      last_x_q     <= last_x_i;
      last_y_q     <= last_y_i;
      length_q     <= length_i;
      rise_q       <= rise_i;
      step_q       <= minor_step_whole_i;
      step_rest_q  <= minor_step_rest_i;
      last_depth_q <= last_depth_i;
      entry_q      <= first_depth_i;
      x_q          <= first_x_i;
      y_q          <= first_y_i;
    end else begin
      if (emit) begin
        start_q <= 1'b0;
        entry_q <= exit_depth;
      end
      if (move_x_o) x_q <= x_positive_q ? x_q + 1'b1 : x_q - 1'b1;
      if (move_y_o) y_q <= y_q + 1'b1;
    end
  end

  // ---- The line ----
  logic [W-1:0] crossing;
  assign index_o      = index_q;
  assign x_o          = x_q;
  assign y_o          = y_q;
  assign left_o       = left_q;
  assign cross_flag_o = near_q[W-1];
  assign x_major_o    = x_major_q;
  assign x_positive_o = x_positive_q;
  assign start_here_o = start_q;
  assign end_here_o   = last;
  assign crossing     = cross_flag_o ? far_q : near_q;
  round_to_field #(.Bits(shadow_pkg::FractionBits)) round_fraction (
    .texel_bits_i, .value_i(crossing[F+1:0]), .field_o(fraction_o));
  round_to_field #(.Bits(shadow_pkg::SlopeBits)) round_slope (
    .texel_bits_i, .value_i(step_q), .field_o(slope_o));
  logic unused;
  assign unused = &{1'b0, crossing[W-1]};
endmodule

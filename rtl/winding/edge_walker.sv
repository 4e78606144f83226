// Edge walker: an outline's pieces, texel by texel.
//
// Twin:    EdgeWalker in model/unit/winding/edge_walker.cpp.
// Numbers: as edge_setup, which loads it. Where the edge meets the next border of an axis is kept exactly,
//          relative to the texel that the walk stands in: a step along u adds to the one ramp and takes a
//          texel off the other. Ramps whose border is never met hold nothing of use.
// Timing:  loaded in cycle n, the first texel in n + 1, then one a step; through a texel's corner the walk
//          takes two steps, and the first of them ends where there is no texel of the edge's.
`include "check.svh"
module edge_walker #(
  localparam int unsigned C = shadow_pkg::CoordBits,
  localparam int unsigned T = shadow_pkg::RowIndexBits,
  localparam int unsigned E = shadow_pkg::EndWidth
) (
  input  logic           clk_i,
  input  logic [4:0]     texel_bits_i,  // f; constant
  input  logic           load_i,        // take an edge: what follows is edge_setup's
  input  logic           positive_i,    // the facet lies right of the direction of travel
  input  logic           x_positive_i,
  input  logic           on_border_i,
  input  logic [T-1:0]   first_u_i,
  input  logic [T-1:0]   first_v_i,
  input  logic [T-1:0]   last_u_i,
  input  logic [T-1:0]   last_v_i,
  input  logic [E-1:0]   from_u_i,
  input  logic [E-1:0]   from_v_i,
  input  logic           from_u_zero_i,
  input  logic           from_v_zero_i,
  input  logic [E-1:0]   to_u_i,
  input  logic [E-1:0]   to_v_i,
  input  logic           to_u_full_i,
  input  logic           to_v_zero_i,
  input  logic [C:0]     v_whole_i,
  input  logic [C-1:0]   v_rest_i,
  input  logic [C-1:0]   v_step_i,
  input  logic [C-1:0]   v_step_rest_i,
  input  logic [C-1:0]   du_i,
  input  logic [C:0]     u_whole_i,
  input  logic [C-1:0]   u_rest_i,
  input  logic [C-1:0]   u_step_i,
  input  logic [C-1:0]   u_step_rest_i,
  input  logic [C-1:0]   dv_i,
  input  logic           step_i,        // on; not after the last texel
  output logic [T-1:0]   x_o,           // texel, signed, from the origin
  output logic [T-1:0]   y_o,
  output logic           on_edge_o,     // it is one of the edge's; else half way through a corner
  output logic           last_o,        // it is the last one
  output logic           along_x_o,     // the step from here goes along x, else along y
  output logic           x_positive_o,  // in this direction
  output logic           row_ends_o,    // it is the last one of its row
  // the piece in this texel
  output logic           has_segment_o,
  output logic           dot_o,         // both ends are one point, that does not cross the left border
  output shadow_pkg::segment_t segment_o  // but for `inner`, which is 0
);
  localparam logic [E-1:0] Side = {1'b1, {(E-1){1'b0}}};

  logic           positive_q, x_positive_q, on_border_q, half_way_q;
  logic [T-1:0]   u_q, v_q, last_u_q, last_v_q;
  logic [C:0]     v_whole_q, u_whole_q;
  logic [C-1:0]   v_rest_q, v_step_q, v_step_rest_q, du_q, u_rest_q, u_step_q, u_step_rest_q, dv_q;
  logic [E-1:0]   entry_u_q, entry_v_q, to_u_q, to_v_q;
  logic           entry_u_zero_q, entry_v_zero_q, to_u_full_q, to_v_zero_q;

  // ---- Where the edge leaves the texel ----
  logic [C-2:0] texel;
  logic         at_last_u, at_last_v, beyond, at_border, leaves_u, leaves_v, along_u;
  assign texel     = (C-1)'(1) << texel_bits_i;
  assign at_last_u = u_q == last_u_q;
  assign at_last_v = v_q == last_v_q;
  assign beyond    = (v_whole_q & ~{2'b0, texel - 1'b1}) != '0;  // at or above the upper border
  assign at_border = v_whole_q == {2'b0, texel} && v_rest_q == '0;
  assign leaves_u  = !at_last_u && (at_last_v || !beyond || at_border) && !half_way_q;
  assign leaves_v  = half_way_q || (!at_last_v && (at_last_u || beyond));
  assign along_u   = leaves_u;

  assign x_o          = x_positive_q ? u_q : ~u_q;
  assign y_o          = v_q;
  assign on_edge_o    = !half_way_q;
  assign last_o       = at_last_u && at_last_v;
  assign along_x_o    = along_u;
  assign x_positive_o = x_positive_q;
  assign row_ends_o   = leaves_v || last_o;

  // ---- Ends of the piece ----
  logic         v_half, u_half;  // what is left over a unit rounds up, where a step is a unit
  if (shadow_pkg::EndBits == shadow_pkg::MaxFraction - 10) begin : g_unit_steps
    assign v_half = {v_rest_q, 1'b0} >= {1'b0, du_q};
    assign u_half = {u_rest_q, 1'b0} >= {1'b0, dv_q};
  end else begin : g_long_steps
    assign v_half = 1'b0;
    assign u_half = 1'b0;
  end
  logic [E:0]   v_unrounded, u_unrounded;
  logic [E-1:0] v_rounded, u_rounded, exit_u, exit_v;
  logic         exit_u_full, exit_v_zero;
  assign v_unrounded = (E+1)'({v_whole_q[C-2:0], v_half} >> (texel_bits_i - 5'(shadow_pkg::EndBits)));
  assign u_unrounded = (E+1)'({u_whole_q[C-2:0], u_half} >> (texel_bits_i - 5'(shadow_pkg::EndBits)));
  assign v_rounded   = v_unrounded[E:1] + E'(v_unrounded[0]);
  assign u_rounded   = u_unrounded[E:1] + E'(u_unrounded[0]);
  assign exit_u      = leaves_u ? Side : last_o ? to_u_q : u_rounded;
  assign exit_v      = leaves_v ? Side : last_o ? to_v_q : v_rounded;
  assign exit_u_full = leaves_u || (last_o && to_u_full_q);
  assign exit_v_zero = !leaves_v && (last_o ? to_v_zero_q : v_whole_q == '0 && v_rest_q == '0);

  // ---- The piece ----
  logic         crosses, swap;
  logic [E-1:0] x0, x1;
  // The left border is met on entry, mirrored on leaving. The sample lies above the lower corner.
  assign crosses = x_positive_q ? entry_u_zero_q && !entry_v_zero_q : exit_u_full && !exit_v_zero;
  assign swap    = crosses && !x_positive_q;
  assign x0      = x_positive_q ? entry_u_q : Side - entry_u_q;
  assign x1      = x_positive_q ? exit_u : Side - exit_u;
  assign dot_o   = entry_u_q == exit_u && entry_v_q == exit_v && !crosses;
  assign has_segment_o = !on_border_q;
  assign segment_o.inner        = 1'b0;
  assign segment_o.crosses_left = crosses;
  // What lies right of a rising edge lies below it. A dot has no side.
  assign segment_o.positive     = (positive_q ^ (crosses && x_positive_q)) && !dot_o;
  assign segment_o.x0           = swap ? x1 : x0;
  assign segment_o.y0           = swap ? exit_v : entry_v_q;
  assign segment_o.x1           = swap ? x0 : x1;
  assign segment_o.y1           = swap ? entry_v_q : exit_v;

  // ---- Steps ----
  logic [C:0]   v_sum, v_less, u_sum, u_less;  // of the rests
  logic         v_carry, u_carry;
  assign v_sum   = {1'b0, v_rest_q} + {1'b0, v_step_rest_q};
  assign v_less  = v_sum - {1'b0, du_q};
  assign v_carry = !v_less[C];
  assign u_sum   = {1'b0, u_rest_q} + {1'b0, u_step_rest_q};
  assign u_less  = u_sum - {1'b0, dv_q};
  assign u_carry = !u_less[C];

  always_ff @(posedge clk_i) begin
    if (load_i) begin
      positive_q     <= positive_i;
      x_positive_q   <= x_positive_i;
      on_border_q    <= on_border_i;
      half_way_q     <= 1'b0;
      u_q            <= first_u_i;
      v_q            <= first_v_i;
      last_u_q       <= last_u_i;
      last_v_q       <= last_v_i;
      v_whole_q      <= v_whole_i;
      v_rest_q       <= v_rest_i;
      v_step_q       <= v_step_i;
      v_step_rest_q  <= v_step_rest_i;
      du_q           <= du_i;
      u_whole_q      <= u_whole_i;
      u_rest_q       <= u_rest_i;
      u_step_q       <= u_step_i;
      u_step_rest_q  <= u_step_rest_i;
      dv_q           <= dv_i;
      entry_u_q      <= from_u_i;
      entry_v_q      <= from_v_i;
      entry_u_zero_q <= from_u_zero_i;
      entry_v_zero_q <= from_v_zero_i;
      to_u_q         <= to_u_i;
      to_v_q         <= to_v_i;
      to_u_full_q    <= to_u_full_i;
      to_v_zero_q    <= to_v_zero_i;
    end else if (step_i) begin
      half_way_q <= leaves_u && leaves_v;
      if (along_u) begin
        u_q            <= u_q + 1'b1;
        v_whole_q      <= v_whole_q + {1'b0, v_step_q} + (C+1)'(v_carry);
        v_rest_q       <= v_carry ? v_less[C-1:0] : v_sum[C-1:0];
        u_whole_q      <= u_whole_q - {2'b0, texel};
        entry_u_q      <= '0;
        entry_u_zero_q <= 1'b1;
        entry_v_q      <= exit_v;
        entry_v_zero_q <= exit_v_zero;
      end else begin
        v_q            <= v_q + 1'b1;
        u_whole_q      <= u_whole_q + {1'b0, u_step_q} + (C+1)'(u_carry);
        u_rest_q       <= u_carry ? u_less[C-1:0] : u_sum[C-1:0];
        v_whole_q      <= v_whole_q - {2'b0, texel};
        entry_v_q      <= '0;
        entry_v_zero_q <= 1'b1;
        if (!half_way_q) begin
          // Met where the edge is not also on a border along u: it would lie within that border.
          entry_u_q      <= u_rounded;
          entry_u_zero_q <= 1'b0;
        end
      end
    end
  end
endmodule

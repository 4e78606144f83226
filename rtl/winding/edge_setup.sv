// Edge setup: from a triangle's edge to the ramps that walk it.
//
// Twin:    EdgeWalker::EdgeWalker in model/unit/winding/edge_walker.cpp.
// Numbers: u is x, mirrored where the edge travels towards -x. Where the edge meets the next border along
//          u is v0 + offset, offset = floor((T - u0 mod T) dv / du), and from border to border it is
//          floor(T dv / du) farther. The offset counts only where the edge crosses a border along u: then
//          T - u0 mod T <= du, and the offset is at most dv. The step counts only from the second border
//          on: then T < du, and the step is below dv. So 28 bits hold all quotients that count, and
//          others are not worked out: offsets are, unless no border is crossed; steps if two are.
// Timing:  taken in cycle n; valid in n + 5 if the edge stays in its texel, in n + 22 at the latest if it
//          crosses a border an axis, and 19 cycles later if more.
`include "check.svh"
module edge_setup #(
  localparam int unsigned C = shadow_pkg::CoordBits,
  localparam int unsigned T = shadow_pkg::RowIndexBits,
  localparam int unsigned E = shadow_pkg::EndWidth
) (
  input  logic           clk_i,
  input  logic           rst_ni,
  input  logic           clear_i,
  input  logic [4:0]     texel_bits_i,   // f; constant
  // an edge; all of it holds until the result was taken
  input  logic           edge_valid_i,
  input  logic [C-1:0]   from_x_i,       // signed; the end that the edge is travelled from: lower, or left if level
  input  logic [C-1:0]   from_y_i,
  input  logic [C-1:0]   to_x_i,
  input  logic [C-1:0]   to_y_i,
  input  logic           upward_i,       // the differences are from its lower end to the other
  input  logic [C:0]     dx_i,           // signed
  input  logic [C:0]     dy_i,
  // products, by plane_setup
  output logic           factors_valid_o, // until the product is there
  output logic [C:0]     factor_a_o,     // signed
  output logic [C-1:0]   factor_b_o,     // unsigned
  input  logic           product_done_i,
  input  logic [2*C-1:0] product_i,
  // to the walker
  output logic           valid_o,
  input  logic           ready_i,
  output logic           x_positive_o,   // travels towards +x, or not along x
  output logic           on_border_o,    // runs within the left or the lower border of its texels
  output logic [T-1:0]   first_u_o,      // texels, signed, from the origin
  output logic [T-1:0]   first_v_o,
  output logic [T-1:0]   last_u_o,
  output logic [T-1:0]   last_v_o,
  // ends within their texels, rounded; and what rounding hides
  output logic [E-1:0]   from_u_o,
  output logic [E-1:0]   from_v_o,
  output logic           from_u_zero_o,  // on the left border
  output logic           from_v_zero_o,  // on the lower one
  output logic [E-1:0]   to_u_o,
  output logic [E-1:0]   to_v_o,
  output logic           to_u_full_o,    // on the right border
  output logic           to_v_zero_o,
  // ramps: v at the next border along u, from first_v's lower border; u at the next border along v
  output logic [C:0]     v_whole_o,
  output logic [C-1:0]   v_rest_o,       // over du
  output logic [C-1:0]   v_step_o,
  output logic [C-1:0]   v_step_rest_o,
  output logic [C-1:0]   du_o,
  output logic [C:0]     u_whole_o,
  output logic [C-1:0]   u_rest_o,       // over dv
  output logic [C-1:0]   u_step_o,
  output logic [C-1:0]   u_step_rest_o,
  output logic [C-1:0]   dv_o
);
  localparam int unsigned G = shadow_pkg::EndBits;
  localparam logic [3:0] Idle = 4'd0, FromU = 4'd1, FromV = 4'd2, ToU = 4'd3, ToV = 4'd4,
                         OffsetV = 4'd6, OffsetU = 4'd7, Offsets = 4'd8, StepV = 4'd9,
                         StepU = 4'd10, Steps = 4'd11;
  logic [3:0] state_q;  // 5: the last coordinate is still on its way

  // ---- Extents ----
  logic [C-1:0] du_q, dv_q;
  logic         x_positive_q;

  logic take;  // the offsets
  // ---- One coordinate after the other: texel, place in it, the same rounded ----
  logic         is_u, is_to, is_u_q, is_to_q, zero, at_end;
  logic [C:0]   coordinate, coordinate_q, signed_x;
  logic [3:0]   part_q;  // the coordinate, by the state that took it
  logic [C-2:0] texel, below, place;
  logic [T-1:0] index;
  logic [E:0]   unrounded;
  logic [E-1:0] rounded;
  assign is_u       = state_q == FromU || state_q == ToU;
  assign is_to      = state_q == ToU || state_q == ToV;
  assign signed_x   = is_to ? {to_x_i[C-1], to_x_i} : {from_x_i[C-1], from_x_i};
  assign coordinate = !is_u ? (is_to ? {to_y_i[C-1], to_y_i} : {from_y_i[C-1], from_y_i})
                    : x_positive_q ? signed_x : -signed_x;
  assign texel      = (C-1)'(1) << {1'b1, texel_bits_i[3:0]};
  assign below      = texel - 1'b1;
  always_ff @(posedge clk_i) begin
    coordinate_q <= coordinate;
    part_q       <= state_q;
    is_u_q       <= is_u;
    is_to_q      <= is_to;
  end
  assign place      = coordinate_q[C-2:0] & below;
  assign zero       = place == '0;
  assign index      = T'($signed(coordinate_q) >>> texel_bits_i);
  assign unrounded  = (E+1)'({place, 1'b0} >> (texel_bits_i - 5'(G)));
  assign rounded    = unrounded[E:1] + E'(unrounded[0]);
  // An edge ends in the texel before the border that it ends on, if it has come along that axis.
  assign at_end     = is_to_q && zero && (is_u_q ? du_q : dv_q) != '0;

  logic [T-1:0] first_u_q, first_v_q, last_u_q, last_v_q;
  logic [E-1:0] from_u_q, from_v_q, to_u_q, to_v_q;
  logic         from_u_zero_q, from_v_zero_q, to_u_full_q, to_v_zero_q;
  // Where the end travelled from lies in its texel, then where the edge meets the next borders.
  logic [C:0]   v_whole_q, u_whole_q;
  logic [C-1:0] v_rest_q, u_rest_q;
  always_ff @(posedge clk_i) begin
    if (state_q == Idle) begin
      x_positive_q <= upward_i != dx_i[C] || dx_i == '0;
      du_q         <= (dx_i[C-1:0] ^ {C{dx_i[C]}}) + C'(dx_i[C]);
      dv_q         <= (dy_i[C-1:0] ^ {C{dy_i[C]}}) + C'(dy_i[C]);
    end
    unique case (part_q)
      FromU: begin
        first_u_q     <= index;
        from_u_q      <= rounded;
        from_u_zero_q <= zero;
        u_whole_q     <= (C+1)'(place);
      end
      FromV: begin
        first_v_q     <= index;
        from_v_q      <= rounded;
        from_v_zero_q <= zero;
        v_whole_q     <= (C+1)'(place);
      end
      ToU: begin
        last_u_q    <= at_end ? index - 1'b1 : index;
        to_u_q      <= at_end ? {1'b1, {G{1'b0}}} : rounded;
        to_u_full_q <= at_end;
      end
      ToV: begin
        last_v_q    <= at_end ? index - 1'b1 : index;
        to_v_q      <= at_end ? {1'b1, {G{1'b0}}} : rounded;
        to_v_zero_q <= zero && !at_end;
      end
      default: ;
    endcase
    if (take) begin
      v_whole_q <= v_whole_o;
      v_rest_q  <= v_rest_o;
      u_whole_q <= u_whole_o;
      u_rest_q  <= u_rest_o;
    end
  end

  // ---- Products and divisions ----
  logic [T-1:0] count_u, count_v;  // borders that are crossed
  logic         any_u, any_v, more_u, more_v;
  assign count_u = last_u_q - first_u_q;
  assign count_v = last_v_q - first_v_q;
  assign any_u   = count_u != '0;
  assign any_v   = count_v != '0;
  assign more_u  = count_u[T-1:1] != '0;
  assign more_v  = count_v[T-1:1] != '0;

  // Offsets if a border is crossed, steps if two are.
  logic along_u, wanted;
  assign along_u = state_q == OffsetV || state_q == StepV;
  always_comb begin
    unique case (state_q)
      OffsetV: wanted = any_u;
      OffsetU: wanted = any_v;
      StepV:   wanted = more_u;
      StepU:   wanted = more_v;
      default: wanted = 1'b0;
    endcase
  end
  assign factors_valid_o = wanted;
  assign factor_a_o = {2'b0, texel} - (state_q == OffsetV ? u_whole_q
                                     : state_q == OffsetU ? v_whole_q : '0);
  assign factor_b_o = along_u ? dv_q : du_q;

  logic         start_v, start_u, done_v, done_u, stop;
  logic         ready_v, ready_u;
  logic [C:0]   quotient_v, quotient_u;
  logic [C-1:0] remainder_v, remainder_u;
  assign start_v = product_done_i && along_u;
  assign start_u = product_done_i && !along_u;
  divider #(.NumeratorBits(2*C-1), .DivisorBits(C), .QuotientBits(C+1), .SkipBits(8)) divide_v (
    .clk_i, .rst_ni, .clear_i(stop), .valid_i(start_v), .ready_o(ready_v), .numerator_i(product_i[2*C-2:0]),
    .divisor_i(du_q), .valid_o(done_v), .ready_i(take), .quotient_o(quotient_v), .remainder_o(remainder_v));
  divider #(.NumeratorBits(2*C-1), .DivisorBits(C), .QuotientBits(C+1), .SkipBits(8)) divide_u (
    .clk_i, .rst_ni, .clear_i(stop), .valid_i(start_u), .ready_o(ready_u), .numerator_i(product_i[2*C-2:0]),
    .divisor_i(dv_q), .valid_o(done_u), .ready_i(take), .quotient_o(quotient_u), .remainder_o(remainder_u));

  logic         offsets_done, steps_done;
  assign offsets_done = state_q == Offsets && (done_v || !any_u) && (done_u || !any_v);
  assign steps_done   = state_q == Steps && (done_v || !more_u) && (done_u || !more_v);
  assign valid_o      = (offsets_done && !more_u && !more_v) || steps_done;
  assign take         = offsets_done && (more_u || more_v);
  assign stop         = clear_i || (valid_o && ready_i);

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      state_q <= Idle;
    end else if (stop) begin
      state_q <= Idle;
    end else begin
      unique case (state_q)
        Idle:    if (edge_valid_i) state_q <= FromU;
        Offsets: if (offsets_done && (more_u || more_v)) state_q <= StepV;
        OffsetV, OffsetU, StepV, StepU: if (!wanted || product_done_i) state_q <= state_q + 4'd1;
        Steps: ;
        default: state_q <= state_q + 4'd1;
      endcase
      `CHECK(dividers_free, !(start_v && !ready_v) && !(start_u && !ready_u))
      `CHECK(upward, state_q != FromU || dy_i == '0 || upward_i != dy_i[C])
      `CHECK(numerator_fits, !(start_v || start_u) || !product_i[2*C-1])
    end
  end
  assign x_positive_o  = x_positive_q;
  assign on_border_o   = (du_q == '0 && from_u_zero_q) || (dv_q == '0 && from_v_zero_q);
  assign first_u_o     = first_u_q;
  assign first_v_o     = first_v_q;
  assign last_u_o      = last_u_q;
  assign last_v_o      = last_v_q;
  assign from_u_o      = from_u_q;
  assign from_v_o      = from_v_q;
  assign from_u_zero_o = from_u_zero_q;
  assign from_v_zero_o = from_v_zero_q;
  assign to_u_o        = to_u_q;
  assign to_v_o        = to_v_q;
  assign to_u_full_o   = to_u_full_q;
  assign to_v_zero_o   = to_v_zero_q;
  assign v_whole_o     = state_q == Steps ? v_whole_q : quotient_v + v_whole_q;
  assign v_rest_o      = state_q == Steps ? v_rest_q : remainder_v;
  assign u_whole_o     = state_q == Steps ? u_whole_q : quotient_u + u_whole_q;
  assign u_rest_o      = state_q == Steps ? u_rest_q : remainder_u;
  assign v_step_o      = quotient_v[C-1:0];
  assign v_step_rest_o = remainder_v;
  assign u_step_o      = quotient_u[C-1:0];
  assign u_step_rest_o = remainder_u;
  assign du_o          = du_q;
  assign dv_o          = dv_q;
endmodule

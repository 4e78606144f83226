// Span filler: the texels strictly between a triangle's outlines, with its plane's depth at their centres.
//
// Source:  3.3.3. Twin: ShadowUnit::fill_spans in model/unit/shadow_unit_pass1.cpp.
// Numbers: depths are inside the triangle, so that the plane's whole part modulo 2^DepthBits is the depth.
// Timing:  two texels a cycle; words leave with their last texel, their depths one cycle later, as plane_walk
//          gives them. It is led to the first texel of a gap from that of the gap before: one texel a cycle,
//          from the row below.
module span_filler #(
  localparam int unsigned D = shadow_pkg::DepthBits,
  localparam int unsigned M = shadow_pkg::MapBits,
  localparam int unsigned R = shadow_pkg::RowIndexBits,
  localparam int unsigned AreaBits = 2 * shadow_pkg::CoordBits,
  localparam int unsigned L = shadow_pkg::TexelsPerWord
) (
  input  logic                clk_i,
  input  logic                rst_ni,
  input  logic                clear_i,
  // plane_walk stands in an edge's first texel; the lowest one is gone on from
  input  logic                anchor_i,
  input  logic                first_i,     // of the triangle's first edge
  input  logic [R-1:0]        anchor_x_i,  // signed
  input  logic [R-1:0]        anchor_y_i,
  input  logic                start_i,      // visited_rows begins with the gaps, the first in a later cycle
  // gaps of visited_rows
  input  logic                gap_valid_i,
  output logic                gap_ready_o,
  input  logic [M-1:0]        gap_y_i,
  input  logic [M-1:0]        gap_from_i,
  input  logic [M-1:0]        gap_to_i,
  // plane_walk
  output logic                load_o,       // from here:
  output logic [D-1:0]        whole_o,
  output logic [AreaBits:0]   rest_o,
  output logic                move_x_o,     // one of both a cycle
  output logic                move_y_o,     // upwards
  output logic                back_o,
  output logic                two_o,        // along x by two
  input  logic [AreaBits:0]   rest_i,
  input  logic [D-1:0]        whole_i,      // of the texel where it stood in the cycle before,
  input  logic [D-1:0]        next_whole_i, // and one further along x
  // words
  output logic                word_valid_o,
  input  logic                ready_i,      // without it nothing moves, whether valid or not
  output logic [M-1:0]        x_o,
  output logic [M-1:0]        y_o,
  output logic [L*D-1:0]      depth_o,      // texel i at i * D; one cycle later
  output logic [L-1:0]        mask_o
);
  localparam int unsigned LaneBits = $clog2(L);
  logic [R-1:0]        anchor_x_q, anchor_y_q, x_q, y_q, x, y;
  logic [D-1:0]        anchor_whole_q;
  logic [AreaBits:0]   anchor_rest_q;
  logic                anchor_due_q;  // its whole part comes
  logic                reload_q;   // the ramp is elsewhere: at the anchor is where to go on from
  logic                in_gap_q;   // in the gap
  logic [L-1:0]        mask_q;

  logic at_row, at_from, at_to, in_gap, last, pair, step;
  logic [LaneBits-1:0] lane;
  assign x       = reload_q ? anchor_x_q : x_q;
  assign y       = reload_q ? anchor_y_q : y_q;
  assign at_row  = y == R'(gap_y_i);
  assign at_from = at_row && x == R'(gap_from_i);
  assign in_gap  = gap_valid_i && !reload_q && (in_gap_q || at_from);
  assign pair    = !x_q[0] && !at_to;  // both texels of an even and an odd column
  assign at_to   = x_q == R'(gap_to_i);
  assign last    = at_to || (pair && {x_q[R-1:1], 1'b1} == R'(gap_to_i));
  assign lane    = x_q[LaneBits-1:0];
  assign step    = ready_i && gap_valid_i;

  assign load_o   = step && reload_q;
  assign whole_o  = anchor_whole_q;
  assign rest_o   = anchor_rest_q;
  assign move_y_o = step && !in_gap && !at_row;
  assign move_x_o = step && (in_gap || (at_row && !at_from));
  assign two_o    = in_gap && pair;
  assign back_o   = move_x_o && !in_gap && $signed(x) > $signed(R'(gap_from_i));

  assign word_valid_o = in_gap && (last || (lane | LaneBits'(pair)) == LaneBits'(L - 1));
  assign gap_ready_o  = ready_i && in_gap && last;
  assign x_o = {x_q[M-1:LaneBits], {LaneBits{1'b0}}};
  assign y_o = y_q[M-1:0];
  // What goes to which lane. A word's last two texels leave as they come, or one alone as the gap ends.
  logic [L-1:0] here, next, next_q;
  logic [L-3:0] here_q;
  for (genvar i = 0; i < L; i++) begin : g_lane
    assign here[i] = in_gap && lane == LaneBits'(i);
    assign next[i] = in_gap && i % 2 == 1 && pair && (lane | LaneBits'(1)) == LaneBits'(i);
    if (i >= L - 2) begin : g_last
      assign depth_o[i*D +: D] = next_q[i] ? next_whole_i : whole_i;
    end else begin : g_kept
      logic [D-1:0] depth_q;
      assign depth_o[i*D +: D] = here_q[i] ? whole_i : next_q[i] ? next_whole_i : depth_q;
      always_ff @(posedge clk_i) if (ready_i) depth_q <= depth_o[i*D +: D];
    end
  end
  assign mask_o = here | next | mask_q;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      in_gap_q <= 1'b0;
      reload_q <= 1'b0;
      mask_q   <= '0;
    end else if (clear_i) begin
      in_gap_q <= 1'b0;
      reload_q <= 1'b0;
      mask_q   <= '0;
    end else begin
      if (start_i) reload_q <= 1'b1;
      else if (step) reload_q <= in_gap && last;
      if (step) in_gap_q <= in_gap && !last;
      if (step && in_gap) mask_q <= word_valid_o ? '0 : mask_o;
    end
  end
  logic anchor;  // here
  assign anchor = anchor_i ? first_i || $signed(anchor_y_i) < $signed(anchor_y_q) : step && in_gap && !in_gap_q;
  always_ff @(posedge clk_i) begin
    if (anchor) begin
      anchor_x_q    <= anchor_i ? anchor_x_i : x_q;
      anchor_y_q    <= anchor_i ? anchor_y_i : y_q;
      anchor_rest_q <= rest_i;
    end
    if (ready_i) begin
      anchor_due_q <= anchor;
      if (anchor_due_q) anchor_whole_q <= whole_i;
      here_q <= here[L-3:0];
      next_q <= next;
    end
    if (step) begin
      x_q <= !move_x_o ? x : back_o ? x - 1'b1 : x + (two_o ? R'(2) : R'(1));
      y_q <= move_y_o ? y + 1'b1 : y;
    end
  end
endmodule

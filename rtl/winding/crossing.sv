// What a point learns of a segment: what it adds to the winding number, and whether it is near.
//
// Twins:   model/unit/winding/segment.h, crossing
// Numbers: ends UQ1.G texel, place UQ0.26 texel; the cross product is exact. An end at or below the place is at or
//          below the place's upper G bits.
// Timing:  inputs of cycle n are answered in n + 2, one a cycle; no stalls.
module crossing (
  input  logic                               clk_i,
  input  logic                               valid_i,    // the segment exists; else adds nothing
  input  logic [shadow_pkg::SegmentBits-1:0] segment_i,  // segment_t
  input  logic [shadow_pkg::MaxFraction-1:0] x_i,
  input  logic [shadow_pkg::MaxFraction-1:0] y_i,
  input  logic                               boxed_i,    // of segment_box
  output logic signed [1:0]                  winding_o,  // -1, 0 or 1
  output logic                               near_o
);
  localparam int unsigned G = shadow_pkg::EndBits;
  localparam int unsigned E = shadow_pkg::EndWidth;
  localparam int unsigned Below = shadow_pkg::MaxFraction - G;  // bits of a place below those of an end
  localparam int unsigned OffsetBits = shadow_pkg::MaxFraction + 2;
  localparam int unsigned SideBits = OffsetBits + G + 2;

  /* verilator lint_off UNUSEDSIGNAL */  // who is inner matters to pass 1 alone
  shadow_pkg::segment_t s;
  /* verilator lint_on UNUSEDSIGNAL */
  assign s = segment_i;

  // 1: differences, and which half planes count
  logic signed [G+1:0]          dx, dy;
  logic [G:0]                   size_x, size_y;
  logic                         rises, above0, above1;  // y0, y1 is at or below the place
  logic signed [OffsetBits-1:0] px, py;                 // from end 0
  function automatic logic signed [OffsetBits-1:0] place_of(input logic [E-1:0] e);
    place_of = OffsetBits'(e) << Below;
  endfunction

  assign dx     = $signed({1'b0, s.x1}) - $signed({1'b0, s.x0});
  assign dy     = $signed({1'b0, s.y1}) - $signed({1'b0, s.y0});
  assign size_x = dx[G+1] ? (G+1)'(-dx) : (G+1)'(dx);
  assign size_y = dy[G+1] ? (G+1)'(-dy) : (G+1)'(dy);
  assign rises  = !dy[G+1] && dy != '0;
  assign above0 = s.y0 <= E'(y_i[Below+:G]);
  assign above1 = s.y1 <= E'(y_i[Below+:G]);
  assign px     = $signed(OffsetBits'(x_i)) - place_of(s.x0);
  assign py     = $signed(OffsetBits'(y_i)) - place_of(s.y0);

  logic signed [G+1:0]          dx_q, dy_q;
  logic signed [OffsetBits-1:0] px_q, py_q;
  logic [G+1:0]                 size_q, size2_q;
  logic rises_q, positive_q, border_q, level_q, boxed_q, crosses_q;
  always_ff @(posedge clk_i) begin
    dx_q       <= dx;
    dy_q       <= dy;
    px_q       <= px;
    py_q       <= py;
    size_q     <= (G+2)'(size_x) + (G+2)'(size_y);
    rises_q    <= rises;
    positive_q <= s.positive;
    crosses_q  <= s.crosses_left;
    border_q   <= valid_i && s.crosses_left && above0;
    level_q    <= valid_i && above0 != above1;  // rising: above0 alone; falling: above1 alone
    boxed_q    <= boxed_i;
  end

  // 2: the side of the segment that the place is on; > 0: left of 0-1
  logic signed [SideBits-1:0] side_q;
  logic rises2_q, positive2_q, border2_q, level2_q, boxed2_q, crosses2_q;
  always_ff @(posedge clk_i) begin
    side_q      <= dx_q * py_q - dy_q * px_q;
    size2_q     <= size_q;
    rises2_q    <= rises_q;
    positive2_q <= positive_q;
    crosses2_q  <= crosses_q;
    border2_q   <= border_q;
    level2_q    <= level_q;
    boxed2_q    <= boxed_q;
  end

  // 3: the answer
  logic signed [SideBits+1:0] twice, most, above, below;
  logic                       counts, against;
  assign counts    = level2_q && (side_q == '0 || side_q[SideBits-1] == rises2_q);
  // A crossing segment that rises has its inside right of it where the border has it below: it cancels
  // what the border counted. One that falls does not count there as well.
  assign against   = crosses2_q && rises2_q;
  assign winding_o = !(counts ? !against : border2_q) ? 2'sd0 : positive2_q ? 2'sd1 : -2'sd1;
  // Both bounds at once, rather than one after a negation.
  assign twice     = (SideBits + 2)'(side_q) <<< 1;
  assign most      = $signed((SideBits + 2)'(size2_q) << Below);
  assign above     = most - twice;
  assign below     = most + twice;
  assign near_o    = boxed2_q && !above[SideBits+1] && !below[SideBits+1];
endmodule

// Is a place within half a step of a segment's bounding box? If not, comparisons alone tell what the segment
// adds to the winding number, and it is not near; else it takes a cross product (crossing).
//
// Twins:   model/unit/winding/segment.h, crossing
// Numbers: ends UQ1.G texel, places rounded to them. A place level with a segment but not boxed lies beside
//          the box, half a step away or more, hence on a known side.
// Timing:  combinational.
module segment_box (
  input  logic                               valid_i,    // the segment exists; else adds nothing
  input  logic [shadow_pkg::SegmentBits-1:0] segment_i,  // segment_t
  input  logic [shadow_pkg::EndWidth-1:0]    x_up_i,     // rounded to nearest, ties up
  input  logic [shadow_pkg::EndWidth-1:0]    x_down_i,   // ties down
  input  logic [shadow_pkg::EndWidth-1:0]    y_up_i,
  input  logic [shadow_pkg::EndWidth-1:0]    y_down_i,
  input  logic [shadow_pkg::EndBits-1:0]     y_floor_i,  // cut
  output logic                               boxed_o,
  output logic signed [1:0]                  winding_o   // unless boxed: -1, 0 or 1
);
  localparam int unsigned E = shadow_pkg::EndWidth;

  /* verilator lint_off UNUSEDSIGNAL */  // who is inner matters to pass 1 alone
  shadow_pkg::segment_t s;
  /* verilator lint_on UNUSEDSIGNAL */
  logic         leftwards, falls, above0, above1, right, counts;
  logic [E-1:0] low_x, high_x, low_y, high_y;

  assign s         = segment_i;
  assign leftwards = s.x1 < s.x0;
  assign falls     = s.y1 < s.y0;
  assign low_x     = leftwards ? s.x1 : s.x0;
  assign high_x    = leftwards ? s.x0 : s.x1;
  assign low_y     = falls ? s.y1 : s.y0;
  assign high_y    = falls ? s.y0 : s.y1;
  assign right     = x_down_i > high_x;
  assign above0    = s.y0 <= E'(y_floor_i);
  assign above1    = s.y1 <= E'(y_floor_i);
  assign boxed_o   = valid_i && low_x <= x_up_i && !right && low_y <= y_up_i && y_down_i <= high_y;
  assign counts    = above0 != above1 && right;
  // Right of a segment that rises from the left border, what it adds there is cancelled.
  assign winding_o = !valid_i || !(counts ? falls || !s.crosses_left : s.crosses_left && above0) ? 2'sd0
                   : s.positive ? 2'sd1 : -2'sd1;
endmodule

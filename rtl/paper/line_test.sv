// Does a line's own half plane hold a point of its texel? (Tables 5 and 6, without the division)
// Twin:    ShadowDecision::contains in model/unit/shadow_decision.h.
// Numbers: the point is UQ1.PointBits, 0 to 1 inclusive; exact. d = minor - Fraction - Slope x
//          (major - Cross) in units of 2^-(PointBits + SlopeBits) texel; left of the line is d > 0
//          for (x, +) and (y, -), d < 0 for the two others.
// Timing:  combinational: one product of SlopeBits by PointBits + 2 bits.
module line_test #(
  parameter int unsigned PointBits = 26  // at least FractionBits
) (
  input  shadow_pkg::line_t    line_i,
  input  logic [PointBits:0]   x_i,   // Mx
  input  logic [PointBits:0]   nx_i,  // 1 - Mx
  input  logic [PointBits:0]   y_i,   // My
  output logic                 holds_o
);
  localparam int unsigned S = shadow_pkg::SlopeBits;
  localparam int unsigned F = shadow_pkg::FractionBits;
  localparam int unsigned D = PointBits + S + 3;  // d and its sign; |d| <= 3

  logic [PointBits:0] u, major, minor;
  logic [S-1:0]       crossed;  // Slope x Cross
  logic [D-1:0]       d;        // or d - 1
  logic               above_is_left;

  assign u       = line_i.x_positive ? x_i : nx_i;
  assign major   = line_i.x_major ? u : y_i;
  assign minor   = line_i.x_major ? y_i : u;
  assign crossed = line_i.slope & {S{line_i.cross_flag}};

  // d > 0 is d - 1 >= 0: one sign tells either question.
  assign above_is_left = line_i.x_major == line_i.x_positive;
  assign d = D'({minor, {S{1'b0}}}) + D'({crossed, {PointBits{1'b0}}})
             - D'({line_i.fraction, {(PointBits + S - F){1'b0}}})
             - D'(line_i.slope) * D'(major) - D'(above_is_left);
  assign holds_o       = line_i.left ^ above_is_left ^ d[D-1];

  logic unused_fields;
  assign unused_fields = ^{line_i.start_here, line_i.end_here, line_i.polygon};
endmodule

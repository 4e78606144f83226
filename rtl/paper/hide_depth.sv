// Does what covers a texel hide an entry there (hidden_removal)? Part of silhouette_buffer.
// Twin:    ShadowUnit::cover in model/unit/shadow_unit_pass1.cpp; Polygon::farthest.
// Numbers: depth is min(centre + rise, most) or the centre. It is below nearest if one of the two is: so
//          there is one sum of three, and no choice between sums.
// Timing:  combinational.
module hide_depth (
  input  logic                             farthest_i,  // not the depth at the centre
  input  logic [shadow_pkg::DepthBits-1:0] centre_i,
  input  logic [shadow_pkg::DepthBits-1:0] most_i,      // the triangle's
  input  logic [shadow_pkg::DepthBits:0]   rise_i,      // of its plane in half a texel
  input  logic [shadow_pkg::DepthBits-1:0] nearest_i,   // the entry's
  output logic                             hides_o
);
  localparam int unsigned W = shadow_pkg::DepthBits + 3;
  logic [W-1:0] centre, rise, less, sum, carry, beyond;  // beyond: centre + rise - nearest

  assign centre  = W'(centre_i);
  assign rise    = farthest_i ? W'(rise_i) : '0;
  assign less    = {3'b111, ~nearest_i};
  assign sum     = centre ^ rise ^ less;
  assign carry   = (centre & rise) | (centre & less) | (rise & less);
  assign beyond  = sum + {carry[W-2:0], 1'b1};
  assign hides_o = beyond[W-1] || (farthest_i && most_i < nearest_i);

  logic unused;
  assign unused = &{1'b0, carry[W-1], beyond[W-2:0]};
endmodule

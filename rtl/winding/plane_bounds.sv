// Nearest and farthest depth of a stored plane over its texel.
//
// Twins:   model/unit/winding/plane.h, ThresholdPlane::nearest and farthest
// Numbers: depth units, signed; without bounds -2^31 and 2^31 - 1, which compare as the golden -2^31 and 2^31 do.
// Timing:  combinational.
module plane_bounds (
  input  logic [shadow_pkg::BaseBits-1:0] base_i,
  input  logic                            steep_i,  // of plane_steepness
  input  logic [26:0]                     half_i,
  output logic [31:0]                     nearest_o,
  output logic [31:0]                     farthest_o
);
  logic [31:0] centre;
  assign centre = {base_i[shadow_pkg::BaseBits-1], base_i, {shadow_pkg::PlaneStepBits{1'b0}}};
  assign nearest_o  = steep_i ? 32'h8000_0000 : centre - {5'd0, half_i} - 32'd1;
  assign farthest_o = steep_i ? 32'h7fff_ffff : centre + {5'd0, half_i};
endmodule

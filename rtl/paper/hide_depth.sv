// The depth behind which what covers a texel hides its lines (hidden_removal). Part of silhouette_buffer.
// Twin:    ShadowUnit::cover in model/unit/shadow_unit_pass1.cpp; Polygon::farthest.
// Timing:  combinational.
module hide_depth (
  input  logic                             farthest_i,  // not the depth at the centre
  input  logic [shadow_pkg::DepthBits-1:0] centre_i,
  input  logic [shadow_pkg::DepthBits-1:0] most_i,      // the triangle's
  input  logic [shadow_pkg::DepthBits:0]   rise_i,      // of its plane in half a texel
  output logic [shadow_pkg::DepthBits-1:0] depth_o
);
  localparam int unsigned DepthBits = shadow_pkg::DepthBits;
  logic [DepthBits+1:0] risen;

  assign risen = (DepthBits + 2)'(centre_i) + (DepthBits + 2)'(rise_i);
  always_comb begin
    depth_o = centre_i;
    if (farthest_i) depth_o = risen > (DepthBits + 2)'(most_i) ? most_i : risen[DepthBits-1:0];
  end
endmodule

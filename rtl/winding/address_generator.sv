// Where a tile's word stands in the upper half of the texel memory, and the place of a fragment on the map.
//
// Twins:   model/unit/winding/texel_buffers.h (tile), shadow_unit_pass1.cpp (announce), shadow_unit_pass2.cpp (known)
// Timing:  combinational.
module address_generator (
  input  shadow_pkg::settings_t                  settings_i,
  input  shadow_pkg::frag_t                      frag_i,
  output logic                                   known_o,  // decided without the buffers: not announced
  output logic [shadow_pkg::MapBits-1:0]         frag_x_o, // texel on the map, unless known
  output logic [shadow_pkg::MapBits-1:0]         frag_y_o,
  input  logic [shadow_pkg::MapBits-1:0]         x_i,      // texel
  input  logic [shadow_pkg::MapBits-1:0]         y_i,
  output logic [2*(shadow_pkg::MapBits-3)-1:0]   tile_o
);
  localparam int unsigned M = shadow_pkg::MapBits;
  localparam int unsigned R = shadow_pkg::RowIndexBits;

  // From the map's corner; f is 16 at least.
  logic signed [R-1:0] x, y;
  /* verilator lint_off UNUSEDSIGNAL */  // copies of the sign
  logic signed [shadow_pkg::CoordBits-1:0] floor_x, floor_y;
  /* verilator lint_on UNUSEDSIGNAL */
  assign floor_x = $signed(frag_i.p.x) >>> settings_i.texel_bits;
  assign floor_y = $signed(frag_i.p.y) >>> settings_i.texel_bits;
  assign x = R'(floor_x) + R'(settings_i.map_width[M:1]);
  assign y = R'(floor_y) + R'(settings_i.map_height[M:1]);
  assign frag_x_o = x[M-1:0];
  assign frag_y_o = y[M-1:0];
  assign known_o = frag_i.averted || frag_i.outside
                   || x < 0 || y < 0 || x >= $signed(R'(settings_i.map_width)) || y >= $signed(R'(settings_i.map_height))
                   || (settings_i.skip_fragments && frag_i.unshadowable);
  assign tile_o = {y_i[M-1:3], x_i[M-1:3]};

  logic unused;
  assign unused = ^{frag_i.object, frag_i.p.z, settings_i, x_i[2:0], y_i[2:0]};
endmodule

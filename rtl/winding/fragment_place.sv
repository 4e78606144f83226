// Where a fragment lies: its texel on the map, and its place in it, for any number f of fraction bits.
//
// Twins:   model/unit/winding/shadow_unit_pass2.cpp, decide_one and read_texel
// Timing:  combinational.
module fragment_place (
  input  logic [4:0]                         texel_bits_i,  // f, 16 to 26
  input  logic [shadow_pkg::MapBits:0]       map_side_i,    // texels
  input  logic [shadow_pkg::CoordBits-1:0]   position_i,    // signed, units of 2^-f texel from the map's centre
  output logic                               on_map_o,
  output logic [shadow_pkg::MapBits-1:0]     texel_o,       // if on the map
  output logic [shadow_pkg::MaxFraction-1:0] place_o        // UQ0.26 texel
);
  localparam int unsigned Most = shadow_pkg::MaxFraction;
  localparam int unsigned Index = shadow_pkg::RowIndexBits;

  logic signed [Most+Index-1:0] aligned;
  logic signed [Index-1:0]      index;
  assign aligned  = (Most + Index)'($signed(position_i)) <<< (5'(Most) - texel_bits_i);
  assign index    = $signed(aligned[Most+:Index]) + $signed(Index'(map_side_i[shadow_pkg::MapBits:1]));
  assign on_map_o = !index[Index-1] && index < $signed(Index'(map_side_i));
  assign texel_o  = index[shadow_pkg::MapBits-1:0];
  assign place_o  = aligned[Most-1:0];
endmodule

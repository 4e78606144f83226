// Edge geometry: in which texel an end of an edge lies, and where in it, along one axis.
//
// Source:  3.3.1. Twin: Axis in model/unit/edge_setup.cpp.
// Numbers: texel indices count from the map's corner, off the map too.
// Timing:  combinational.
module edge_geometry (
  input  logic [4:0]                          texel_bits_i,  // f
  input  logic [shadow_pkg::MapBits:0]        map_size_i,    // texels
  input  logic [shadow_pkg::CoordBits-1:0]    coordinate_i,  // signed
  input  logic                                before_i,      // on a border it belongs to the texel below
  output logic [shadow_pkg::RowIndexBits-1:0] index_o,       // signed
  output logic [shadow_pkg::MaxFraction:0]    inside_o       // units from the texel's lower side, 0 to 2^f
);
  localparam int unsigned C = shadow_pkg::CoordBits;
  localparam int unsigned R = shadow_pkg::RowIndexBits;
  localparam int unsigned F = shadow_pkg::MaxFraction;
  logic signed [C-1:0] coordinate;
  logic [F:0]   texel, units;
  logic         border_before;
  logic [R-1:0] index;
  assign coordinate    = $signed(coordinate_i);
  assign texel         = (F + 1)'(1) << texel_bits_i;
  assign units         = coordinate[F:0] & (texel - 1'b1);
  assign border_before = before_i && units == '0;
  assign index         = R'(coordinate >>> texel_bits_i);
  assign index_o       = index + R'(map_size_i[shadow_pkg::MapBits:1]) - R'(border_before);
  assign inside_o      = border_before ? texel : units;
  logic unused;
  assign unused = &{1'b0, map_size_i[0]};
endmodule

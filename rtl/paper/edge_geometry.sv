// Edge geometry: direction, axes and texels of one edge of a triangle.
//
// Source:  3.3.1. Twin: the first half of setup_edge in model/unit/edge_setup.cpp.
// Numbers: an edge goes up along y, a horizontal one up along x. Texel indices count from the map's
//          corner, off the map too. "into": units from a texel's side to the start, as the walk goes.
// Timing:  combinational, in three stages: the direction comes back through a register, then the axes.
module edge_geometry (
  input  logic [4:0]                          texel_bits_i,  // f
  input  logic [shadow_pkg::MapBits:0]        map_width_i,
  input  logic [shadow_pkg::MapBits:0]        map_height_i,
  input  shadow_pkg::point_t                  a_i,  // the edge is a to b
  input  shadow_pkg::point_t                  b_i,
  output logic                                swap_o,        // it goes from b to a
  input  logic                                swap_i,
  output logic                                x_major_o,
  output logic                                x_positive_o,
  input  logic                                x_major_i,
  input  logic                                x_positive_i,
  input  logic                                rises_i,       // rise > 0
  output logic [shadow_pkg::RowIndexBits-1:0] first_x_o,     // signed, as the next three
  output logic [shadow_pkg::RowIndexBits-1:0] first_y_o,
  output logic [shadow_pkg::RowIndexBits-1:0] last_x_o,
  output logic [shadow_pkg::RowIndexBits-1:0] last_y_o,
  output logic [shadow_pkg::MaxFraction:0]    start_x_o,     // units from the first texel's left side, 0 to 2^f
  output logic [shadow_pkg::MaxFraction:0]    start_y_o,     // and from its lower side
  output logic [shadow_pkg::MaxFraction:0]    into_major_o,  // below 2^f
  output logic [shadow_pkg::MaxFraction:0]    into_minor_o,
  output logic [shadow_pkg::CoordBits-1:0]    length_o,      // along the major axis
  output logic [shadow_pkg::CoordBits-1:0]    rise_o,        // along the minor one
  output logic [shadow_pkg::DepthBits-1:0]    first_depth_o,
  output logic [shadow_pkg::DepthBits-1:0]    last_depth_o
);
  localparam int unsigned C = shadow_pkg::CoordBits;
  localparam int unsigned R = shadow_pkg::RowIndexBits;
  localparam int unsigned F = shadow_pkg::MaxFraction;
  localparam int unsigned D = shadow_pkg::DepthBits;

  // Places in the order of an edge's direction.
  logic [2*C-1:0] a_order, b_order;
  assign a_order        = {!a_i.y[C-1], a_i.y[C-2:0], !a_i.x[C-1], a_i.x[C-2:0]};
  assign b_order        = {!b_i.y[C-1], b_i.y[C-2:0], !b_i.x[C-1], b_i.x[C-2:0]};
  assign swap_o   = b_order < a_order;

  logic signed [C-1:0] from_x, from_y, to_x, to_y;
  assign from_x = swap_i ? b_i.x : a_i.x;
  assign from_y = swap_i ? b_i.y : a_i.y;
  assign to_x   = swap_i ? a_i.x : b_i.x;
  assign to_y   = swap_i ? a_i.y : b_i.y;
  assign first_depth_o = swap_i ? b_i.z[shadow_pkg::TraceDepthBits-1 -: D] : a_i.z[shadow_pkg::TraceDepthBits-1 -: D];
  assign last_depth_o  = swap_i ? a_i.z[shadow_pkg::TraceDepthBits-1 -: D] : b_i.z[shadow_pkg::TraceDepthBits-1 -: D];

  logic [C:0]   dx;  // signed
  logic [C-1:0] extent_x, extent_y;
  assign dx           = {to_x[C-1], to_x} - {from_x[C-1], from_x};
  assign x_positive_o = !dx[C];
  assign extent_x     = dx[C] ? from_x - to_x : dx[C-1:0];
  assign extent_y     = to_y - from_y;  // at least 0
  assign x_major_o    = extent_x > extent_y;
  assign length_o     = x_major_o ? extent_x : extent_y;
  assign rise_o       = x_major_o ? extent_y : extent_x;

  // An end on a border belongs to the texel before it, a start to the one after; on an axis without
  // extent both do to the one after.
  logic [F:0]   texel, below;
  logic [F:0]   x_in, y_in;  // units above the border below the start
  logic         from_x_border, to_x_border, to_y_border;
  logic [R-1:0] centre_x, centre_y;
  assign texel         = (F + 1)'(1) << texel_bits_i;
  assign below         = texel - 1'b1;
  assign x_in          = from_x[F:0] & below;
  assign y_in          = from_y[F:0] & below;
  assign from_x_border = x_in == '0;
  assign to_x_border   = (to_x[F:0] & below) == '0;
  assign to_y_border   = (to_y[F:0] & below) == '0;
  assign centre_x      = R'(map_width_i[shadow_pkg::MapBits:1]);
  assign centre_y      = R'(map_height_i[shadow_pkg::MapBits:1]);

  logic [R-1:0] from_x_index, from_y_index, to_x_index, to_y_index;
  assign from_x_index = R'(from_x >>> texel_bits_i);
  assign from_y_index = R'(from_y >>> texel_bits_i);
  assign to_x_index   = R'(to_x >>> texel_bits_i);
  assign to_y_index   = R'(to_y >>> texel_bits_i);
  assign first_x_o = from_x_index + centre_x - R'(!x_positive_i && from_x_border);
  assign first_y_o = from_y_index + centre_y;
  assign last_x_o  = to_x_index + centre_x - R'(x_positive_i && (x_major_i || rises_i) && to_x_border);
  assign last_y_o  = to_y_index + centre_y - R'((!x_major_i || rises_i) && to_y_border);

  logic [F:0] into_x;
  assign into_x       = x_positive_i ? x_in : (texel - x_in) & below;
  assign into_major_o = x_major_i ? into_x : y_in;
  assign into_minor_o = x_major_i ? y_in : into_x;
  assign start_x_o    = !x_positive_i && from_x_border ? texel : x_in;
  assign start_y_o    = y_in;

  logic unused;
  assign unused = &{1'b0, a_i.z, b_i.z, map_width_i[0], map_height_i[0]};
endmodule

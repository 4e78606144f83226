// Walk's place: a texel of the map, with the corner functions and the depth of the triangle there.
//
// Twins:   CornerFunctions and the ramp of model/unit/winding/shadow_unit_pass1.cpp
// Timing:  a step a cycle, along x or y; from load_i on in the texel of the triangle's lowest vertex, which is there
//          a cycle after the vertices are.
module walk_place #(
  localparam int unsigned C     = shadow_pkg::CoordBits,
  localparam int unsigned T     = shadow_pkg::RowIndexBits,
  localparam int unsigned Depth = shadow_pkg::DepthRange,
  localparam int unsigned M     = shadow_pkg::MapBits,
  localparam int unsigned D     = 57,
  localparam int unsigned K     = 42
) (
  input  logic               clk_i,
  input  logic [3:0]         texel_bits_i,  // f - 16
  input  logic [M:0]         map_width_i,
  input  logic [M:0]         map_height_i,
  // the triangle, as plane_setup has it
  input  logic [6*C-1:0]     vertices_i,
  input  logic [2:0]         upward_i,
  input  logic [3*(C+1)-1:0] edge_dx_i,
  input  logic [3*(C+1)-1:0] edge_dy_i,
  input  logic               clockwise_i,
  input  logic [3*K-1:0]     corners_i,
  input  logic [2:0]         inexact_i,
  input  logic [Depth-1:0]   start_i,
  input  logic [D-1:0]       start_rest_i,
  input  logic [Depth-1:0]   step_x_i,
  input  logic [D-1:0]       step_x_rest_i,
  input  logic [Depth-1:0]   step_y_i,
  input  logic [D-1:0]       step_y_rest_i,
  input  logic [D-1:0]       base_i,
  // steps of the walk
  input  logic               load_i,        // with a step: from the lowest vertex
  input  logic               move_x_i,
  input  logic               move_y_i,
  input  logic               along_y_i,     // the way of the step, and
  input  logic               back_i,        //   to -x, if there is one
  // the depth alone goes with the spans
  input  logic               filling_i,
  input  logic               fill_load_i,
  input  logic               fill_x_i,
  input  logic               fill_y_i,
  input  logic               fill_back_i,
  input  logic [Depth-1:0]   fill_step_i,
  input  logic [D-1:0]       fill_step_rest_i,
  output logic [T-1:0]       centre_x_o,    // of the map: where the origin is
  output logic [T-1:0]       centre_y_o,
  output logic [T-1:0]       low_x_o,       // texel of the lowest vertex
  output logic [T-1:0]       low_y_o,
  output logic [T-1:0]       x_o,
  output logic [T-1:0]       y_o,
  output logic               covers_o,      // the triangle covers the texel's corner
  output logic [Depth-1:0]   depth_o,
  output logic [D-1:0]       rest_o,
  output logic               on_map_o,
  output logic               row_on_map_o
);
  logic [1:0]   low;  // the lowest vertex
  logic [T-1:0] low_vertex_x, low_vertex_y;  // units of 2^16: f is 16 at least
  logic [T-1:0] from_x, from_y, next_x, next_y;
  assign low        = upward_i[0] && !upward_i[2] ? 2'd0 : upward_i[1] && !upward_i[0] ? 2'd1 : 2'd2;
  assign centre_x_o = T'(map_width_i[M:1]);
  assign centre_y_o = T'(map_height_i[M:1]);
  assign low_vertex_x = T'($signed(vertices_i[2*low*C+16 +: C-16]));
  assign low_vertex_y = T'($signed(vertices_i[2*low*C+C+16 +: C-16]));
  assign from_x = load_i ? low_x_o : x_o;
  assign from_y = load_i ? low_y_o : y_o;
  assign next_x = from_x + {{(T-1){back_i}}, 1'b1};
  assign next_y = from_y + 1'b1;
  always_ff @(posedge clk_i) begin
    low_x_o <= T'($signed(low_vertex_x) >>> texel_bits_i) + centre_x_o;
    low_y_o <= T'($signed(low_vertex_y) >>> texel_bits_i) + centre_y_o;
    x_o <= move_x_i ? next_x : from_x;
    y_o <= move_y_i ? next_y : from_y;
  end
  assign row_on_map_o = y_o < T'(map_height_i);
  assign on_map_o     = x_o < T'(map_width_i) && row_on_map_o;

  corner_functions #(.DeltaBits(C + 1), .Bits(K), .Diagonal(1'b0)) corner (
    .clk_i, .restart_i(load_i), .start_i(corners_i), .inexact_i, .dx_i(edge_dx_i), .dy_i(edge_dy_i),
    .clockwise_i, .move_x_i, .back_i, .move_y_i, .inside_o(covers_o));
  plane_ramp #(.WholeBits(Depth), .RestBits(D)) ramp (
    .clk_i, .load_i(filling_i ? fill_load_i : load_i), .whole_i(start_i), .rest_i(start_rest_i),
    .move_i(filling_i ? fill_x_i || fill_y_i : move_x_i || move_y_i), .along_y_i(filling_i ? fill_y_i : along_y_i),
    .back_i(filling_i ? fill_back_i : back_i),
    .x_whole_i(filling_i ? fill_step_i : step_x_i), .x_rest_i(filling_i ? fill_step_rest_i : step_x_rest_i),
    .y_whole_i(step_y_i), .y_rest_i(step_y_rest_i), .base_i, .whole_o(depth_o), .rest_o);
endmodule

// Plane's longest edge, and the vertex that a triangle's plane goes out from: the first one, or, of a narrow triangle,
// that of the longest edge.
//
// Twin:    FacetPlane in model/unit/winding/plane.cpp, narrow triangles.
// Numbers: as plane_setup. Of equally long edges the one opposite to the vertex that is last by x, y, z; or first.
// Timing:  commands of cycle n show in n + 1.
module plane_longest #(
  localparam int unsigned C = shadow_pkg::CoordBits,
  localparam int unsigned Z = shadow_pkg::TraceDepthBits,
  localparam int unsigned D = 57
) (
  input  logic           clk_i,
  // the triangle
  input  logic [6*C-1:0] vertices_i,
  input  logic [3*Z-1:0] depths_i,
  input  logic [2:0]     precedes_i,   // vertex i is before i + 1 by x, y, z
  // squares of lengths, of edge 0, 1, 2
  input  logic           length_i,
  input  logic [1:0]     index_i,
  input  logic [D-1:0]   sum_i,
  input  logic           along_i,      // in place of the square: where the third vertex is along the edge
  output logic [1:0]     longest_o,    // edge
  output logic [D-1:0]   best_o,       // its square, or what took its place
  // the plane's origin
  input  logic           first_i,      // the first vertex
  input  logic           flat_i,       // the highest vertex's depth, everywhere
  input  logic           edge_i,       // the longest edge's
  input  logic           third_due_i,  // as far as the third vertex, if that lies beyond the edge beside it:
  input  logic [Z+2:0]   carry_i,      //   how much is nearer at the vertex than there, a cycle ahead
  output logic [C-1:0]   origin_x_o,
  output logic [C-1:0]   origin_y_o,
  output logic [Z+2:0]   origin_z_o
);
  logic [Z-1:0] vz[3];
  logic [1:0]   rank, best_rank_q, longest_back;  // longest_back: the edge before it
  logic [2:0]   opposite_last, opposite_first;
  logic [Z-1:0] highest_01, highest;
  logic [Z+2:0] third_z_q;
  logic         longer;
  logic [1:0]   origin;
  for (genvar i = 0; i < 3; i++) begin : g_vertex
    assign vz[i]             = depths_i[i*Z +: Z];
    assign opposite_last[i]  = precedes_i[(i+1)%3] && !precedes_i[(i+2)%3];
    assign opposite_first[i] = !precedes_i[(i+1)%3] && precedes_i[(i+2)%3];
  end
  assign rank = opposite_last[index_i] ? 2'd0 : opposite_first[index_i] ? 2'd1 : 2'd2;
  assign longer = index_i == 2'd0 || sum_i > best_o || (sum_i == best_o && rank < best_rank_q);
  assign longest_back = longest_o == 2'd0 ? 2'd2 : longest_o - 2'd1;
  assign origin     = first_i ? 2'd0 : longest_o;
  assign highest_01 = vz[0] > vz[1] ? vz[0] : vz[1];
  assign highest    = highest_01 > vz[2] ? highest_01 : vz[2];
  always_ff @(posedge clk_i) begin
    if (length_i && longer) begin
      best_o      <= sum_i;
      best_rank_q <= rank;
      longest_o   <= index_i;
    end else if (along_i) begin
      best_o      <= sum_i;
    end
    third_z_q <= {3'b0, vz[longest_back]} - carry_i;
    if (first_i || (edge_i && !flat_i)) begin
      origin_x_o <= vertices_i[2*origin*C +: C];
      origin_y_o <= vertices_i[2*origin*C+C +: C];
    end
    if (first_i) origin_z_o <= {3'b0, vz[0]};
    else if (flat_i) origin_z_o <= {3'b0, highest};
    else if (edge_i) origin_z_o <= {3'b0, vz[longest_o]};
    else if (third_due_i && $signed(third_z_q) > $signed(origin_z_o)) origin_z_o <= third_z_q;
  end
endmodule

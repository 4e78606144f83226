// Plane triangle: the triangle that is set up, its edges and their order.
//
// Timing:  taken in cycle n, one edge's difference a cycle from n + 1 on; order from n + 4 on, the lowest vertex
//          from n + 5 on.
module plane_triangle #(
  localparam int unsigned C = shadow_pkg::CoordBits,
  localparam int unsigned Z = shadow_pkg::TraceDepthBits
) (
  input  logic             clk_i,
  input  logic             take_i,
  /* verilator lint_off UNUSEDSIGNAL */ // the polygon's number is the paper profile's
  input  shadow_pkg::tri_t tri_i,
  /* verilator lint_on UNUSEDSIGNAL */
  input  logic             differences_i,  // in each cycle after that until they are done
  output logic             last_o,         // of the differences
  output logic             is_plane_o,     // as in tri_t
  output logic             shares_o,
  output logic [2:0]       inner_o,
  output logic [shadow_pkg::IdBits-1:0] object_o,
  output logic [6*C-1:0]   vertices_o,     // x, y of vertex i at 2 i C and (2 i + 1) C
  output logic [3*Z-1:0]   depths_o,       // vertex i at i Z
  // edge i to i + 1, signed
  output logic [3*C+2:0]   edge_x_o,
  output logic [3*C+2:0]   edge_y_o,
  output logic [3*Z+2:0]   edge_z_o,
  output logic [2:0]       up_o,           // vertex i is before i + 1: by y, x;
  output logic [2:0]       precedes_o,     // by x, y, z
  output logic [C-1:0]     low_x_o,        // lowest vertex
  output logic [C-1:0]     low_y_o
);
  shadow_pkg::point_t v0_q, v1_q, v2_q;
  logic [1:0]   index_q, next_index;  // of the vertex whose edge is worked out
  logic [C-1:0] vx[3], vy[3];
  logic [Z-1:0] vz[3];
  assign {vx[0], vy[0], vz[0]} = v0_q;
  assign {vx[1], vy[1], vz[1]} = v1_q;
  assign {vx[2], vy[2], vz[2]} = v2_q;
  assign next_index = index_q == 2'd2 ? 2'd0 : index_q + 2'd1;
  assign last_o     = index_q == 2'd2;
  assign vertices_o = {vy[2], vx[2], vy[1], vx[1], vy[0], vx[0]};
  assign depths_o   = {vz[2], vz[1], vz[0]};
  always_ff @(posedge clk_i) begin
    if (take_i) begin
      is_plane_o <= tri_i.is_plane;
      shares_o   <= tri_i.shares;
      inner_o    <= tri_i.inner;
      object_o   <= tri_i.object[shadow_pkg::IdBits-1:0];
      v0_q       <= tri_i.v0;
      v1_q       <= tri_i.v1;
      v2_q       <= tri_i.v2;
      index_q    <= 2'd0;
    end else if (differences_i) begin
      index_q <= next_index;
    end
    // Vectors: synthesis would round an array up to four words.
    for (int i = 0; i < 3; i++) begin
      if (differences_i && index_q == 2'(i)) begin
        edge_x_o[i*(C+1) +: C+1] <= {vx[next_index][C-1], vx[next_index]} - {vx[index_q][C-1], vx[index_q]};
        edge_y_o[i*(C+1) +: C+1] <= {vy[next_index][C-1], vy[next_index]} - {vy[index_q][C-1], vy[index_q]};
        edge_z_o[i*(Z+1) +: Z+1] <= {1'b0, vz[next_index]} - {1'b0, vz[index_q]};
      end
    end
  end

  for (genvar i = 0; i < 3; i++) begin : g_order
    logic [C:0] ex, ey;
    assign ex            = edge_x_o[i*(C+1) +: C+1];
    assign ey            = edge_y_o[i*(C+1) +: C+1];
    assign up_o[i]       = ey == '0 ? !ex[C] : !ey[C];
    assign precedes_o[i] = ex != '0 ? !ex[C] : ey != '0 ? !ey[C] : !edge_z_o[i*(Z+1)+Z];
  end
  logic [1:0] low_q;
  always_ff @(posedge clk_i) low_q <= up_o[0] && !up_o[2] ? 2'd0 : up_o[1] && !up_o[0] ? 2'd1 : 2'd2;
  assign low_x_o = vx[low_q];
  assign low_y_o = vy[low_q];
endmodule

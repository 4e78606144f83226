// Edge order: which edge of a triangle is set up next. Walked ones come first, then those that are only passed.
//
// Twin:    ShadowUnit::draw in model/unit/winding/shadow_unit_pass1.cpp, order of the edges.
// Timing:  the first edge a cycle after begin_i, another one from the cycle of load_i on.
module edge_order (
  input  logic       clk_i,
  input  logic       rst_ni,
  input  logic       clear_i,
  input  logic       begin_i,        // a triangle, whose edges hold from now on
  input  logic [2:0] passes_i,       // edges that are not walked
  input  logic [2:0] upward_i,       // edge i to i + 1 is travelled that way
  input  logic       load_i,         // the walker takes the edge
  output logic       valid_o,        // the edge is being set up, or was
  output logic [1:0] edge_o,
  output logic       passes_o,
  output logic [1:0] from_vertex_o,
  output logic [1:0] to_vertex_o,
  output logic       none_left_o
);
  logic [2:0] to_walk_q, to_pass_q, left;  // edges that are still to be set up
  logic [1:0] chosen, edge_q, edge_next;
  logic       choose, busy_q, passes_q;
  assign left          = to_walk_q != '0 ? to_walk_q : to_pass_q;
  assign chosen        = left[0] ? 2'd0 : left[1] ? 2'd1 : 2'd2;
  assign choose        = left != '0 && (!busy_q || load_i);
  assign edge_next     = edge_q == 2'd2 ? 2'd0 : edge_q + 2'd1;
  assign valid_o       = busy_q;
  assign edge_o        = edge_q;
  assign passes_o      = passes_q;
  assign from_vertex_o = upward_i[edge_q] ? edge_q : edge_next;
  assign to_vertex_o   = upward_i[edge_q] ? edge_next : edge_q;
  assign none_left_o   = left == '0 && !busy_q;
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      to_walk_q <= '0;
      to_pass_q <= '0;
      busy_q    <= 1'b0;
    end else if (clear_i) begin
      to_walk_q <= '0;
      to_pass_q <= '0;
      busy_q    <= 1'b0;
    end else if (begin_i) begin
      to_walk_q <= ~passes_i;
      to_pass_q <= passes_i;
    end else begin
      if (choose) begin
        to_walk_q[chosen] <= 1'b0;
        if (to_walk_q == '0) to_pass_q[chosen] <= 1'b0;
      end
      busy_q <= choose || (busy_q && !load_i);
    end
  end
  always_ff @(posedge clk_i) begin
    if (choose) begin
      edge_q   <= chosen;
      passes_q <= to_walk_q == '0;
    end
  end
endmodule

// Plane's stages: where the sums that are on their way go, and whose turn it is: plane_setup's or edge_setup's.
//
// Timing:  a sum whose last product is issued in cycle n is there in n + 4.
module plane_stages (
  input  logic       clk_i,
  input  logic       rst_ni,
  input  logic       clear_i,
  input  logic       flush_i,       // what is on its way goes nowhere
  input  logic       issue_i,       // the last product of a sum of plane_setup
  input  logic [3:0] to_i,
  input  logic [1:0] index_i,
  output logic [3:0] to_o,          // the sum of this cycle; 0: none
  output logic [1:0] index_o,
  output logic       in_flight_o,
  // products of edge_setup, of two digits
  input  logic       edge_valid_i,
  input  logic       edge_may_i,    // begin
  output logic       edge_issue_o,
  output logic       edge_digit_o,
  output logic       edge_done_o
);
  localparam logic [3:0] None = 4'd0, Edge = 4'd9;
  logic [3:0] to_next, to1_q, to2_q, to3_q, to_q;
  logic [1:0] index1_q, index2_q, index3_q, index_q;
  logic       edge_digit_q, edge_waits_q;  // which digit; its product is on the way
  assign edge_issue_o = edge_valid_i && !edge_waits_q && (edge_digit_q || edge_may_i);
  assign edge_digit_o = edge_digit_q;
  assign edge_done_o  = to_q == Edge;
  assign to_next      = issue_i ? to_i : edge_issue_o && edge_digit_q ? Edge : None;
  assign to_o         = to_q;
  assign index_o      = index_q;
  assign in_flight_o  = to1_q != None || to2_q != None || to3_q != None || to_q != None;
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      {to1_q, to2_q, to3_q, to_q} <= {4{None}};
      edge_digit_q <= 1'b0;
      edge_waits_q <= 1'b0;
    end else if (clear_i) begin
      {to1_q, to2_q, to3_q, to_q} <= {4{None}};
      edge_digit_q <= 1'b0;
      edge_waits_q <= 1'b0;
    end else begin
      {to1_q, to2_q, to3_q, to_q} <= flush_i ? {4{None}} : {to_next, to1_q, to2_q, to3_q};
      edge_digit_q <= edge_issue_o && !edge_digit_q;
      edge_waits_q <= (edge_issue_o && edge_digit_q) || (edge_waits_q && !edge_done_o);
    end
  end
  always_ff @(posedge clk_i) {index1_q, index2_q, index3_q, index_q} <= {index_i, index1_q, index2_q, index3_q};
endmodule

// Depth ramp: an edge's depth at its next border along one axis.
//
// Twin:    EdgeSetup::major_depth and minor_depth in model/unit/edge_setup.h.
// Numbers: depth = whole + rest / base; kept of the rest, and steps: as in plane_walk. The rest is one step ahead,
//          so that the carry of the next one is there.
// Timing:  load or advance in cycle n, the new depth in n + 1; between a load and the first advance, once ahead.
module depth_ramp #(
  localparam int unsigned D = shadow_pkg::DepthBits,
  localparam int unsigned C = shadow_pkg::CoordBits
) (
  input  logic         clk_i,
  input  logic         load_i,
  input  logic [D:0]   whole_i,       // at the first border; wraps where no border is crossed
  input  logic [C:0]   rest_i,        // as kept
  input  logic [D-1:0] step_whole_i,  // taken with the load, as the next
  input  logic [C-1:0] step_rest_i,
  input  logic         less_i,        // the depth falls; constant from the cycle after the load to the next one
  input  logic [C-1:0] base_i,        // as this
  input  logic         ahead_i,
  input  logic         advance_i,
  output logic [D:0]   whole_o
);
  logic [D:0]   whole_q;
  logic [D-1:0] step_whole_q;
  logic [C-1:0] step_rest_q;
  logic [C:0]   rest_q, step, base, major, sum;
  assign step  = {1'b0, step_rest_q} ^ {(C+1){less_i}};
  assign base  = ({1'b0, base_i} ^ {(C+1){!less_i}}) & {(C+1){less_i == rest_q[C]}};
  assign major = (rest_q & step) | (rest_q & base) | (step & base);
  assign sum   = (rest_q ^ step ^ base) + {major[C-1:0], 1'b0} + (C+1)'(!less_i && !rest_q[C]);
  always_ff @(posedge clk_i) begin
    if (load_i) begin
      whole_q      <= whole_i;
      rest_q       <= rest_i;
      step_whole_q <= step_whole_i;
      step_rest_q  <= step_rest_i;
    end else if (ahead_i || advance_i) begin
      rest_q <= sum;
      if (advance_i) whole_q <= whole_q + ({1'b0, step_whole_q} ^ {(D+1){less_i}}) + (D+1)'(!rest_q[C]);
    end
  end
  assign whole_o = whole_q;
  logic unused;
  assign unused = &{1'b0, major[C]};
endmodule

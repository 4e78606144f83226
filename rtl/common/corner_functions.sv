// Corner functions: does a triangle cover the lower left corner of the texel that a walk stands in?
//
// Twin:    Polygon::covers_corner in model/unit/span_filler.h.
// Numbers: function i at (x, y) is dx (y - y_i) - dy (x - x_i), dx and dy those of edge i to i + 1. Corners
//          lie 2^f apart, so that a step of the walk adds dx or -dy, times 2^f: the f lowest bits never
//          change. What is kept is floor(function / 2^f), and whether the lowest bits are all 0.
//          The vertices go round as the triangle has them; clockwise ones have all signs inverted.
// Timing:  restart and move in cycle n, inside_o of the new texel in n + 1. A restart may move at once.
module corner_functions #(
  parameter int unsigned DeltaBits = 29,  // of dx and dy, signed
  parameter int unsigned Bits      = 42,  // of what is kept, signed
  parameter bit          Diagonal  = 1'b1 // x and y may move in the same cycle
) (
  input  logic                   clk_i,
  input  logic                   restart_i,    // take start_i instead of the present value
  input  logic [3*Bits-1:0]      start_i,      // function i at i * Bits, divided by 2^f, rounded down
  input  logic [2:0]             inexact_i,    // bit i: that division had a rest; constant
  input  logic [3*DeltaBits-1:0] dx_i,         // constant while the walk goes on, as all below
  input  logic [3*DeltaBits-1:0] dy_i,
  input  logic                   clockwise_i,  // the triangle's area is negative
  input  logic                   move_x_i,     // one texel along x: up,
  input  logic                   back_i,       // or down
  input  logic                   move_y_i,     // one texel up along y
  output logic                   inside_o      // the corner is covered
);
  logic [2:0] holds;
  assign inside_o = holds == 3'b111;

  for (genvar i = 0; i < 3; i++) begin : g_edge
    logic [DeltaBits-1:0] dx, dy;
    logic [Bits-1:0]      value_q, from, along_x, along_y, sum;
    logic                 zero, tie, negative;
    assign dx = dx_i[i*DeltaBits +: DeltaBits];
    assign dy = dy_i[i*DeltaBits +: DeltaBits];

    assign from    = restart_i ? start_i[i*Bits +: Bits] : value_q;
    assign along_x = {{(Bits-DeltaBits){dy[DeltaBits-1]}}, dy} ^ {Bits{!back_i}};  // -dy: + 1 below
    assign along_y = {{(Bits-DeltaBits){dx[DeltaBits-1]}}, dx};
    if (Diagonal) begin : g_diagonal
      assign sum = from + (along_x & {Bits{move_x_i}}) + (along_y & {Bits{move_y_i}})
                 + {{(Bits-1){1'b0}}, move_x_i && !back_i};
    end else begin : g_straight
      assign sum = from + (move_x_i ? along_x : along_y & {Bits{move_y_i}})
                 + {{(Bits-1){1'b0}}, move_x_i && !back_i};
    end
    always_ff @(posedge clk_i) value_q <= sum;

    // On the line: the corner moved by (+e^2, +e).
    assign tie       = (dx == '0 ? dy[DeltaBits-1] : !dx[DeltaBits-1]) ^ clockwise_i;
    assign negative  = value_q[Bits-1];
    assign zero      = value_q == '0 && !inexact_i[i];
    assign holds[i] = zero ? tie : negative == clockwise_i;
  end
endmodule

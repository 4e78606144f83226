// Plane ramp: a plane's value at texel centres, exact, moved by a texel along x or y a cycle.
//
// Twins:   ExactRamp in model/unit/fixed.h, Polygon::centre_ramp in model/unit/span_filler.h.
// Numbers: value = whole + rest / base, 0 <= rest < base; so are the steps for one texel up along x and y.
//          whole wraps: it is right wherever the true one fits WholeBits, whatever lies between.
// Timing:  load and move in cycle n, whole_o and rest_o of the new texel in n + 1. A load may move at once.
module plane_ramp #(
  parameter int unsigned WholeBits = 81,  // signed
  parameter int unsigned RestBits  = 56
) (
  input  logic                 clk_i,
  input  logic                 load_i,     // take the start instead of the present value
  input  logic [WholeBits-1:0] whole_i,    // start
  input  logic [RestBits-1:0]  rest_i,
  input  logic                 move_i,     // by one texel; may come late
  input  logic                 along_y_i,  // not along x
  input  logic                 back_i,     // down instead of up
  input  logic [WholeBits-1:0] x_whole_i,  // steps, and base; constant between a load and the last move
  input  logic [RestBits-1:0]  x_rest_i,
  input  logic [WholeBits-1:0] y_whole_i,
  input  logic [RestBits-1:0]  y_rest_i,
  input  logic [RestBits-1:0]  base_i,
  output logic [WholeBits-1:0] whole_o,
  output logic [RestBits-1:0]  rest_o
);
  logic [WholeBits-1:0] whole_q, from_whole, step_whole, up, up_one;
  logic [RestBits-1:0]  rest_q, from_rest, step_rest;
  logic [RestBits+1:0]  from, step, base, carries, sum, wrapped;  // signed
  logic                 wraps;

  assign from_whole = load_i ? whole_i : whole_q;
  assign from_rest  = load_i ? rest_i : rest_q;
  assign step_whole = (along_y_i ? y_whole_i : x_whole_i) ^ {WholeBits{back_i}};
  assign step_rest  = along_y_i ? y_rest_i : x_rest_i;

  // Up: + step, and - base where that wraps; down: - step, and + base. Both sums side by side; of the longer
  // one, where one of the two is inverted, the lowest carry is the 1 that this lacks.
  assign from    = {2'b0, from_rest};
  assign step    = {2'b0, step_rest} ^ {(RestBits+2){back_i}};
  assign base    = {2'b0, base_i} ^ {(RestBits+2){!back_i}};
  assign sum     = from + step + (RestBits+2)'(back_i);
  assign carries = (from & step) | (from & base) | (step & base);
  assign wrapped = (from ^ step ^ base) + {carries[RestBits:0], 1'b1};
  assign wraps   = back_i ? sum[RestBits+1] : !wrapped[RestBits+1];
  logic unused;
  assign unused = &{1'b0, carries[RestBits+1]};

  // Down adds ~step and 1, less the borrow; both sums are there before wraps is.
  assign up     = from_whole + step_whole;
  assign up_one = from_whole + step_whole + 1'b1;

  always_ff @(posedge clk_i) begin
    if (move_i) begin
      whole_q <= wraps != back_i ? up_one : up;
      rest_q  <= wraps ? wrapped[RestBits-1:0] : sum[RestBits-1:0];
    end else if (load_i) begin
      whole_q <= whole_i;
      rest_q  <= rest_i;
    end
  end
  assign whole_o = whole_q;
  assign rest_o  = rest_q;
endmodule

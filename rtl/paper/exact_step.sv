// One step of an exact ramp: whole + rest / base grows by step_whole + step_rest / base.
//
// Twin:    ExactRamp::advance in model/unit/fixed.h.
// Timing:  combinational.
module exact_step #(
  parameter int unsigned WholeBits = 29,  // signed
  parameter int unsigned RestBits  = 28
) (
  input  logic [WholeBits-1:0] whole_i,
  input  logic [RestBits-1:0]  rest_i,        // below base
  input  logic [WholeBits-1:0] step_whole_i,  // signed
  input  logic [RestBits-1:0]  step_rest_i,   // below base
  input  logic [RestBits-1:0]  base_i,
  output logic [WholeBits-1:0] whole_o,
  output logic [RestBits-1:0]  rest_o
);
  // All sums beside each other, the last one's carry selects.
  logic [RestBits-1:0]  sum;
  logic [RestBits+1:0]  major, less;  // less: signed, of sum - base
  logic [WholeBits-1:0] whole;
  logic                 carry;
  assign sum     = rest_i + step_rest_i;
  assign major   = {2'b0, (rest_i & step_rest_i) | ((rest_i | step_rest_i) & ~base_i)};
  assign less    = {2'b11, rest_i ^ step_rest_i ^ ~base_i} + {major[RestBits:0], 1'b1};
  assign carry   = !less[RestBits+1];
  assign rest_o  = carry ? less[RestBits-1:0] : sum;
  assign whole   = whole_i + step_whole_i;
  assign whole_o = carry ? whole + 1'b1 : whole;
  logic unused;
  assign unused = &{1'b0, major[RestBits+1]};
endmodule

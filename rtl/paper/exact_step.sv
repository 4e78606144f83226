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
  logic [RestBits:0]   sum;
  logic [RestBits+1:0] less;  // signed
  logic                carry;
  assign sum     = {1'b0, rest_i} + {1'b0, step_rest_i};
  assign less    = {1'b0, sum} - {2'b0, base_i};
  assign carry   = !less[RestBits+1];
  assign rest_o  = carry ? less[RestBits-1:0] : sum[RestBits-1:0];
  assign whole_o = whole_i + step_whole_i + WholeBits'(carry);
endmodule

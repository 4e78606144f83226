// How far a stored plane reaches beyond its depth at the texel's centre: half its steepness, rounded up.
//
// Twins:   model/unit/winding/plane.h, decode_gradient and ThresholdPlane::steepness
// Numbers: |x| + |y| in depth units; exact below 2^27, `steep` from there on, where the plane has no bounds.
// Timing:  combinational.
module plane_steepness (
  input  logic [shadow_pkg::GradientCodeBits-1:0] gradient_x_i,
  input  logic [shadow_pkg::GradientCodeBits-1:0] gradient_y_i,
  output logic                                    steep_o,
  output logic [26:0]                             half_o  // meaningless if steep
);
  localparam int unsigned M = shadow_pkg::GradientBits;
  localparam int unsigned E = shadow_pkg::ExponentBits;
  localparam int unsigned SizeBits = 28;  // bit 27: 2^27 or more
  localparam int unsigned HugeShift = SizeBits - 1 - M - shadow_pkg::PlaneStepBits;  // brings the leading one there

  // Exponent 0 has no leading one, and the shift of exponent 1.
  function automatic logic [SizeBits-1:0] size(input logic [M+E-1:0] code);
    logic [E-1:0]        shift;
    logic [SizeBits-1:0] mantissa;
    shift    = code[M+:E] == '0 ? '0 : code[M+:E] - 1'b1;
    mantissa = SizeBits'({code[M+:E] != '0, code[M-1:0]}) << shadow_pkg::PlaneStepBits;
    size     = mantissa << shift;
    size[SizeBits-1] = 32'(shift) >= HugeShift;
  endfunction

  logic [SizeBits-1:0] x, y;
  logic [SizeBits-1:0] sum;
  assign x       = size(gradient_x_i[M+E-1:0]);
  assign y       = size(gradient_y_i[M+E-1:0]);
  assign sum     = {1'b0, x[SizeBits-2:0]} + {1'b0, y[SizeBits-2:0]};
  assign steep_o = x[SizeBits-1] || y[SizeBits-1] || sum[SizeBits-1];
  assign half_o  = 27'(sum[SizeBits-1:1]) + 27'(sum[0]);

  // The signs do not matter.
  logic unused;
  assign unused = gradient_x_i[M+E] ^ gradient_y_i[M+E];
endmodule

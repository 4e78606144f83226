// The nearest UQ0.Bits to value / 2^f, ties up; 1.0 and above saturate.
//
// Twin:    round_to_field in model/unit/fixed.h.
// Timing:  combinational.
module round_to_field #(
  parameter int unsigned Bits = 8  // at most 15
) (
  input  logic [4:0]                         texel_bits_i,  // f, 16 to 26
  input  logic [shadow_pkg::MaxFraction+1:0] value_i,
  output logic [Bits-1:0]                    field_o
);
  localparam int unsigned V = shadow_pkg::MaxFraction + 2;
  // One bit more than the field's, for rounding, and two above it, for saturation.
  logic [V-1:0]    shifted;
  logic [Bits+1:0] rounded;
  assign shifted = value_i >> (texel_bits_i - 5'(Bits + 1));
  assign rounded = shifted[Bits+2:1] + {{(Bits+1){1'b0}}, shifted[0]};
  assign field_o = rounded[Bits+1:Bits] == '0 ? rounded[Bits-1:0] : '1;
  logic unused;
  assign unused = &{1'b0, shifted[V-1:Bits+3]};
endmodule

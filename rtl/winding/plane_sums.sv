// Plane sums: sums of products for the setup of triangles and edges, one digit of one product a cycle.
//
// Numbers: exact. A sum is worked out from its lowest digit up, DigitBits of each product's second factor at a
//          time; what lies below the next digit leaves the accumulator to the right. The sum of two digits is
//          in its upper part, that of four digits in all of it.
// Timing:  factors of cycle n are in the sum in n + 2.
module plane_sums #(
  parameter int unsigned ABits     = 31,
  parameter int unsigned DigitBits = 15,
  parameter int unsigned Digits    = 4,
  localparam int unsigned HighBits = ABits + DigitBits + 2,
  localparam int unsigned LowBits  = (Digits - 1) * DigitBits
) (
  input  logic                        clk_i,
  input  logic                        valid_i,  // else the sum stays
  input  logic [ABits-1:0]            a_i,      // signed
  input  logic [DigitBits:0]          digit_i,  // signed; below the topmost digit not negative
  input  logic                        minus_i,  // subtract the product
  input  logic                        first_i,  // of a sum
  input  logic                        move_i,   // the next one is of the next digit
  output logic [HighBits+LowBits-1:0] sum_o     // signed
);
  logic                       valid_q, minus_q, first_q, move_q;
  logic signed [ABits-1:0]    a_q;
  logic signed [DigitBits:0]  digit_q;
  logic signed [HighBits-1:0] high_q, from, rest, sum;
  logic [LowBits-1:0]         low_q;

  // -a d = ~a d + d
  assign from = first_q ? '0 : high_q;
  assign rest = $signed(HighBits'(digit_q) & {HighBits{minus_q}});
  assign sum  = from + a_q * digit_q + rest;
  always_ff @(posedge clk_i) begin
    valid_q <= valid_i;
    minus_q <= minus_i;
    first_q <= first_i;
    move_q  <= move_i;
    a_q     <= $signed(a_i ^ {ABits{minus_i}});
    digit_q <= $signed(digit_i);
    if (valid_q) begin
      high_q <= move_q ? sum >>> DigitBits : sum;
      if (move_q) low_q <= {sum[DigitBits-1:0], low_q[LowBits-1:DigitBits]};
    end
  end
  assign sum_o = {high_q, low_q};
endmodule

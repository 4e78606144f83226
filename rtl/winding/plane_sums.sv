// Plane sums: sums of products for the setup of triangles and edges, one digit of one product a cycle.
//
// Numbers: exact. A sum is worked out from its lowest digit up, DigitBits of each product's second factor at a
//          time; what lies below the next digit leaves the accumulator to the right. The sum of two digits is
//          in its upper part, that of four digits in all of it.
//          A product is two halves until it is added.
// Timing:  factors of cycle n are in the sum in n + 3.
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
  localparam int unsigned Half     = (DigitBits + 1) / 2;
  localparam int unsigned HalfBits = ABits + Half + 1;
  logic                       valid_q, first_q, move_q, minus_q, added_q, add_first_q, add_move_q;
  logic signed [ABits-1:0]    a_q;
  logic signed [DigitBits:0]  digit_q;
  logic signed [Half:0]       lower;  // never negative
  logic signed [DigitBits-Half:0] upper;
  logic signed [HalfBits-1:0] lower_q, upper_q, rest;
  logic signed [HighBits-1:0] high_q, from, sum;
  logic [LowBits-1:0]         low_q;

  // -a d = ~a d + d
  assign lower = $signed({1'b0, digit_q[Half-1:0]});
  assign upper = $signed(digit_q[DigitBits:Half]);
  assign rest  = $signed({{(HalfBits-DigitBits-1){digit_q[DigitBits]}}, digit_q} & {HalfBits{minus_q}});
  assign from  = add_first_q ? '0 : high_q;
  assign sum   = from + HighBits'(lower_q) + (HighBits'(upper_q) <<< Half);
  always_ff @(posedge clk_i) begin
    valid_q     <= valid_i;
    minus_q     <= minus_i;
    first_q     <= first_i;
    move_q      <= move_i;
    a_q         <= $signed(a_i ^ {ABits{minus_i}});
    digit_q     <= $signed(digit_i);
    added_q     <= valid_q;
    add_first_q <= first_q;
    add_move_q  <= move_q;
    lower_q     <= a_q * lower + rest;
    upper_q     <= HalfBits'(a_q * upper);
    if (added_q) begin
      high_q <= add_move_q ? sum >>> DigitBits : sum;
      if (add_move_q) low_q <= {sum[DigitBits-1:0], low_q[LowBits-1:DigitBits]};
    end
  end
  assign sum_o = {high_q, low_q};
endmodule

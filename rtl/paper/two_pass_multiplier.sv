// Signed multiplier of half the size, for setup sequencers: a product takes two cycles, one for each half of
// an operand.
//
// Timing:  operands that are taken in cycle n (take_i) are the product of cycle n + 3, and of that one alone;
//          take_i comes every other cycle at most.
module two_pass_multiplier #(
  parameter int unsigned ABits = 29,
  parameter int unsigned BBits = 29   // odd
) (
  input  logic                   clk_i,
  input  logic                   take_i,
  input  logic [ABits-1:0]       a_i,       // signed
  input  logic [BBits-1:0]       b_i,       // signed
  output logic [ABits+BBits-1:0] product_o
);
  localparam int unsigned Low  = BBits / 2;
  localparam int unsigned High = BBits - Low;  // more than Low
  localparam int unsigned P    = ABits + BBits;
  logic                     high_q;  // b's high half comes first
  logic signed [ABits-1:0]  a_q;
  logic        [BBits-1:0]  b_q;
  logic signed [High-1:0]   half;
  logic signed [P-1:0]      product_q, high_part;
  assign half      = high_q ? $signed(b_q[BBits-1:Low]) : $signed(High'(b_q[Low-1:0]));
  assign high_part = high_q ? '0 : product_q <<< Low;
  assign product_o = product_q;
  always_ff @(posedge clk_i) begin
    high_q <= take_i;
    if (take_i) begin
      a_q <= $signed(a_i);
      b_q <= b_i;
    end
    product_q <= high_part + a_q * half;
  end
endmodule

// Signed multiplier with registered operands and a registered product, for setup sequencers.
//
// Timing:  operands of cycle n are the product of cycle n + 2, one product a cycle; there is no handshake,
//          who drives it counts the cycles.
module multiplier #(
  parameter int unsigned ABits = 29,
  parameter int unsigned BBits = 29
) (
  input  logic                   clk_i,
  input  logic [ABits-1:0]       a_i,       // signed
  input  logic [BBits-1:0]       b_i,       // signed
  output logic [ABits+BBits-1:0] product_o  // signed, of the operands two cycles ago
);
  logic signed [ABits-1:0] a_q;
  logic signed [BBits-1:0] b_q;
  logic signed [ABits+BBits-1:0] product_q;

  assign product_o = product_q;
  always_ff @(posedge clk_i) begin
    a_q       <= $signed(a_i);
    b_q       <= $signed(b_i);
    product_q <= a_q * b_q;
  end
endmodule

// Plane divider: quotient and remainder of unsigned numbers, two bits of the numerator a cycle.
//
// Twin:    floor_div in model/unit/fixed.h.
// Numbers: the numerator stands at the top, `pairs` times two bits of it count. Those below come out above
//          the quotient, and so are 0.
// Timing:  taken in cycle n, valid in n + 1 + pairs at the latest: eight leading zeros of the quotient take
//          one cycle together. The result stays until it is taken.
`include "check.svh"
module plane_divider #(
  parameter int unsigned NumeratorBits = 80,  // even, and so is the quotient's
  parameter int unsigned DivisorBits   = 56,  // more than 8
  localparam int unsigned PairBits = $clog2(NumeratorBits / 2 + 1)
) (
  input  logic                     clk_i,
  input  logic                     rst_ni,
  input  logic                     clear_i,
  input  logic                     valid_i,
  output logic                     ready_o,      // low while a result is on its way or waits
  input  logic [NumeratorBits-1:0] numerator_i,
  input  logic [PairBits-1:0]      pairs_i,      // at least 1
  input  logic [DivisorBits-1:0]   divisor_i,    // > 0, constant until valid_o
  output logic                     valid_o,
  input  logic                     ready_i,
  output logic [NumeratorBits-1:0] quotient_o,
  output logic [DivisorBits-1:0]   remainder_o
);
  localparam int unsigned N = NumeratorBits;
  localparam int unsigned D = DivisorBits;
  localparam int unsigned Skip = 8;
  logic                busy_q, done_q;
  logic [PairBits-1:0] left_q;
  logic [D-1:0]        rest_q;
  logic [N-1:0]        low_q;  // numerator's bits that are left, above the quotient's that have come

  // Two bits at once: the second one with the divisor taken from the first one's rest (thrice in all) or not.
  logic [D:0]   upper;
  logic [D+1:0] upper_less, once, thrice_sum, thrice_carry, thrice;
  logic [D-1:0] upper_rest, lower_less, lower_rest;
  logic         unused;
  assign unused = &{1'b0, thrice_carry[D+1], upper_rest[D-1]};
  logic         upper_bit, lower_bit;
  assign upper        = {rest_q, low_q[N-1]};
  assign upper_less   = {1'b0, upper} - {2'b0, divisor_i};
  assign upper_bit    = !upper_less[D+1];
  assign once         = {1'b0, upper[D-1:0], low_q[N-2]} - {2'b0, divisor_i};
  assign thrice_sum   = {upper, low_q[N-2]} ^ {1'b0, divisor_i, 1'b0} ^ {2'b0, divisor_i};
  assign thrice_carry = ~{upper, low_q[N-2]} & ({1'b0, divisor_i, 1'b0} | {2'b0, divisor_i})
                      | {1'b0, divisor_i, 1'b0} & {2'b0, divisor_i};  // borrows
  assign thrice       = thrice_sum - {thrice_carry[D:0], 1'b0};
  assign upper_rest   = upper_bit ? upper_less[D-1:0] : upper[D-1:0];
  assign lower_bit    = upper_bit ? !thrice[D+1] : !once[D+1];
  assign lower_less   = upper_bit ? thrice[D-1:0] : once[D-1:0];
  assign lower_rest   = lower_bit ? lower_less : {upper_rest[D-2:0], low_q[N-2]};

  logic         skip;
  logic [D-1:0] skip_rest;
  assign skip_rest = {rest_q[D-1-Skip:0], low_q[N-1 -: Skip]};
  assign skip      = left_q >= PairBits'(Skip / 2) && rest_q[D-1 -: Skip] == '0 && skip_rest < divisor_i;

  assign ready_o     = !busy_q && !done_q;
  assign valid_o     = done_q;
  assign quotient_o  = low_q;
  assign remainder_o = rest_q;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      busy_q <= 1'b0;
      done_q <= 1'b0;
    end else if (clear_i) begin
      busy_q <= 1'b0;
      done_q <= 1'b0;
    end else begin
      if (valid_i && ready_o) begin
        busy_q <= 1'b1;
        `CHECK(divisor_positive, divisor_i != '0)
      end else if (busy_q && left_q == (skip ? PairBits'(Skip / 2) : PairBits'(1))) begin
        busy_q <= 1'b0;
        done_q <= 1'b1;
      end else if (ready_i) begin
        done_q <= 1'b0;
      end
    end
  end
  always_ff @(posedge clk_i) begin
    if (valid_i && ready_o) begin
      rest_q <= '0;
      low_q  <= numerator_i;
      left_q <= pairs_i;
    end else if (busy_q) begin
      rest_q <= skip ? skip_rest : lower_rest;
      low_q  <= skip ? {low_q[N-1-Skip:0], {Skip{1'b0}}} : {low_q[N-3:0], upper_bit, lower_bit};
      left_q <= left_q - (skip ? PairBits'(Skip / 2) : PairBits'(1));
    end
  end
endmodule

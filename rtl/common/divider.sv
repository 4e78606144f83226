// Divider: quotient = floor(numerator / divisor) and remainder in [0, divisor), two bits a cycle.
//
// Twin:    floor_div in model/unit/fixed.h.
// Numbers: numerator signed, divisor unsigned and > 0. Where the quotient does not fit QuotientBits signed
//          bits, quotient and remainder are meaningless (but the division ends).
//          A negative numerator n is divided as ~n: floor(n / d) = ~floor(~n / d), remainder d - 1 - r.
// Timing:  taken in cycle n, valid in n + 1 + ceil((QuotientBits - 1) / 2) at the latest; SkipBits leading
//          zeros of the quotient may take one cycle together. The result stays until it is taken.
`include "check.svh"
module divider #(
  parameter int unsigned NumeratorBits = 55,  // with sign
  parameter int unsigned DivisorBits   = 28,
  parameter int unsigned QuotientBits  = 29,  // with sign, at most NumeratorBits; odd
  parameter int unsigned SkipBits      = 0,   // even; 0: never skip; below DivisorBits and QuotientBits
  parameter bit          Floor         = 1'b1 // 0: of a negative n quotient and remainder of ~n come out
) (
  input  logic                     clk_i,
  input  logic                     rst_ni,
  input  logic                     clear_i,
  input  logic                     valid_i,
  output logic                     ready_o,  // low while a result is on its way or waits
  input  logic [NumeratorBits-1:0] numerator_i,
  input  logic [DivisorBits-1:0]   divisor_i,  // constant from valid_i until the result is taken
  output logic                     valid_o,
  input  logic                     ready_i,
  output logic [QuotientBits-1:0]  quotient_o,
  output logic [DivisorBits-1:0]   remainder_o
);
  localparam int unsigned Q = QuotientBits - 1;    // bits of the magnitude of the quotient
  localparam int unsigned H = NumeratorBits - 1 - Q;  // bits of the numerator that start as remainder
  localparam int unsigned D = DivisorBits;
  localparam int unsigned CountBits = $clog2(Q + 1);

  logic busy_q, done_q, negative_q;
  logic [CountBits-1:0] left_q;  // bits still to come
  logic [D-1:0] rest_q;
  logic [Q-1:0] low_q;           // numerator's bits that are left, above the quotient's that have come

  logic [NumeratorBits-2:0] magnitude;
  assign magnitude = numerator_i[NumeratorBits-2:0] ^ {(NumeratorBits-1){numerator_i[NumeratorBits-1]}};
  logic [D-1:0] head;
  if (H == 0) begin : g_no_head
    assign head = '0;
  end else if (H >= D) begin : g_long_head
    assign head = magnitude[Q +: D];
  end else begin : g_head
    assign head = {{(D-H){1'b0}}, magnitude[NumeratorBits-2:Q]};
  end

  // Two bits at once: the second one with the divisor taken from the first one's rest (thrice in all) or not.
  logic [D:0]   upper;
  logic [D+1:0] upper_less, once, thrice_sum, thrice_carry, thrice;
  logic [D-1:0] upper_rest, lower_less, lower_rest;
  logic         unused;
  assign unused = &{1'b0, thrice_carry[D+1], upper_rest[D-1]};
  logic         upper_bit, lower_bit;
  assign upper        = {rest_q, low_q[Q-1]};
  assign upper_less   = {1'b0, upper} - {2'b0, divisor_i};
  assign upper_bit    = !upper_less[D+1];
  assign once         = {1'b0, upper[D-1:0], low_q[Q-2]} - {2'b0, divisor_i};
  assign thrice_sum   = {upper, low_q[Q-2]} ^ {1'b0, divisor_i, 1'b0} ^ {2'b0, divisor_i};
  assign thrice_carry = ~{upper, low_q[Q-2]} & ({1'b0, divisor_i, 1'b0} | {2'b0, divisor_i})
                      | {1'b0, divisor_i, 1'b0} & {2'b0, divisor_i};  // borrows
  assign thrice       = thrice_sum - {thrice_carry[D:0], 1'b0};
  assign upper_rest   = upper_bit ? upper_less[D-1:0] : upper[D-1:0];
  assign lower_bit    = upper_bit ? !thrice[D+1] : !once[D+1];
  assign lower_less   = upper_bit ? thrice[D-1:0] : once[D-1:0];
  assign lower_rest   = lower_bit ? lower_less : {upper_rest[D-2:0], low_q[Q-2]};

  logic         skip;
  logic [D-1:0] skip_rest;
  logic [Q-1:0] skip_low;
  if (SkipBits == 0) begin : g_no_skip
    assign skip      = 1'b0;
    assign skip_rest = rest_q;
    assign skip_low  = low_q;
  end else begin : g_skip
    assign skip_rest = {rest_q[D-1-SkipBits:0], low_q[Q-1 -: SkipBits]};
    assign skip_low  = {low_q[Q-1-SkipBits:0], {SkipBits{1'b0}}};
    assign skip = 32'(left_q) >= SkipBits && rest_q[D-1 -: SkipBits] == '0 && skip_rest < divisor_i;
  end

  assign ready_o     = !busy_q && !done_q;
  assign valid_o     = done_q;
  assign quotient_o  = {1'b0, low_q} ^ {QuotientBits{Floor && negative_q}};
  assign remainder_o = Floor && negative_q ? divisor_i + ~rest_q : rest_q;

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
      end else if (busy_q && (skip ? 32'(left_q) == SkipBits : left_q == CountBits'(2))) begin
        busy_q <= 1'b0;
        done_q <= 1'b1;
      end else if (ready_i) begin
        done_q <= 1'b0;
      end
    end
  end
  always_ff @(posedge clk_i) begin
    if (valid_i && ready_o) begin
      negative_q <= numerator_i[NumeratorBits-1];
      rest_q     <= head;
      low_q      <= magnitude[Q-1:0];
      left_q     <= CountBits'(Q);
    end else if (busy_q) begin
      rest_q <= skip ? skip_rest : lower_rest;
      low_q  <= skip ? skip_low : {low_q[Q-3:0], upper_bit, lower_bit};
      left_q <= skip ? left_q - CountBits'(SkipBits) : left_q - CountBits'(2);
    end
  end
endmodule

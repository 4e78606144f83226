// For every numerator and divisor whose quotient fits: quotient and remainder are those of the floored
// division, offered once, in the promised time, and until they are taken.
//
// broken: divider.sv: `{QuotientBits{Floor && negative_q}}` => `{QuotientBits{1'b0}}`
// broken: divider.sv: `divisor_i + ~rest_q : rest_q` => `divisor_i - rest_q : rest_q`
// broken: divider.sv: `assign valid_o     = done_q;` => `assign valid_o     = done_q && !valid_i;`
// broken: divider.sv: `left_q == CountBits'(2)` => `left_q == CountBits'(4)`
// broken: divider.sv: `end else if (ready_i) begin` => `end else begin`
module divider_proof #(
  parameter int unsigned NumeratorBits = 7,
  parameter int unsigned DivisorBits = 3,
  parameter int unsigned QuotientBits = 5
) (
  input logic                     clk_i,
  input logic                     clear_i,
  input logic                     valid_i,
  input logic                     ready_i,
  input logic [NumeratorBits-1:0] numerator_i,
  input logic [DivisorBits-1:0]   divisor_i
);
  logic running_q = 1'b0;
  always_ff @(posedge clk_i) running_q <= 1'b1;

  logic                    ready_o, valid_o;
  logic [QuotientBits-1:0] quotient_o;
  logic [DivisorBits-1:0]  remainder_o;
  divider #(.NumeratorBits(NumeratorBits), .DivisorBits(DivisorBits), .QuotientBits(QuotientBits)) dut (
    .rst_ni(running_q), .*
  );

  logic                     inside_q = 1'b0, held_q = 1'b0, offered_q = 1'b0;
  logic [NumeratorBits-1:0] numerator_q;
  logic [DivisorBits-1:0]   divisor_q;
  logic [QuotientBits-1:0]  quotient_q;
  logic [3:0]               age_q = '0;
  // Wide enough for every value, so that the product is exact.
  wire signed [11:0] numerator = 12'($signed(numerator_q));
  wire signed [11:0] divisor   = $signed({9'b0, divisor_q});
  wire signed [11:0] back      = 12'($signed(quotient_o)) * divisor + $signed({9'b0, remainder_o});
  wire fits = numerator < (divisor <<< (QuotientBits - 1)) && numerator >= -(divisor <<< (QuotientBits - 1));

  always_ff @(posedge clk_i) begin
    if (running_q) begin
      assume (divisor_i != '0);
      if (inside_q) assume (divisor_i == divisor_q);
      if (held_q) assume (valid_i);
      assert (!valid_o || inside_q);
      assert (!(ready_o && inside_q));
      assert (ready_o || inside_q);
      if (offered_q) assert (valid_o && quotient_o == quotient_q);
      if (valid_o && fits) assert (back == numerator && remainder_o < divisor_q);
      if (inside_q && !valid_o) assert (age_q < 4'((QuotientBits - 1) / 2));

      age_q      <= inside_q ? (valid_o ? age_q : age_q + 4'd1) : '0;
      held_q     <= valid_i && !ready_o && !clear_i;
      offered_q  <= valid_o && !ready_i && !clear_i;
      quotient_q <= quotient_o;
      if (valid_i && ready_o) begin
        inside_q    <= 1'b1;
        numerator_q <= numerator_i;
        divisor_q   <= divisor_i;
        age_q       <= '0;
      end else if (valid_o && ready_i) begin
        inside_q <= 1'b0;
      end
      if (clear_i) inside_q <= 1'b0;
    end
  end
endmodule

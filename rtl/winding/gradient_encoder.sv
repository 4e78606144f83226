// Gradient encoder: the codes of a plane's two gradients, and the bias that makes up for what they and
// the ends of segments round off.
//
// Twins:   encode_gradient and FacetPlane::store in model/unit/winding/plane.cpp.
// Numbers: a gradient is depth a texel, rounded down; its size takes SizeBits. Code: sign, exponent, mantissa.
//          It is normalised and spread out again bit by bit: twice its exponent, which is small where the
//          plane is not steep. Bias: half of what is off, rounded up, with 3 on top; and the steeper sum.
// Timing:  gradient x, then y, each taken when ready; 7 + 2 * exponent cycles each. done_o from then until
//          clear_i.
`include "check.svh"
module gradient_encoder #(
  localparam int unsigned M        = shadow_pkg::GradientBits,
  localparam int unsigned Step     = shadow_pkg::PlaneStepBits,
  localparam int unsigned SizeBits = shadow_pkg::FractionBits + 27,  // no facet that has a plane is steeper
  localparam int unsigned SumBits  = SizeBits + 2
) (
  input  logic                clk_i,
  input  logic                rst_ni,
  input  logic                clear_i,     // forgets both gradients; before the first one, too
  input  logic                valid_i,
  output logic                ready_o,
  input  logic [SizeBits:0]   gradient_i,  // signed
  input  logic [shadow_pkg::DepthRange-1:0] offset_i,  // modular, with the first gradient
  output logic [shadow_pkg::GradientCodeBits-1:0] code_x_o,
  output logic [shadow_pkg::GradientCodeBits-1:0] code_y_o,
  output logic                done_o,      // both codes and the bias are there
  output logic [shadow_pkg::DepthRange-1:0] bias_o  // modular, with the offset
);
  localparam int unsigned S = SumBits;
  localparam logic [2:0] Idle = 3'd0, Absolute = 3'd1, Load = 3'd2, Normalise = 3'd3, Spread = 3'd4, True = 3'd5,
                         Stored = 3'd6, Rounding = 3'd7;
  logic [2:0] state_q;
  logic       negative_q;
  logic [1:0] taken_q;            // gradients
  logic       done_q;
  logic [SizeBits:0] size_q;      // gradient, then |gradient|
  logic [SizeBits:0] shift_q;     // size >> exponent, then the stored size, then how far that is off
  logic [shadow_pkg::ExponentBits-1:0] exponent_q, left_q;
  logic [shadow_pkg::GradientCodeBits-1:0] code_x_q, code_y_q;
  // Sums over both gradients, as a ring: of sizes and 2, of stored sizes, of twice the offset, what rounding
  // was off, and 9.
  logic [S-1:0] sum0_q, sum1_q, sum2_q, term, next;
  logic [shadow_pkg::DepthRange-1:0] bias_q;

  logic         fits;
  logic [M+1:0] mantissa;  // with its leading one, or 2^(M+1) where it rounds up to that
  logic [shadow_pkg::GradientCodeBits-2:0] code;
  logic [SizeBits:0] less, off_size;
  assign fits     = (shift_q >> (Step + M + 1)) == '0;
  assign mantissa = {1'b0, shift_q[Step +: M+1]} + {{(M+1){1'b0}}, shift_q[Step-1]};
  assign code     = {exponent_q, {M{1'b0}}} + (shadow_pkg::GradientCodeBits-1)'(mantissa);
  assign less     = shift_q - size_q;
  assign off_size = shift_q ^ {(SizeBits+1){shift_q[SizeBits]}};  // less 1 if it is negative
  assign term     = state_q == True ? S'(size_q)
                  : state_q == Stored ? S'(shift_q) : S'(off_size);
  assign next     = sum0_q + term + S'(state_q == Rounding && shift_q[SizeBits]);

  logic [S-1:0] steeper;
  assign steeper  = sum0_q > sum1_q ? sum0_q : sum1_q;
  always_ff @(posedge clk_i)
    bias_q <= shadow_pkg::DepthRange'((sum2_q >> 1) + (steeper >> (shadow_pkg::EndBits - 1)));
  assign bias_o   = bias_q;
  assign ready_o  = state_q == Idle && taken_q != 2'd2;
  assign done_o   = done_q;
  assign code_x_o = code_x_q;
  assign code_y_o = code_y_q;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      state_q    <= Idle;
      taken_q    <= 2'd0;
      done_q     <= 1'b0;
      exponent_q <= '0;
    end else if (clear_i) begin
      state_q <= Idle;
      taken_q <= 2'd0;
      done_q  <= 1'b0;
    end else begin
      unique case (state_q)
        Idle: if (valid_i && ready_o) begin
          state_q    <= Absolute;
          taken_q    <= taken_q + 2'd1;
          exponent_q <= '0;
        end
        Normalise: begin
          if (fits) state_q <= Spread;
          else exponent_q <= exponent_q + 1'b1;
        end
        Spread: if (left_q == '0) state_q <= True;
        default: state_q <= state_q + 3'd1;  // Rounding: to Idle
      endcase
      done_q <= state_q == Idle && taken_q == 2'd2;
      `CHECK(exponent_in_range, state_q != Normalise || fits || exponent_q != '1)
    end
  end
  always_ff @(posedge clk_i) begin
    unique case (state_q)
      Idle: if (valid_i && ready_o) begin
        negative_q <= gradient_i[SizeBits];
        size_q     <= gradient_i;
        shift_q    <= '0;
      end
      Absolute: if (negative_q) size_q <= less;
      Load: shift_q <= size_q;
      Normalise: begin
        left_q <= exponent_q;
        if (!fits) begin
          shift_q <= shift_q >> 1;
        end else begin
          shift_q  <= {{(SizeBits-M-1-Step){1'b0}}, mantissa, {Step{1'b0}}};
          code_y_q <= {negative_q && code != '0, code};
          code_x_q <= code_y_q;
        end
      end
      Spread: begin
        left_q <= left_q - 1'b1;
        if (left_q != '0) shift_q <= shift_q << 1;
      end
      // A code of 0 has lost its sign, and with it nothing: 0 is as far from the one as the other.
      Stored: shift_q <= less;
      default: ;
    endcase
    if (taken_q == 2'd0) begin
      sum0_q <= S'(2);
      sum1_q <= '0;
      sum2_q <= S'({offset_i, 1'b0}) + S'(9);
    end else if (state_q == True || state_q == Stored || state_q == Rounding) begin
      sum0_q <= sum1_q;
      sum1_q <= sum2_q;
      sum2_q <= next;
    end
  end
endmodule

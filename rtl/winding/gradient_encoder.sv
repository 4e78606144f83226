// Gradient encoder: the codes of a plane's two gradients, and the bias that makes up for what they and
// the ends of segments round off.
//
// Twins:   encode_gradient and FacetPlane::store in model/unit/winding/plane.cpp.
// Numbers: a gradient is depth a texel, rounded down; its size takes SizeBits. Code: sign, exponent, mantissa.
//          It is normalised and spread out again bit by bit: twice its exponent, which is small where the
//          plane is not steep.
// Timing:  gradient x, then y, each taken when ready; 3 + 2 * exponent cycles each. done_o from then until
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
  input  logic                clear_i,     // forgets both gradients
  input  logic                valid_i,
  output logic                ready_o,
  input  logic [SizeBits:0]   gradient_i,  // signed
  output logic [shadow_pkg::GradientCodeBits-1:0] code_x_o,
  output logic [shadow_pkg::GradientCodeBits-1:0] code_y_o,
  output logic                done_o,      // both codes and the bias are there
  output logic [shadow_pkg::DepthRange-1:0] bias_o  // modular, without a shared plane's tolerance
);
  localparam logic [1:0] Idle = 2'd0, Normalise = 2'd1, Spread = 2'd2, Sum = 2'd3;
  logic [1:0] state_q;
  logic       second_q, negative_q;
  logic [1:0] taken_q;  // gradients
  logic [SizeBits-1:0] size_q;           // |gradient|
  logic [SizeBits:0]   shift_q;          // size >> exponent, then the stored size
  logic [shadow_pkg::ExponentBits-1:0] exponent_q, left_q;
  logic [shadow_pkg::GradientCodeBits-1:0] code_x_q, code_y_q;
  logic [SumBits-1:0] rounding_q, true_q, stored_q;  // sums over both

  logic                fits;
  logic [M+1:0]        mantissa;  // with its leading one, or 2^(M+1) where it rounds up to that
  logic [shadow_pkg::GradientCodeBits-2:0] code;
  logic [SizeBits:0]   off, off_size;  // stored less true size
  assign fits     = (shift_q >> (Step + M + 1)) == '0;
  assign mantissa = {1'b0, shift_q[Step +: M+1]} + {{(M+1){1'b0}}, shift_q[Step-1]};
  assign code     = {exponent_q, {M{1'b0}}} + (shadow_pkg::GradientCodeBits-1)'(mantissa);
  assign off      = shift_q - {1'b0, size_q};
  assign off_size = (off ^ {(SizeBits+1){off[SizeBits]}}) + (SizeBits+1)'(off[SizeBits]);

  logic [SumBits-1:0] steeper;
  assign steeper  = true_q + SumBits'(2) > stored_q ? true_q + SumBits'(2) : stored_q;
  assign bias_o   = shadow_pkg::DepthRange'(((rounding_q + SumBits'(3)) >> 1) + (steeper >> (shadow_pkg::EndBits - 1)) + SumBits'(3));
  assign ready_o  = state_q == Idle && taken_q != 2'd2;
  assign done_o   = state_q == Idle && taken_q == 2'd2;
  assign code_x_o = code_x_q;
  assign code_y_o = code_y_q;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      state_q <= Idle;
      taken_q <= 2'd0;
    end else if (clear_i) begin
      state_q <= Idle;
      taken_q <= 2'd0;
    end else begin
      unique case (state_q)
        Idle: if (valid_i && ready_o) begin
          state_q <= Normalise;
          taken_q <= taken_q + 2'd1;
        end
        Normalise: if (fits) state_q <= Spread;
        Spread: if (left_q == '0) state_q <= Sum;
        default: state_q <= Idle;
      endcase
      `CHECK(exponent_in_range, state_q != Normalise || fits || exponent_q != '1)
    end
  end
  always_ff @(posedge clk_i) begin
    unique case (state_q)
      Idle: if (valid_i && ready_o) begin
        negative_q <= gradient_i[SizeBits];
        size_q     <= (gradient_i[SizeBits-1:0] ^ {SizeBits{gradient_i[SizeBits]}})
                    + {{(SizeBits-1){1'b0}}, gradient_i[SizeBits]};
        shift_q    <= (gradient_i ^ {(SizeBits+1){gradient_i[SizeBits]}})
                    + {{SizeBits{1'b0}}, gradient_i[SizeBits]};
        exponent_q <= '0;
        second_q   <= taken_q[0];
        if (taken_q == 2'd0) begin
          rounding_q <= '0;
          true_q     <= '0;
          stored_q   <= '0;
        end
      end
      Normalise: begin
        left_q <= exponent_q;
        if (!fits) begin
          shift_q    <= shift_q >> 1;
          exponent_q <= exponent_q + 1'b1;
        end else begin
          shift_q <= {{(SizeBits-M-1-Step){1'b0}}, mantissa, {Step{1'b0}}};
          if (second_q) code_y_q <= {negative_q && code != '0, code};
          else code_x_q <= {negative_q && code != '0, code};
        end
      end
      Spread: begin
        left_q <= left_q - 1'b1;
        if (left_q != '0) shift_q <= shift_q << 1;
      end
      default: begin
        // A code of 0 has lost its sign, and with it nothing: 0 is as far from the one as the other.
        rounding_q <= rounding_q + SumBits'(off_size);
        true_q     <= true_q + SumBits'(size_q);
        stored_q   <= stored_q + SumBits'(shift_q);
      end
    endcase
  end
endmodule

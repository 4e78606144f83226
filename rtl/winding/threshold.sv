// Threshold plane: is a depth strictly beyond the depth that a facet shadows from, at a place?
//
// Twins:   model/unit/winding/plane.h, decode_gradient and ThresholdPlane::at
// Numbers: place in steps of 2^-EndBits texel from the texel's lower corner; depths are signed and modular
//          in DepthRange bits. base + floor of the two products' exact sum: no error of its own.
// Timing:  inputs of cycle n are answered in n + 2, one a cycle; no stalls.
module threshold (
  input  logic                                  clk_i,
  input  logic [shadow_pkg::ThresholdBits-1:0]  threshold_i,  // threshold_t
  input  logic [shadow_pkg::EndBits-1:0]        x_i,
  input  logic [shadow_pkg::EndBits-1:0]        y_i,
  input  logic [shadow_pkg::TraceDepthBits-1:0] depth_i,
  output logic                                  beyond_o
);
  localparam int unsigned G = shadow_pkg::EndBits;
  localparam int unsigned Mantissa = shadow_pkg::GradientBits + 1;  // leading one included
  localparam int unsigned ExponentBits = shadow_pkg::ExponentBits;
  localparam int unsigned ProductBits = Mantissa + G + 1;
  localparam int unsigned Step = shadow_pkg::PlaneStepBits;
  localparam int unsigned Range = shadow_pkg::DepthRange;
  // Of what the modular depth needs: steps of 2^(Step - G).
  localparam int unsigned SumBits = G + Range;

  shadow_pkg::threshold_t t;
  assign t = threshold_i;

  // Mantissa times the signed distance from the centre, which takes the gradient's sign.
  function automatic logic [ProductBits-1:0] product(
      input logic [shadow_pkg::GradientCodeBits-1:0] code, input logic [G-1:0] at);
    logic                     leading;
    logic signed [Mantissa:0] mantissa;
    logic signed [G:0]        distance;
    leading  = code[shadow_pkg::GradientBits+:ExponentBits] != '0;
    mantissa = $signed({1'b0, leading, code[shadow_pkg::GradientBits-1:0]});
    distance = $signed({{2{!at[G-1]}}, at[G-2:0]});
    if (code[shadow_pkg::GradientCodeBits-1]) distance = -distance;
    product = ProductBits'(mantissa * distance);
  endfunction
  function automatic logic [ExponentBits-1:0] shift_of(
      input logic [ExponentBits-1:0] exponent);
    shift_of = exponent == '0 ? '0 : exponent - 1'b1;
  endfunction

  // 1: products
  logic signed [ProductBits-1:0] product_x_q, product_y_q;
  logic [ExponentBits-1:0]       shift_x_q, shift_y_q;
  logic [shadow_pkg::BaseBits-1:0] base1_q, base2_q;
  logic [shadow_pkg::TraceDepthBits-1:0] depth1_q, depth2_q;
  always_ff @(posedge clk_i) begin
    product_x_q <= $signed(product(t.gradient_x, x_i));
    product_y_q <= $signed(product(t.gradient_y, y_i));
    shift_x_q   <= shift_of(t.gradient_x[shadow_pkg::GradientBits+:ExponentBits]);
    shift_y_q   <= shift_of(t.gradient_y[shadow_pkg::GradientBits+:ExponentBits]);
    base1_q     <= t.base;
    depth1_q    <= depth_i;
  end

  // 2: their sum
  logic signed [SumBits-1:0] term_x, term_y;
  /* verilator lint_off UNUSEDSIGNAL */  // the fraction is cut
  logic signed [SumBits-1:0] sum;
  /* verilator lint_on UNUSEDSIGNAL */
  logic [Range-1:0]          slope_q;
  assign term_x = SumBits'(product_x_q) <<< shift_x_q;
  assign term_y = SumBits'(product_y_q) <<< shift_y_q;
  assign sum    = (term_x + term_y) <<< Step;
  always_ff @(posedge clk_i) begin
    slope_q  <= sum[G+:Range];
    base2_q  <= base1_q;
    depth2_q <= depth1_q;
  end

  // 3: the depth, and the answer
  logic [Range-1:0] at;
  assign at       = slope_q + (Range'(base2_q) << Step);
  assign beyond_o = $signed({8'd0, depth2_q}) > $signed({at[Range-1], at});
endmodule

// Beyond means a depth above base + the floor of both gradients' exact products with the distance from the
// texel's centre, signs, exponents and both products included: for every plane, place and depth at reduced
// fields. A depth counts modulo 2^8 here; the
// specification sums in wide words before it is cut.
//
// profile: winding
// pipeline: 3
// package: FractionBits=1 EndGuardBits=2 GradientBits=2 ExponentBits=2 PlaneStepBits=1 TraceDepthBits=5 DepthRange=8
// broken: threshold.sv: `exponent == '0 ? '0 : exponent - 1'b1` => `exponent`
// broken: threshold.sv: `distance = -distance` => `distance = ~distance`
// broken: threshold.sv: `{8'd0, depth2_q}) >` => `{8'd0, depth2_q}) >=`
// broken: threshold.sv: `assign sum    = (term_x + term_y)` => `assign sum    = (term_x - term_y)`
// broken: threshold.sv: `{2{!at[G-1]}}` => `{2{at[G-1]}}`
// broken: threshold.sv: `leading  = code[shadow_pkg::GradientBits+:ExponentBits] != '0` => `leading  = 1'b1`
module threshold_proof (
  input logic                                  clk_i,
  input logic [shadow_pkg::ThresholdBits-1:0]  threshold_i,
  input logic [shadow_pkg::EndBits-1:0]        x_i,
  input logic [shadow_pkg::EndBits-1:0]        y_i,
  input logic [shadow_pkg::TraceDepthBits-1:0] depth_i
);
  localparam int unsigned Wide = 14;
  logic beyond_o;
  threshold dut (.*);

  shadow_pkg::threshold_t t;
  assign t = threshold_i;
  function automatic logic signed [Wide-1:0] gradient(input logic [shadow_pkg::GradientCodeBits-1:0] code);
    logic signed [Wide-1:0] size;
    size = Wide'(code[1:0]) + (code[3:2] == 2'd0 ? Wide'(0) : Wide'(4));
    size = size <<< (code[3:2] == 2'd0 ? 2'd0 : code[3:2] - 2'd1);
    gradient = (code[4] ? -size : size) <<< shadow_pkg::PlaneStepBits;
  endfunction
  wire signed [Wide-1:0] dx  = $signed({{(Wide-3){1'b0}}, x_i}) - Wide'(4);
  wire signed [Wide-1:0] dy  = $signed({{(Wide-3){1'b0}}, y_i}) - Wide'(4);
  wire signed [Wide-1:0] slope = gradient(t.gradient_x) * dx + gradient(t.gradient_y) * dy;
  wire signed [Wide-1:0] base  = $signed({{(Wide-7){t.base[6]}}, t.base}) <<< shadow_pkg::PlaneStepBits;
  wire signed [Wide-1:0] whole = base + (slope >>> shadow_pkg::EndBits);
  wire signed [7:0]      at    = $signed(whole[7:0]);
  wire               beyond = $signed({4'd0, depth_i}) > at;

  logic [1:0] beyond_q;
  logic [1:0] age_q = '0;
  always_ff @(posedge clk_i) begin
    beyond_q <= {beyond_q[0], beyond};
    if (age_q != 2'd2) age_q <= age_q + 2'd1;
    if (age_q == 2'd2) assert (beyond_o == beyond_q[1]);
  end
endmodule

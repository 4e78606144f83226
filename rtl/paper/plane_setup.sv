// Plane setup: a triangle's gradients, and the plane's depth at the centre of each edge's first texel,
// all as whole + rest / twice the area.
//
// Twin:    Polygon::make_plane, centre_ramp and farthest in model/unit/span_filler.cpp.
// Numbers: the gradients' and the area's signs are inverted together where the area is negative. A negative
//          numerator n is divided as ~n: floor(n / d) = ~floor(~n / d). Steps and starts are as plane_walk has
//          them: of ~n / d = whole + rest / d the step is whole + (rest + 1) / d downwards, the start ~rest - so
//          that no rest is ever corrected.
//          |gradient| < 2^(D+C+1) and |offset| <= 2^f - so numerators are below 2^(D+C+F+2).
// Timing:  products come as edge_setup's program says. One divider does, in turn: (rise,) step along x,
//          along y, then a start for each edge.
`include "check.svh"
module plane_setup #(
  localparam int unsigned D = shadow_pkg::DepthBits,
  localparam int unsigned C = shadow_pkg::CoordBits,
  localparam int unsigned F = shadow_pkg::MaxFraction,
  localparam int unsigned G = D + C + 2,                      // of a gradient, signed
  localparam int unsigned P = 2 * ((D + C + F + 3) / 2) + 1,  // of a numerator, signed
  localparam int unsigned W = 2 * C + 2,                      // of a product and the sum of some, at least P - C + 1
  localparam int unsigned N = P - 1,                          // of its magnitude, even
  localparam int unsigned AreaBits = 2 * C
) (
  input  logic                  clk_i,
  input  logic                  rst_ni,
  input  logic                  clear_i,
  input  logic [4:0]            texel_bits_i,
  input  logic                  farthest_i,      // rise is wanted
  input  logic [2*C+1:0]        product_i,       // signed
  input  logic                  gradient_x_i,    // product adds to the gradient
  input  logic                  gradient_y_i,
  input  logic                  offset_i,        // product adds to the numerator of the edge's start
  input  logic                  first_i,         // it does not add to what was there
  input  logic                  less_i,          // it is subtracted
  input  logic                  high_i,          // it counts 2^(C-1) times: after those that do not
  input  logic                  start_i,         // gradients are there: begin with the steps
  input  logic                  offset_ready_i,  // the numerator is there, held until taken
  output logic                  offset_taken_o,
  input  logic [AreaBits-1:0]   area_i,          // twice the area, > 0, constant until the last start was taken
  input  logic [D-1:0]          range_i,         // most - least
  output logic [G-1:0]          gradient_x_o,
  output logic [G-1:0]          gradient_y_o,
  output logic                  x_less_o,        // steps, valid with the first start
  output logic [N-1:0]          x_whole_o,
  output logic [AreaBits-1:0]   x_rest_o,
  output logic                  y_less_o,
  output logic [N-1:0]          y_whole_o,
  output logic [AreaBits-1:0]   y_rest_o,
  output logic [D:0]            rise_o,
  output logic                  start_valid_o,   // of an edge, less its first vertex's depth
  input  logic                  start_ready_i,
  output logic [P-1:0]          start_whole_o,
  output logic [AreaBits:0]     start_rest_o
);
  // ---- Sums ----
  // The numerator's register adds up |gradient x| + |gradient y| too, for the rise.
  logic [G-1:0] gradient_x_q, gradient_y_q, gradient_from, gradient_sum, product_g, steep;
  logic [P-1:0] offset_q;
  logic [W-1:0] offset_from, offset_more, offset_sum;
  logic         steep_x, steep_y_q, steep_less;
  assign gradient_x_o  = gradient_x_q;
  assign gradient_y_o  = gradient_y_q;
  assign product_g     = product_i[G-1:0] ^ {G{less_i}};
  assign gradient_from = first_i ? '0 : gradient_x_i ? gradient_x_q : gradient_y_q;
  assign gradient_sum  = gradient_from + product_g + G'(less_i);
  assign steep_x       = start_i && farthest_i;
  assign steep         = steep_x ? gradient_x_q : gradient_y_q;
  assign steep_less    = !offset_i && steep[G-1];
  assign offset_from   = first_i || steep_x ? '0 : high_i ? W'($signed(offset_q[P-1:C-1])) : offset_q[W-1:0];
  assign offset_more   = offset_i ? product_i : W'($signed(steep ^ {G{steep_less}}));
  assign offset_sum    = offset_from + offset_more + W'(steep_less);
  always_ff @(posedge clk_i) begin
    if (gradient_x_i) gradient_x_q <= gradient_sum;
    if (gradient_y_i) gradient_y_q <= gradient_sum;
    if (offset_i || steep_x || steep_y_q) begin
      if (offset_i && high_i) offset_q[P-1:C-1] <= offset_sum[P-C:0];
      else offset_q <= P'($signed(offset_sum));
    end
  end

  // ---- Divisions ----
  localparam logic [1:0] JobX = 2'd0, JobY = 2'd1, JobRise = 2'd2, JobStart = 2'd3;
  logic         idle_q;  // nothing of a triangle to do
  logic [1:0]   job_q;
  logic         issued_q;  // job_q's division is in the divider
  logic         divide, div_ready, div_valid, div_taken;
  logic         less, start_less_q;
  logic [G-1:0] slope;
  logic [N-G:0] below;  // the shift's bits below a gradient: 0, inverted
  logic [N-1:0] shifted, numerator, quotient;
  logic [AreaBits-1:0] rest;
  logic [PairBits-1:0] pairs;
  logic         odd;

  // A gradient times 2^f, or the rise's times 2^(f-1), has G - 1 + f bits. They begin at the top, or with a
  // 0 more where they are an odd number.
  localparam int unsigned PairBits = $clog2(N / 2 + 1);
  assign slope = job_q == JobX ? gradient_x_q : gradient_y_q;
  assign less  = job_q == JobRise ? 1'b0 : job_q == JobStart ? offset_q[P-1] : slope[G-1];
  assign odd   = texel_bits_i[0] != 1'((G - 1) % 2);
  for (genvar i = 0; i <= N - G; i++) begin : g_below
    assign below[N-G-i] = less && texel_bits_i > 5'(i);
  end
  assign shifted   = job_q == JobRise ? {offset_q[G-1:0], {(N-G){1'b0}}} : {slope[G-2:0] ^ {(G-1){less}}, below};
  assign numerator = job_q == JobStart ? offset_q[N-1:0] ^ {N{less}} : odd ? {1'b0, shifted[N-1:1]} : shifted;
  assign pairs     = job_q == JobStart ? PairBits'(N / 2) : PairBits'((7'(G) + 7'(texel_bits_i)) >> 1);

  assign divide         = !idle_q && !issued_q && !steep_y_q && (job_q != JobStart || offset_ready_i);
  assign offset_taken_o = divide && div_ready && job_q == JobStart;
  assign start_valid_o  = div_valid && job_q == JobStart;
  assign div_taken      = job_q != JobStart || start_ready_i;
  assign start_whole_o  = {1'b0, quotient} ^ {P{start_less_q}};
  assign start_rest_o   = {1'b0, rest} ^ {(AreaBits+1){start_less_q}};
  always_ff @(posedge clk_i) if (offset_taken_o) start_less_q <= offset_q[P-1];
  plane_divider #(.NumeratorBits(N), .DivisorBits(AreaBits)) divider (
    .clk_i, .rst_ni, .clear_i,
    .valid_i(divide), .ready_o(div_ready), .numerator_i(numerator), .pairs_i(pairs), .divisor_i(area_i),
    .valid_o(div_valid), .ready_i(div_taken), .quotient_o(quotient), .remainder_o(rest)
  );

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      idle_q   <= 1'b1;
      issued_q <= 1'b0;
      steep_y_q <= 1'b0;
      job_q    <= JobX;
    end else if (clear_i) begin
      idle_q   <= 1'b1;
      issued_q <= 1'b0;
      steep_y_q <= 1'b0;
      job_q    <= JobX;
    end else begin
      steep_y_q <= steep_x;
      if (start_i) begin
        idle_q <= 1'b0;
        job_q  <= farthest_i ? JobRise : JobX;
        `CHECK(divider_free, !issued_q)
      end else if (div_valid && div_taken) begin
        job_q <= job_q == JobRise ? JobX : job_q == JobX ? JobY : JobStart;
      end
      issued_q <= (divide && div_ready) || (issued_q && !(div_valid && div_taken));
    end
  end
  logic [D-1:0] range_q;
  always_ff @(posedge clk_i) begin
    range_q <= range_i;
    if (div_valid && job_q == JobX) begin
      x_less_o  <= gradient_x_q[G-1];
      x_whole_o <= quotient;
      x_rest_o  <= rest;
    end
    if (div_valid && job_q == JobY) begin
      y_less_o  <= gradient_y_q[G-1];
      y_whole_o <= quotient;
      y_rest_o  <= rest;
    end
    if (div_valid && job_q == JobRise) begin
      rise_o <= quotient >= N'(range_q) ? {1'b0, range_q} + 1'b1 : quotient[D:0] + 1'b1;
    end
  end
endmodule

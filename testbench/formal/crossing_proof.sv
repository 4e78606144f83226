// Box and cross product together give what docs/unit.md says a segment adds to the winding number and
// whether the square of one step round the place touches it, products and all: for every segment on a
// 1/4 texel grid and every place on a 1/16 texel grid.
//
// profile: winding
// pipeline: 4
// package: FractionBits=1 EndGuardBits=1 MaxFraction=4
// broken: crossing.sv: `side_q == '0 || side_q` => `side_q`
// broken: crossing.sv: `crosses2_q && rises2_q` => `crosses2_q`
// broken: crossing.sv: `size_q     <= (G+2)'(size_x) + (G+2)'(size_y);` => `size_q     <= (G+2)'(size_x);`
// broken: segment_box.sv: `y_down_i <= high_y` => `y_down_i < high_y`
// broken: segment_box.sv: `x_down_i > high_x` => `x_down_i >= high_x`
// broken: crossing.sv: `dx_q * py_q - dy_q * px_q` => `dx_q * py_q + dy_q * px_q`
module crossing_proof (
  input logic                               clk_i,
  input logic [shadow_pkg::SegmentBits-1:0] segment_i,
  input logic [3:0]                         x_i,
  input logic [3:0]                         y_i
);
  shadow_pkg::segment_t s;
  assign s = segment_i;

  logic              boxed, near;
  logic signed [1:0] box_winding, winding;
  segment_box box (
    .valid_i(1'b1), .segment_i, .x_up_i(3'((5'(x_i) + 5'd2) >> 2)), .x_down_i(3'((5'(x_i) + 5'd1) >> 2)),
    .y_up_i(3'((5'(y_i) + 5'd2) >> 2)), .y_down_i(3'((5'(y_i) + 5'd1) >> 2)), .y_floor_i(y_i[3:2]),
    .boxed_o(boxed), .winding_o(box_winding)
  );
  crossing dut (
    .clk_i, .valid_i(1'b1), .segment_i, .x_i, .y_i, .boxed_i(boxed), .winding_o(winding), .near_o(near)
  );

  // Specification, in 1/16 texel.
  wire signed [11:0] px = $signed({8'b0, x_i}), py = $signed({8'b0, y_i});
  wire signed [11:0] x0 = $signed({7'b0, s.x0, 2'b0}), y0 = $signed({7'b0, s.y0, 2'b0});
  wire signed [11:0] x1 = $signed({7'b0, s.x1, 2'b0}), y1 = $signed({7'b0, s.y1, 2'b0});
  wire signed [11:0] side = (x1 - x0) * (py - y0) - (y1 - y0) * (px - x0);
  wire rises = y0 < y1;
  wire level = rises ? y0 <= py && py < y1 : y1 <= py && py < y0;
  wire at_or_left = rises ? side <= 12'sd0 : side >= 12'sd0;
  wire signed [2:0] sign = s.positive ? 3'sd1 : -3'sd1;
  wire signed [2:0] of_border = s.crosses_left && y0 <= py ? sign : 3'sd0;
  // +1 lies right of a segment; of a crossing one, above it: which is left of one that rises.
  wire signed [2:0] of_row = !(level && at_or_left) ? 3'sd0 : s.crosses_left && rises ? -sign : sign;
  wire signed [2:0] sum = of_border + of_row;
  // The square reaches 2/16 each way. It misses the segment iff an axis or the segment's line parts them.
  wire signed [11:0] low_x = x0 < x1 ? x0 : x1, high_x = x0 < x1 ? x1 : x0;
  wire signed [11:0] low_y = rises ? y0 : y1, high_y = rises ? y1 : y0;
  wire signed [11:0] reach = 12'sd2 * ((high_x - low_x) + (high_y - low_y));
  wire touches = low_x <= px + 12'sd2 && px - 12'sd2 <= high_x && low_y <= py + 12'sd2
              && py - 12'sd2 <= high_y && side <= reach && -side <= reach;

  logic signed [2:0] sum1_q, sum2_q;
  logic signed [1:0] box1_q, box2_q;
  logic              touches1_q, touches2_q, boxed1_q, boxed2_q;
  logic [1:0]        age_q = '0;
  always_ff @(posedge clk_i) begin
    age_q <= age_q == 2'd2 ? age_q : age_q + 2'd1;
    {sum1_q, box1_q, touches1_q, boxed1_q} <= {sum, box_winding, touches, boxed};
    {sum2_q, box2_q, touches2_q, boxed2_q} <= {sum1_q, box1_q, touches1_q, boxed1_q};
    assume (s.x0 <= 3'd4 && s.y0 <= 3'd4 && s.x1 <= 3'd4 && s.y1 <= 3'd4);
    if (age_q == 2'd2) begin
      assert (touches2_q == near);
      assert (3'($signed(boxed2_q ? winding : box2_q)) == sum2_q);
    end
  end
endmodule

// Span filler: the gaps between a triangle's outlines as words of four texels, with the plane's depth.
//
// Twin:    ShadowUnit::fill_spans in model/unit/winding/shadow_unit_pass1.cpp.
// Numbers: as plane_ramp, which this moves by two texels at a time: whole + rest / base. The second texel of
//          a pair is one step on.
// Timing:  one cycle before the first pair of a triangle, then a pair a cycle, a word with its last pair; to the
//          next row one cycle and as many as its first pair is pairs away.
`include "check.svh"
module span_filler #(
  localparam int unsigned MapBits = shadow_pkg::MapBits,
  localparam int unsigned T       = shadow_pkg::RowIndexBits,
  localparam int unsigned Depth   = shadow_pkg::DepthRange,
  localparam int unsigned D       = 57,  // base
  localparam int unsigned B       = shadow_pkg::BaseBits
) (
  input  logic               clk_i,
  input  logic               rst_ni,
  input  logic               clear_i,
  input  logic               start_i,      // of a triangle's gaps
  input  logic [T-1:0]       start_x_i,    // texel of the ramp's start, signed, from the map's corner
  input  logic [T-1:0]       start_y_i,
  // gaps, see visited_rows
  input  logic               gap_valid_i,
  output logic               gap_ready_o,
  input  logic [MapBits-1:0] gap_y_i,
  input  logic [MapBits-1:0] gap_from_i,
  input  logic [MapBits-1:0] gap_to_i,
  // the ramp; steps and base as plane_ramp has them
  input  logic [Depth-1:0]   step_x_whole_i,
  input  logic [D-1:0]       step_x_rest_i,
  input  logic [D-1:0]       base_i,
  input  logic [Depth-1:0]   whole_i,      // present value
  input  logic [D-1:0]       rest_i,
  output logic               keep_o,       // the present value is the start from now on
  output logic               load_o,       // go back to the start
  output logic               move_x_o,
  output logic               move_y_o,
  output logic               back_o,
  output logic [Depth-1:0]   step_whole_o, // along x
  output logic [D-1:0]       step_rest_o,
  // pairs of texels, and the words they make
  output logic               word_valid_o, // the pair ends a word
  input  logic               pair_ready_i,
  output logic               upper_o,      // the word's texels 2 and 3
  output logic [MapBits-1:0] x_o,          // word
  output logic [MapBits-1:0] y_o,
  output logic [3:0]         mask_o,
  output logic [2*B-1:0]     bases_o       // of the pair
);
  logic         filling_q;  // else nothing of the triangle was filled yet
  logic [T-1:0] x_q, y_q, start_x_q;  // of the ramp's present value; of its start
  logic         inside_q;   // within a gap
  logic         away_q;     // the start is the row's first pair, and the ramp has left it

  // ---- Two texels' step ----
  logic [D-1:0] double_rest_q;
  logic         double_carry_q;
  logic [D+1:0] double_less;  // signed
  assign double_less = {1'b0, step_x_rest_i, 1'b0} - {2'b0, base_i};
  always_ff @(posedge clk_i) begin
    double_carry_q <= !double_less[D+1];
    double_rest_q  <= double_less[D+1] ? {step_x_rest_i[D-2:0], 1'b0} : double_less[D-1:0];
  end
  assign step_whole_o = filling_q ? {step_x_whole_i[Depth-2:0], double_carry_q} : step_x_whole_i;
  assign step_rest_o  = filling_q ? double_rest_q : step_x_rest_i;

  // ---- To the gap's first pair, and along its pairs ----
  logic [T-1:0] from_pair;
  logic         in_row, at_pair, pair_valid, last, up, first_word, last_word;
  assign from_pair  = {{(T-MapBits){1'b0}}, gap_from_i[MapBits-1:1], 1'b0};
  assign in_row     = y_q == T'(gap_y_i);
  assign at_pair    = inside_q || (in_row && x_q == from_pair);
  assign first_word = x_q[MapBits-1:2] == gap_from_i[MapBits-1:2];
  assign last_word  = x_q[MapBits-1:2] == gap_to_i[MapBits-1:2];
  assign last       = last_word && x_q[1] == gap_to_i[1];
  assign up         = filling_q && gap_valid_i && !inside_q && !in_row;

  assign pair_valid   = filling_q && gap_valid_i && at_pair;
  assign word_valid_o = pair_valid && (last || upper_o);
  assign gap_ready_o  = pair_valid && pair_ready_i && last;
  assign upper_o      = x_q[1];
  assign x_o          = {x_q[MapBits-1:2], 2'b0};
  assign y_o          = gap_y_i;
  assign mask_o       = (4'b1111 << (gap_from_i[1:0] & {2{first_word}}))
                      & (4'b1111 >> (~gap_to_i[1:0] & {2{last_word}}));

  assign move_y_o = up;
  assign move_x_o = filling_q ? gap_valid_i && (at_pair ? pair_ready_i && !last : in_row) : start_x_i[0];
  assign back_o   = filling_q ? !at_pair && in_row && $signed(x_q) > $signed(from_pair) : 1'b1;
  assign load_o   = !filling_q || (up && away_q);
  assign keep_o   = pair_valid && !inside_q && !away_q;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      filling_q <= 1'b0;
      inside_q  <= 1'b0;
    end else if (clear_i || start_i) begin
      filling_q <= 1'b0;
      inside_q  <= 1'b0;
    end else begin
      if (gap_valid_i) filling_q <= 1'b1;
      if (pair_valid && pair_ready_i) inside_q <= !last;
      `CHECK(rows_upwards, !(filling_q && gap_valid_i) || $signed(y_q) <= $signed(T'(gap_y_i)))
    end
  end
  always_ff @(posedge clk_i) begin
    if (!filling_q) begin
      x_q    <= {start_x_i[T-1:1], 1'b0};
      y_q    <= start_y_i;
      away_q <= 1'b0;
    end else if (up) begin
      y_q    <= y_q + 1'b1;
      away_q <= 1'b0;
      if (away_q) x_q <= start_x_q;
    end else if (move_x_o) begin
      x_q <= back_o ? x_q - T'(2) : x_q + T'(2);
    end
    if (keep_o) start_x_q <= x_q;
    if (pair_valid && pair_ready_i) away_q <= 1'b1;
  end

  // ---- Depths of a pair ----
  logic [D+1:0]     less;  // signed: the second one's rest, less base
  /* verilator lint_off UNUSEDSIGNAL */ // steps are stored
  logic [Depth-1:0] second, second_one, depth;
  /* verilator lint_on UNUSEDSIGNAL */
  assign less       = {2'b0, rest_i} + {2'b0, step_x_rest_i} - {2'b0, base_i};
  assign second     = whole_i + step_x_whole_i;
  assign second_one = whole_i + step_x_whole_i + 1'b1;
  assign depth      = less[D+1] ? second : second_one;
  assign bases_o    = {depth[Depth-1 -: B], whole_i[Depth-1 -: B]};
endmodule

// Tile sum: what the texels of a settled tile have in common, texel by texel, as long as all are covered.
//
// Twin:    model/unit/winding/shadow_unit_pass2.cpp, sum_up
// Numbers: the farthest depth is clamped to -1 .. 2^24 - 1, signed.
// Timing:  commands of cycle n show in n + 1.
module tile_sum (
  input  logic                             clk_i,
  input  logic                             restart_i,
  input  logic                             uncovered_i, // a texel is not covered
  input  logic                             add_i,       // this one is:
  /* verilator lint_off UNUSEDSIGNAL */  // a list's first cluster
  input  logic [shadow_pkg::TexelBits-1:0] texel_i,     // texel_t
  /* verilator lint_on UNUSEDSIGNAL */
  input  logic                             steep_i,     // of its plane, if it is one
  input  logic [26:0]                      half_i,
  output logic                             covered_o,   // all are
  output logic                             several_o,   // objects
  output logic [shadow_pkg::IdBits-1:0]    object_o,
  output logic [24:0]                      farthest_o
);
  shadow_pkg::texel_t      texel;
  /* verilator lint_off UNUSEDSIGNAL */
  shadow_pkg::texel_list_t list;
  /* verilator lint_on UNUSEDSIGNAL */
  logic [31:0]             depth, farthest, unused_nearest;
  logic [24:0]             clamped, farthest_q;
  logic                    all_q, some_q, several_q;
  logic [shadow_pkg::IdBits-1:0] object_q;
  assign texel = texel_i;
  assign list  = texel.word[shadow_pkg::ListBits-1:0];
  plane_bounds bounds (
    .base_i(texel.word[2*shadow_pkg::GradientCodeBits+:shadow_pkg::BaseBits]), .steep_i, .half_i,
    .nearest_o(unused_nearest), .farthest_o(farthest)
  );
  assign depth   = texel.kind == shadow_pkg::TexelPlane ? farthest : list.cover_depth;
  assign clamped = depth[31] ? '1 : |depth[30:24] ? 25'h0ffffff : {1'b0, depth[23:0]};
  always_ff @(posedge clk_i) begin
    if (restart_i) begin
      all_q      <= 1'b1;
      some_q     <= 1'b0;
      several_q  <= 1'b0;
      farthest_q <= '1;
    end else if (add_i) begin
      some_q    <= 1'b1;
      object_q  <= texel.object;
      several_q <= several_q || (some_q && texel.object != object_q);
      if ($signed(clamped) > $signed(farthest_q)) farthest_q <= clamped;
    end else if (uncovered_i) begin
      all_q <= 1'b0;
    end
  end
  assign covered_o  = all_q;
  assign several_o  = several_q;
  assign object_o   = object_q;
  assign farthest_o = farthest_q;
endmodule

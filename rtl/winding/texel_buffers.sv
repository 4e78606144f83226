// Texel buffers: what visits do to the texels of a word. Empty texels and planes are dealt with here, four at a
// time; what has a list or gets one goes to the silhouette buffer, one texel after the other.
//
// Twins:   model/unit/winding/shadow_unit_store.cpp (hidden, cover of a texel without a list), shadow_unit_pass2.cpp
//          (settle, sum_up)
// Numbers: a plane's bounds are its depth at the centre and half its steepness, rounded up: plane_bounds.
// Timing:  one visit a cycle in the word held; another word costs a cycle, once it is there. A word to settle takes
//          one cycle, or, while all texels of its tile are covered, six; lists with a bare cluster more.
//
// A visit of kind VisitTile settles its word; with x = 1 it is the last of a tile, whose sum follows.
`include "check.svh"
module texel_buffers (
  input  logic                                  clk_i,
  input  logic                                  rst_ni,
  input  logic                                  clear_i,
  input  logic                                  paper_i,       // settings_t.paper_semantics
  // visits and their word, from memory_window; mask: texels visited, each with its base
  input  logic                                  in_valid_i,
  input  logic                                  in_fresh_i,
  /* verilator lint_off UNUSEDSIGNAL */  // place and segment go elsewhere
  input  shadow_pkg::visit_t                    in_i,
  /* verilator lint_on UNUSEDSIGNAL */
  input  logic [shadow_pkg::TexelWordBits-1:0]  in_word_i,
  output logic                                  load_o,
  output logic                                  pop_o,
  output logic                                  clean_o,       // the word held is as in the memory
  output logic                                  keep_o,        // writes the word back to the window
  input  logic                                  keep_ready_i,
  output logic [shadow_pkg::TexelWordBits-1:0]  word_o,
  // silhouette buffer
  output logic                                  start_o,
  output logic                                  settle_o,
  output logic                                  span_o,
  output logic                                  steep_o,
  output logic [26:0]                           half_o,
  output logic [2*shadow_pkg::GradientCodeBits-1:0] gradient_o,
  output logic [shadow_pkg::IdBits-1:0]         object_o,
  output logic [shadow_pkg::BaseBits-1:0]       base_o,        // with start_o
  output logic [4:0]                            mark_o,        // with start_o
  output logic                                  unmarked_o,    // with start_o
  output logic [shadow_pkg::TexelBits-1:0]      texel_o,       // with start_o
  output logic                                  texel_steep_o, // after it
  output logic [26:0]                           texel_half_o,
  input  logic                                  done_i,
  input  logic                                  changed_i,
  input  logic [shadow_pkg::TexelBits-1:0]      texel_i,
  input  logic                                  texel_steep_i,
  input  logic [26:0]                           texel_half_i,
  // sum of a settled tile
  output logic                                  sum_valid_o,
  input  logic                                  sum_ready_i,
  output logic                                  sum_covered_o,
  output logic                                  sum_several_o,
  output logic [shadow_pkg::IdBits-1:0]         sum_object_o,
  output logic [24:0]                           sum_farthest_o,
  // memory write of the word held
  output logic                                  wr_valid_o,
  input  logic                                  wr_ready_i,
  output logic [3:0]                            wr_mask_o,
  output logic                                  idle_o,
  output logic                                  running_o,     // the silhouette buffer is at work
  output logic [2:0]                            hidden_o       // event
);
  localparam logic [1:0] VisitTile = 2'd2;
  localparam int unsigned B = shadow_pkg::BaseBits;
  localparam int unsigned T = shadow_pkg::TexelBits;
  localparam int unsigned CodeBits = shadow_pkg::GradientCodeBits;
  localparam int unsigned TriBits = shadow_pkg::IdBits + 2 * CodeBits;

  logic [4*T-1:0]  word_d, word_q;
  logic [3:0]      steep_d, steep_q, dirty_d, dirty_q, todo_d, todo_q;
  logic [4*27-1:0] half_d, half_q;
  logic            unkept_q, flush_q, running_q, resumed_d, resumed_q, sums_d, sums_q, change;
  logic [1:0]      lane, lane_q, sum_lane_q;

  // ---- The triangle: a begin carries it in place of the bases ---------------------------------------
  logic [4*B-1:0]         body;
  shadow_pkg::visit_tri_t tri_q;
  logic                   begins, tri_steep, tri_steep_q;
  logic [26:0]            tri_half, tri_half_q;
  logic [4:0]             tri_mark, tri_mark_q;  // of the planes' marks, what the texel's base does not add
  assign body   = {in_i.base3, in_i.base2, in_i.base1, in_i.base0};
  assign begins = in_i.kind == shadow_pkg::VisitBegin;
  plane_steepness tri_steepness (
    .gradient_x_i(body[CodeBits+:CodeBits]), .gradient_y_i(body[CodeBits-1:0]),
    .steep_o(tri_steep), .half_o(tri_half)
  );
  always_comb begin
    tri_mark = '0;
    for (int i = 0; i < 2 * CodeBits; i++) tri_mark[i%5] = tri_mark[i%5] ^ body[i];
    for (int i = 0; i < shadow_pkg::IdBits; i++) tri_mark[i%5] = tri_mark[i%5] ^ body[2*CodeBits+i];
  end

  // ---- Four texels ----------------------------------------------------------------------------------
  logic       span, settles, nothing, at_work, evaluate, tile_ends_q, quick;
  logic [3:0] active, hidden, slow, put, held, unmarked, data_held, data_bare;
  logic [4*5-1:0] marks;
  assign span     = in_i.kind == shadow_pkg::VisitSpan;
  assign settles  = in_i.kind == VisitTile;
  assign nothing  = in_i.kind == shadow_pkg::VisitEdge && !in_i.corner && !in_i.has_segment;
  assign at_work  = in_valid_i && !in_fresh_i && !flush_q && !tile_ends_q;
  assign active   = resumed_q ? todo_q : in_i.mask;
  assign evaluate = at_work && !begins && !running_q && !sums_q;

  for (genvar i = 0; i < 4; i++) begin : g_texel
    texel_test test (
      .paper_i, .span_i(span), .settle_i(settles), .nothing_i(nothing), .base_i(body[i*B+:B]), .tri_i(tri_q),
      .tri_steep_i(tri_steep_q), .tri_half_i(tri_half_q), .tri_mark_i(tri_mark_q), .texel_i(word_q[i*T+:T]),
      .steep_i(steep_q[i]), .half_i(half_q[i*27+:27]), .hidden_o(hidden[i]), .put_o(put[i]), .slow_o(slow[i]),
      .held_o(held[i]), .mark_o(marks[5*i+:5]), .unmarked_o(unmarked[i])
    );
    logic [1:0] data_kind;
    assign data_kind = in_word_i[i*T+T-1-:2];
    assign data_held[i] = data_kind == shadow_pkg::TexelPlane
                          || (data_kind != shadow_pkg::TexelEmpty && in_word_i[i*T+shadow_pkg::ListBits-1]);
    assign data_bare[i] = data_kind == shadow_pkg::TexelList && in_word_i[i*T+shadow_pkg::ListBits-2];
    logic        data_steep;
    logic [26:0] data_half;
    plane_steepness data_steepness (
      .gradient_x_i(in_word_i[i*T+CodeBits+:CodeBits]), .gradient_y_i(in_word_i[i*T+:CodeBits]),
      .steep_o(data_steep), .half_o(data_half)
    );
    always_comb begin
      word_d[i*T+:T]    = word_q[i*T+:T];
      steep_d[i]        = steep_q[i];
      half_d[i*27+:27]  = half_q[i*27+:27];
      if (load_o) begin
        word_d[i*T+:T]   = in_word_i[i*T+:T];
        steep_d[i]       = data_steep;
        half_d[i*27+:27] = data_half;
      end else if (running_q) begin
        if (done_i && changed_i && lane_q == 2'(i)) begin
          word_d[i*T+:T]   = texel_i;
          steep_d[i]       = texel_steep_i;
          half_d[i*27+:27] = texel_half_i;
        end
      end else if (evaluate && active[i] && put[i] && !settles) begin
        word_d[i*T+:T]   = {shadow_pkg::TexelPlane, tri_q.object,
                            shadow_pkg::WordBits'({body[i*B+:B], tri_q.gradient_x, tri_q.gradient_y})};
        steep_d[i]       = tri_steep_q;
        half_d[i*27+:27] = tri_half_q;
      end
    end
    assign dirty_d[i] = (running_q ? done_i && changed_i && lane_q == 2'(i)
                                   : evaluate && active[i] && put[i] && !settles)
                        || (dirty_q[i] && !(wr_valid_o && wr_ready_i));
  end
  assign change = running_q ? done_i && changed_i : evaluate && !settles && (active & put) != '0;

  function automatic logic [2:0] count(input logic [3:0] bits);
    count = 3'(bits[0]) + 3'(bits[1]) + 3'(bits[2]) + 3'(bits[3]);
  endfunction
  assign hidden_o = evaluate && !settles && !resumed_q ? count(active & hidden) : '0;

  // ---- The texel for the silhouette buffer ------------------------------------------------------
  logic [3:0] wanted;
  assign wanted = active & slow;
  assign lane          = wanted[0] ? 2'd0 : wanted[1] ? 2'd1 : wanted[2] ? 2'd2 : 2'd3;
  assign start_o       = evaluate && wanted != '0;
  assign settle_o      = settles;
  assign span_o        = span;
  assign steep_o       = tri_steep_q;
  assign half_o        = tri_half_q;
  assign gradient_o    = {tri_q.gradient_x, tri_q.gradient_y};
  assign object_o      = tri_q.object;
  assign base_o        = body[32'(lane)*B+:B];
  assign mark_o        = marks[32'(lane)*5+:5];
  assign unmarked_o    = unmarked[lane];
  assign texel_o       = word_q[32'(lane)*T+:T];
  assign texel_steep_o = steep_q[lane_q];
  assign texel_half_o  = half_q[32'(lane_q)*27+:27];
  assign running_o     = running_q;

  // ---- Sum of a tile: a texel a cycle, as long as all were covered -------------------------------------
  logic all;
  tile_sum tile_sum (
    .clk_i, .restart_i((tile_ends_q && sum_ready_i) || (at_work && begins)), .uncovered_i(settles && pop_o && !sums_q),
    .add_i(sums_q), .texel_i(word_q[32'(sum_lane_q)*T+:T]), .steep_i(steep_q[sum_lane_q]),
    .half_i(half_q[32'(sum_lane_q)*27+:27]), .covered_o(all), .several_o(sum_several_o), .object_o(sum_object_o),
    .farthest_o(sum_farthest_o)
  );
  assign sum_covered_o = all;

  // ---- Control --------------------------------------------------------------------------------------
  always_comb begin
    pop_o     = 1'b0;
    todo_d    = todo_q;
    resumed_d = resumed_q;
    sums_d    = sums_q;
    if (at_work) begin
      if (begins) begin
        pop_o = 1'b1;
      end else if (sums_q) begin
        pop_o  = sum_lane_q == 2'd3;
        sums_d = !pop_o;
      end else if (running_q) begin
        if (done_i) begin
          pop_o     = todo_q == '0 && !settles;
          resumed_d = todo_q != '0 || settles;
        end
      end else begin
        todo_d    = wanted & ~(4'd1 << lane);
        resumed_d = wanted != '0;
        sums_d    = wanted == '0 && settles && all && held == '1;
        pop_o     = wanted == '0 && !sums_d;
      end
    end else if (load_o) begin
      pop_o = quick;
    end
  end
  // Nothing is to be done with the word.
  assign quick = settles && data_bare == '0 && !(all && data_held == '1);
  assign sum_valid_o = tile_ends_q;

  // ---- Back to the window and the memory ------------------------------------------------------------
  logic back, mem_done, keep_done;
  assign back       = flush_q || (in_valid_i && in_fresh_i);
  assign wr_valid_o = dirty_q != '0 && back;
  assign wr_mask_o  = dirty_q;
  assign keep_o     = unkept_q && back;
  assign mem_done   = dirty_q == '0 || wr_ready_i;
  assign keep_done  = !unkept_q || keep_ready_i;
  assign load_o     = in_valid_i && in_fresh_i && mem_done && keep_done && !tile_ends_q;
  assign clean_o    = dirty_q == '0 && !unkept_q;
  assign idle_o     = clean_o && !in_valid_i && !tile_ends_q;
  assign word_o     = word_q;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      dirty_q     <= '0;
      unkept_q    <= 1'b0;
      flush_q     <= 1'b0;
      running_q   <= 1'b0;
      resumed_q   <= 1'b0;
      sums_q      <= 1'b0;
      tile_ends_q <= 1'b0;
    end else if (clear_i) begin
      dirty_q     <= '0;
      unkept_q    <= 1'b0;
      flush_q     <= 1'b0;
      running_q   <= 1'b0;
      resumed_q   <= 1'b0;
      sums_q      <= 1'b0;
      tile_ends_q <= 1'b0;
    end else begin
      dirty_q     <= dirty_d;
      unkept_q    <= change || (unkept_q && !(keep_o && keep_ready_i));
      flush_q     <= flush_q ? !(mem_done && keep_done) : !in_valid_i && !clean_o;
      running_q   <= start_o || (running_q && !done_i);
      resumed_q   <= resumed_d;
      sums_q      <= sums_d;
      tile_ends_q <= tile_ends_q ? !sum_ready_i : settles && pop_o && in_i.x[0];
      `CHECK(done_when_running, !done_i || running_q)
    end
  end

  always_ff @(posedge clk_i) begin
    word_q  <= word_d;
    steep_q <= steep_d;
    half_q  <= half_d;
    todo_q  <= todo_d;
    if (start_o) lane_q <= lane;
    sum_lane_q <= sums_q ? sum_lane_q + 1'b1 : '0;
    if (at_work && begins) begin
      tri_q       <= body[TriBits-1:0];
      tri_steep_q <= tri_steep;
      tri_half_q  <= tri_half;
      tri_mark_q  <= tri_mark;
    end
  end
endmodule

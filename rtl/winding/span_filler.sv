// Span filler: the gaps between a triangle's outlines as words of four texels, with the plane's depth.
//
// Twin:    ShadowUnit::fill_spans in model/unit/winding/shadow_unit_pass1.cpp.
// Numbers: as plane_ramp, which this moves: whole + rest / base. Texel k of a word is k steps on; k times
//          the step, brought below base, is worked out by the ramp itself, from 0.
// Timing:  seven cycles or so before the first word of a triangle, then a word a cycle; to the next row one
//          cycle and as many as its first word is words away.
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
  input  logic [Depth-1:0]   start_whole_i,
  input  logic [D-1:0]       start_rest_i,
  input  logic [Depth-1:0]   step_x_whole_i,
  input  logic [D-1:0]       step_x_rest_i,
  input  logic [D-1:0]       base_i,
  input  logic [Depth-1:0]   whole_i,      // present value
  input  logic [D-1:0]       rest_i,
  output logic               load_o,
  output logic [Depth-1:0]   whole_o,      // to load
  output logic [D-1:0]       rest_o,
  output logic               move_x_o,
  output logic               move_y_o,
  output logic               back_o,
  output logic [Depth-1:0]   step_whole_o, // along x: of a texel or of a word
  output logic [D-1:0]       step_rest_o,
  // words
  output logic               word_valid_o,
  input  logic               word_ready_i,
  output logic [MapBits-1:0] x_o,
  output logic [MapBits-1:0] y_o,
  output logic [3:0]         mask_o,
  output logic [4*B-1:0]     bases_o       // texel i at i * B
);
  localparam logic [2:0] Wait = 3'd0, One = 3'd1, Two = 3'd2, Three = 3'd3, Four = 3'd4, Load = 3'd5,
                         Align = 3'd6, Fill = 3'd7;
  logic [2:0]       state_q;
  logic [T-1:0]     x_q, y_q, anchor_x_q;  // of the ramp's present value; of the anchor
  logic             inside_q;   // within a gap
  logic             away_q;     // the row's first word is the anchor, and the ramp has left it
  logic [Depth-1:0] whole2_q, whole3_q, whole4_q, anchor_whole_q;
  logic [D-1:0]     rest2_q, rest3_q, rest4_q, anchor_rest_q;

  // ---- To the gap's first word, and along its words ----
  logic [T-1:0] from_word;
  logic         in_row, at_word, last, up, aligned;
  assign from_word = {{(T-MapBits){1'b0}}, gap_from_i[MapBits-1:2], 2'b0};
  assign in_row    = y_q == T'(gap_y_i);
  assign at_word   = inside_q || (in_row && x_q == from_word);
  assign last      = x_q[MapBits-1:2] == gap_to_i[MapBits-1:2];
  assign aligned   = x_q[1:0] == 2'd0;
  assign up        = state_q == Fill && gap_valid_i && !inside_q && !in_row;

  assign word_valid_o = state_q == Fill && gap_valid_i && at_word;
  assign gap_ready_o  = word_valid_o && word_ready_i && last;
  assign x_o          = x_q[MapBits-1:0];
  assign y_o          = gap_y_i;
  for (genvar i = 0; i < 4; i++) begin : g_mask
    assign mask_o[i] = {x_q[MapBits-1:2], 2'(i)} >= gap_from_i && {x_q[MapBits-1:2], 2'(i)} <= gap_to_i;
  end

  always_comb begin
    move_x_o = 1'b0;
    back_o   = 1'b0;
    unique case (state_q)
      One, Two, Three, Four: move_x_o = 1'b1;
      Align: begin
        move_x_o = !aligned;
        back_o   = 1'b1;
      end
      Fill: begin
        move_x_o = gap_valid_i && (at_word ? word_ready_i && !last : in_row);
        back_o   = !at_word && in_row && $signed(x_q) > $signed(from_word);
      end
      default: ;
    endcase
  end
  assign move_y_o = up;
  assign load_o   = state_q == One || state_q == Load || (up && away_q);
  assign whole_o  = state_q == One ? '0 : state_q == Load ? start_whole_i : anchor_whole_q;
  assign rest_o   = state_q == One ? '0 : state_q == Load ? start_rest_i : anchor_rest_q;
  assign step_whole_o = state_q == Fill ? whole4_q : step_x_whole_i;
  assign step_rest_o  = state_q == Fill ? rest4_q : step_x_rest_i;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      state_q  <= Wait;
      inside_q <= 1'b0;
    end else if (clear_i || start_i) begin
      state_q  <= Wait;
      inside_q <= 1'b0;
    end else begin
      unique case (state_q)
        Wait:  if (gap_valid_i) state_q <= One;
        Align: if (aligned) state_q <= Fill;
        Fill:  if (word_valid_o && word_ready_i) inside_q <= !last;
        default: state_q <= state_q + 3'd1;
      endcase
      `CHECK(rows_upwards, !(state_q == Fill && gap_valid_i) || $signed(y_q) <= $signed(T'(gap_y_i)))
    end
  end
  always_ff @(posedge clk_i) begin
    unique case (state_q)
      Wait: begin
        x_q    <= start_x_i;
        y_q    <= start_y_i;
        away_q <= 1'b0;
      end
      // The present value is that many steps.
      Three: begin
        whole2_q <= whole_i;
        rest2_q  <= rest_i;
      end
      Four: begin
        whole3_q <= whole_i;
        rest3_q  <= rest_i;
      end
      Load: begin
        whole4_q <= whole_i;
        rest4_q  <= rest_i;
      end
      Align: if (!aligned) x_q <= x_q - 1'b1;
      Fill: begin
        if (up) begin
          y_q    <= y_q + 1'b1;
          away_q <= 1'b0;
          if (away_q) x_q <= anchor_x_q;
        end else if (move_x_o) begin
          x_q <= back_o ? x_q - T'(4) : x_q + T'(4);
        end
        if (word_valid_o && !inside_q && !away_q) begin
          anchor_x_q     <= x_q;
          anchor_whole_q <= whole_i;
          anchor_rest_q  <= rest_i;
        end
        if (word_valid_o && word_ready_i) away_q <= 1'b1;
      end
      default: ;
    endcase
  end

  // ---- Depths of a word's texels ----
  logic [D:0]       sum1, sum2, sum3;
  /* verilator lint_off UNUSEDSIGNAL */ // steps are stored
  logic [Depth-1:0] depth1, depth2, depth3;
  /* verilator lint_on UNUSEDSIGNAL */
  assign sum1   = {1'b0, rest_i} + {1'b0, step_x_rest_i};
  assign sum2   = {1'b0, rest_i} + {1'b0, rest2_q};
  assign sum3   = {1'b0, rest_i} + {1'b0, rest3_q};
  assign depth1 = whole_i + step_x_whole_i + Depth'(sum1 >= {1'b0, base_i});
  assign depth2 = whole_i + whole2_q + Depth'(sum2 >= {1'b0, base_i});
  assign depth3 = whole_i + whole3_q + Depth'(sum3 >= {1'b0, base_i});
  assign bases_o = {depth3[Depth-1 -: B], depth2[Depth-1 -: B], depth1[Depth-1 -: B], whole_i[Depth-1 -: B]};
endmodule

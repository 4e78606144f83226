// Plane's quotients: the divider of plane_setup and what it finds, the ramp's steps and start.
//
// Numbers: as plane_setup. Depths are modular: what is above is cut off.
// Timing:  of divider; a sum waits here while that is at work.
`include "check.svh"
module plane_quotients #(
  parameter int unsigned NumeratorBits = 83,
  parameter int unsigned QuotientBits  = 61,  // odd
  localparam int unsigned Depth = shadow_pkg::DepthRange,
  localparam int unsigned D     = 57
) (
  input  logic                     clk_i,
  input  logic                     rst_ni,
  input  logic                     clear_i,
  input  logic                     flush_i,       // no division goes on or begins
  // a sum, which holds until it is taken
  input  logic                     valid_i,       // in its first cycle
  output logic                     taken_o,
  output logic                     ready_o,
  input  logic [1:0]               division_i,    // which, see plane_setup
  input  logic [NumeratorBits-1:0] numerator_i,
  input  logic [D-1:0]             divisor_i,
  // gradients go to the encoder
  output logic                     gradient_valid_o,
  input  logic                     encoder_ready_i,
  output logic [QuotientBits-1:0]  quotient_o,
  // the start is taken when its bias is there
  input  logic                     bias_ready_i,
  input  logic [Depth-1:0]         bias_i,
  output logic                     start_done_o,
  output logic                     narrow_done_o, // quotient_o: depth along the longest edge
  // the start may be taken from the walk
  input  logic                     keep_i,
  input  logic [Depth-1:0]         whole_i,
  input  logic [D-1:0]             rest_i,
  output logic [Depth-1:0]         step_x_whole_o,
  output logic [D-1:0]             step_x_rest_o,
  output logic [Depth-1:0]         step_y_whole_o,
  output logic [D-1:0]             step_y_rest_o,
  output logic [Depth-1:0]         start_whole_o,
  output logic [D-1:0]             start_rest_o
);
  localparam logic [1:0] StepX = 2'd0, StepY = 2'd1, Start = 2'd2, Narrow = 2'd3;
  logic         div_valid, div_done, div_take, waiting_q;  // waiting_q: the sum is complete
  logic [1:0]   waits_for, waits_for_q, division_q;
  logic [D-1:0] remainder;
  assign waits_for = valid_i ? division_i : waits_for_q;
  assign div_valid = (valid_i || waiting_q) && !flush_i;
  assign taken_o   = div_valid && ready_o;
  divider #(.NumeratorBits(NumeratorBits), .DivisorBits(D), .QuotientBits(QuotientBits), .SkipBits(8)) division (
    .clk_i, .rst_ni, .clear_i(clear_i || flush_i),
    .valid_i(div_valid), .ready_o, .numerator_i, .divisor_i,
    .valid_o(div_done), .ready_i(div_take), .quotient_o, .remainder_o(remainder));
  always_comb begin
    unique case (division_q)
      StepX, StepY: div_take = encoder_ready_i;
      Start:        div_take = bias_ready_i;
      default:      div_take = 1'b1;
    endcase
  end
  assign gradient_valid_o = div_done && (division_q == StepX || division_q == StepY);
  assign start_done_o     = div_done && div_take && division_q == Start;
  assign narrow_done_o    = div_done && division_q == Narrow;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) waiting_q <= 1'b0;
    else waiting_q <= div_valid && !ready_o && !flush_i && !clear_i;
  end
  always_ff @(posedge clk_i) begin
    waits_for_q <= waits_for;
    if (taken_o) division_q <= waits_for;
    if (keep_i) begin
      start_whole_o <= whole_i;
      start_rest_o  <= rest_i;
    end else if (div_done && div_take) begin
      unique case (division_q)
        StepX: begin
          step_x_whole_o <= quotient_o[Depth-1:0];
          step_x_rest_o  <= remainder;
        end
        StepY: begin
          step_y_whole_o <= quotient_o[Depth-1:0];
          step_y_rest_o  <= remainder;
        end
        Start: begin
          start_whole_o <= quotient_o[Depth-1:0] + bias_i;
          start_rest_o  <= remainder;
        end
        default: ;
      endcase
    end
  end
endmodule

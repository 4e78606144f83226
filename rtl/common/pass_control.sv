// Sequences passes: what runs, when it is done, and the way out of an aborted one.
//
// Timing: busy from the cycle after start_i until the last beat of the pass has gone; an abort
//         closes the channels, then holds clear_o until no response is outstanding.
`include "check.svh"
module pass_control (
  input  logic        clk_i,
  input  logic        rst_ni,
  input  logic        start_i,     // one cycle; idle
  input  logic [2:0]  pass_i,
  input  logic [31:0] count_i,
  input  logic        abort_i,     // one cycle
  input  logic [2:0]  items_i,     // items taken in this cycle: triangles, or fragments of all lanes
  // how far the blocks are
  input  logic        front_idle_i,
  input  logic        store_idle_i,
  input  logic        wiped_i,
  input  logic        settled_i,
  input  logic        lanes_idle_i,
  input  logic        closed_i,       // every channel out of the unit is
  input  logic        outstanding_i,  // some read has no response yet
  output logic [2:0]  pass_o,         // that runs; PassIdle also while an abort ends
  output logic        pass2_o,        // the pass that runs or ran last is pass 2; so also while its abort ends
  output logic        busy_o,
  output logic        open_o,         // items of the pass may enter
  output logic        waits_o,        // some item of the pass has not entered
  output logic        close_o,        // to the abort guard
  output logic        clear_o,        // drops everything inside
  output logic        clear_lanes_o,
  output logic        done_o,         // one cycle
  output logic [31:0] cycles_o        // of the running or the last pass
);
  localparam logic [1:0] Idle = 2'd0, Run = 2'd1, Close = 2'd2, Clear = 2'd3;
  logic [1:0]  state_d, state_q;
  logic [2:0]  pass_q;
  logic [31:0] left_q, cycles_q;  // left_q: without those taken in the cycle before
  logic [2:0]  items_q;
  logic        finished;

  always_comb begin
    case (pass_q)
      shadow_pkg::PassWipe:     finished = wiped_i;
      shadow_pkg::PassAnnounce: finished = !waits_o && store_idle_i;
      shadow_pkg::PassDraw:     finished = !waits_o && front_idle_i && store_idle_i;
      shadow_pkg::PassSettle:   finished = settled_i;
      shadow_pkg::PassDecide:   finished = !waits_o && lanes_idle_i;
      default:                  finished = 1'b1;
    endcase
  end

  always_comb begin
    state_d = state_q;
    case (state_q)
      Idle:  if (start_i) state_d = Run;
      Run:   if (abort_i) state_d = Close; else if (finished) state_d = Idle;
      Close: if (closed_i) state_d = Clear;
      Clear: if (!outstanding_i) state_d = Idle;
    endcase
  end

  assign pass_o        = state_q == Idle || state_q == Clear ? shadow_pkg::PassIdle : pass_q;
  assign pass2_o       = pass_q == shadow_pkg::PassDecide;
  assign busy_o        = state_q != Idle;
  assign waits_o       = left_q != 32'(items_q);
  // What is offered stays offered inside until everything is cleared.
  assign open_o        = (state_q == Run || state_q == Close) && waits_o;
  assign close_o       = state_q == Close || state_q == Clear;
  assign clear_o       = state_q == Clear;
  assign clear_lanes_o = clear_o || start_i;  // what a lane keeps of the memories is of one pass
  assign done_o        = state_q != Idle && state_d == Idle;
  assign cycles_o      = cycles_q;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      state_q <= Idle;
    end else begin
      state_q <= state_d;
      `CHECK(no_start_while_busy, !start_i || state_q == Idle)
      `CHECK(no_more_items_than_counted, state_q != Run || 32'(items_i) <= left_q - 32'(items_q))
    end
  end

  always_ff @(posedge clk_i) begin
    if (start_i) begin
      pass_q   <= pass_i;
      left_q   <= pass_i == shadow_pkg::PassAnnounce || pass_i == shadow_pkg::PassDraw ||
                  pass_i == shadow_pkg::PassDecide ? count_i : '0;
      items_q  <= '0;
      cycles_q <= '0;
    end else if (state_q == Run) begin
      left_q   <= left_q - 32'(items_q);
      items_q  <= items_i;
      cycles_q <= cycles_q + 32'd1;
    end
  end
endmodule

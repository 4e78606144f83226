// What is known of each line of a cache. Part of line_cache.
//
// An update shows a cycle late, for whether there is one is known last: who looks at its line in between
// is told so by update_o. Counts of lookups that are still to come say nothing of a line without a word:
// they are undefined at first.
// Timing:  all else shows in the next cycle. Of what meets in a cycle the last named here holds.
`include "check.svh"
module line_flags #(
  parameter int unsigned Lines = 4,
  parameter int unsigned Ways  = 1,
  localparam int unsigned LineBits = $clog2(Lines)
) (
  input  logic                clk_i,
  input  logic                rst_ni,
  input  logic                clear_i,        // no line holds a word; reads under way go on
  input  logic                unsent_i,       // but for this one
  input  logic [LineBits-1:0] unsent_line_i,
  input  logic                hint_i,         // one more lookup of its word is to come; up to two are counted
  input  logic [LineBits-1:0] hint_line_i,
  input  logic                met_i,          // one came
  input  logic [LineBits-1:0] met_line_i,
  input  logic                came_i,         // the response
  input  logic [LineBits-1:0] came_line_i,
  input  logic                update_i,       // holds a newer word
  input  logic [LineBits-1:0] update_line_i,
  input  logic                take_i,         // .. of an address that it did not have;
  input  logic                move_i,         // the set's other way gives its word up
  input  logic                fill_i,         // is read
  input  logic [LineBits-1:0] fill_line_i,
  input  logic                fill_hinted_i,  // a lookup is to come
  output logic [Lines-1:0]    valid_o,        // holds a word, or will
  output logic [Lines-1:0]    busy_o,         // is being read; the word is kept if valid
  output logic [Lines-1:0]    updated_o,      // the word is in the memory of updates
  output logic [Lines-1:0]    awaited_o,      // a lookup is still to come
  output logic                update_o,       // of the cycle before
  output logic [LineBits-1:0] update_line_o
);
  logic [Lines-1:0]    valid_q, busy_q, valid_d, busy_d, updated_q;
  logic [Lines-1:0]    hinted_q, again_q;  // a lookup is still to come, and another one
  logic                update_q, take_q, move_q;
  logic [LineBits-1:0] update_line_q;

  assign valid_o       = valid_q;
  assign busy_o        = busy_q;
  assign updated_o     = updated_q;
  assign awaited_o     = valid_q & hinted_q;
  assign update_o      = update_q;
  assign update_line_o = update_line_q;

  always_comb begin
    valid_d = valid_q;
    busy_d  = busy_q;
    if (came_i) busy_d[came_line_i] = 1'b0;
    if (Ways == 2 && move_q) valid_d[update_line_q ^ LineBits'(1)] = 1'b0;
    if (update_q) valid_d[update_line_q] = 1'b1;
    if (fill_i) begin
      valid_d[fill_line_i] = 1'b1;
      busy_d[fill_line_i]  = 1'b1;
    end
    // Dropped requests were never sent: nothing will come back for them.
    if (clear_i) begin
      valid_d = '0;
      if (fill_i) busy_d[fill_line_i] = 1'b0;
      if (unsent_i) busy_d[unsent_line_i] = 1'b0;
    end
  end

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      valid_q  <= '0;
      busy_q   <= '0;
      update_q <= 1'b0;
      move_q   <= 1'b0;
    end else begin
      valid_q  <= valid_d;
      busy_q   <= busy_d;
      update_q <= update_i && !clear_i;
      move_q   <= move_i && !clear_i;
      `CHECK(response_was_asked_for, !came_i || busy_q[came_line_i])
    end
  end

  always_ff @(posedge clk_i) begin
    take_q        <= take_i;
    update_line_q <= update_line_i;
    if (hint_i && !(met_i && hint_line_i == met_line_i)) begin
      again_q[hint_line_i]  <= hinted_q[hint_line_i];
      hinted_q[hint_line_i] <= 1'b1;
    end
    if (met_i && !(hint_i && hint_line_i == met_line_i)) begin
      hinted_q[met_line_i] <= again_q[met_line_i];
      again_q[met_line_i]  <= 1'b0;
    end
    if (update_q) begin
      updated_q[update_line_q] <= 1'b1;
      if (take_q) begin
        hinted_q[update_line_q] <= 1'b0;
        again_q[update_line_q]  <= 1'b0;
      end
    end
    if (fill_i) begin
      updated_q[fill_line_i] <= 1'b0;
      hinted_q[fill_line_i]  <= fill_hinted_i;
      again_q[fill_line_i]   <= 1'b0;
    end
  end
endmodule

// Of any word that enters the FIFO: it leaves once, as it was, behind exactly the words that entered
// before it, however long the reader waits; and the FIFO never stops while somebody reads.
//
// broken: fifo.sv: `if (push) tail_q <= tail_q + 1'b1;` => `if (push && !fetch) tail_q <= tail_q + 1'b1;`
// broken: fifo.sv: `(!out_valid_q || ready_i);` => `(!out_valid_q || ready_i || valid_i);`
// broken: fifo.sv: `!= (PtrBits + 1)'(Depth);` => `!= (PtrBits + 1)'(Depth - 1);`
// broken: fifo.sv: `out_valid_q <= fetch || (out_valid_q && !ready_i);` => `out_valid_q <= fetch || out_valid_q;`
// broken: fifo.sv: `.read_addr_i(head_q[PtrBits-1:0])` => `.read_addr_i(tail_q[PtrBits-1:0])`
module fifo_proof #(
  parameter int unsigned Width = 2,
  parameter int unsigned Depth = 4
) (
  input logic             clk_i,
  input logic             clear_i,
  input logic             valid_i,
  input logic             ready_i,
  input logic [Width-1:0] data_i,
  input logic             pick_i  // the word that enters now is the one that is followed
);
  logic running_q = 1'b0;  // reset ends after the first cycle
  always_ff @(posedge clk_i) running_q <= 1'b1;

  logic             ready_o, valid_o, empty_o;
  logic [Width-1:0] data_o;
  fifo #(.Width(Width), .Depth(Depth)) dut (.rst_ni(running_q), .*);

  logic [3:0] inside_q = '0;       // words
  logic [3:0] ahead_q = '0;        // of the word that is followed
  logic       followed_q = 1'b0;   // it is inside
  logic [Width-1:0] word_q;
  logic [1:0] waited_q = '0;       // cycles in which words were inside and none was offered
  logic       held_q = 1'b0;       // an offer was not taken
  logic [Width-1:0] held_data_q;
  wire push = valid_i && ready_o;
  wire pop  = valid_o && ready_i;

  always_ff @(posedge clk_i) begin
    if (running_q) begin
      assert (empty_o == (inside_q == '0));
      assert (ready_o || inside_q == 4'(Depth + 1));
      assert (inside_q <= 4'(Depth + 1));
      assert (!valid_o || inside_q != '0);
      assert (waited_q != 2'd2);
      if (held_q) assert (valid_o && data_o == held_data_q);
      if (pop && followed_q) assert (ahead_q != '0 || data_o == word_q);

      inside_q <= inside_q + 4'(push) - 4'(pop);
      waited_q <= inside_q != '0 && !valid_o ? waited_q + 2'd1 : '0;
      held_q      <= valid_o && !ready_i;
      held_data_q <= data_o;
      if (push && pick_i && !followed_q) begin
        followed_q <= 1'b1;
        word_q     <= data_i;
        ahead_q    <= inside_q - 4'(pop);
      end else if (pop && followed_q) begin
        followed_q <= ahead_q != '0;
        ahead_q    <= ahead_q - 4'd1;
      end
      if (clear_i) begin
        inside_q   <= '0;
        followed_q <= 1'b0;
        waited_q   <= '0;
        held_q     <= 1'b0;
      end
    end
  end
endmodule

// First-in first-out queue. Width bits, Depth entries; a word is at the output two cycles after it
// went in at the earliest, then one a cycle.
//
// The words stand in a ram_1r1w and, ahead of it, an output register, so that the read port's cycle
// is hidden.
`include "check.svh"
module fifo #(
  parameter int unsigned Width = 8,
  parameter int unsigned Depth = 4  // a power of two; one more stands in the output register
) (
  input  logic             clk_i,
  input  logic             rst_ni,
  input  logic             clear_i,  // drops everything
  input  logic             valid_i,
  output logic             ready_o,
  input  logic [Width-1:0] data_i,
  output logic             valid_o,
  input  logic             ready_i,
  output logic [Width-1:0] data_o,
  output logic             empty_o  // nothing inside, output register included
);
  localparam int unsigned Words   = Depth < 2 ? 2 : Depth;  // of the memory
  localparam int unsigned PtrBits = $clog2(Words);
  logic [PtrBits:0] head_q, tail_q;  // read, write; one bit more tells full from empty
  logic out_valid_q;
  logic push, fetch;

  assign ready_o = (tail_q - head_q) != (PtrBits + 1)'(Depth);
  assign push    = valid_i && ready_o;
  // The word read in this cycle is the output of the next: data_o holds until then.
  assign fetch   = head_q != tail_q && (!out_valid_q || ready_i);
  assign valid_o = out_valid_q;
  assign empty_o = !out_valid_q && head_q == tail_q;

  ram_1r1w #(.Width(Width), .Depth(Words)) ram (
    .clk_i,
    .write_i(push), .write_addr_i(tail_q[PtrBits-1:0]), .write_data_i(data_i),
    .read_i(fetch), .read_addr_i(head_q[PtrBits-1:0]), .read_data_o(data_o)
  );

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      head_q      <= '0;
      tail_q      <= '0;
      out_valid_q <= 1'b0;
    end else if (clear_i) begin
      head_q      <= '0;
      tail_q      <= '0;
      out_valid_q <= 1'b0;
    end else begin
      if (push) tail_q <= tail_q + 1'b1;
      if (fetch) head_q <= head_q + 1'b1;
      out_valid_q <= fetch || (out_valid_q && !ready_i);
      `CHECK(never_overfull, (tail_q - head_q) <= (PtrBits + 1)'(Depth))
    end
  end
endmodule

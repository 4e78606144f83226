// Is a response of a memory port still due?
`include "check.svh"
module memory_reads (
  input  logic clk_i,
  input  logic rst_ni,
  input  logic request_i,   // a read was accepted
  input  logic response_i,  // a response came
  output logic outstanding_o
);
  logic [shadow_pkg::TagBits:0] count_q;  // tags are unique, so no more than there are tags

  assign outstanding_o = count_q != '0;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      count_q <= '0;
    end else begin
      count_q <= count_q + (shadow_pkg::TagBits + 1)'(request_i) - (shadow_pkg::TagBits + 1)'(response_i);
      `CHECK(response_was_asked_for, !response_i || outstanding_o)
    end
  end
endmodule

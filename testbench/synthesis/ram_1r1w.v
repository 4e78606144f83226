// rtl/common/ram_1r1w.sv as Icarus Verilog takes it. Contents are unknown until written; reading at
// an unknown address gives unknown data, and writing at one makes every word unknown.
`timescale 1ns/1ps
module ram_1r1w #(
  parameter Width = 8,
  parameter Depth = 16,
  parameter AddrBits = $clog2(Depth)
) (
  input                     clk_i,
  input                     write_i,
  input      [AddrBits-1:0] write_addr_i,
  input      [Width-1:0]    write_data_i,
  input                     read_i,
  input      [AddrBits-1:0] read_addr_i,
  output reg [Width-1:0]    read_data_o
);
  reg [Width-1:0] words [0:Depth-1];
  integer i;
  always @(posedge clk_i) begin
    if (read_i === 1'b1) read_data_o <= words[read_addr_i];
    else if (read_i !== 1'b0) read_data_o <= {Width{1'bx}};
    if (write_i !== 1'b0) begin
      if (write_i === 1'bx || write_i === 1'bz || ^write_addr_i === 1'bx) begin
        for (i = 0; i < Depth; i = i + 1) words[i] <= {Width{1'bx}};
      end else begin
        words[write_addr_i] <= write_data_i;
      end
    end
  end
endmodule

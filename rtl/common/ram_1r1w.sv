// Memory with one write and one read port, for FIFOs and what is kept on chip.
//
// Timing:  data of the address in cycle n is on read_data_o in n + 1, and stays until the next read.
//          A read of the word that the same cycle writes returns the old data.
// Synthesis: black box; its bits are counted apart. Contents are undefined until written.
module ram_1r1w #(
  parameter int unsigned Width = 8,
  parameter int unsigned Depth = 16,  // words, a power of two, 2 or more
  localparam int unsigned AddrBits = $clog2(Depth)
) (
  input  logic                clk_i,
  input  logic                write_i,
  input  logic [AddrBits-1:0] write_addr_i,
  input  logic [Width-1:0]    write_data_i,
  input  logic                read_i,
  input  logic [AddrBits-1:0] read_addr_i,
  output logic [Width-1:0]    read_data_o
);
  logic [Width-1:0] words[Depth];
  always_ff @(posedge clk_i) begin
    if (write_i) words[write_addr_i] <= write_data_i;
    if (read_i) read_data_o <= words[read_addr_i];
  end
endmodule

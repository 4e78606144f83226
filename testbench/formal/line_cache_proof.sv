// Whatever the owner, the hints and the memory do, a hit is the word last written to its address, or
// the memory's, updates of the cycle before included; words go to memory as they were written, in an
// order in which it ends with the last of each address; a read never asks for a word that a waiting
// write replaces; a tag is not used again while its response is due. One way, two lines.
//
// broken: line_cache.sv: `.write_data_i(update_data_i)` => `.write_data_i(rsp_data_i)`
// broken: line_cache.sv: `(!raced && (match` => `((match`
// broken: line_cache.sv: `&& (in_place ||` => `&& (1'b1 ||`
// broken: line_cache.sv: `rd_valid_q && !(wr_valid_q && wr_addr_q == rd_addr_q)` => `rd_valid_q`
module line_cache_proof (
  input logic       clk_i,
  input logic       hint_valid_i,
  input logic       hint_weak_i,
  input logic       lookup_i,
  input logic       lookup_new_i,
  input logic       lookup_end_i,
  input logic       update_i,
  input logic       rd_ready_i,
  input logic       rsp_valid_i,
  input logic       wr_ready_i,
  input logic       rsp_tag_i,
  input logic       rsp_data_i,
  input logic       update_data_i,
  input logic [1:0] hint_addr_i,
  input logic [1:0] lookup_addr_i,
  input logic [1:0] update_addr_i
);
  logic running_q = 1'b0;
  always_ff @(posedge clk_i) running_q <= 1'b1;

  logic       hint_ready_o, hit_o, data_o, update_ready_o, idle_o, rd_valid_o, rd_tag_o, wr_valid_o, wr_data_o;
  logic [1:0] rd_addr_o, wr_addr_o;
  line_cache #(.Width(1), .AddrBits(2), .Lines(2), .TagBits(1)) dut (
    .rst_ni(running_q), .clear_i(1'b0), .*
  );

  // Memory: one word an address; a read takes its word when it is accepted.
  logic [3:0] memory_q, now_q;        // what stands there; what the owner has written last
  logic [1:0] due_q = '0, due_data_q; // reads under way, by tag
  logic       lookup_q = 1'b0;
  logic [1:0] addr_q;
  logic       rd_held_q = 1'b0, wr_held_q = 1'b0, wr_data_q;
  logic [1:0] rd_addr_q, wr_addr_q;
  wire        updated = update_i && update_ready_o;

  always_ff @(posedge clk_i) begin
    if (!running_q) assume (memory_q == now_q);
    if (running_q) begin
      assume (!rsp_valid_i || (due_q[rsp_tag_i] && rsp_data_i == due_data_q[rsp_tag_i]));
      if (lookup_q && hit_o) assert (data_o == now_q[addr_q]);
      if (rd_held_q) assert (rd_valid_o && rd_addr_o == rd_addr_q);
      if (wr_held_q) assert (wr_valid_o && wr_addr_o == wr_addr_q && wr_data_o == wr_data_q);
      if (rd_valid_o) assert (!due_q[rd_tag_o]);
      if (idle_o) assert (memory_q == now_q && due_q == '0);

      if (lookup_i) addr_q <= lookup_addr_i;
      lookup_q <= lookup_i || (lookup_q && !lookup_end_i);
      if (rsp_valid_i) due_q[rsp_tag_i] <= 1'b0;
      if (rd_valid_o && rd_ready_i) begin
        due_q[rd_tag_o]      <= 1'b1;
        due_data_q[rd_tag_o] <= memory_q[rd_addr_o];
      end
      if (wr_valid_o && wr_ready_i) memory_q[wr_addr_o] <= wr_data_o;
      if (updated) now_q[update_addr_i] <= update_data_i;
      rd_held_q <= rd_valid_o && !rd_ready_i && !(wr_valid_o && wr_ready_i);
      rd_addr_q <= rd_addr_o;
      wr_held_q <= wr_valid_o && !wr_ready_i;
      wr_addr_q <= wr_addr_o;
      wr_data_q <= wr_data_o;
    end
  end
endmodule

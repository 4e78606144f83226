// A response is due exactly while a tag is in use, whatever requests and responses coincide, from reset on;
// and the count never wraps while tags are unique.
//
// package: TagBits=2
// broken: memory_reads.sv: `+ (shadow_pkg::TagBits + 1)'(request_i)` => `+ (shadow_pkg::TagBits + 1)'(request_i && !response_i)`
// broken: memory_reads.sv: `logic [shadow_pkg::TagBits:0] count_q;` => `logic [shadow_pkg::TagBits-1:0] count_q;`
// broken: memory_reads.sv: `- (shadow_pkg::TagBits + 1)'(response_i)` => `- (shadow_pkg::TagBits + 1)'(1'b0)`
module memory_reads_proof (
  input logic                           clk_i,
  input logic                           request_i,
  input logic                           response_i,
  input logic [shadow_pkg::TagBits-1:0] request_tag_i,
  input logic [shadow_pkg::TagBits-1:0] response_tag_i
);
  localparam int unsigned Tags = 1 << shadow_pkg::TagBits;
  logic running_q = 1'b0;
  always_ff @(posedge clk_i) running_q <= 1'b1;

  logic outstanding_o;
  memory_reads dut (.rst_ni(running_q), .*);

  logic [Tags-1:0] due_d, due_q = '0;
  always_comb begin
    due_d = due_q;
    if (request_i) due_d[request_tag_i] = 1'b1;
    if (response_i) due_d[response_tag_i] = 1'b0;
  end
  always_ff @(posedge clk_i) begin
    if (running_q) begin
      assume (!request_i || !due_q[request_tag_i]);
      assume (!response_i || due_q[response_tag_i]);  // so never in the cycle of its request
      assert (outstanding_o == (due_q != '0));
      due_q <= due_d;
    end
  end
endmodule

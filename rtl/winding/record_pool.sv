// Record pool: which records of the SLB are in use, and the next to be given out.
//
// Numbers: records that were never used go first, none has to be read for that; then those of the list of free
//          ones, whose links are in the records.
// Timing:  a spare record a cycle after the last was given, as long as there are fresh ones; else it is taken: the
//          first free record is read by the owner.
`include "check.svh"
module record_pool (
  input  logic                                  clk_i,
  input  logic                                  rst_ni,
  input  logic                                  clear_i,         // no record is in use
  input  logic [shadow_pkg::LimitBits-1:0]      record_limit_i,
  input  logic                                  given_i,         // the spare is in use now
  input  logic                                  released_i,      // one record is not any more
  input  logic                                  put_i,           // records from put_addr_i on, the last of which
  input  logic [shadow_pkg::RecordAddrBits-1:0] put_addr_i,      //   leads to free_o, join the list of free ones
  input  logic                                  take_i,          // the first free one becomes the spare; its link:
  input  logic [shadow_pkg::RecordAddrBits-1:0] take_next_i,
  input  logic                                  take_has_next_i,
  output logic [shadow_pkg::RecordAddrBits-1:0] spare_o,
  output logic                                  spare_ready_o,   // there is one, at the latest in the next cycle
  output logic [shadow_pkg::RecordAddrBits-1:0] free_o,
  output logic                                  free_valid_o,
  output logic                                  full_o,          // as many are in use as may be
  output logic [shadow_pkg::LimitBits-1:0]      used_o
);
  localparam int unsigned A = shadow_pkg::RecordAddrBits;
  localparam int unsigned LimitBits = shadow_pkg::LimitBits;
  logic [A-1:0]         spare_q, free_q;
  logic                 cleared_q, spare_valid_q, free_valid_q, fresh;  // cleared_q: before that the limit is not set
  logic [A:0]           fresh_q;  // records from here on were never in use
  logic [LimitBits-1:0] used_q;
  assign fresh         = cleared_q && LimitBits'(fresh_q) < record_limit_i;
  assign spare_o       = spare_q;
  assign spare_ready_o = spare_valid_q || fresh;
  assign free_o        = free_q;
  assign free_valid_o  = free_valid_q;
  assign full_o        = used_q >= record_limit_i;
  assign used_o        = used_q;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      cleared_q     <= 1'b0;
      spare_valid_q <= 1'b0;
      free_valid_q  <= 1'b0;
      fresh_q       <= '0;
      used_q        <= '0;
    end else if (clear_i) begin
      cleared_q     <= 1'b1;
      spare_valid_q <= 1'b0;
      free_valid_q  <= 1'b0;
      fresh_q       <= '0;
      used_q        <= '0;
    end else begin
      spare_valid_q <= take_i || (spare_valid_q ? !given_i : fresh);
      if (!spare_valid_q && fresh) fresh_q <= fresh_q + 1'b1;
      if (put_i) free_valid_q <= 1'b1;
      else if (take_i) free_valid_q <= take_has_next_i;
      used_q <= used_q + LimitBits'(given_i) - LimitBits'(released_i);
      `CHECK(gives_what_it_has, !given_i || (spare_valid_q && !full_o))
      `CHECK(takes_when_it_must, !take_i || (!spare_valid_q && !fresh && free_valid_q))
    end
  end
  always_ff @(posedge clk_i) begin
    if (take_i) spare_q <= free_q;
    else if (!spare_valid_q) spare_q <= fresh_q[A-1:0];
    if (put_i) free_q <= put_addr_i;
    else if (take_i) free_q <= take_next_i;
  end
endmodule

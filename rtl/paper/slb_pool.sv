// The SLB's records behind the buckets' own: which is the next to be taken. Part of silhouette_buffer.
//
// The spot is a record that just came free and is kept at hand, or else one never used before. Further
// freed ones are linked by `more`: the first is read (reuse_i) once the pool has no other.
// Twin:    allocate, release in model/unit/silhouette_buffer.cpp; addresses differ, which nothing shows.
// Timing:  what was done in one cycle shows in the next.
`include "check.svh"
module slb_pool (
  input  logic                  clk_i,
  input  logic                  rst_ni,
  input  logic                  clear_i,   // nothing is in use
  input  shadow_pkg::settings_t settings_i,
  input  logic                  begin_i,   // held while wiping: the pool begins at begin_addr_i
  input  logic [shadow_pkg::RecordAddrBits-1:0] begin_addr_i,
  // at most one of the four
  input  logic                  take_i,    // the spot
  input  logic                  keep_i,    // addr_i is the next spot; there is none at hand
  input  logic                  free_i,    // addr_i, which links to the first freed one, is the first now
  input  logic                  reuse_i,   // the first freed one is the next spot
  input  logic [shadow_pkg::RecordAddrBits-1:0] addr_i,
  input  logic                  next_valid_i,  // reuse_i: the freed one behind it
  input  logic [shadow_pkg::RecordAddrBits-1:0] next_i,
  input  logic                  more_i,    // one more record is in use, buckets' own ones included
  input  logic                  less_i,
  output logic [shadow_pkg::RecordAddrBits-1:0] spot_o,
  output logic                  kept_o,    // the spot is one that came free
  output logic                  dry_o,     // there is no spot
  output logic [shadow_pkg::RecordAddrBits-1:0] free_o,
  output logic                  has_free_o,
  output logic [shadow_pkg::LimitBits-1:0]      used_o
);
  localparam int unsigned AddrBits  = shadow_pkg::RecordAddrBits;
  localparam int unsigned LimitBits = shadow_pkg::LimitBits;

  logic [AddrBits-1:0]  spot_q, free_q, unused_q;  // unused_q: the first never used
  logic [LimitBits-1:0] used_q, used;  // used_q: a cycle behind, for more and less are known late
  logic                 more_q, less_q;
  logic [LimitBits:0]   pool_end;
  logic                 kept_q, has_free_q;

  assign pool_end   = ((LimitBits + 1)'(1) << settings_i.buckets_log2) + (LimitBits + 1)'(settings_i.record_limit);
  assign spot_o     = kept_q ? spot_q : unused_q;
  assign kept_o     = kept_q;
  assign dry_o      = !kept_q && (LimitBits + 1)'(unused_q) >= pool_end;
  assign free_o     = free_q;
  assign has_free_o = has_free_q;
  assign used       = used_q + LimitBits'(more_q) - LimitBits'(less_q);
  assign used_o     = used;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      kept_q     <= 1'b0;
      has_free_q <= 1'b0;
      more_q     <= 1'b0;
      less_q     <= 1'b0;
      used_q     <= '0;
    end else if (clear_i) begin
      kept_q     <= 1'b0;
      has_free_q <= 1'b0;
      more_q     <= 1'b0;
      less_q     <= 1'b0;
      used_q     <= '0;
    end else begin
      kept_q     <= keep_i || reuse_i || (kept_q && !take_i);
      has_free_q <= free_i || (reuse_i ? next_valid_i : has_free_q);
      more_q     <= more_i;
      less_q     <= less_i;
      used_q     <= used;
      `CHECK(within_capacity, !more_i || less_i || used < settings_i.record_limit)
      `CHECK(one_at_hand, !(keep_i || reuse_i) || !kept_q)
      `CHECK(takes_what_is_there, !take_i || !dry_o)
    end
  end

  always_ff @(posedge clk_i) begin
    if (begin_i) unused_q <= begin_addr_i;
    else if (take_i && !kept_q) unused_q <= unused_q + 1'b1;
    if (keep_i) spot_q <= addr_i;
    else if (reuse_i) spot_q <= free_q;
    if (free_i) free_q <= addr_i;
    else if (reuse_i) free_q <= next_i;
  end

  logic unused;
  assign unused = &{1'b0, settings_i};
endmodule

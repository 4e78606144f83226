// Shadow decision: what one SLB record says of a fragment.
//
// A cluster comes record by record; what its records before this one found comes with it and goes on with
// the answer, so that records of many fragments may be mixed.
// Twins:   model/unit/winding/shadow_unit_pass2.cpp, read_texel (from the clusters on) and inside
// Numbers: place UQ0.26 texel. The winding sum is exact for lists of up to 2^RecordAddrBits records.
// Timing:  a record taken in cycle n is answered in n + 3. One is taken a cycle, but where the place is within
//          the boxes of several of its segments: a cycle each of these, for the one cross product.
//          Inputs may come from memories: nothing but comparisons and the choice of a segment is done with
//          them before the first register.
module shadow_decision #(
  localparam int unsigned WindingBits = shadow_pkg::RecordAddrBits + shadow_pkg::SegmentCountBits + 1,
  localparam int unsigned ContextBits = WindingBits + 3
) (
  input  logic                                  clk_i,
  input  logic                                  rst_ni,
  input  logic                                  clear_i,
  input  logic                                  paper_semantics_i,  // own clusters are passed over
  // a record and its fragment
  input  logic                                  valid_i,
  output logic                                  ready_o,
  input  logic [shadow_pkg::SlotBits-1:0]       slot_i,
  input  logic [shadow_pkg::RecordBits-1:0]     record_i,   // record_t
  input  logic [ContextBits-1:0]                context_i,  // of the answer before; 0 for a list's first record
  input  logic [shadow_pkg::MaxFraction-1:0]    x_i,        // in the texel
  input  logic [shadow_pkg::MaxFraction-1:0]    y_i,
  input  logic [shadow_pkg::TraceDepthBits-1:0] depth_i,
  input  logic [shadow_pkg::IdBits-1:0]         object_i,
  // the answer
  output logic                                  valid_o,
  output logic [shadow_pkg::SlotBits-1:0]       slot_o,
  output logic                                  dark_o,     // decided: dark
  output logic                                  lit_o,      // decided: lit. Neither: read on at `next_o`
  output logic [shadow_pkg::RecordAddrBits-1:0] next_o,
  output logic [ContextBits-1:0]                context_o,
  output logic                                  begins_o,   // a cluster's first record
  output logic [shadow_pkg::SegmentCountBits-1:0] count_o   // its segments
);
  localparam int unsigned Segments = shadow_pkg::SegmentsPerRecord;
  localparam int unsigned G = shadow_pkg::EndBits;
  localparam int unsigned E = shadow_pkg::EndWidth;
  localparam int unsigned Below = shadow_pkg::MaxFraction - G;
  localparam int unsigned SumBits = shadow_pkg::SegmentCountBits + 1;  // of one record's segments

  typedef struct packed {
    logic                   continues;  // the next record is of the same cluster
    logic                   shadows;    // the fragment lies beyond the cluster's plane, and it may shadow it
    logic                   holds;      // the cluster is full, or a segment is near
    logic [WindingBits-1:0] winding;    // signed
  } context_t;
  // What a record's answer needs beside planes and segments.
  typedef struct packed {
    logic [shadow_pkg::SlotBits-1:0]         slot;
    logic                                    other;  // the cluster may shadow the fragment
    context_t                                past;
    logic                                    goes_on;
    logic                                    has_next;
    logic [shadow_pkg::RecordAddrBits-1:0]   next;
    logic [shadow_pkg::SegmentCountBits-1:0] count;
  } meta_t;

  shadow_pkg::record_t record;
  context_t            context_in, context_out;
  meta_t               meta0, meta1_q, meta2_q, meta3_q;
  logic                valid1_q, valid2_q, valid3_q;
  assign record     = record_i;
  assign context_in = context_i;

  always_comb begin
    meta0.slot     = slot_i;
    meta0.other    = !paper_semantics_i || record.object != object_i;
    meta0.past     = context_in;
    if (!context_in.continues) begin
      meta0.past.holds   = record.full;
      meta0.past.winding = WindingBits'(record.corner);
    end
    meta0.goes_on  = record.goes_on;
    meta0.has_next = record.has_next;
    meta0.next     = record.next;
    meta0.count    = record.count;
  end

  // ---- The plane and the segments -----------------------------------------------------------------
  logic [E-1:0] x_up, x_down, y_up, y_down;
  assign x_up   = E'(x_i[Below+:G]) + E'(x_i[Below-1]);
  assign x_down = E'(x_i[Below+:G]) + E'(x_i[Below-1] && x_i[Below-2:0] != '0);
  assign y_up   = E'(y_i[Below+:G]) + E'(y_i[Below-1]);
  assign y_down = E'(y_i[Below+:G]) + E'(y_i[Below-1] && y_i[Below-2:0] != '0);

  logic                                  beyond;
  logic [shadow_pkg::ThresholdBits-1:0]  threshold1_q;
  logic [shadow_pkg::MaxFraction-1:0]    x1_q, y1_q;
  logic [shadow_pkg::TraceDepthBits-1:0] depth1_q;
  threshold plane (
    .clk_i, .threshold_i(threshold1_q), .x_i(x1_q[Below+:G]), .y_i(y1_q[Below+:G]), .depth_i(depth1_q),
    .beyond_o(beyond)
  );

  // Segments with the place in their box are crossed one after the other; others are done at once.
  logic [Segments-1:0]          boxed, left, chosen, done_q;
  logic [2*Segments-1:0]        beside;    // what each adds if not boxed
  logic [shadow_pkg::SegmentBits-1:0] segment;
  logic signed [SumBits-1:0]    beside_sum, beside1_q, beside2_q, beside3_q, boxed_sum, boxed_sum_q;
  logic signed [1:0]            winding;
  logic                         crossed1_q, near, near_sum, near_sum_q;
  logic                         first1_q, first2_q, first3_q, last1_q, last2_q, last3_q;
  logic [shadow_pkg::SegmentBits-1:0] segment1_q;
  for (genvar i = 0; i < Segments; i++) begin : g_segment
    segment_box box (
      .valid_i(record.count > shadow_pkg::SegmentCountBits'(i)),
      .segment_i(record.segments[i*shadow_pkg::SegmentBits+:shadow_pkg::SegmentBits]),
      .x_up_i(x_up), .x_down_i(x_down), .y_up_i(y_up), .y_down_i(y_down), .y_floor_i(y_i[Below+:G]),
      .boxed_o(boxed[i]), .winding_o(beside[2*i+:2])
    );
  end
  assign left    = boxed & ~done_q;
  assign chosen  = left & (~left + 1'b1);  // the lowest one
  assign ready_o = left == chosen;
  always_comb begin
    segment    = '0;
    beside_sum = '0;
    for (int unsigned i = 0; i < Segments; i++) begin
      if (chosen[i]) segment = segment | record.segments[i*shadow_pkg::SegmentBits+:shadow_pkg::SegmentBits];
      if (!boxed[i]) beside_sum = beside_sum + SumBits'($signed(beside[2*i+:2]));
    end
  end
  crossing cross_product (
    .clk_i, .valid_i(crossed1_q), .segment_i(segment1_q), .x_i(x1_q), .y_i(y1_q), .boxed_i(crossed1_q),
    .winding_o(winding), .near_o(near)
  );

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      valid1_q <= 1'b0;
      valid2_q <= 1'b0;
      valid3_q <= 1'b0;
      done_q   <= '0;
    end else begin
      valid1_q <= valid_i && !clear_i;
      valid2_q <= valid1_q && !clear_i;
      valid3_q <= valid2_q && !clear_i;
      done_q   <= valid_i && !ready_o && !clear_i ? done_q | chosen : '0;
    end
  end
  always_ff @(posedge clk_i) begin
    threshold1_q <= record.threshold;
    depth1_q    <= depth_i;
    crossed1_q  <= chosen != '0;
    segment1_q  <= segment;
    x1_q        <= x_i;
    y1_q        <= y_i;
    beside1_q   <= beside_sum;
    beside2_q   <= beside1_q;
    beside3_q   <= beside2_q;
    first1_q    <= done_q == '0;
    first2_q    <= first1_q;
    first3_q    <= first2_q;
    last1_q     <= ready_o;
    last2_q     <= last1_q;
    last3_q     <= last2_q;
    boxed_sum_q <= boxed_sum;
    near_sum_q  <= near_sum;
  end
  assign boxed_sum = (first3_q ? '0 : boxed_sum_q) + SumBits'(winding);
  assign near_sum  = (!first3_q && near_sum_q) || near;
  always_ff @(posedge clk_i) begin
    meta1_q <= meta0;
    meta2_q <= meta1_q;
    meta3_q <= meta2_q;
  end

  // ---- Together ---------------------------------------------------------------------------------
  always_comb begin
    context_out.continues = meta3_q.goes_on;
    context_out.shadows   = meta3_q.past.continues ? meta3_q.past.shadows : beyond && meta3_q.other;
    context_out.holds     = meta3_q.past.holds || near_sum;
    context_out.winding   = meta3_q.past.winding + WindingBits'(boxed_sum) + WindingBits'(beside3_q);
  end
  assign valid_o   = valid3_q && last3_q;
  assign slot_o    = meta3_q.slot;
  assign dark_o    = !meta3_q.goes_on && context_out.shadows &&
                     (context_out.holds || $signed(context_out.winding) > 0);
  assign lit_o     = !meta3_q.goes_on && !meta3_q.has_next && !dark_o;
  assign next_o    = meta3_q.next;
  assign context_o = context_out;
  assign begins_o  = !meta3_q.past.continues;
  assign count_o   = meta3_q.count;
endmodule

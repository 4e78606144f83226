// Buckets that spans will walk: those of the texels with lines in a word that was fetched for a span.
// Part of the store. Hints: they change time, never a value.
//
// Where a word belongs is known when its span enters the queue, whether its texels hold lines when it
// comes from memory. In between a table by address and one by tag pass on what the span covers. Words
// that are on chip already come to nothing: their records were fetched not long ago.
// Timing:  first hint two cycles after the word has come.
module span_hints (
  input  logic                  clk_i,
  input  logic                  rst_ni,
  input  logic                  clear_i,
  input  shadow_pkg::settings_t settings_i,
  // a visit enters the queue
  input  logic                  visit_i,
  input  logic                  visit_span_i,
  input  logic [shadow_pkg::TexelAddrBits-1:0]  visit_addr_i,
  input  logic [shadow_pkg::RecordAddrBits-1:0] visit_bucket_i,
  input  logic [shadow_pkg::TexelsPerWord-1:0]  visit_mask_i,
  // its word is asked for, and comes
  input  logic                  read_i,
  input  logic [shadow_pkg::TexelAddrBits-1:0]  read_addr_i,
  input  logic [shadow_pkg::TagBits-1:0]        read_tag_i,
  input  logic                  rsp_valid_i,
  input  logic [shadow_pkg::TagBits-1:0]        rsp_tag_i,
  input  logic [shadow_pkg::TexelDataBits-1:0]  rsp_data_i,
  output logic                  hint_valid_o,
  input  logic                  hint_ready_i,
  output logic [shadow_pkg::RecordAddrBits-1:0] hint_addr_o
);
  localparam int unsigned AddrBits = shadow_pkg::RecordAddrBits;
  localparam int unsigned Texels   = shadow_pkg::TexelsPerWord;
  localparam int unsigned SlotBits = 6;
  localparam int unsigned KeyBits  = shadow_pkg::TexelAddrBits - SlotBits;
  localparam int unsigned SpanBits = AddrBits + Texels;
  localparam int unsigned LineBits = $clog2(shadow_pkg::TexelLines);

  logic [SpanBits-1:0] span, word;  // {bucket, texels that it covers}
  logic [KeyBits-1:0]  key, key_q;
  logic [LineBits-1:0] tag_q;
  logic                read_q, came_q, unknown_q;  // unknown_q: it came before the table had it
  logic [Texels-1:0]   edges_q, todo_q;
  logic [AddrBits-1:0] bucket_q;
  logic [1:0]          texel;
  logic [Texels-1:0]   fresh;

  ram_1r1w #(.Width(KeyBits + SpanBits), .Depth(1 << SlotBits)) queued (
    .clk_i, .write_i(visit_i), .write_addr_i(visit_addr_i[SlotBits-1:0]),
    .write_data_i({visit_addr_i[shadow_pkg::TexelAddrBits-1:SlotBits], visit_bucket_i,
                   visit_span_i ? visit_mask_i : Texels'(0)}),
    .read_i(read_i), .read_addr_i(read_addr_i[SlotBits-1:0]), .read_data_o({key, span})
  );
  ram_1r1w #(.Width(SpanBits), .Depth(shadow_pkg::TexelLines)) fetched (
    .clk_i, .write_i(read_q), .write_addr_i(tag_q),
    .write_data_i({span[SpanBits-1:Texels], span[Texels-1:0] & {Texels{key == key_q}}}),
    .read_i(rsp_valid_i), .read_addr_i(rsp_tag_i[LineBits-1:0]), .read_data_o(word)
  );

  // A texel's bucket is the one behind its left neighbour's: (x + 181 y) mod the buckets.
  assign texel        = todo_q[0] ? 2'd0 : todo_q[1] ? 2'd1 : todo_q[2] ? 2'd2 : 2'd3;
  assign fresh        = word[Texels-1:0] & edges_q & {Texels{!unknown_q}};
  assign hint_valid_o = todo_q != '0;
  assign hint_addr_o  = (bucket_q + AddrBits'(texel)) & ~({AddrBits{1'b1}} << settings_i.buckets_log2);

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      read_q <= 1'b0;
      came_q <= 1'b0;
      todo_q <= '0;
    end else begin
      read_q <= read_i;
      came_q <= rsp_valid_i && !clear_i;
      // What was not hinted yet gives way.
      if (clear_i) todo_q <= '0;
      else if (came_q && fresh != '0) todo_q <= fresh;
      else if (hint_ready_i) todo_q <= todo_q & (todo_q - 1'b1);
    end
  end
  always_ff @(posedge clk_i) begin
    key_q <= read_addr_i[shadow_pkg::TexelAddrBits-1:SlotBits];
    tag_q <= read_tag_i[LineBits-1:0];
    for (int unsigned i = 0; i < Texels; i++) begin
      edges_q[i] <= rsp_data_i[i*shadow_pkg::TexelBits + shadow_pkg::IdBits + shadow_pkg::DepthBits + 1];
    end
    if (came_q && fresh != '0) bucket_q <= word[SpanBits-1:Texels];
    unknown_q <= read_q && rsp_tag_i[LineBits-1:0] == tag_q;
  end

  logic unused;
  assign unused = &{1'b0, settings_i, rsp_data_i, rsp_tag_i, read_tag_i};
endmodule

// What becomes of an SLB record in one update: a base, its links, its lines. Part of silhouette_buffer.
// Timing:  combinational.
module record_update (
  input  shadow_pkg::record_t    record_i,    // as it stands
  // base
  input  logic                   fresh_i,     // a new entry of the visit's texel and object, without a line
  input  logic                   unused_i,    // all clear: a bucket without entries
  input  logic [2*shadow_pkg::MapBits-1:0] texel_i,
  input  logic [shadow_pkg::IdBits-1:0]    object_i,
  input  logic [shadow_pkg::DepthBits-1:0] nearest_i,  // the visit's
  // links
  input  logic                   set_next_i,
  input  logic                   has_next_i,
  input  logic [shadow_pkg::RecordAddrBits-1:0] next_i,
  input  logic                   set_more_i,
  input  logic                   has_more_i,
  input  logic [shadow_pkg::RecordAddrBits-1:0] more_i,
  // fields
  input  logic                   set_nearest_i,
  input  logic                   set_corner_i,
  input  logic                   set_vertex_i,  // a line was added to this entry
  // lines: at most one of the two
  input  logic                   append_i,
  input  shadow_pkg::line_t      line_i,
  input  logic                   remove_i,
  input  logic [shadow_pkg::LinesPerRecord-1:0] from_i,  // bit i: the removed line is i or before
  input  logic                   refill_i,    // `last_i` moves up from the next record: the count stays
  input  logic [shadow_pkg::LineBits-1:0]       last_i,
  output shadow_pkg::record_t    record_o
);
  localparam int unsigned Lines     = shadow_pkg::LinesPerRecord;
  localparam int unsigned LineBits  = shadow_pkg::LineBits;
  localparam int unsigned CountBits = shadow_pkg::LineCountBits;

  logic [CountBits-1:0]      count;  // of the base
  logic [Lines*LineBits-1:0] lines;
  logic                      vertex, corner;

  assign count  = fresh_i ? '0 : record_i.count;
  assign corner = record_i.corner && !fresh_i;
  // The flag is of the lines since the entry was last empty.
  assign vertex = record_i.vertex && count != '0;

  always_comb begin
    lines = record_i.lines;
    for (int unsigned i = 0; i < Lines; i++) begin
      if (remove_i && from_i[i]) begin
        lines[i*LineBits +: LineBits] =
            i + 1 < Lines ? record_i.lines[(i+1)%Lines*LineBits +: LineBits] : last_i;
      end
      if (append_i && count == CountBits'(i)) lines[i*LineBits +: LineBits] = line_i;
    end
  end

  always_comb begin
    record_o = record_i;
    if (fresh_i) begin
      record_o.used     = 1'b1;
      record_o.has_next = 1'b0;
      record_o.has_more = 1'b0;
      record_o.texel    = texel_i;
      record_o.object   = object_i;
      record_o.vertex   = 1'b0;
    end
    if (set_next_i) begin
      record_o.has_next = has_next_i;
      record_o.next     = next_i;
    end
    if (set_more_i) begin
      record_o.has_more = has_more_i;
      record_o.more     = more_i;
    end
    if (fresh_i || set_nearest_i) record_o.nearest = nearest_i;
    record_o.corner = corner || set_corner_i;
    if (set_vertex_i) record_o.vertex = vertex || line_i.start_here || line_i.end_here;
    record_o.count  = append_i ? count + 1'b1 : remove_i && !refill_i ? count - 1'b1 : count;
    record_o.lines  = lines;
    if (unused_i) record_o = '0;
  end
endmodule

// Visited rows: which texels of a row a triangle's outlines visited, one interval an edge, and the gaps
// between them.
//
// Twin:    VisitedRows in model/unit/span_filler.h.
// Numbers: columns off the map are kept as the one next to it, -1 or the map's width: neither a look-up on
//          the map nor a gap clipped to it can tell the difference. An edge's texels come row by row upwards
//          without leaving one out, so that the first and the last row tell which words count: nothing is cleared.
// Memory:  one of 2^MapBits words an edge.
// Timing:  a visit in cycle n is seen by look-ups from n + 1 on; a look-up in cycle n is answered in n + 1,
//          until the next one. Gaps: started in cycle n, the first row's in n + 3, then one row or gap a cycle.
`include "check.svh"
module visited_rows #(
  parameter int unsigned MapBits  = 10,  // of a texel index on the map
  parameter int unsigned RowIndexBits = 14  // of x, signed
) (
  input  logic                    clk_i,
  input  logic                    rst_ni,
  input  logic                    clear_i,
  input  logic [MapBits:0]        map_width_i,  // texels
  input  logic                    begin_i,      // a new triangle: nothing is visited; with no visit
  // a texel whose row is on the map
  input  logic                    visit_i,      // the edge visits it
  input  logic [1:0]              edge_i,       // 0 to 2
  input  logic [RowIndexBits-1:0] x_i,          // signed, from the map's corner
  input  logic [MapBits-1:0]      y_i,
  input  logic                    lookup_i,     // was it visited by one of
  input  logic [2:0]              passed_i,     // these? bit i: edge i; not the one that visits
  output logic                    visited_o,    // answer to the last look-up
  // gaps: runs of texels on the map strictly between visited ones of a row, rows and runs upwards
  input  logic                    gaps_i,       // start; no visit or look-up until done
  output logic                    gap_valid_o,
  input  logic                    gap_ready_i,
  output logic [MapBits-1:0]      gap_y_o,
  output logic [MapBits-1:0]      gap_from_o,   // first and
  output logic [MapBits-1:0]      gap_to_o,     // last column
  output logic                    gaps_busy_o   // from the cycle after gaps_i until the last gap was taken
);
  localparam int unsigned W = MapBits + 2;  // -1 to 2^MapBits, signed
  typedef struct packed {
    logic [W-1:0] low;     // signed
    logic [W-1:0] beyond;  // signed; one after the highest
  } interval_t;

  // ---- Visits ----
  logic [W-1:0] x, x_next;
  assign x = x_i[RowIndexBits-1] ? '1
           : x_i >= RowIndexBits'(map_width_i) ? W'(map_width_i) : x_i[W-1:0];
  assign x_next = x + 1'b1;
  logic [2:0]         any_q;            // the edge visited a row
  // Rows. As vectors: synthesis would round an array up to four words.
  logic [3*MapBits-1:0] first_rows_q, last_rows_q;
  logic [MapBits-1:0]   first_q[3], last_q[3];
  for (genvar e = 0; e < 3; e++) begin : g_rows
    assign first_q[e] = first_rows_q[e*MapBits +: MapBits];
    assign last_q[e]  = last_rows_q[e*MapBits +: MapBits];
  end
  interval_t          open_q, open;     // of the edge and row of the last visit
  logic [1:0]         edge_q;
  logic               same_row;
  assign same_row  = any_q[edge_i] && edge_q == edge_i && last_q[edge_i] == y_i;
  assign open.low  = same_row && $signed(open_q.low) < $signed(x) ? open_q.low : x;
  assign open.beyond = same_row && $signed(open_q.beyond) > $signed(x) ? open_q.beyond : x_next;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      any_q <= '0;
    end else if (clear_i || begin_i) begin
      any_q <= '0;
    end else if (visit_i) begin
      any_q[edge_i] <= 1'b1;
      `CHECK(rows_in_order, !any_q[edge_i] || y_i == last_q[edge_i]
                            || (edge_q == edge_i && y_i == last_q[edge_i] + 1'b1))
      `CHECK(three_edges, edge_i != 2'd3)
    end
  end
  always_ff @(posedge clk_i) begin
    if (visit_i) begin
      open_q <= open;
      edge_q <= edge_i;
      for (int e = 0; e < 3; e++) begin
        if (edge_i == 2'(e)) begin
          last_rows_q[e*MapBits +: MapBits] <= y_i;
          if (!any_q[e]) first_rows_q[e*MapBits +: MapBits] <= y_i;
        end
      end
    end
  end

  // ---- The rows' words ----
  logic               read;
  logic [MapBits-1:0] read_y, row_q;  // row_q: of what is read
  interval_t          word0, word1, word2;
  logic [2:0]         holds;  // the edge has an interval there
  ram_1r1w #(.Width(2*W), .Depth(1 << MapBits)) ram0 (
    .clk_i, .write_i(visit_i && edge_i == 2'd0), .write_addr_i(y_i), .write_data_i(open),
    .read_i(read), .read_addr_i(read_y), .read_data_o(word0));
  ram_1r1w #(.Width(2*W), .Depth(1 << MapBits)) ram1 (
    .clk_i, .write_i(visit_i && edge_i == 2'd1), .write_addr_i(y_i), .write_data_i(open),
    .read_i(read), .read_addr_i(read_y), .read_data_o(word1));
  ram_1r1w #(.Width(2*W), .Depth(1 << MapBits)) ram2 (
    .clk_i, .write_i(visit_i && edge_i == 2'd2), .write_addr_i(y_i), .write_data_i(open),
    .read_i(read), .read_addr_i(read_y), .read_data_o(word2));
  for (genvar e = 0; e < 3; e++) begin : g_holds
    assign holds[e] = any_q[e] && first_q[e] <= row_q && row_q <= last_q[e];
  end
  always_ff @(posedge clk_i) if (read) row_q <= read_y;

  // ---- Look-ups ----
  logic [W-1:0] x_q;
  logic [2:0]   passed_q, hit;
  always_ff @(posedge clk_i) begin
    if (lookup_i) begin
      x_q      <= x;
      passed_q <= passed_i;
    end
  end
  assign hit[0] = $signed(word0.low) <= $signed(x_q) && $signed(x_q) < $signed(word0.beyond);
  assign hit[1] = $signed(word1.low) <= $signed(x_q) && $signed(x_q) < $signed(word1.beyond);
  assign hit[2] = $signed(word2.low) <= $signed(x_q) && $signed(x_q) < $signed(word2.beyond);
  assign visited_o = (hit & holds & passed_q) != '0;

  // ---- Gaps ----
  // Sorted by their low ends; what an edge does not have comes last, and is never reached. All that is compared
  // is compared at once.
  localparam logic [W-1:0] Never = {1'b0, {(W-1){1'b1}}};
  logic [W-1:0] low[3], beyond[3];
  assign low[0]    = holds[0] ? word0.low : Never;
  assign low[1]    = holds[1] ? word1.low : Never;
  assign low[2]    = holds[2] ? word2.low : Never;
  assign beyond[0] = word0.beyond;
  assign beyond[1] = word1.beyond;
  assign beyond[2] = word2.beyond;
  logic [2:0] later;     // low i > low i + 1 (bit 2: low 0 > low 2)
  logic [2:0] farther;   // the same of beyond
  logic [2:0] clear_of[3];  // clear_of[i][j]: j begins after a gap after i
  assign later[0]   = $signed(low[0]) > $signed(low[1]);
  assign later[1]   = $signed(low[1]) > $signed(low[2]);
  assign later[2]   = $signed(low[0]) > $signed(low[2]);
  assign farther[0] = $signed(beyond[0]) > $signed(beyond[1]);
  assign farther[1] = $signed(beyond[1]) > $signed(beyond[2]);
  assign farther[2] = $signed(beyond[0]) > $signed(beyond[2]);
  for (genvar i = 0; i < 3; i++) begin : g_clear
    for (genvar j = 0; j < 3; j++) begin : g_of
      if (i == j) begin : g_self
        assign clear_of[i][j] = 1'b0;
      end else begin : g_other
        assign clear_of[i][j] = holds[j] && $signed(low[j]) > $signed(beyond[i]);
      end
    end
  end
  // First, second, third.
  logic [1:0] s0, s1, s2;
  always_comb begin
    unique case (later)
      3'b000:  {s0, s1, s2} = {2'd0, 2'd1, 2'd2};
      3'b001:  {s0, s1, s2} = {2'd1, 2'd0, 2'd2};
      3'b010:  {s0, s1, s2} = {2'd0, 2'd2, 2'd1};
      3'b101:  {s0, s1, s2} = {2'd1, 2'd2, 2'd0};
      3'b110:  {s0, s1, s2} = {2'd2, 2'd0, 2'd1};
      default: {s0, s1, s2} = {2'd2, 2'd1, 2'd0};
    endcase
  end
  // A gap goes from beyond one to below the next: both ends are visited or off the map.
  logic [MapBits-1:0] beyond0, below0, beyond1, below1;
  logic         gap0, gap1, first_reaches;  // first_reaches: as far as the second, or farther
  always_comb begin
    unique case ({s0, s1})
      {2'd0, 2'd1}: first_reaches = farther[0];
      {2'd1, 2'd0}: first_reaches = !farther[0];
      {2'd1, 2'd2}: first_reaches = farther[1];
      {2'd2, 2'd1}: first_reaches = !farther[1];
      {2'd0, 2'd2}: first_reaches = farther[2];
      default:      first_reaches = !farther[2];
    endcase
  end
  assign beyond0 = MapBits'(beyond[s0]);
  assign below0  = MapBits'(low[s1]);
  assign beyond1 = MapBits'(first_reaches ? beyond[s0] : beyond[s1]);
  assign below1  = MapBits'(low[s2]);
  assign gap0    = clear_of[s0][s1];
  assign gap1    = clear_of[s0][s2] && clear_of[s1][s2];

  // Rows from the first one of any edge to the last one.
  logic               reading_q, row_valid_q;  // rows are left; a row's words are read
  logic [MapBits-1:0] next_q, end_q;           // rows
  logic               gap0_q, gap1_q;
  logic [MapBits-1:0] from0_q, to0_q, from1_q, to1_q, y_q;
  logic               take;  // the row's gaps go to the output registers
  logic [MapBits-1:0] first, last;
  logic [MapBits-1:0] first01, last01;
  assign first01 = !any_q[1] || (any_q[0] && first_q[0] < first_q[1]) ? first_q[0] : first_q[1];
  assign last01  = !any_q[1] || (any_q[0] && last_q[0] > last_q[1]) ? last_q[0] : last_q[1];
  assign first   = !any_q[2] || (any_q[1:0] != '0 && first01 < first_q[2]) ? first01 : first_q[2];
  assign last    = !any_q[2] || (any_q[1:0] != '0 && last01 > last_q[2]) ? last01 : last_q[2];

  logic fetch;
  assign take   = row_valid_q && (!(gap0_q || gap1_q) || (gap_ready_i && !(gap0_q && gap1_q)));
  assign fetch  = reading_q && (take || !row_valid_q);
  assign read   = fetch || lookup_i;
  assign read_y = reading_q ? next_q : y_i;

  assign gap_valid_o = gap0_q || gap1_q;
  assign gap_y_o     = y_q;
  assign gap_from_o  = gap0_q ? from0_q : from1_q;
  assign gap_to_o    = gap0_q ? to0_q : to1_q;
  assign gaps_busy_o = reading_q || row_valid_q || gap_valid_o;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      reading_q   <= 1'b0;
      row_valid_q <= 1'b0;
      gap0_q      <= 1'b0;
      gap1_q      <= 1'b0;
    end else if (clear_i) begin
      reading_q   <= 1'b0;
      row_valid_q <= 1'b0;
      gap0_q      <= 1'b0;
      gap1_q      <= 1'b0;
    end else begin
      if (gaps_i) reading_q <= any_q != '0;
      else if (fetch && next_q == end_q) reading_q <= 1'b0;
      row_valid_q <= fetch || (row_valid_q && !take);
      if (take) begin
        gap0_q <= gap0;
        gap1_q <= gap1;
      end else if (gap_ready_i) begin
        gap0_q <= 1'b0;
        gap1_q <= gap1_q && gap0_q;
      end
      `CHECK(quiet_while_gaps, !gaps_busy_o || !(visit_i || lookup_i || gaps_i || begin_i))
    end
  end
  always_ff @(posedge clk_i) begin
    if (gaps_i) begin
      next_q <= first;
      end_q  <= last;
    end else if (fetch) begin
      next_q <= next_q + 1'b1;
    end
    if (take) begin
      y_q     <= row_q;
      from0_q <= beyond0;
      to0_q   <= below0 - 1'b1;
      from1_q <= beyond1;
      to1_q   <= below1 - 1'b1;
    end
  end
endmodule

// The verdict of a fragment before any chain of up to three records of a line, two of two lines, or one of two
// lines at 2-bit fields, next to any traffic of another slot:
// record by record, as the lane asks for them, the block comes to what docs/unit.md (4.2) says of the whole
// chain at once, reads each entry and line that it counts, and comes to it in time. The lines' products are
// included: half planes and combination are written here once more, from their definitions.
//
// long run
// pipeline: 50
// package: FractionBits=1 SlopeBits=1 PolygonBits=1 DepthBits=1 IdBits=1 MapBits=2 RecordAddrBits=2 LinesPerRecord=1 FragmentSlots=2
// package: FractionBits=2 SlopeBits=2 PolygonBits=1 DepthBits=1 IdBits=1 MapBits=2 RecordAddrBits=2 LinesPerRecord=2 FragmentSlots=2
// package: FractionBits=1 SlopeBits=1 PolygonBits=1 DepthBits=1 IdBits=1 MapBits=2 RecordAddrBits=2 LinesPerRecord=2 FragmentSlots=2
// broken: shadow_decision.sv: `around == now.candidate_at` => `1'b1`
// broken: shadow_decision.sv: `!now.others && !now.goes_on && !has_next` => `!now.goes_on && !has_next`
// broken: shadow_decision.sv: `IndexBits'(i) > choice.index` => `IndexBits'(i) >= choice.index`
// broken: shadow_decision.sv: `(was.uncounted && was.uncounted_at == at_q)` => `was.uncounted`
// broken: shadow_decision.sv: `|(misses_q & ands)` => `|misses_q`
// broken: shadow_decision.sv: `texels_q && (!first_i || used_q)` => `texels_q`
// broken: shadow_decision.sv: `.write_addr_i(end_slot_q), .write_data_i(now)` => `.write_addr_i(slot_q), .write_data_i(now)`
// broken: shadow_decision.sv: `now.others ? now.candidate_at : now.goes_on` => `now.goes_on`
// broken: line_test.sv: `D'(above_is_left)` => `D'(1'b0)`
module shadow_decision_proof #(
  localparam int unsigned L = shadow_pkg::LinesPerRecord,
  localparam int unsigned N = L == 1 ? 3 : shadow_pkg::FractionBits == 1 ? 2 : 1,  // records
  localparam int unsigned P = shadow_pkg::FractionBits,
  localparam int unsigned Most = 14            // records that are read for a verdict
) (
  input logic                                clk_i,
  input logic [N*shadow_pkg::RecordBits-1:0] chain_i,   // in the first cycle
  input shadow_pkg::settings_t               settings_i,
  input logic [P-1:0]                        x_i, y_i,  // of the fragment, 2^-P texel
  input logic                                depth_i, object_i,
  input logic [3:0]                          texel_i,
  // the other slot's
  input logic                                other_i, other_first_i, other_in_entry_i,
  input logic [1:0]                          other_at_i,
  input logic [shadow_pkg::RecordBits-1:0]   other_record_i
);
  localparam int unsigned RecordBits = shadow_pkg::RecordBits;
  localparam int unsigned LineBits = shadow_pkg::LineBits;
  logic running_q = 1'b0;
  always_ff @(posedge clk_i) running_q <= 1'b1;

  // The chain and the question stay.
  logic [N*RecordBits-1:0] chain_q;
  shadow_pkg::settings_t   settings_q;
  logic [P-1:0]            x_q, y_q;
  logic                    depth_q, object_q;
  logic [3:0]              texel_q;
  always_ff @(posedge clk_i) begin
    if (!running_q) begin
      chain_q <= chain_i;
      {settings_q, x_q, y_q, depth_q, object_q, texel_q} <= {settings_i, x_i, y_i, depth_i, object_i, texel_i};
    end
  end

  // ---- A read of every third cycle, and any of the other slot in between ----
  logic [1:0] phase_q = 2'd0;
  logic       first_q = 1'b1, in_entry_q = 1'b0, done_q = 1'b0;
  logic [1:0] at_q = 2'd0;
  logic [5:0] reads_q = '0;
  logic [3:0] entries_q = '0;
  logic [5:0] lines_q = '0;
  logic       was_other_q;
  wire        ours = phase_q == 2'd0 && !done_q;
  logic       middle_valid, middle_slot, slot_valid, slot, decided, dark, next_in_entry, entry_read;
  logic [1:0] next_at;
  logic [3:0] lines_read;
  shadow_decision #(.PointBits(P)) dut (
    .clk_i, .rst_ni(running_q), .clear_i(1'b0), .settings_i(settings_q),
    .valid_i(running_q && (ours || other_i)), .slot_i(!ours),
    .record_i(ours ? chain_q[at_q*RecordBits +: RecordBits] : other_record_i),
    .x_i(ours ? x_q : x_i), .nx_i((P + 1)'(1 << P) - {1'b0, ours ? x_q : x_i}), .y_i(ours ? y_q : y_i),
    .depth_i(ours ? depth_q : depth_i), .object_i(ours ? object_q : object_i),
    .texel_i(ours ? texel_q : texel_i),
    .first_i(phase_q == 2'd1 ? first_q : other_first_i),
    .in_entry_i(phase_q == 2'd1 ? in_entry_q : other_in_entry_i), .at_i(phase_q == 2'd1 ? at_q : other_at_i),
    .middle_valid_o(middle_valid), .middle_slot_o(middle_slot), .slot_valid_o(slot_valid), .slot_o(slot),
    .decided_o(decided), .dark_o(dark), .next_in_entry_o(next_in_entry), .next_at_o(next_at),
    .entry_read_o(entry_read), .lines_read_o(lines_read)
  );

  // ---- Specification ----
  logic [N-1:0]     used, has_next, has_more, here, beyond, own, vertex;
  logic [2*N-1:0]   next, more;
  logic [4*N-1:0]   count;
  logic [N*L-1:0]   there, holds;
  logic [N*L*LineBits-1:0] lines;
  shadow_pkg::record_t     record;
  always_comb begin
    for (int i = 0; i < N; i++) begin
      record = chain_q[i*RecordBits +: RecordBits];
      has_next[i] = record.has_next;
      has_more[i] = record.has_more;
      next[2*i +: 2] = record.next;
      more[2*i +: 2] = record.more;
      here[i]   = record.texel == texel_q && (i > 0 || record.used);
      beyond[i] = depth_q > record.nearest;
      own[i]    = record.object == object_q;
      vertex[i] = record.vertex;
      count[4*i +: 4] = record.count;
      for (int l = 0; l < L; l++) there[i*L+l] = 4'(l) < record.count;
      lines[i*L*LineBits +: L*LineBits] = record.lines;
    end
  end
  // Line a ANDed with b, in an entry with the Vertex Flag and in one without.
  logic [N*L*N*L-1:0] ands0, ands1;
  for (genvar a = 0; a < N * L; a++) begin : g_line
    half_plane_spec #(.PointBits(P)) half_plane (
      .line_i(lines[a*LineBits +: LineBits]), .x_i({1'b0, x_q}), .y_i({1'b0, y_q}), .holds_o(holds[a])
    );
    for (genvar b = 0; b < N * L; b++) begin : g_pair
      combine_spec pair0 (.vertex_per_entry_i(settings_q.vertex_per_entry), .table7_printed_i(settings_q.table7_printed), .a_i(lines[a*LineBits +: LineBits]),
                       .b_i(lines[b*LineBits +: LineBits]), .vertex_i(1'b0), .and_o(ands0[a*N*L+b]));
      combine_spec pair1 (.vertex_per_entry_i(settings_q.vertex_per_entry), .table7_printed_i(settings_q.table7_printed), .a_i(lines[a*LineBits +: LineBits]),
                       .b_i(lines[b*LineBits +: LineBits]), .vertex_i(1'b1), .and_o(ands1[a*N*L+b]));
    end
  end

  logic [N-1:0]   of_entry;
  logic [N*L-1:0] in_entry;
  logic [N-1:0]   inside, reached;
  logic           candidate_lives, spec_dark;
  logic [5:0]     lines_of, spec_lines;
  logic [3:0]     spec_entries;
  always_comb begin
    spec_dark = 1'b0;
    spec_lines = '0;
    spec_entries = '0;
    reached = N'(1);
    inside = '0;
    for (int e = 0; e < N; e++) begin
      of_entry = N'(1) << e;
      lines_of = '0;
      for (int i = 0; i < N; i++) begin
        for (int k = i + 1; k < N; k++)
          if (of_entry[i] && has_more[i] && more[2*i +: 2] == 2'(k)) of_entry[k] = 1'b1;
        if (of_entry[i]) lines_of = lines_of + 6'(count[4*i +: 4]);
        for (int l = 0; l < L; l++) in_entry[i*L+l] = of_entry[i] && there[i*L+l];
      end
      for (int a = 0; a < N * L; a++) begin
        candidate_lives = in_entry[a] && holds[a];
        for (int b = 0; b < N * L; b++) begin
          if (b != a && in_entry[b] && !holds[b] && (vertex[e] ? ands1[a*N*L+b] : ands0[a*N*L+b]))
            candidate_lives = 1'b0;
        end
        if (candidate_lives) inside[e] = 1'b1;
      end
      if (reached[e]) begin
        if (here[e] && beyond[e]) spec_entries = spec_entries + 4'd1;
        if (here[e] && beyond[e] && !own[e]) begin
          spec_lines = spec_lines + lines_of;
          spec_dark  = inside[e];
        end
        for (int k = e + 1; k < N; k++) begin
          if (has_next[e] && next[2*e +: 2] == 2'(k) && !spec_dark && (!here[e] || beyond[e])) reached[k] = 1'b1;
        end
      end
    end
  end

  always_ff @(posedge clk_i) begin
    if (running_q) begin
      // A chain goes on behind, and a record has no more lines than fit.
      for (int i = 0; i < N; i++) begin
        assume (!has_next[i] || (next[2*i +: 2] > 2'(i) && next[2*i +: 2] < 2'(N)));
        assume (!has_more[i] || (more[2*i +: 2] > 2'(i) && more[2*i +: 2] < 2'(N)));
        assume (count[4*i +: 4] <= 4'(L));
      end
      assume (other_record_i[L*LineBits +: 4] <= 4'(L));
      assert (reads_q <= 6'(Most));
      if (phase_q == 2'd1) assert (middle_valid && middle_slot == 1'b0);
      if (phase_q == 2'd2) begin
        assert (slot_valid && slot == 1'b0);
        if (decided) begin
          assert (dark == spec_dark);
          assert (entries_q + 4'(entry_read) == spec_entries);
          assert (lines_q + 6'(lines_read) == spec_lines);
        end
        done_q     <= decided;
        first_q    <= 1'b0;
        in_entry_q <= next_in_entry;
        at_q       <= next_at;
        reads_q    <= reads_q + 6'd1;
        entries_q  <= entries_q + 4'(entry_read);
        lines_q    <= lines_q + 6'(lines_read);
      end
      if (!done_q) phase_q <= phase_q == 2'd2 ? 2'd0 : phase_q + 2'd1;
      else phase_q <= 2'd0;
    end
  end
endmodule

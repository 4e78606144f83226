// List texel: the texel that a visit works on, as it was taken and as it becomes.
//
// Twins:   model/unit/winding/shadow_unit_store.cpp (Texel of open_list, cover, overflow)
// Numbers: depths in depth units, signed; of a list without a cover the depth is a set of marks.
// Timing:  commands of cycle n show in n + 1, `next` outputs in n. One command at a time, but for note_i.
module list_texel (
  input  logic                              clk_i,
  input  logic                              load_i,
  input  logic [shadow_pkg::TexelBits-1:0]  texel_i,         // texel_t
  input  logic                              steep_i,         // of its plane, if it is one
  input  logic [26:0]                       half_i,
  // the visit's plane; it and the texel hold
  input  logic [shadow_pkg::ThresholdBits-1:0] threshold_i,
  input  logic [shadow_pkg::IdBits-1:0]     object_i,
  output logic                              unmarked_o,      // a list that has no cluster of that plane
  // commands
  input  logic                              open_i,          // its plane is a cluster now, the list's first
  input  logic                              insert_i,        // a cluster of the visit's plane comes first
  input  logic                              insert_bare_i,   // without a segment
  input  logic [shadow_pkg::RecordAddrBits-1:0] spare_i,     // record of that cluster
  input  logic                              behead_i,        // the first cluster goes;
  input  logic                              next_valid_i,    //   another one is first, or none
  input  logic [shadow_pkg::RecordAddrBits-1:0] next_i,
  input  logic                              bare_i,          // a cluster has lost its last segment
  input  logic                              settled_i,
  input  logic                              spill_i,         // no room: a plane's nearest depth is what it keeps
  input  logic                              overflow_i,      // its list is gone
  input  logic                              note_i,          // is that its cover, or what it keeps?
  input  logic [31:0]                       note_depth_i,
  input  logic [shadow_pkg::IdBits-1:0]     note_object_i,
  // the texel
  output logic [1:0]                        kind_o,
  output logic                              covered_o,
  output logic                              covered_next_o,
  output logic [shadow_pkg::IdBits-1:0]     object_o,        // of the cover
  output logic [31:0]                       depth_o,
  output logic [shadow_pkg::RecordAddrBits-1:0] first_o,
  output logic [shadow_pkg::RecordAddrBits-1:0] first_next_o,
  output logic                              changed_o,
  output logic [shadow_pkg::TexelBits-1:0]  texel_o          // texel_t
);
  localparam int unsigned A = shadow_pkg::RecordAddrBits;
  shadow_pkg::texel_t      texel, result;
  shadow_pkg::texel_list_t list, result_list;
  /* verilator lint_off UNUSEDSIGNAL */  // how steep it is comes with it
  shadow_pkg::threshold_t  plane;
  /* verilator lint_on UNUSEDSIGNAL */
  assign texel = texel_i;
  assign list  = texel.word[shadow_pkg::ListBits-1:0];
  assign plane = texel.word[shadow_pkg::ThresholdBits-1:0];

  // A list without the mark of a plane has no cluster of it.
  logic [4:0]  mark_number;
  logic [31:0] mark, cover_depth, unused_nearest;
  always_comb begin
    mark_number = '0;
    for (int i = 0; i < shadow_pkg::ThresholdBits; i++) mark_number[i%5] = mark_number[i%5] ^ threshold_i[i];
    for (int i = 0; i < shadow_pkg::IdBits; i++) mark_number[i%5] = mark_number[i%5] ^ object_i[i];
  end
  assign mark       = 32'd1 << mark_number;
  assign unmarked_o = !list.covered && (list.cover_depth & mark) == '0;
  plane_bounds cover_bounds (
    .base_i(plane.base), .steep_i, .half_i, .nearest_o(unused_nearest), .farthest_o(cover_depth)
  );

  logic [1:0]   kind_d, kind_q;
  logic         covered_d, covered_q, bare_d, bare_q, changed_d, changed_q;
  logic [shadow_pkg::IdBits-1:0] object_d, object_q;
  logic [31:0]  depth_d, depth_q;
  logic [A-1:0] first_d, first_q;
  always_comb begin
    kind_d = kind_q; covered_d = covered_q; bare_d = bare_q; object_d = object_q; depth_d = depth_q;
    first_d = first_q; changed_d = changed_q;
    if (load_i) begin
      kind_d    = texel.kind;
      object_d  = texel.object;
      covered_d = list.covered;
      depth_d   = list.cover_depth;
      first_d   = list.first;
      bare_d    = texel.kind == shadow_pkg::TexelList && list.bare;
      changed_d = 1'b0;
    end
    if (open_i) begin
      kind_d    = shadow_pkg::TexelList;
      covered_d = 1'b1;
      depth_d   = cover_depth;
    end
    if (insert_i) begin
      kind_d = shadow_pkg::TexelList;
      if (kind_q == shadow_pkg::TexelEmpty) begin
        covered_d = 1'b0;
        depth_d   = mark;
      end else if (!covered_q) begin
        depth_d = depth_q | mark;
      end
      if (insert_bare_i) bare_d = 1'b1;
    end
    if (open_i || insert_i) first_d = spare_i;
    if (behead_i) begin
      first_d = next_i;
      if (!next_valid_i) kind_d = shadow_pkg::TexelEmpty;
    end
    if (spill_i) begin
      covered_d = kind_q == shadow_pkg::TexelPlane;
      depth_d   = {plane.base[shadow_pkg::BaseBits-1], plane.base, {shadow_pkg::PlaneStepBits{1'b0}}};
      if (kind_q != shadow_pkg::TexelList) kind_d = shadow_pkg::TexelOverflow;
    end
    if (overflow_i) kind_d = shadow_pkg::TexelOverflow;
    if (open_i || insert_i || behead_i || spill_i || (bare_i && !bare_q)) changed_d = 1'b1;
    if (bare_i) bare_d = 1'b1;
    if (settled_i) bare_d = 1'b0;
    if (note_i && (!covered_q || $signed(note_depth_i) < $signed(depth_q))) begin
      covered_d = 1'b1;
      depth_d   = note_depth_i;
      object_d  = note_object_i;
      changed_d = 1'b1;
    end
  end
  always_ff @(posedge clk_i) begin
    kind_q <= kind_d; covered_q <= covered_d; bare_q <= bare_d; object_q <= object_d; depth_q <= depth_d;
    first_q <= first_d; changed_q <= changed_d;
  end

  always_comb begin
    result_list.covered     = covered_q;
    result_list.bare        = bare_q;
    result_list.cover_depth = depth_q;
    result_list.first       = first_q;
    result.kind   = kind_q;
    result.object = object_q;
    result.word   = shadow_pkg::WordBits'(result_list);
  end
  assign kind_o         = kind_q;
  assign covered_o      = covered_q;
  assign covered_next_o = covered_d;
  assign object_o       = object_q;
  assign depth_o        = depth_q;
  assign first_o        = first_q;
  assign first_next_o   = first_d;
  assign changed_o      = changed_q;
  assign texel_o        = result;
endmodule

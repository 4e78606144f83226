// List texel: the texel that a visit works on, as it was taken and as it becomes.
//
// Twins:   model/unit/winding/shadow_unit_store.cpp (Texel of open_list, cover, overflow)
// Numbers: depths in depth units, signed; of a list without a cover the depth is a set of marks: no mark, no
//          cluster of that plane.
// Timing:  commands of cycle n show in n + 1, `next` outputs in n. One command at a time, but for note_i.
module list_texel (
  input  logic                              clk_i,
  input  logic                              load_i,          // the texel, with the mark:
  input  logic [shadow_pkg::TexelBits-1:0]  texel_i,         // texel_t
  input  logic [4:0]                        mark_i,          // of the visit's plane
  input  logic                              steep_i,         // of its plane, if it is one; from the next cycle on
  input  logic [26:0]                       half_i,
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
  output logic                              covered_next_o,  // of a list
  output logic [shadow_pkg::IdBits-1:0]     object_o,        // of the cover
  output logic [31:0]                       depth_o,
  output logic [shadow_pkg::RecordAddrBits-1:0] first_o,
  output logic                              changed_o,
  output logic [shadow_pkg::ThresholdBits-1:0] plane_o,      // threshold_t, as long as the texel is a plane
  output logic [shadow_pkg::TexelBits-1:0]  texel_o          // texel_t
);
  shadow_pkg::texel_t      texel, result;
  shadow_pkg::texel_list_t list_d, list_q;  // or the plane's lower bits
  shadow_pkg::threshold_t  plane;
  logic [shadow_pkg::WordBits-1:0] word_d, word_q;
  logic [shadow_pkg::IdBits-1:0]   object_d, object_q;
  logic [1:0]  kind_d, kind_q;
  logic        changed_d, changed_q;
  logic [4:0]  mark_q;
  logic [31:0] mark, cover_depth, unused_nearest;
  assign texel  = texel_i;
  assign list_q = word_q[shadow_pkg::ListBits-1:0];
  assign plane  = word_q[shadow_pkg::ThresholdBits-1:0];
  assign mark   = 32'd1 << mark_q;
  plane_bounds cover_bounds (
    .base_i(plane.base), .steep_i, .half_i, .nearest_o(unused_nearest), .farthest_o(cover_depth)
  );

  always_comb begin
    kind_d = kind_q; list_d = list_q; word_d = word_q; object_d = object_q; changed_d = changed_q;
    if (load_i) begin
      kind_d    = texel.kind;
      object_d  = texel.object;
      word_d    = texel.word;
      list_d    = texel.word[shadow_pkg::ListBits-1:0];
      changed_d = 1'b0;
    end
    if (open_i) begin
      kind_d             = shadow_pkg::TexelList;
      list_d.covered     = 1'b1;
      list_d.bare        = 1'b0;
      list_d.cover_depth = cover_depth;
    end
    if (insert_i) begin
      kind_d = shadow_pkg::TexelList;
      if (kind_q == shadow_pkg::TexelEmpty) begin
        list_d.covered     = 1'b0;
        list_d.bare        = 1'b0;
        list_d.cover_depth = mark;
      end else if (!list_q.covered) begin
        list_d.cover_depth = list_q.cover_depth | mark;
      end
      if (insert_bare_i) list_d.bare = 1'b1;
    end
    if (open_i || insert_i) list_d.first = spare_i;
    if (behead_i) begin
      list_d.first = next_i;
      if (!next_valid_i) kind_d = shadow_pkg::TexelEmpty;
    end
    if (spill_i) begin
      list_d.covered     = kind_q == shadow_pkg::TexelPlane;
      list_d.cover_depth = {plane.base[shadow_pkg::BaseBits-1], plane.base, {shadow_pkg::PlaneStepBits{1'b0}}};
      if (kind_q != shadow_pkg::TexelList) begin
        kind_d      = shadow_pkg::TexelOverflow;
        list_d.bare = 1'b0;
      end
    end
    if (overflow_i) kind_d = shadow_pkg::TexelOverflow;
    if (open_i || insert_i || behead_i || spill_i || (bare_i && !list_q.bare)) changed_d = 1'b1;
    if (bare_i) list_d.bare = 1'b1;
    if (settled_i) list_d.bare = 1'b0;
    if (note_i && (!list_q.covered || $signed(note_depth_i) < $signed(list_q.cover_depth))) begin
      list_d.covered     = 1'b1;
      list_d.cover_depth = note_depth_i;
      object_d           = note_object_i;
      changed_d          = 1'b1;
    end
    word_d[shadow_pkg::ListBits-1:0] = list_d;
  end
  always_ff @(posedge clk_i) begin
    kind_q <= kind_d; word_q <= word_d; object_q <= object_d; changed_q <= changed_d;
    if (load_i) mark_q <= mark_i;
  end

  always_comb begin
    result.kind   = kind_q;
    result.object = object_q;
    result.word   = shadow_pkg::WordBits'(list_q);
  end
  assign kind_o         = kind_q;
  assign covered_o      = list_q.covered;
  assign covered_next_o = list_q.covered || note_i;
  assign object_o       = object_q;
  assign depth_o        = list_q.cover_depth;
  assign first_o        = list_q.first;
  assign changed_o      = changed_q;
  assign plane_o        = plane;
  assign texel_o        = result;
endmodule

// Texel test: what a visit is to one texel of a word.
//
// Twins:   model/unit/winding/shadow_unit_store.cpp (hidden, cover of a texel without a list)
// Numbers: a visit at or beyond the farthest depth of a texel's plane is hidden, one whose own farthest depth is not
//          beyond the nearest one hides it; both by the planes' bounds, in steps of a base.
// Timing:  combinational.
module texel_test (
  input  logic                             paper_i,     // settings_t.paper_semantics
  // the visit
  input  logic                             span_i,      // the facet covers the texel; else a visit of an edge
  input  logic                             settle_i,    // end of pass 1
  input  logic                             nothing_i,   // of an edge, with neither corner nor segment
  input  logic [shadow_pkg::BaseBits-1:0]  base_i,
  input  shadow_pkg::visit_tri_t           tri_i,
  input  logic                             tri_steep_i,
  input  logic [26:0]                      tri_half_i,
  input  logic [4:0]                       tri_mark_i,  // of the mark's number, what the base does not add
  // the texel
  input  logic [shadow_pkg::TexelBits-1:0] texel_i,     // texel_t
  input  logic                             steep_i,     // of its plane, if it is one
  input  logic [26:0]                      half_i,
  output logic                             hidden_o,    // the visit is
  output logic                             put_o,       // the visit's plane takes the texel
  output logic                             slow_o,      // the silhouette buffer has to do with it
  output logic                             held_o,      // the texel is covered
  output logic [4:0]                       mark_o,      // number of the mark of the visit's plane
  output logic                             unmarked_o   // a list that has no cluster of that plane
);
  localparam int unsigned B = shadow_pkg::BaseBits;
  localparam int unsigned Step = shadow_pkg::PlaneStepBits;
  localparam int unsigned CodeBits = shadow_pkg::GradientCodeBits;
  shadow_pkg::texel_t      texel;
  /* verilator lint_off UNUSEDSIGNAL */  // its first cluster
  shadow_pkg::texel_list_t list;
  /* verilator lint_on UNUSEDSIGNAL */
  shadow_pkg::threshold_t  plane;
  assign texel = texel_i;
  assign list  = texel.word[shadow_pkg::ListBits-1:0];
  assign plane = texel.word[shadow_pkg::ThresholdBits-1:0];

  // How far the one is behind the other, at the centre, less the margin that both bounds take: one sum.
  logic [B+1:0] behind, ahead, margin, visit_base, plane_base;
  logic         is_plane, same, bounded;
  assign visit_base = {{2{base_i[B-1]}}, base_i};
  assign plane_base = {{2{plane.base[B-1]}}, plane.base};
  assign margin     = (B + 2)'((29'(half_i) + 29'(tri_half_i) + 29'(1 << Step)) >> Step);
  assign behind     = visit_base - plane_base - margin;
  assign ahead     = plane_base - visit_base - margin;
  assign is_plane   = texel.kind == shadow_pkg::TexelPlane;
  assign same       = plane == {base_i, tri_i.gradient_x, tri_i.gradient_y} && texel.object == tri_i.object;
  assign bounded    = is_plane && !steep_i && !tri_steep_i && (!paper_i || texel.object == tri_i.object);
  assign hidden_o   = bounded && !behind[B+1];
  assign put_o      = span_i && (texel.kind == shadow_pkg::TexelEmpty || (bounded && !same && !ahead[B+1]));
  assign held_o     = is_plane || (texel.kind != shadow_pkg::TexelEmpty && list.covered);
  always_comb begin
    case (texel.kind)
      shadow_pkg::TexelEmpty:    slow_o = !span_i && !nothing_i;
      shadow_pkg::TexelPlane:    slow_o = !hidden_o && !same && !put_o && !nothing_i;
      shadow_pkg::TexelOverflow: slow_o = !nothing_i;
      shadow_pkg::TexelList:     slow_o = !nothing_i || list.covered;
    endcase
    if (settle_i) slow_o = texel.kind == shadow_pkg::TexelList && list.bare;
  end

  always_comb begin
    mark_o = tri_mark_i;
    for (int i = 0; i < B; i++) mark_o[(2*CodeBits+i)%5] = mark_o[(2*CodeBits+i)%5] ^ base_i[i];
  end
  assign unmarked_o = !list.covered && !list.cover_depth[mark_o];
endmodule

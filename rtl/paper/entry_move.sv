// An entry whose nearest depth has changed goes to where it belongs among those of its texel.
// Part of silhouette_buffer: says what is done in a cycle; nothing is kept here.
//
// Out of its chain it keeps its record, but for one that stood in the bucket's own: that one goes to
// the pool, and the chain's next one into its place.
// Twin:    set_nearest, unlink in model/unit/silhouette_buffer.cpp.
// Timing:  combinational.
module entry_move (
  input  logic [4:0]             state_i,
  input  shadow_pkg::slb_walk_t  walk_i,
  input  shadow_pkg::slb_facts_t facts_i,
  input  shadow_pkg::record_t    record_i,
  output logic [4:0]             state_o,
  output shadow_pkg::slb_walk_t  walk_o,
  output shadow_pkg::slb_step_t  step_o
);
  shadow_pkg::slb_facts_t f;
  shadow_pkg::slb_walk_t  w;
  shadow_pkg::slb_step_t  s;
  assign f      = facts_i;
  assign walk_o = w;
  assign step_o = s;

  always_comb begin
    state_o = state_i;
    w       = walk_i;
    s       = '0;
    s.act        = f.hit;
    s.look       = 1'b1;
    s.look_addr  = walk_i.entry;
    s.write_addr = f.at;
    s.link_has   = 1'b1;
    s.link_addr  = walk_i.place;
    s.free_addr  = walk_i.next;

    unique case (state_i)
      shadow_pkg::SlbBehind: begin
        state_o = shadow_pkg::SlbStay;
        if (f.same_texel && f.before_it) begin
          s.look_addr = walk_i.is_own ? walk_i.entry : walk_i.prev;
          state_o     = walk_i.is_own ? shadow_pkg::SlbUnlinkCopy : shadow_pkg::SlbUnlink;
        end else if (!f.same_texel && record_i.has_next) begin
          s.look_addr = record_i.next;
          state_o     = shadow_pkg::SlbBehind;
        end
      end
      shadow_pkg::SlbStay: begin
        s.write       = 1'b1;
        s.set_nearest = 1'b1;
        w.settled     = 1'b1;
        w.head        = 1'b1;
        state_o       = shadow_pkg::SlbScan;
      end
      shadow_pkg::SlbUnlink: begin
        s.write     = 1'b1;
        s.set_next  = 1'b1;
        s.link_has  = walk_i.has_next;
        s.link_addr = walk_i.next;
        w.relink    = 1'b1;
        s.restart   = 1'b1;
      end
      shadow_pkg::SlbUnlinkCopy: begin
        s.write      = 1'b1;
        s.write_addr = f.spot;
        s.take       = 1'b1;
        w.entry      = f.spot;
        s.look_addr  = walk_i.next;
        state_o      = shadow_pkg::SlbUnlinkPull;
      end
      shadow_pkg::SlbUnlinkPull: begin
        s.write      = 1'b1;
        s.write_addr = walk_i.own;
        s.keep       = 1'b1;
        w.relink     = 1'b1;
        s.restart    = 1'b1;
      end
      shadow_pkg::SlbRejoin: begin
        s.write       = 1'b1;
        s.set_next    = 1'b1;
        s.link_has    = walk_i.has_next;
        s.link_addr   = walk_i.next;
        s.set_nearest = 1'b1;
        w.relink      = 1'b0;
        w.settled     = 1'b1;
        w.head        = 1'b1;
        w.is_own      = 1'b0;
        state_o       = shadow_pkg::SlbScan;
      end
      shadow_pkg::SlbRejoinOwn: begin
        s.write       = 1'b1;
        s.write_addr  = walk_i.own;
        s.set_next    = 1'b1;
        s.set_nearest = 1'b1;
        s.keep        = 1'b1;
        s.free_addr   = walk_i.entry;
        w.relink      = 1'b0;
        w.settled     = 1'b1;
        w.head        = 1'b1;
        w.is_own      = 1'b1;
        w.entry       = walk_i.own;
        s.look_addr   = walk_i.own;
        state_o       = shadow_pkg::SlbScan;
      end
      default: s.act = 1'b0;
    endcase
  end

  logic unused;
  assign unused = &{1'b0, f, record_i};
endmodule

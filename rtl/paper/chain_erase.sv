// Entries of a texel that go: hidden by what covers it, emptied, or given up where there are too many.
// Part of silhouette_buffer: says what is done in a cycle; nothing is kept here.
//
// Records that are erased become the first of the freed ones, an entry's all at once. Where the
// bucket's own record is one of them, the chain's next entry moves into it.
// Twin:    erase in model/unit/silhouette_buffer.cpp; overflow, remove_hidden and update_edge_flag in
//          shadow_unit_pass1.cpp.
// Timing:  combinational.
module chain_erase (
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
  logic erases, all;
  logic linked;  // the chain is closed again
  logic finish;  // all entries of the texel were looked at, or need not be
  assign f      = facts_i;
  assign walk_o = w;
  assign step_o = s;
  assign all    = walk_i.mode == shadow_pkg::EraseAll;
  assign erases = f.same_texel && (all || (walk_i.mode == shadow_pkg::EraseHidden && f.erasable));

  always_comb begin
    state_o = state_i;
    w       = walk_i;
    s       = '0;
    s.act        = f.hit;
    s.look_addr  = f.at;
    s.write_addr = f.at;
    s.link_has   = walk_i.has_next;
    s.link_addr  = walk_i.next;
    s.more_has   = f.has_free;
    s.more_addr  = f.free;
    s.free_addr  = f.at;
    linked       = 1'b0;
    finish       = 1'b0;

    unique case (state_i)
      shadow_pkg::SlbJudge: begin
        s.act     = 1'b1;
        s.stored  = !f.too_long;
        s.last    = !f.too_long;
        state_o   = shadow_pkg::SlbOverflow;
      end
      shadow_pkg::SlbOverflow: begin
        s.act          = 1'b1;
        s.touch        = 1'b1;
        s.cover_texel        = 1'b1;
        s.set_edge     = 1'b1;
        s.set_overflow = 1'b1;
        s.events.overflow_texel = 1'b1;
        s.events.overflow_lines = walk_i.storing ? 16'd0 : 16'd1;
        w.mode         = shadow_pkg::EraseAll;
        s.walk         = 1'b1;
      end
      shadow_pkg::SlbWalk: begin
        s.act      = f.hit && f.texel_hit;
        w.next     = record_i.next;
        w.has_next = record_i.has_next;
        s.look     = 1'b1;
        if (erases) begin
          s.touch        = all;
          s.cover_record = all;
          w.head         = 1'b1;
          state_o        = shadow_pkg::SlbErase;
        end else begin
          w.kept      = walk_i.kept || f.same_texel;
          w.prev      = f.at;
          w.has_prev  = 1'b1;
          s.look_addr = record_i.next;
          finish      = !record_i.has_next;
        end
      end
      shadow_pkg::SlbErase: begin
        s.used_less = 1'b1;
        if (all) s.events.overflow_lines = 16'(record_i.count);
        else s.events.lines_hidden = 16'(record_i.count);
        if (walk_i.head) w.ahead = walk_i.has_prev ? f.at : record_i.more;
        w.head      = 1'b0;
        s.look      = 1'b1;
        s.look_addr = record_i.more;
        if (!record_i.has_more) begin
          // The bucket's own record does not go to the pool, but its continuations do.
          if (!walk_i.head || walk_i.has_prev) begin
            s.write     = 1'b1;
            s.set_more  = 1'b1;
            s.free      = 1'b1;
            s.free_addr = w.ahead;
          end
          s.look_addr = walk_i.has_prev ? walk_i.prev : walk_i.next;
          s.look      = walk_i.has_prev || walk_i.has_next;
          state_o     = shadow_pkg::SlbEraseLink;
        end
      end
      shadow_pkg::SlbEraseLink: begin
        s.write = 1'b1;
        if (walk_i.has_prev) begin
          s.set_next = 1'b1;
          linked     = 1'b1;
        end else if (walk_i.has_next) begin
          s.write_addr = walk_i.own;
          state_o      = shadow_pkg::SlbEraseFree;
        end else begin
          s.act           = 1'b1;
          s.write_addr    = walk_i.own;
          s.unused_record = 1'b1;
          finish          = 1'b1;
        end
      end
      shadow_pkg::SlbEraseFree: begin
        s.write     = 1'b1;
        s.set_more  = 1'b1;
        s.free      = 1'b1;
        linked      = 1'b1;
      end
      default: s.act = 1'b0;
    endcase

    if (linked && walk_i.emptying) begin
      // The edge buffer wants to know of others; what covers the texel may hide them.
      w.emptying = 1'b0;
      w.mode     = walk_i.covered && f.wants_hiding ? shadow_pkg::EraseHidden : shadow_pkg::EraseNone;
      s.walk     = w.mode == shadow_pkg::EraseHidden ? walk_i.kept || walk_i.has_next
                                                     : !walk_i.kept && walk_i.has_next;
      finish     = !s.walk;
    end else if (linked && !walk_i.has_prev) begin
      s.walk = 1'b1;
    end else if (linked) begin
      s.look      = 1'b1;
      s.look_addr = walk_i.next;
      state_o     = shadow_pkg::SlbWalk;
      finish      = !walk_i.has_next;
    end
    if (finish) begin
      s.spread       = 1'b1;
      s.touch        = !all && (!w.kept || walk_i.covered);
      s.set_edge     = !all;
      s.edge_flag    = w.kept;
      s.cover_centre = walk_i.covered;
      s.events.emptied_covered = walk_i.covered;
    end
  end

  logic unused;
  assign unused = &{1'b0, f, record_i};
endmodule

// An operation's way along its bucket's chain to the texel's entry, and a new entry's way into it.
// Part of silhouette_buffer: says what is done in a cycle; nothing is kept here.
//
// What finds all in one record is done in the cycle in which that record is there. A texel without
// lines, which the edge buffer tells, needs no walk: its entry goes to the bucket's own record or
// behind it.
// Twin:    find, insert and link in model/unit/silhouette_buffer.cpp; visit_texel and empty_visited in
//          shadow_unit_pass1.cpp.
// Timing:  combinational.
module chain_find (
  input  logic [4:0]             state_i,
  input  shadow_pkg::slb_walk_t  walk_i,
  input  shadow_pkg::slb_facts_t facts_i,
  input  shadow_pkg::record_t    record_i,
  output logic [4:0]             state_o,
  output shadow_pkg::slb_walk_t  walk_o,
  output shadow_pkg::slb_step_t  step_o
);
  localparam int unsigned CountBits = shadow_pkg::LineCountBits;

  shadow_pkg::slb_facts_t f;
  shadow_pkg::slb_walk_t  w;
  shadow_pkg::slb_step_t  s;
  logic first_line, store_new, store_here;
  logic one_line;
  assign f          = facts_i;
  assign walk_o     = w;
  assign step_o     = s;
  assign first_line = f.is_edge && !walk_i.relink;  // a line whose entry is looked for
  assign one_line   = record_i.count == CountBits'(1);

  always_comb begin
    state_o    = state_i;
    w          = walk_i;
    s          = '0;
    s.act      = f.hit;
    s.look_addr  = walk_i.own;
    s.write_addr = f.at;
    s.link_has   = 1'b1;
    s.link_addr  = f.spot;
    s.more_has   = f.has_free;
    s.more_addr  = f.free;
    s.free_addr  = f.at;
    store_new    = 1'b0;
    store_here   = 1'b0;

    unique case (state_i)
      shadow_pkg::SlbSpan: begin
        s.act        = f.texel_hit;
        s.touch      = 1'b1;
        s.cover_span = 1'b1;
        w.todo       = f.wants_hiding ? f.edges : '0;
        s.spread     = 1'b1;
      end

      shadow_pkg::SlbFind: begin
        s.act = f.texel_hit && f.hit;
        if (first_line && f.dry && f.has_free) begin
          s.act       = 1'b1;
          s.look      = 1'b1;
          s.look_addr = f.free;
          state_o     = shadow_pkg::SlbReuse;
        end else if (first_line && f.overflow) begin
          s.act   = f.texel_hit;
          s.touch = 1'b1;
          s.cover_texel = 1'b1;
          s.last  = 1'b1;
          s.events.overflow_lines = 16'd1;
        end else if (first_line && !f.edge_flag && f.hidden) begin
          s.act  = f.texel_hit;
          s.last = 1'b1;
          s.events.lines_hidden = 16'd1;
        end else if (first_line && !f.edge_flag && f.full) begin
          s.act          = f.texel_hit;
          s.touch        = 1'b1;
          s.cover_texel        = 1'b1;
          s.set_overflow = 1'b1;
          s.last         = 1'b1;
          s.events.overflow_texel = 1'b1;
          s.events.overflow_lines = 16'd1;
        end else if (first_line && !f.edge_flag) begin
          s.write = 1'b1;
          if (record_i.used) begin
            s.set_next = 1'b1;
            w.next     = record_i.next;
            w.has_next = record_i.has_next;
            s.look     = 1'b1;
            s.look_new = 1'b1;
            s.look_addr = f.spot;
            state_o    = shadow_pkg::SlbNew;
          end else begin
            store_new   = 1'b1;
            s.set_next  = 1'b0;
            s.last      = 1'b1;
          end
        end else if (!f.is_edge && !f.edge_flag) begin
          s.act  = f.texel_hit;
          s.last = 1'b1;
        end else if (f.same_entry && first_line) begin
          w.entry    = f.at;
          w.is_own   = !walk_i.has_prev;
          w.is_first = !walk_i.seen;
          w.head     = 1'b1;
          if (record_i.has_more && !f.match) begin
            w.next       = record_i.next;
            w.has_next   = record_i.has_next;
            w.nearer     = f.nearer;
            w.new_corner = f.new_corner;
            w.new_vertex = f.new_vertex;
            w.length     = walk_i.length + 1'b1;
            w.ahead      = f.at;
            w.head       = 1'b0;
            s.look       = 1'b1;
            s.look_addr  = record_i.more;
            state_o      = shadow_pkg::SlbScan;
          end else if (f.match && !record_i.has_more) begin
            s.write      = 1'b1;
            s.remove     = 1'b1;
            s.set_corner = 1'b1;
            s.emptied    = one_line;
            s.last       = 1'b1;
            s.events.line_cancelled = 1'b1;
          end else if (f.hidden && !f.match) begin
            s.last = 1'b1;
            s.events.lines_hidden = 16'd1;
          end else if (f.room && !f.match && !(f.nearer && (walk_i.seen || record_i.has_next))) begin
            s.write       = 1'b1;
            store_here    = 1'b1;
            s.set_nearest = f.nearer;
            s.stored      = 1'b1;
            s.last        = 1'b1;
          end else begin
            s.look      = 1'b1;
            s.look_addr = f.at;
            state_o     = shadow_pkg::SlbScan;
          end
        end else if (f.same_entry && !f.is_edge) begin
          // It has no continuation, being empty.
          w.covered  = record_i.corner;
          w.next     = record_i.next;
          w.has_next = record_i.has_next;
          w.kept     = walk_i.seen;
          w.emptying = 1'b1;
          w.mode     = shadow_pkg::EraseNone;
          s.look     = 1'b1;
          state_o    = shadow_pkg::SlbEraseLink;
          if (record_i.count != '0) begin
            s.last = 1'b1;
          end else if (walk_i.has_prev) begin
            s.used_less = 1'b1;
            s.look_addr = walk_i.prev;
            s.keep      = !f.has_spot;
            s.free      = f.has_spot;
            s.write     = f.has_spot;
            s.set_more  = 1'b1;
          end else if (record_i.has_next) begin
            s.used_less = 1'b1;
            s.look_addr = record_i.next;
          end else begin
            s.used_less     = 1'b1;
            s.write         = 1'b1;
            s.unused_record = 1'b1;
            s.touch         = 1'b1;
            s.set_edge      = 1'b1;
            s.cover_centre  = record_i.corner;
            s.last          = 1'b1;
            s.events.emptied_covered = record_i.corner;
          end
        end else begin
          if (f.same_texel) begin
            w.seen      = 1'b1;
            w.length    = walk_i.length + 1'b1;
            w.continued = walk_i.continued || record_i.has_more;
            if (!walk_i.placed) begin
              if (f.beyond_it) begin
                w.placed = 1'b1;
                w.push   = !walk_i.has_prev;
                w.place  = walk_i.prev;
              end else begin
                w.place = f.at;
              end
            end
          end
          w.prev      = f.at;
          w.has_prev  = 1'b1;
          s.look      = 1'b1;
          s.look_addr = record_i.next;
          if (!record_i.has_next) begin
            s.look_addr = w.push ? walk_i.own : w.place;
            state_o     = w.push ? shadow_pkg::SlbPush : shadow_pkg::SlbLink;
            if (!f.is_edge) begin
              s.last = 1'b1;
            end else if (first_line && f.hidden) begin
              s.last = 1'b1;
              s.events.lines_hidden = 16'd1;
            end else if (first_line && f.full) begin
              s.look  = 1'b0;
              state_o = shadow_pkg::SlbOverflow;
            end
          end
        end
      end

      shadow_pkg::SlbNew: begin
        s.act        = 1'b1;
        s.write      = 1'b1;
        s.write_addr = f.spot;
        s.take       = 1'b1;
        s.link_has   = walk_i.has_next;
        s.link_addr  = walk_i.next;
        store_new    = 1'b1;
      end
      shadow_pkg::SlbLink: begin
        s.write     = 1'b1;
        s.set_next  = 1'b1;
        w.next      = record_i.next;
        w.has_next  = record_i.has_next;
        s.look      = 1'b1;
        s.look_new  = 1'b1;
        s.look_addr = f.spot;
        state_o     = shadow_pkg::SlbNew;
        if (walk_i.relink) begin
          s.link_addr = walk_i.entry;
          s.look_new  = 1'b0;
          s.look_addr = walk_i.entry;
          state_o     = shadow_pkg::SlbRejoin;
        end
      end
      shadow_pkg::SlbPush: begin
        s.write      = 1'b1;
        s.write_addr = f.spot;
        s.take       = 1'b1;
        w.place      = f.spot;
        s.look       = 1'b1;
        state_o      = shadow_pkg::SlbPushNew;
        if (walk_i.relink) begin
          s.look_addr = walk_i.entry;
          state_o     = shadow_pkg::SlbRejoinOwn;
        end
      end
      shadow_pkg::SlbPushNew: begin
        s.write     = 1'b1;
        s.link_addr = walk_i.place;
        store_new   = 1'b1;
      end
      shadow_pkg::SlbReuse: begin
        s.reuse = 1'b1;
        s.look  = 1'b1;
        state_o = shadow_pkg::SlbFind;
      end
      default: s.act = 1'b0;
    endcase

    if (store_new) begin
      s.fresh     = 1'b1;
      s.set_next  = state_i != shadow_pkg::SlbFind;
      s.used_more = 1'b1;
      w.storing   = 1'b1;
      if (state_i == shadow_pkg::SlbFind || f.short_chain) begin
        s.stored = 1'b1;
        s.last   = 1'b1;
      end else begin
        s.look   = 1'b1;
        w.length = '0;
        state_o  = shadow_pkg::SlbLength;
      end
    end
    if (store_new || store_here) begin
      s.append     = 1'b1;
      s.set_corner = 1'b1;
      s.set_vertex = 1'b1;
    end
  end

  logic unused;
  assign unused = &{1'b0, f, record_i};
endmodule

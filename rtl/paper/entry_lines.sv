// The lines of one entry where it has more records than one: cancelling, appending, counting.
// Part of silhouette_buffer: says what is done in a cycle; nothing is kept here.
//
// A removed line leaves a gap that the first line of each further record fills, so that all records
// but the last are full. A new line goes to the last one, or to a continuation behind it.
// Twin:    append, remove_first, chain_length in model/unit/silhouette_buffer.cpp.
// Timing:  combinational.
module entry_lines (
  input  logic [4:0]             state_i,
  input  shadow_pkg::slb_walk_t  walk_i,
  input  shadow_pkg::slb_facts_t facts_i,
  input  shadow_pkg::record_t    record_i,
  output logic [4:0]             state_o,
  output shadow_pkg::slb_walk_t  walk_o,
  output shadow_pkg::slb_step_t  step_o
);
  localparam int unsigned CountBits = shadow_pkg::LineCountBits;
  localparam int unsigned LineBits  = shadow_pkg::LineBits;

  shadow_pkg::slb_facts_t f;
  shadow_pkg::slb_walk_t  w;
  shadow_pkg::slb_step_t  s;
  logic one_line;
  assign f        = facts_i;
  assign walk_o   = w;
  assign step_o   = s;
  assign one_line = record_i.count == CountBits'(1);

  always_comb begin
    state_o = state_i;
    w       = walk_i;
    s       = '0;
    s.act        = f.hit;
    s.look       = 1'b1;
    s.look_addr  = walk_i.entry;
    s.write_addr = f.at;
    s.more_has   = f.has_free;
    s.more_addr  = f.free;
    s.free_addr  = f.at;

    unique case (state_i)
      shadow_pkg::SlbScan: begin
        if (walk_i.head) begin
          w.next     = record_i.next;
          w.has_next = record_i.has_next;
          w.nearer   = f.nearer;
          w.new_corner = f.new_corner;
          w.new_vertex = f.new_vertex;
        end
        w.length = walk_i.length + 1'b1;
        if (walk_i.gap || (!walk_i.settled && f.match)) begin
          if (record_i.has_more) begin
            w.ahead    = f.at;
            s.look_addr = record_i.more;
            state_o     = shadow_pkg::SlbLift;
          end else begin
            s.write = 1'b1;
            s.events.line_cancelled = 1'b1;
            if (walk_i.head) begin
              s.remove     = 1'b1;
              s.set_corner = 1'b1;
              s.emptied    = one_line;
              s.last       = 1'b1;
            end else if (one_line) begin
              s.set_more  = 1'b1;
              s.free      = 1'b1;
              s.used_less = 1'b1;
              s.look_addr = walk_i.ahead;
              state_o     = shadow_pkg::SlbCut;
            end else begin
              s.remove       = 1'b1;
              s.remove_first = walk_i.gap;
              s.last         = !walk_i.new_corner;
              state_o        = shadow_pkg::SlbMark;
            end
          end
        end else if (record_i.has_more) begin
          w.ahead    = f.at;
          w.head      = 1'b0;
          s.look_addr = record_i.more;
        end else if (!walk_i.settled && f.hidden) begin
          s.last = 1'b1;
          s.events.lines_hidden = 16'd1;
        end else if (!walk_i.settled && w.nearer) begin
          // Where the entry belongs now, entry_move finds.
          s.look_addr = !walk_i.is_first ? walk_i.prev : w.has_next ? w.next : walk_i.entry;
          state_o     = !walk_i.is_first ? shadow_pkg::SlbUnlink
                      : w.has_next ? shadow_pkg::SlbBehind : shadow_pkg::SlbStay;
        end else if (f.room) begin
          s.write      = 1'b1;
          s.append     = 1'b1;
          s.set_corner = walk_i.head;
          s.set_vertex = walk_i.head;
          s.stored     = walk_i.head || !(walk_i.new_corner || walk_i.new_vertex);
          s.last       = s.stored;
          w.storing    = 1'b1;
          state_o      = shadow_pkg::SlbMark;
        end else if (f.full) begin
          s.look  = 1'b0;
          state_o = shadow_pkg::SlbOverflow;
        end else begin
          s.write     = 1'b1;
          s.set_more  = 1'b1;
          s.more_has  = 1'b1;
          s.more_addr = f.spot;
          s.look_new  = 1'b1;
          s.look_addr = f.spot;
          state_o     = shadow_pkg::SlbExtend;
        end
      end
      shadow_pkg::SlbLift: begin
        w.lifted    = record_i.lines[LineBits-1:0];
        s.look_addr = walk_i.ahead;
        state_o     = shadow_pkg::SlbClose;
      end
      shadow_pkg::SlbClose: begin
        s.write        = 1'b1;
        s.remove       = 1'b1;
        s.remove_first = walk_i.gap;
        s.refill       = 1'b1;
        w.ahead       = f.at;
        w.head         = 1'b0;
        w.gap          = 1'b1;
        s.look_addr    = record_i.more;
        state_o        = shadow_pkg::SlbScan;
      end
      shadow_pkg::SlbCut: begin
        s.write    = 1'b1;
        s.set_more = 1'b1;
        s.more_has = 1'b0;
        state_o    = shadow_pkg::SlbMark;
      end
      shadow_pkg::SlbExtend: begin
        s.act        = 1'b1;
        s.write      = 1'b1;
        s.write_addr = f.spot;
        s.take       = 1'b1;
        s.used_more  = 1'b1;
        s.fresh      = 1'b1;
        s.append     = 1'b1;
        w.storing    = 1'b1;
        w.grown      = 1'b1;
        state_o      = shadow_pkg::SlbMark;
      end
      shadow_pkg::SlbMark: begin
        s.write      = 1'b1;
        s.set_corner = 1'b1;
        s.set_vertex = walk_i.storing;
        if (walk_i.grown && !(f.short_chain && (f.few || !walk_i.has_next))) begin
          w.length    = '0;
          s.look_addr = walk_i.own;
          state_o     = shadow_pkg::SlbLength;
        end else begin
          s.stored = walk_i.storing;
          s.last   = 1'b1;
        end
      end
      shadow_pkg::SlbLength: begin
        if (f.same_texel) w.length = walk_i.length + 1'b1;
        w.next      = record_i.next;
        w.has_next  = record_i.has_next;
        s.look_addr = record_i.next;
        if (f.same_texel && record_i.has_more) begin
          s.look_addr = record_i.more;
          state_o     = shadow_pkg::SlbLengthMore;
        end else if (!record_i.has_next) begin
          s.look  = 1'b0;
          state_o = shadow_pkg::SlbJudge;
        end
      end
      shadow_pkg::SlbLengthMore: begin
        w.length    = walk_i.length + 1'b1;
        s.look_addr = record_i.more;
        if (!record_i.has_more) begin
          s.look      = walk_i.has_next;
          s.look_addr = walk_i.next;
          state_o     = walk_i.has_next ? shadow_pkg::SlbLength : shadow_pkg::SlbJudge;
        end
      end
      default: s.act = 1'b0;
    endcase
  end

  logic unused;
  assign unused = &{1'b0, f, record_i};
endmodule

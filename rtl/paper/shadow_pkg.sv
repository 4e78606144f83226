// Types and parameters of the shadow unit, paper profile.
//
// Widths come from the configuration (`kagesen config`); everything else follows from them.
// docs/rtl.md draws the words; docs/unit.md says what they mean.
// Generated from shadow_pkg.sv.in by `kagesen rtl`; do not edit.
package shadow_pkg;
  // From the configuration.
  localparam int unsigned FractionBits  = 8;
  localparam int unsigned SlopeBits     = 8;
  localparam int unsigned DepthBits     = 24;
  localparam int unsigned IdBits        = 16;
  localparam int unsigned PolygonBits   = 14;
  localparam int unsigned PositionBits  = 26;  // of Mx and My that are looked at
  localparam int unsigned LinesPerRecord = 3;
  localparam int unsigned RecordAddrBits = 19;  // buckets, then the pool
  localparam int unsigned Lanes         = 1;
  localparam int unsigned FragmentsInFlight = 128;  // of a lane, a power of two
  localparam int unsigned FragmentSlots = FragmentsInFlight < 8 ? 8 : FragmentsInFlight;
  localparam int unsigned VisitFifoDepth = 32;  // visits ahead of the store, a power of two
  localparam int unsigned TexelLines    = 64;   // texel words kept on chip in pass 1, a power of two
  localparam int unsigned RecordLines   = 128;  // SLB records kept on chip in pass 1, a power of two

  localparam int unsigned MapBits       = 10;  // of a texel index; the map's sides are at most 2^MapBits

  // Fixed by the trace format.
  localparam int unsigned CoordBits  = 28;  // signed, units of 2^-f texel, f = 16 to 26
  localparam int unsigned MaxFraction = 26;
  localparam int unsigned TraceDepthBits = 24;
  localparam int unsigned ObjectBits = 24;
  localparam int unsigned RowIndexBits = 14;  // signed: texel index from the map's corner, off the map too, for any f

  localparam int unsigned TexelsPerWord = 4;  // neighbours along x in one word of the texel memory
  localparam int unsigned TexelAddrBits = 2 * MapBits - 2;
  localparam int unsigned LineCountBits = 4;
  localparam int unsigned SlotBits   = $clog2(FragmentSlots);
  localparam int unsigned TagBits    = 8;  // of a memory request; unique while outstanding
  localparam int unsigned LimitBits  = 25;  // of the capacity registers

  typedef struct packed {
    logic [CoordBits-1:0]      x;  // signed
    logic [CoordBits-1:0]      y;  // signed
    logic [TraceDepthBits-1:0] z;
  } point_t;

  // A beat of the triangle stream.
  typedef struct packed {
    logic                  is_plane;  // winding alone: v0 to v2 give the plane of the next triangle
    logic                  shares;    // winding alone: takes the plane of the beat before
    logic [2:0]            inner;     // winding alone: bit i, edge i to i + 1 is inside that plane
    logic [23:0]           polygon;
    logic [ObjectBits-1:0] object;    // unit ID
    point_t                v0;
    point_t                v1;
    point_t                v2;
  } tri_t;

  // A beat of the fragment stream.
  typedef struct packed {
    logic                  unshadowable;  // winding alone, skip_fragments
    logic                  outside;
    logic                  averted;
    logic [ObjectBits-1:0] object;  // unit ID
    point_t                p;
  } frag_t;
  localparam int unsigned FragBits = 3 + ObjectBits + 2 * CoordBits + TraceDepthBits;

  typedef struct packed {
    logic [2:0] by;  // what decided: one of By*
    logic       dark;
  } verdict_t;
  localparam int unsigned VerdictBits = 4;
  localparam logic [2:0] ByDefinition = 3'd0;  // averted: dark
  localparam logic [2:0] ByOutside    = 3'd1;  // outside the light or the map: lit
  localparam logic [2:0] ByNothing    = 3'd2;  // lit, everything that holds the texel was asked
  localparam logic [2:0] ByBuffer     = 3'd3;  // dark by the texel buffers
  localparam logic [2:0] ByLines      = 3'd4;  // dark by the SLB
  localparam logic [2:0] ByTile       = 3'd5;  // winding alone

  // Passes, as CONTROL starts them.
  localparam logic [2:0] PassIdle     = 3'd0;
  localparam logic [2:0] PassWipe     = 3'd1;  // a new frame: empty buffers
  localparam logic [2:0] PassAnnounce = 3'd2;  // winding alone: the frame's fragments, for the receiver mask
  localparam logic [2:0] PassDraw     = 3'd3;  // pass 1
  localparam logic [2:0] PassSettle   = 3'd4;  // ends pass 1
  localparam logic [2:0] PassDecide   = 3'd5;  // pass 2

  // What the registers say; constant during a pass.
  typedef struct packed {
    logic [4:0]           texel_bits;   // f
    logic [MapBits:0]     map_width;    // texels
    logic [MapBits:0]     map_height;
    logic [3:0]           pitch_log2;   // texel words of a row: 2^pitch_log2 >= map_width / 4
    // capacities
    logic [4:0]           buckets_log2;   // of the address hash
    logic [LimitBits-1:0] record_limit;   // records the SLB has room for, slb_entries
    logic [LimitBits-1:0] chain_limit;    // records a texel may hold, link_depth
    // policies, as the configuration's keys
    logic                 own_id_literal;
    logic                 vertex_per_entry;
    logic                 table7_printed;
    logic                 depth_writes_all;
    logic [1:0]           hidden_removal;  // 0 off, 1 centre, 2 farthest
    logic                 match_polygon_id;
  } settings_t;

  // ---- Pass 1 -------------------------------------------------------------------------------

  // A silhouette line as stored (3.1).
  typedef struct packed {
    logic                    left;
    logic                    cross_flag;
    logic                    x_major;
    logic                    x_positive;
    logic                    start_here;
    logic                    end_here;
    logic [PolygonBits-1:0]  polygon;
    logic [SlopeBits-1:0]    slope;
    logic [FractionBits-1:0] fraction;
  } line_t;
  localparam int unsigned LineBits = 6 + PolygonBits + SlopeBits + FractionBits;

  // What the front (edge_setup, edge_walker, span_filler) hands to the store, in order:
  // VisitBegin, then VisitEdge for every texel on the map that an outline visits, edge after edge,
  // then VisitEdgesDone, then VisitSpan words of the texels in between.
  localparam logic [1:0] VisitBegin     = 2'd0;
  localparam logic [1:0] VisitEdge      = 2'd1;
  localparam logic [1:0] VisitEdgesDone = 2'd2;
  localparam logic [1:0] VisitSpan      = 2'd3;
  typedef struct packed {
    logic [1:0]           kind;
    logic [MapBits-1:0]   x;        // span: of the word's first texel, a multiple of TexelsPerWord
    logic [MapBits-1:0]   y;
    line_t                line;     // edge
    logic [DepthBits-1:0] nearest;  // edge: least depth of the line in the texel
    logic                 corner;   // edge: the triangle holds the texel's corner
    logic [DepthBits-1:0] depth0;   // edge: plane's depth at the texel's centre, clamped; span: texel 0
    logic [DepthBits-1:0] depth1;   // span
    logic [DepthBits-1:0] depth2;
    logic [DepthBits-1:0] depth3;
    logic [TexelsPerWord-1:0] mask; // span: texels that are covered
  } visit_t;
  // Constant from a VisitBegin to the next one; beside the visit stream.
  typedef struct packed {
    logic [IdBits-1:0]    object;
    logic [DepthBits-1:0] most;  // the triangle's farthest depth
    logic [DepthBits:0]   rise;  // half a texel's rise of its plane, up, at most most - least + 1
  } visit_tri_t;

  // ---- Memories -----------------------------------------------------------------------------

  // One texel of the shadow (depth), ID and edge buffers. Cleared: depth all ones, the rest 0.
  typedef struct packed {
    logic                 overflow;
    logic                 edge_flag;  // the SLB holds lines of this texel
    logic                 covered;    // id is of what covers it
    logic [IdBits-1:0]    id;
    logic [DepthBits-1:0] depth;
  } texel_t;
  localparam int unsigned TexelBits    = 3 + IdBits + DepthBits;
  localparam int unsigned TexelWordBits = TexelsPerWord * TexelBits;  // texel i at i * TexelBits
  localparam int unsigned TexelDataBits = TexelWordBits;

  // One record of the SLB. The first 2^buckets_log2 records are the buckets' own: a bucket's first
  // entry stands in it, further ones in the pool behind. Cleared: 0.
  typedef struct packed {
    logic                      used;       // bucket's own: it holds an entry
    logic                      has_next;
    logic                      has_more;
    logic [RecordAddrBits-1:0] next;       // next entry of the bucket; of a texel, from the light outwards
    logic [RecordAddrBits-1:0] more;       // continuation record of this entry
    logic [2*MapBits-1:0]      texel;      // tag: {y, x}
    logic [IdBits-1:0]         object;
    logic [DepthBits-1:0]      nearest;
    logic                      vertex;
    logic                      corner;
    logic [LineCountBits-1:0]  count;      // lines in this record
    logic [LinesPerRecord*LineBits-1:0] lines;  // line i at i * LineBits, oldest first
  } record_t;
  localparam int unsigned RecordBits = 5 + 2 * RecordAddrBits + 2 * MapBits + IdBits + DepthBits
                                     + LineCountBits + LinesPerRecord * LineBits;

  // ---- Where cycles go ----------------------------------------------------------------------

  // Pass 1, each cycle exactly one. The first three are work.
  localparam logic [3:0] StoreEdge   = 4'd0;  // an edge's visit was carried out
  localparam logic [3:0] StoreSpan   = 4'd1;  // a word of a span was
  localparam logic [3:0] StoreOther  = 4'd2;  // something else was: begin, emptied texel, clear, settle, announce
  localparam logic [3:0] StoreInput  = 4'd3;  // no triangle was offered
  localparam logic [3:0] StoreSetup  = 4'd4;  // the front sets an edge or a triangle up
  localparam logic [3:0] StoreWalk   = 4'd5;  // the front walks, but not to a texel on the map; or fills its pipeline
  localparam logic [3:0] StoreTexel  = 4'd6;  // a texel word has not come yet
  localparam logic [3:0] StoreRecord = 4'd7;  // the first SLB record of a texel has not come yet
  localparam logic [3:0] StoreChain  = 4'd8;  // further records are read, linked or written
  localparam logic [3:0] StoreWrite  = 4'd9;  // a memory takes no write
  // Pass 2, a lane, each cycle exactly one. The first is work.
  localparam logic [3:0] LaneFragment = 4'd0;  // a fragment was taken
  localparam logic [3:0] LaneInput    = 4'd1;  // none was offered
  // No slot was free, and the oldest fragment:
  localparam logic [3:0] LaneTexel     = 4'd2;  // waits for the texel memory
  localparam logic [3:0] LaneTexelPort = 4'd3;  // waits for its turn there
  localparam logic [3:0] LaneSlb       = 4'd4;  // waits for the SLB memory
  localparam logic [3:0] LaneSlbPort   = 4'd5;  // waits for its turn there
  localparam logic [3:0] LaneDecision  = 4'd6;  // is being decided
  localparam logic [3:0] LaneVerdict   = 4'd7;  // has a verdict that nobody takes
  localparam logic [3:0] LaneDrain     = 4'd8;  // all fragments were taken, verdicts are due

  // ---- What happened in a cycle; for counters, no function depends on it ----------------------

  typedef struct packed {
    logic       caster;        // a triangle was taken
    logic       edge_begun;
    logic       edge_texel;    // a texel on the map was visited
    logic [2:0] span_texels;   // texels of spans
  } front_events_t;
  localparam int unsigned FrontEventBits = 6;
  typedef struct packed {
    logic        line_stored;
    logic        line_cancelled;
    logic        emptied_covered;
    logic [15:0] lines_hidden;
    logic [15:0] overflow_lines;
    logic        overflow_texel;
  } store_events_t;
  localparam int unsigned StoreEventBits = 36;
  typedef struct packed {
    logic                     slb_lookup;  // a fragment begins to read the SLB
    logic                     entry_read;
    logic [LineCountBits-1:0] lines_read;
  } lane_events_t;
  localparam int unsigned LaneEventBits = 2 + LineCountBits;

  // ---- Inside silhouette_buffer ---------------------------------------------------------------

  // Whose turn the next cycle is. The upper two bits say which block knows the step.
  localparam logic [4:0] SlbIdle       = 5'd0;   // chain_find
  localparam logic [4:0] SlbSpan       = 5'd1;   // covers a word
  localparam logic [4:0] SlbFind       = 5'd2;   // walks the bucket for the entry, or for its place
  localparam logic [4:0] SlbNew        = 5'd3;   // writes a new entry to the pool
  localparam logic [4:0] SlbLink       = 5'd4;   // behind another entry
  localparam logic [4:0] SlbPush       = 5'd5;   // before the bucket's first entry: that one to the pool
  localparam logic [4:0] SlbPushNew    = 5'd6;
  localparam logic [4:0] SlbReuse      = 5'd7;   // reads the first freed record
  localparam logic [4:0] SlbScan       = 5'd8;   // entry_lines: walks the entry's records
  localparam logic [4:0] SlbLift       = 5'd9;   // the next record's first line is to move up
  localparam logic [4:0] SlbClose      = 5'd10;  // it moves up
  localparam logic [4:0] SlbCut        = 5'd11;  // the last record is gone: its predecessor becomes the last
  localparam logic [4:0] SlbExtend     = 5'd12;  // a continuation record
  localparam logic [4:0] SlbMark       = 5'd13;  // the entry's flags, after a change in a continuation
  localparam logic [4:0] SlbLength     = 5'd14;  // counts the texel's records
  localparam logic [4:0] SlbLengthMore = 5'd15;
  localparam logic [4:0] SlbBehind     = 5'd16;  // entry_move: what stands behind the entry in the texel?
  localparam logic [4:0] SlbStay       = 5'd17;  // it stays where it is with its new nearest
  localparam logic [4:0] SlbUnlink     = 5'd18;  // takes an entry of the pool out of its chain
  localparam logic [4:0] SlbUnlinkCopy = 5'd19;  // takes one out of the bucket's own record: to the pool
  localparam logic [4:0] SlbUnlinkPull = 5'd20;  // and the next entry of the bucket in
  localparam logic [4:0] SlbRejoin     = 5'd21;  // links it in again
  localparam logic [4:0] SlbRejoinOwn  = 5'd22;
  localparam logic [4:0] SlbJudge      = 5'd24;  // chain_erase: does the texel hold too many records?
  localparam logic [4:0] SlbOverflow   = 5'd25;
  localparam logic [4:0] SlbWalk       = 5'd26;  // walks the bucket and erases entries of the texel
  localparam logic [4:0] SlbErase      = 5'd27;  // the entry's records
  localparam logic [4:0] SlbEraseLink  = 5'd28;  // closes the chain
  localparam logic [4:0] SlbEraseFree  = 5'd29;

  localparam logic [1:0] EraseAll    = 2'd0;  // what SlbWalk erases
  localparam logic [1:0] EraseHidden = 2'd1;
  localparam logic [1:0] EraseNone   = 2'd2;  // just looks whether the texel has entries

  // What an operation knows from one step to the next. Of a record nothing but links and one line.
  typedef struct packed {
    logic [1:0]                word_x;     // texel of the word
    logic [RecordAddrBits-1:0] own;        // the bucket's own record
    logic [RecordAddrBits-1:0] ahead;      // the record before this one in its entry; erased: the first of them
    logic [RecordAddrBits-1:0] prev;       // the entry before it in its bucket
    logic                      has_prev;
    logic [RecordAddrBits-1:0] entry;      // found; or where an unlinked one stands
    logic                      head;       // the record is the entry's, not a continuation
    logic                      is_own;     // the entry stands in the bucket's own record
    logic                      is_first;   // of its texel
    logic [RecordAddrBits-1:0] place;      // behind this one an entry belongs; pushed: where the first one went
    logic                      push;       // it belongs before the bucket's first
    logic                      placed;     // its place is found
    logic                      seen;       // an entry of the texel was met
    logic [RecordAddrBits-1:0] next;       // of the entry
    logic                      has_next;
    logic                      relink;     // the entry was unlinked: SlbFind looks for its place
    logic                      settled;    // the new line is none that cancels, nearest is set
    logic                      nearer;     // nearest is to change
    logic                      gap;        // the removed line is the record's first
    logic                      grown;      // a record was taken
    logic                      new_corner; // the visit changes the entry's flags
    logic                      new_vertex;
    logic                      storing;    // the line is stored
    logic [LineBits-1:0]       lifted;
    logic [RecordAddrBits-1:0] length;     // records of the texel that were met; others' continuations are not
    logic                      continued;  // one of them has some
    logic [1:0]                mode;
    logic                      kept;       // the texel has entries that stay
    logic                      covered;    // the emptied texel is covered
    logic                      emptying;
    logic [TexelsPerWord-1:0]  todo;       // texels of the span that hold lines
  } slb_walk_t;

  // What is so in this cycle.
  typedef struct packed {
    logic                      hit;          // the record is there
    logic                      texel_hit;
    logic [RecordAddrBits-1:0] at;           // of the record
    logic                      is_edge;      // the visit's kind; neither: an emptied entry
    logic                      edge_flag;    // of the texel
    logic                      overflow;
    logic                      same_texel;   // the record is of the visit's texel
    logic                      same_entry;   // and object
    logic                      match;        // it holds a line that cancels
    logic                      hidden;       // the line is
    logic                      nearer;       // an entry's nearest would change
    logic                      new_corner;   // an entry's flags would
    logic                      new_vertex;
    logic                      before_it;    // the record's nearest is before the line's
    logic                      beyond_it;    // behind it
    logic                      room;         // for a line
    logic                      erasable;     // its nearest is behind what covers the texel
    logic                      full;         // no record is left
    logic                      few;          // fewer records are in use than a texel may hold
    logic                      short_chain;  // so does the texel with one more entry
    logic                      too_long;
    logic [TexelsPerWord-1:0]  edges;        // texels of the span that hold lines
    logic                      wants_hiding;
    logic [RecordAddrBits-1:0] spot;         // where the next record will stand
    logic                      has_spot;
    logic                      dry;          // the next one would have to be a freed one, not read yet
    logic [RecordAddrBits-1:0] free;         // first freed record
    logic                      has_free;
  } slb_facts_t;

  // What is done in a cycle, all of it or, if a memory takes no write, nothing.
  typedef struct packed {
    logic                      act;
    logic                      last;         // ends the operation
    logic                      look;         // the next record
    logic                      look_new;     // which will be written, not read
    logic [RecordAddrBits-1:0] look_addr;
    logic                      restart;      // SlbFind begins at the bucket's own record
    logic                      walk;         // SlbWalk does
    logic                      spread;       // so it does in the span's next texel, if there is one
    // record
    logic                      write;
    logic [RecordAddrBits-1:0] write_addr;
    logic                      fresh;
    logic                      unused_record;
    logic                      set_next;
    logic                      link_has;
    logic [RecordAddrBits-1:0] link_addr;
    logic                      set_more;
    logic                      more_has;
    logic [RecordAddrBits-1:0] more_addr;
    logic                      set_nearest;
    logic                      set_corner;
    logic                      set_vertex;
    logic                      append;
    logic                      remove;
    logic                      remove_first;
    logic                      refill;
    logic                      emptied;
    // pool
    logic                      take;         // the spot
    logic                      keep;         // a record that came free is the next spot
    logic                      free;         // it is the first of the freed ones
    logic [RecordAddrBits-1:0] free_addr;
    logic                      reuse;        // the first freed record is the next spot
    logic                      used_more;    // one more record is in use
    logic                      used_less;
    // texel
    logic                      touch;
    logic                      stored;       // the line is: edge flag, and what else goes with it
    logic                      cover_texel;
    logic                      cover_span;
    logic                      cover_record; // with the record's nearest and object
    logic                      cover_centre; // with the depth at the centre
    logic                      set_edge;
    logic                      edge_flag;
    logic                      set_overflow;
    store_events_t             events;
  } slb_step_t;
endpackage

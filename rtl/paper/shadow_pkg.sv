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
  localparam int unsigned FragmentSlots = 128;  // fragments in flight a lane, a power of two
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
endpackage

// Types and parameters of the shadow unit, winding profile.
//
// Widths come from the configuration (`kagesen config`); everything else follows from them.
// docs/rtl.md draws the words; docs/unit.md says what they mean.
// Generated from shadow_pkg.sv.in by `kagesen rtl`; do not edit.
package shadow_pkg;
  // From the configuration.
  localparam int unsigned FractionBits  = 8;    // F: exact beyond 2^-F texel
  localparam int unsigned EndGuardBits  = 3;
  localparam int unsigned GradientBits  = 7;    // mantissa, effective
  localparam int unsigned PlaneStepBits = 4;
  localparam int unsigned CornerBits    = 8;
  localparam int unsigned IdBits        = 16;
  localparam int unsigned SegmentsPerRecord = 2;
  localparam int unsigned RecordAddrBits = 22;
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

  localparam int unsigned EndBits    = FractionBits + EndGuardBits;  // G <= 16 <= f
  localparam int unsigned EndWidth   = EndBits + 1;                  // UQ1.G, 0 to 1
  localparam int unsigned ExponentBits = 5;
  localparam int unsigned GradientCodeBits = 1 + ExponentBits + GradientBits;
  localparam int unsigned DepthRange = 31;  // stored depths are kept modulo 2^31
  localparam int unsigned BaseBits   = DepthRange - PlaneStepBits;

  localparam int unsigned TexelsPerWord = 4;  // neighbours along x in one word of the texel memory
  localparam int unsigned TileSlotBits  = 2 * MapBits - 6;
  localparam int unsigned TexelAddrBits = 2 * MapBits - 2 + 1;  // tile words: upper half
  localparam int unsigned SegmentCountBits = 4;
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
    logic [ObjectBits-1:0] object;    // unit ID; 0 in physical semantics
    point_t                v0;
    point_t                v1;
    point_t                v2;
  } tri_t;

  // A beat of the fragment stream.
  typedef struct packed {
    logic                  unshadowable;  // winding alone, skip_fragments
    logic                  outside;
    logic                  averted;
    logic [ObjectBits-1:0] object;  // unit ID; 0 in physical semantics
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
  localparam logic [2:0] ByBuffer     = 3'd3;  // dark by a texel's cover
  localparam logic [2:0] ByLines      = 3'd4;  // dark by the SLB
  localparam logic [2:0] ByTile       = 3'd5;  // lit or dark by the tile

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
    // capacities
    logic [LimitBits-1:0] record_limit;  // records the SLB has room for, cluster_records
    logic [LimitBits-1:0] chain_limit;   // records of one texel's list, chain_records
    logic [16:0]          plane_tolerance;
    // policies, as the configuration's keys
    logic                 paper_semantics;
    logic                 skip_receiver_mask;
    logic                 skip_first_test;
    logic                 skip_tiles;
    logic                 skip_edges;
    logic                 skip_fragments;
  } settings_t;

  // ---- Pass 1 -------------------------------------------------------------------------------

  // A piece of a facet's outline in a texel. Ends UQ1.G texel; end 0 is where it crosses the left
  // border, if it does.
  typedef struct packed {
    logic                inner;
    logic                crosses_left;
    logic                positive;
    logic [EndWidth-1:0] x0;
    logic [EndWidth-1:0] y0;
    logic [EndWidth-1:0] x1;
    logic [EndWidth-1:0] y1;
  } segment_t;
  localparam int unsigned SegmentBits = 3 + 4 * EndWidth;

  // What the front (edge_setup, edge_walker, span_filler) hands to the store, in order:
  // VisitBegin, then VisitEdge for every texel on the map in which the facet has a piece of an
  // outline or a corner to add, then VisitSpan words of the texels that it covers.
  localparam logic [1:0] VisitBegin = 2'd0;
  localparam logic [1:0] VisitEdge  = 2'd1;
  localparam logic [1:0] VisitSpan  = 2'd3;
  typedef struct packed {
    logic [1:0]          kind;
    logic [MapBits-1:0]  x;        // span: of the word's first texel, a multiple of TexelsPerWord
    logic [MapBits-1:0]  y;
    logic                has_segment;
    logic                corner;   // count the texel's corner
    segment_t            segment;
    logic [BaseBits-1:0] base0;    // threshold at the texel's centre; span: of texel 0
    logic [BaseBits-1:0] base1;    // span
    logic [BaseBits-1:0] base2;
    logic [BaseBits-1:0] base3;
    logic [TexelsPerWord-1:0] mask;  // span: texels that are covered
  } visit_t;
  // Constant from a VisitBegin to the next one; beside the visit stream.
  typedef struct packed {
    logic [IdBits-1:0]           object;
    logic [GradientCodeBits-1:0] gradient_x;
    logic [GradientCodeBits-1:0] gradient_y;
  } visit_tri_t;

  // ---- Memories -----------------------------------------------------------------------------

  // A threshold as stored.
  typedef struct packed {
    logic [BaseBits-1:0]         base;  // signed, steps of 2^PlaneStepBits, modular
    logic [GradientCodeBits-1:0] gradient_x;
    logic [GradientCodeBits-1:0] gradient_y;
  } threshold_t;
  localparam int unsigned ThresholdBits = BaseBits + 2 * GradientCodeBits;

  // One texel. kind: TexelEmpty, TexelPlane (plane = threshold_t), TexelList, TexelOverflow.
  // TexelList: word = {covered, bare, cover_depth (signed 32), first}: covered, some full cluster covers it, the
  // nearest one ending at `cover_depth`; else `cover_depth` has the mark of every plane in the list, for pass 1.
  // bare: a cluster may be without segments. TexelOverflow: {covered, 0, cover_depth}; dark beyond `cover_depth`.
  localparam logic [1:0] TexelEmpty    = 2'd0;
  localparam logic [1:0] TexelPlane    = 2'd1;
  localparam logic [1:0] TexelList     = 2'd2;
  localparam logic [1:0] TexelOverflow = 2'd3;
  localparam int unsigned CoverBits = 32;
  localparam int unsigned ListBits  = 2 + CoverBits + RecordAddrBits;
  localparam int unsigned WordBits  = ThresholdBits > ListBits ? ThresholdBits : ListBits;
  typedef struct packed {
    logic                      covered;
    logic                      bare;
    logic [CoverBits-1:0]      cover_depth;  // signed
    logic [RecordAddrBits-1:0] first;
  } texel_list_t;  // in the lower ListBits of `word`
  typedef struct packed {
    logic [1:0]          kind;
    logic [IdBits-1:0]   object;  // of the cover; paper semantics
    logic [WordBits-1:0] word;
  } texel_t;
  localparam int unsigned TexelBits    = 2 + IdBits + WordBits;
  localparam int unsigned TexelWordBits = TexelsPerWord * TexelBits;  // texel i at i * TexelBits

  // One tile of 8 x 8 texels. Bounds are clamped to -1 .. 2^24 - 1, signed 25 bits; "none" is 2^24 - 1
  // for both (nothing is nearer, nothing lies beyond). Cleared: touched 0, nearest and farthest none,
  // several and object_valid 0, mask 0, last 0.
  typedef struct packed {
    logic                    touched;
    logic [TileSlotBits-1:0] slot;      // its 64 texels: words slot * 16 + (y % 8) * 2 + (x % 8) / 4
    logic                    several;   // covers of several objects
    logic                    object_valid;
    logic [IdBits-1:0]       object;
    logic [24:0]             nearest;   // of every threshold in the tile
    logic [24:0]             farthest;  // some cover is nearer in every texel
    logic [23:0]             last;      // depth of the farthest fragment
    logic [63:0]             mask;      // receiver mask: bit (y % 8) * 8 + x % 8
  } tile_t;
  localparam int unsigned TileBits = 3 + TileSlotBits + IdBits + 25 + 25 + 24 + 64;
  localparam int unsigned TexelDataBits = TexelWordBits > TileBits ? TexelWordBits : TileBits;

  // One record of the SLB: a cluster, or a continuation of the one before it.
  typedef struct packed {
    threshold_t                  threshold;
    logic [IdBits-1:0]           object;
    logic [CornerBits-1:0]       corner;
    logic                        full;
    logic [SegmentCountBits-1:0] count;     // segments in this record
    logic                        goes_on;   // `next` is a continuation of this cluster
    logic                        has_next;
    logic [RecordAddrBits-1:0]   next;
    logic [SegmentsPerRecord*SegmentBits-1:0] segments;  // segment i at i * SegmentBits
  } record_t;
  localparam int unsigned RecordBits = ThresholdBits + IdBits + CornerBits + 3 + SegmentCountBits
                                     + RecordAddrBits + SegmentsPerRecord * SegmentBits;

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
    logic       inner_texel;   // a texel on the map of an edge that is not walked
    logic [2:0] span_texels;   // texels of spans
  } front_events_t;
  localparam int unsigned FrontEventBits = 7;
  typedef struct packed {
    logic        line_stored;     // a segment
    logic        line_cancelled;
    logic        emptied_covered;
    logic [2:0]  texel_visits;
    logic [2:0]  masked_visits;
    logic [2:0]  hidden_visits;
    logic        tile_touched;
    logic [15:0] lines_hidden;
    logic [15:0] overflow_lines;
    logic        overflow_texel;
  } store_events_t;
  localparam int unsigned StoreEventBits = 46;
  typedef struct packed {
    logic                        known;       // skip_fragments: nothing was looked up
    logic                        tile_lit;
    logic                        tile_dark;
    logic                        texel_lookup;
    logic                        first_test;
    logic                        slb_lookup;  // a fragment begins to read the SLB
    logic                        entry_read;  // a cluster
    logic [SegmentCountBits-1:0] lines_read;  // segments
  } lane_events_t;
  localparam int unsigned LaneEventBits = 7 + SegmentCountBits;
endpackage

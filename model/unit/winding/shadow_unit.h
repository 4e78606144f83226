#pragma once
/// The shadow unit in the winding profile: both passes, block by block.
#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <unordered_map>
#include <vector>

#include "model/engine.h"
#include "model/unit/span_filler.h"
#include "model/unit/winding/cluster_index.h"
#include "model/unit/winding/edge_walker.h"
#include "model/unit/winding/fragment_trail.h"
#include "model/unit/winding/plane.h"
#include "model/unit/winding/silhouette_buffer.h"
#include "model/unit/winding/texel_buffers.h"
#include "model/unit/winding/triangle_trail.h"

namespace kagesen::unit::winding {

/// Integers only; exact but for the stored ends and planes, whose errors docs/unit.md bounds.
///
/// Verdicts depend on the set of clusters alone, a cluster on the set of its facets, and a cluster
/// is dropped only where another makes every fragment dark that it could: the order of triangles
/// does not matter. Capacity overflow: the texel keeps the nearest of its thresholds at its centre,
/// the verdict of a plain map; it is counted and marked.
class ShadowUnit {
 public:
  void begin(const UnitConfig& config, const FrameSetup& setup);
  void announce(const Fragment* fragments, std::size_t count);  ///< receiver mask
  /// Which texel of the map a fragment is announced in; false if its verdict is known.
  bool place(const Fragment& fragment, TriangleTrail::Texel& texel) const;
  void draw(const Caster& caster);                              ///< pass 1
  /// The same, and what was done. @param trail  cleared
  void draw(const Caster& caster, TriangleTrail& trail);
  /// Ends pass 1: clusters without segments become covers, tiles are summed up. Idempotent.
  void settle();
  /// The same, and what was done. @param trail  cleared
  void settle(SettleTrail& trail);
  /// Pass 2: a verdict a fragment.
  void decide(const Fragment* fragments, std::size_t count, Verdict* verdicts);
  struct Tally {  // of pass 2
    std::uint64_t averted = 0, outside = 0, dark_by_buffer = 0, dark_by_lines = 0;
    std::uint64_t known = 0, tile_lit = 0, tile_dark = 0, texels = 0, first_test = 0;
    std::uint64_t lists = 0, clusters = 0, segments = 0;
  };
  /// The same of one fragment, and what is read for it; count() what was tallied at the end.
  /// @pre settled  @param trail  cleared
  Verdict decide(const Fragment& fragment, FragmentTrail& trail, Tally& tally);
  void count(const Tally& tally, std::size_t fragments);

  const UnitConfig& config() const { return config_; }
  const Widths& widths() const { return widths_; }
  const TexelBuffers& texels() const { return texels_; }
  const SilhouetteBuffer& slb() const { return slb_; }
  const UnitCounters& counters() const { return counters_; }

 private:
  struct Drawn {  // the facet being drawn
    const Caster& caster;
    const Polygon& polygon;
    const FacetPlane& plane;
    std::uint32_t object;
  };
  /// A texel in which the facet being drawn has something to store.
  struct Visit {
    Texel* texel;
    std::uint32_t index;  // of the texel among the touched ones
    Threshold threshold;
    std::int64_t farthest;
  };
  /// Spares the model reading a long list through for each facet; hardware compares as it reads.
  struct LongList {
    std::map<std::array<std::uint32_t, 3>, std::uint32_t> clusters;  // by plane and object
    std::uint32_t records = 0;
  };
  static constexpr std::uint32_t kLongList = 32;
  static std::array<std::uint32_t, 3> plane_key(const Threshold& t, std::uint32_t object) {
    return {static_cast<std::uint32_t>(t.base),
            std::uint32_t{t.gradient_x} << 16 | std::uint32_t{t.gradient_y}, object};
  }

  // Pass 1
  void walk_edge(const Drawn& facet, int index, unsigned passed, bool inner);
  void pass_inner_edge(const Drawn& facet, int index, unsigned passed);
  void begin_trail(const Drawn& facet);
  void begin_edge_trail(const Drawn& facet, int index, bool passed, const EdgeWalker& walker);
  void fill_spans(const Drawn& facet);
  bool covers_corner(const Drawn& facet, std::int32_t x, std::int32_t y) const {
    return facet.polygon.covers_corner(x - centre_x_, y - centre_y_);
  }
  /// False where nothing need be stored: masked, or behind what covers the texel.
  bool visit(std::uint32_t x, std::uint32_t y, const Threshold& threshold, std::uint32_t object,
             Visit& out);

  // Pass 1, within a texel
  bool same_plane(const Visit& visit, std::uint32_t object);
  void add(const Visit& visit, std::uint32_t object, bool corner, const Segment* segment);
  void cover(const Visit& visit, std::uint32_t object);
  void overflow(const Visit& visit, std::uint32_t object);
  bool hidden(const Texel& texel, std::int64_t nearest, std::uint32_t object) const;
  Cluster* cluster_of(const Visit& visit, std::uint32_t object);
  std::uint32_t find(const Visit& visit, std::uint32_t object, std::uint32_t& records);
  std::uint32_t find_in_long_list(const Visit& visit, std::uint32_t object, std::uint32_t& records);
  LongList* long_list(const Visit& visit);
  std::uint32_t records_of_list(const Visit& visit);
  bool open_list(Texel& texel);
  static void note_cover(Texel& texel, std::int64_t farthest, std::uint32_t object);
  void drop_hidden(Texel& texel);
  void settle_texel(Texel& texel);
  void sum_up(Tile& tile);

  // Pass 2
  bool by_definition(const Fragment& f, std::int32_t x, std::int32_t y) const;
  bool known(const Fragment& f, std::int32_t x, std::int32_t y) const;
  Verdict decide_one(const Fragment& fragment, Tally& tally, FragmentTrail* trail);
  Verdict look_up(const Fragment& fragment, std::int32_t x, std::int32_t y, Tally& tally,
                  FragmentTrail* trail);
  Verdict read_texel(const Texel& texel, const Fragment& fragment, Tally& tally,
                     FragmentTrail* trail);
  void follow(std::uint32_t list, std::uint32_t clusters, const Place& place, int shift,
              FragmentTrail& trail) const;
  const ClusterIndex* index_of(std::uint32_t list);
  bool inside(const Cluster& cluster, const Place& place, int shift) const;
  bool passes_over(std::uint32_t source, std::uint32_t object) const {
    return paper_ && source == object;
  }
  std::uint32_t unit_id(std::uint32_t object) const {
    if (!paper_) return 0;
    return object < ids_.size() ? ids_[object] : object & id_mask_;
  }

  UnitConfig config_;
  Widths widths_;
  bool paper_ = false;  // semantics
  std::uint32_t id_mask_ = 0;
  std::int32_t centre_x_ = 0, centre_y_ = 0;  // texel of the map's origin
  std::vector<std::uint32_t> ids_;
  std::vector<Facet> facets_;
  std::vector<Caster> planes_;
  std::vector<std::uint8_t> unshadowable_;

  TexelBuffers texels_;
  SilhouetteBuffer slb_;
  VisitedRows rows_;
  std::unordered_map<std::uint32_t, LongList> long_lists_;  // pass 1, by texel
  struct OftenRead {
    std::uint32_t lookups = 0;
    std::unique_ptr<ClusterIndex> index;
  };
  std::unordered_map<std::uint32_t, OftenRead> indices_;  // pass 2, by the list's head
  bool settled_ = true;
  UnitCounters counters_;
  void note_visit(const Texel& texel, std::int64_t nearest, std::uint32_t object, bool is_hidden);
  TexelVisit* note() { return trail_ == nullptr ? nullptr : &trail_->visits.back(); }
  TriangleTrail* trail_ = nullptr;         // of the facet being drawn, or null
  SettleTrail* settle_trail_ = nullptr;    // while settling, or null
  std::vector<std::uint32_t>* dropped_ = nullptr;  // clusters that are hidden now, or null
};

}  // namespace kagesen::unit::winding

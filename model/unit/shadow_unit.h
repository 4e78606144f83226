#pragma once
/// The shadow unit: pass 1 and pass 2 of the paper's pipeline, block by block.
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "model/engine.h"
#include "model/unit/combination.h"
#include "model/unit/edge_walker.h"
#include "model/unit/fragment_trail.h"
#include "model/unit/shadow_decision.h"
#include "model/unit/silhouette_buffer.h"
#include "model/unit/span_filler.h"
#include "model/unit/texel_buffers.h"
#include "model/unit/triangle_trail.h"

namespace kagesen::unit {

/// Paper profile. Integers only. Capacity overflow: the texel loses its lines and keeps the nearest
/// of their depths with its ID, the verdict of a plain map; it is counted and marked.
class ShadowUnit {
 public:
  void begin(const UnitConfig& config, const FrameSetup& setup);
  void draw(const Caster& caster);  ///< pass 1
  /// The same, and what was done. @param trail  cleared
  void draw(const Caster& caster, TriangleTrail& trail);
  /// Pass 2: a verdict a fragment.
  void decide(const Fragment* fragments, std::size_t count, Verdict* verdicts);
  /// The same of one fragment, and what is read for it. @param trail  cleared
  Verdict decide(const Fragment& fragment, FragmentTrail& trail);

  const UnitConfig& config() const { return config_; }
  const TexelBuffers& texels() const { return texels_; }
  const SilhouetteBuffer& slb() const { return slb_; }
  std::uint32_t bucket_at(std::uint32_t texel) const;
  const UnitCounters& counters() const { return counters_; }

 private:
  struct Tally {  // of one call of decide
    std::uint64_t averted = 0, outside = 0, dark_by_buffer = 0, dark_by_lines = 0;
  };
  struct Visit {  // a texel of the polygon being drawn
    std::int32_t x, y;
    std::uint32_t texel;
  };
  void draw_edge(int index, const EdgeSetup& edge);
  void visit_texel(const OutlineTexel& at, std::uint32_t texel);
  void mark_corner(Record& record, const OutlineTexel& at);
  void empty_visited();
  void fill_spans();
  void cover(std::uint32_t texel, std::uint32_t centre);
  std::uint32_t hide_depth(std::uint32_t centre) const;
  void remove_hidden(std::uint32_t texel, std::uint32_t depth);
  void overflow(std::uint32_t texel, std::uint32_t depth);
  void update_edge_flag(std::uint32_t texel);
  void count(const Tally& tally, std::size_t fragments);
  Verdict decide_one(const Fragment& fragment, Tally& tally, FragmentTrail* trail);
  Verdict decide_by_lines(std::uint32_t texel, std::uint32_t object, std::uint32_t depth,
                          const SubTexel& point);
  Verdict walk_chain(std::uint32_t texel, std::uint32_t object, std::uint32_t depth,
                     const SubTexel& point, FragmentTrail& trail);
  Combination& combination_of(std::uint32_t entry);
  std::uint32_t unit_id(std::uint32_t object) const {
    return object < ids_.size() ? ids_[object] : object & id_mask_;
  }

  UnitConfig config_;
  int bits_ = kMinFractionBits;  // log2 of a texel's units
  int position_shift_ = 0;       // units dropped from Mx and My
  int depth_shift_ = 0;
  std::uint32_t link_depth_ = 0;
  std::uint32_t id_mask_ = 0, polygon_mask_ = 0;
  std::int32_t centre_x_ = 0, centre_y_ = 0;  // texel of the map's origin
  std::vector<std::uint32_t> ids_;

  TexelBuffers texels_;
  SilhouetteBuffer slb_;
  ShadowDecision decision_;
  VisitedRows rows_;
  std::vector<Visit> emptied_;
  std::unordered_map<std::uint32_t, Combination>
      combinations_;  // pass 2: of entries with continuations
  UnitCounters counters_;

  // The polygon being drawn.
  TriangleTrail* trail_ = nullptr;  // or null
  const Polygon* polygon_ = nullptr;
  std::uint32_t object_ = 0, polygon_id_ = 0;
};

}  // namespace kagesen::unit

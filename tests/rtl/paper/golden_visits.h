#pragma once
/// The stream of visits that the front of the paper profile must produce, from the golden classes.
///
/// The order is that of ShadowUnit::draw in model/unit/shadow_unit_pass1.cpp.
#include <algorithm>
#include <cstdint>
#include <vector>

#include "model/unit/config.h"
#include "model/unit/edge_setup.h"
#include "model/unit/edge_walker.h"
#include "model/unit/line.h"
#include "model/unit/span_filler.h"
#include "traces/format/records.h"

namespace kagesen::rtl {

/// visit_t and visit_tri_t of rtl/paper/shadow_pkg.sv; fields that a kind does not use are 0.
struct GoldenVisit {
  enum Kind : std::uint8_t { kBegin, kEdge, kEdgesDone, kSpan };
  Kind kind = kBegin;
  std::int32_t x = 0, y = 0;              ///< texel on the map; span: the word's first texel
  unit::Line line;                        ///< edge
  std::uint32_t nearest = 0;              ///< edge
  bool corner = false;                    ///< edge
  std::uint32_t depth[4] = {0, 0, 0, 0};  ///< edge: [0]; span: where mask says
  std::uint32_t mask = 0;                 ///< span: bit i, texel x + i
  // Of the triangle, in every visit:
  std::uint32_t object = 0, least = 0, most = 0;
  std::uint32_t rise = 0;  ///< at most the depth range; the RTL's may exceed it, to no effect
};

/// What the front counts.
struct GoldenVisitCounts {
  std::uint64_t casters = 0, edges = 0, edge_texels = 0, span_texels = 0;
};

/// Appends the visits of one triangle.
/// @param caster      its `object` is the unit ID already; vertices as in the trace
/// @param texel_bits  f
inline void golden_visits(const Caster& caster, const UnitConfig& config, int texel_bits,
                          std::vector<GoldenVisit>& visits, GoldenVisitCounts& counts) {
  ++counts.casters;
  const int depth_shift = 24 - static_cast<int>(config.depth_bits);
  Caster c = caster;
  for (LightPoint& v : c.vertex) v.z >>= depth_shift;
  const unit::Polygon polygon(c, texel_bits);
  if (polygon.degenerate()) return;
  const auto width = static_cast<std::int32_t>(config.map_width);
  const auto height = static_cast<std::int32_t>(config.map_height);
  const std::int32_t centre_x = width / 2, centre_y = height / 2;

  GoldenVisit tri;
  tri.object = caster.object & ((1u << config.id_bits) - 1);
  tri.most = std::max({c.vertex[0].z, c.vertex[1].z, c.vertex[2].z});
  tri.least = std::min({c.vertex[0].z, c.vertex[1].z, c.vertex[2].z});
  // farthest() takes the lesser of most and centre + rise: beyond the range is as good as the
  // range.
  tri.rise = polygon.farthest(tri.least) - tri.least;
  visits.push_back(tri);

  const auto [low, high] = std::minmax({c.vertex[0].y, c.vertex[1].y, c.vertex[2].y});
  unit::VisitedRows rows;
  rows.begin(std::max(0, (low >> texel_bits) + centre_y),
             std::min(height - 1, (high >> texel_bits) + centre_y));
  for (int i = 0; i < 3; ++i) {
    const LightPoint& a = c.vertex[i];
    const LightPoint& b = c.vertex[(i + 1) % 3];
    if (a.x == b.x && a.y == b.y) continue;
    ++counts.edges;
    const unit::EdgeSetup edge = unit::setup_edge(a, b, c.vertex[(i + 2) % 3], texel_bits,
                                                  static_cast<int>(config.slope_bits));
    for (unit::EdgeWalker walker(edge, texel_bits, static_cast<int>(config.fraction_bits));;
         walker.step()) {
      const unit::OutlineTexel at = walker.texel();
      const std::int32_t x = at.x + centre_x, y = at.y + centre_y;
      if (y >= 0 && y < height) {
        rows.visit(i, x, y);
        if (x >= 0 && x < width) {
          ++counts.edge_texels;
          GoldenVisit visit = tri;
          visit.kind = GoldenVisit::kEdge;
          visit.x = x;
          visit.y = y;
          visit.line = at.line;
          visit.line.polygon = caster.polygon & ((1u << config.polygon_id_bits) - 1);
          visit.nearest = at.nearest;
          visit.corner = polygon.covers_corner(at.x, at.y);
          visit.depth[0] = polygon.centre_depth(at.x, at.y);
          visits.push_back(visit);
        }
      }
      if (walker.last()) break;
    }
  }
  GoldenVisit done = tri;
  done.kind = GoldenVisit::kEdgesDone;
  visits.push_back(done);

  rows.gaps([&](std::int32_t y, std::int32_t from, std::int32_t to) {
    from = std::max(from, 0);
    to = std::min(to, width - 1);
    if (from > to) return;
    counts.span_texels += static_cast<std::uint64_t>(to - from + 1);
    unit::ExactRamp depth = polygon.centre_ramp(from - centre_x, y - centre_y);
    for (std::int32_t word = from & ~3; word <= to; word += 4) {
      GoldenVisit span = tri;
      span.kind = GoldenVisit::kSpan;
      span.x = word;
      span.y = y;
      for (std::int32_t x = std::max(from, word); x <= std::min(to, word + 3); ++x) {
        span.mask |= 1u << (x - word);
        span.depth[x - word] = static_cast<std::uint32_t>(depth.whole);
        depth.advance();
      }
      visits.push_back(span);
    }
  });
}

/// The visits of a whole pass 1.
inline std::vector<GoldenVisit> golden_visits(const std::vector<Caster>& casters,
                                              const UnitConfig& config, int texel_bits,
                                              GoldenVisitCounts* counts = nullptr) {
  std::vector<GoldenVisit> visits;
  GoldenVisitCounts sum;
  for (const Caster& caster : casters) golden_visits(caster, config, texel_bits, visits, sum);
  if (counts != nullptr) *counts = sum;
  return visits;
}

}  // namespace kagesen::rtl

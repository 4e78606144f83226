#pragma once
/// The stream of visits that the front of the winding profile must produce, from the golden classes.
///
/// The order is that of ShadowUnit::draw in model/unit/winding/shadow_unit_pass1.cpp.
#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "model/engine.h"
#include "model/unit/config.h"
#include "model/unit/span_filler.h"
#include "model/unit/winding/edge_walker.h"
#include "model/unit/winding/plane.h"
#include "model/unit/winding/segment.h"

namespace kagesen::rtl {

/// visit_t and visit_tri_t of rtl/winding/shadow_pkg.sv; fields that a kind does not use are 0.
struct GoldenVisit {
  enum Kind : std::uint8_t { kBegin = 0, kEdge = 1, kSpan = 3 };
  Kind kind = kBegin;
  std::int32_t x = 0, y = 0;  ///< texel on the map; span: the word's first texel
  bool has_segment = false, corner = false;
  unit::winding::Segment segment;            ///< if has_segment
  std::array<std::int32_t, 4> base{};        ///< edge: [0]; span: where mask says
  std::uint32_t mask = 0;                    ///< span: bit i, texel x + i
  // Of the triangle, in every visit:
  std::uint32_t object = 0, gradient_x = 0, gradient_y = 0;
};

/// What the front counts.
struct GoldenVisitCounts {
  std::uint64_t casters = 0, edges = 0, edge_texels = 0, inner_texels = 0, span_texels = 0;
};

/// A triangle as the host hands it over.
struct GoldenTri {
  Caster caster;  ///< its object is the unit ID already
  Facet facet;
};

namespace detail {

/// One triangle's visits, one after the other.
class GoldenFront {
 public:
  GoldenFront(const GoldenTri& tri, const FrameSetup& setup, const UnitConfig& config,
              std::vector<GoldenVisit>& visits, GoldenVisitCounts& counts)
      : v_(tri.caster.vertex),
        facet_(tri.facet),
        widths_(config, static_cast<int>(setup.fraction_bits)),
        polygon_(tri.caster, widths_.texel_bits),
        width_(static_cast<std::int32_t>(config.map_width)),
        height_(static_cast<std::int32_t>(config.map_height)),
        skip_edges_(config.skip_edges),
        plane_(tri.caster,
               facet_.plane != Facet::kOwnPlane ? &setup.planes[facet_.plane] : nullptr, widths_),
        visits_(visits),
        counts_(counts) {
    tri_.object =
        config.semantics == Semantics::kPaper ? tri.caster.object & ((1u << config.id_bits) - 1) : 0;
    const auto threshold = plane_.in(0, 0);
    tri_.gradient_x = threshold.gradient_x;
    tri_.gradient_y = threshold.gradient_y;
  }

  void draw() {
    visits_.push_back(tri_);
    const auto [low, high] = std::minmax({v_[0].y, v_[1].y, v_[2].y});
    rows_.begin(std::max(0, (low >> widths_.texel_bits) + height_ / 2),
                std::min(height_ - 1, (high >> widths_.texel_bits) + height_ / 2));
    const unsigned inner = skip_edges_ ? facet_.inner_edges : 0;
    unsigned passed = 0;
    for (int i = 0; i < 3; ++i) {
      const LightPoint &a = v_[i], &b = v_[(i + 1) % 3];
      if ((inner >> i & 1) != 0 || (a.x == b.x && a.y == b.y)) continue;
      walk(i, passed, (facet_.inner_edges >> i & 1) != 0);
      passed |= 1u << i;
    }
    for (int i = 0; i < 3; ++i) {
      if ((inner >> i & 1) == 0) continue;
      pass(i, passed);
      passed |= 1u << i;
    }
    fill();
  }

 private:
  unit::winding::EdgeWalker walker(int i) const {
    return {v_[i], v_[(i + 1) % 3], v_[(i + 2) % 3], widths_.texel_bits, widths_.end_bits};
  }
  bool covers(std::int32_t x, std::int32_t y) const {
    return polygon_.covers_corner(x - width_ / 2, y - height_ / 2);
  }
  GoldenVisit edge_visit(std::int32_t x, std::int32_t y) const {
    GoldenVisit visit = tri_;
    visit.kind = GoldenVisit::kEdge;
    visit.x = x;
    visit.y = y;
    visit.base[0] = plane_.in(x - width_ / 2, y - height_ / 2).base;
    return visit;
  }

  void walk(int index, unsigned passed, bool inner) {
    ++counts_.edges;
    for (unit::winding::EdgeWalker w = walker(index);; w.step()) {
      const std::int32_t x = w.x() + width_ / 2, y = w.y() + height_ / 2;
      if (y >= 0 && y < height_) {
        rows_.visit(index, x, y);
        if (x >= 0 && x < width_) {
          ++counts_.edge_texels;
          GoldenVisit visit = edge_visit(x, y);
          visit.has_segment = w.segment(visit.segment);
          if (inner) {
            visit.has_segment = visit.has_segment && !visit.segment.dot();
            visit.segment.flags |= unit::winding::Segment::kInner;
          }
          if (!visit.has_segment) visit.segment = {};
          visit.corner = !rows_.visited(passed, x, y) && covers(x, y);
          visits_.push_back(visit);
        }
      }
      if (w.last()) break;
    }
  }

  void pass(int index, unsigned passed) {
    for (unit::winding::EdgeWalker w = walker(index);; w.next_row()) {
      const std::int32_t y = w.y() + height_ / 2;
      if (y >= 0 && y < height_) {
        std::int32_t low, high;
        w.row(low, high);
        low += width_ / 2;
        high += width_ / 2;
        rows_.visit(index, low, y);
        rows_.visit(index, high, y);
        for (std::int32_t x = std::max(low, 0); x <= std::min(high, width_ - 1); ++x) {
          ++counts_.inner_texels;
          if (rows_.visited(passed, x, y) || !covers(x, y)) continue;
          visits_.push_back(edge_visit(x, y));
          visits_.back().corner = true;
        }
      }
      if (w.last_row()) break;
    }
  }

  void fill() {
    rows_.gaps([&](std::int32_t y, std::int32_t from, std::int32_t to) {
      from = std::max(from, 0);
      to = std::min(to, width_ - 1);
      if (from > to) return;
      counts_.span_texels += static_cast<std::uint64_t>(to - from + 1);
      unit::ExactRamp depth = plane_.ramp(from - width_ / 2, y - height_ / 2);
      for (std::int32_t word = from & ~3; word <= to; word += 4) {
        GoldenVisit span = tri_;
        span.kind = GoldenVisit::kSpan;
        span.x = word;
        span.y = y;
        for (std::int32_t x = std::max(from, word); x <= std::min(to, word + 3); ++x) {
          span.mask |= 1u << (x - word);
          span.base[static_cast<std::size_t>(x - word)] = plane_.at(depth).base;
          depth.advance();
        }
        visits_.push_back(span);
      }
    });
  }

  const LightPoint* v_;
  Facet facet_;
  unit::winding::Widths widths_;
  unit::Polygon polygon_;
  std::int32_t width_, height_;
  bool skip_edges_;
  unit::winding::FacetPlane plane_;
  unit::VisitedRows rows_;
  GoldenVisit tri_;
  std::vector<GoldenVisit>& visits_;
  GoldenVisitCounts& counts_;
};

}  // namespace detail

/// Appends the visits of one triangle.
inline void golden_visits(const GoldenTri& tri, const FrameSetup& setup, const UnitConfig& config,
                          std::vector<GoldenVisit>& visits, GoldenVisitCounts& counts) {
  ++counts.casters;
  const unit::Polygon polygon(tri.caster, static_cast<int>(setup.fraction_bits));
  if (polygon.degenerate()) return;
  detail::GoldenFront(tri, setup, config, visits, counts).draw();
}

/// A trace's casters as the host hands them over, in the order they are drawn.
inline std::vector<GoldenTri> golden_tris(const std::vector<Caster>& casters,
                                          const FrameSetup& setup, const UnitConfig& config) {
  std::vector<GoldenTri> tris;
  for (std::size_t i = 0; i < casters.size(); ++i) {
    GoldenTri tri{casters[i], i < setup.facets.size() ? setup.facets[i] : Facet{}};
    const std::uint32_t object = tri.caster.object;
    tri.caster.object = config.semantics != Semantics::kPaper ? 0
                        : object < setup.unit_ids.size()      ? setup.unit_ids[object]
                                                              : object & ((1u << config.id_bits) - 1);
    tris.push_back(tri);
  }
  return tris;
}

/// The visits of a whole pass 1.
inline std::vector<GoldenVisit> golden_visits(const std::vector<Caster>& casters,
                                              const FrameSetup& setup, const UnitConfig& config,
                                              GoldenVisitCounts* counts = nullptr) {
  std::vector<GoldenVisit> visits;
  GoldenVisitCounts sum;
  for (const GoldenTri& tri : golden_tris(casters, setup, config)) {
    golden_visits(tri, setup, config, visits, sum);
  }
  if (counts != nullptr) *counts = sum;
  return visits;
}

}  // namespace kagesen::rtl

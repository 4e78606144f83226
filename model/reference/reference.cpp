#include "model/reference/reference.h"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <optional>

#include "model/reference/boundary.h"
#include "model/reference/caster_tree.h"

namespace kagesen {

struct ExactReference::Impl {
  explicit Impl(const std::vector<Caster>& c) : casters(c), tree(c, CasterTree::Shape::kOutline) {}

  /// Does a caster of an object that `relevant` accepts cover (x, y) strictly nearer than z?
  template <class Relevant>
  bool any_nearer(std::int32_t x, std::int32_t y, std::uint32_t z, Relevant relevant) const {
    if (!tree.contains(x, y)) return false;
    bool found = false;
    tree.visit_point(
        x, y,
        [&](const CasterTree::Cover& cover) {
          if (cover.nearest >= z) return CasterTree::kSkipNode;
          if (!relevant(cover.object)) return CasterTree::kNext;
          const Caster& c = casters[cover.caster];
          found = cover.farthest < z || plane_nearer(c, weights_at(c, x, y), z);
          return found ? CasterTree::kStop : CasterTree::kNext;
        },
        [&](const CasterTree::Ref& ref) {
          if (ref.nearest >= z) return CasterTree::kSkipNode;
          const Caster& c = casters[ref.caster];
          if (!relevant(c.object)) return CasterTree::kNext;
          const Weights w = weights_at(c, x, y);
          found = w.inside() && plane_nearer(c, w, z);
          return found ? CasterTree::kStop : CasterTree::kNext;
        });
    return found;
  }

  /// Depth of the nearest relevant surface at (x, y), depth units; infinite where there is none.
  template <class Relevant>
  double nearest_surface(std::int32_t x, std::int32_t y, Relevant relevant) const {
    double best = std::numeric_limits<double>::infinity();
    if (!tree.contains(x, y)) return best;
    auto consider = [&](std::uint32_t nearest, std::uint32_t caster) {
      if (nearest >= best) return CasterTree::kSkipNode;
      const Caster& c = casters[caster];
      if (!relevant(c.object)) return CasterTree::kNext;
      const Weights w = weights_at(c, x, y);
      if (w.inside()) best = std::min(best, plane_depth(c, w));
      return CasterTree::kNext;
    };
    tree.visit_point(
        x, y, [&](const CasterTree::Cover& c) { return consider(c.nearest, c.caster); },
        [&](const CasterTree::Ref& r) { return consider(r.nearest, r.caster); });
    return best;
  }

  /// A second tree, over bounding boxes; only casters_in needs it, so it is made on demand.
  const CasterTree& boxes() const {
    std::call_once(boxes_once, [this] { box_tree.emplace(casters, CasterTree::Shape::kBox); });
    return *box_tree;
  }

  /// Only the judgement of wrong fragments asks for outlines, so this is made on demand too.
  const BoundaryFinder& boundary() const {
    std::call_once(finder_once, [this] { finder.emplace(tree); });
    return *finder;
  }

  const std::vector<Caster>& casters;
  CasterTree tree;
  mutable std::once_flag finder_once;
  mutable std::optional<BoundaryFinder> finder;
  mutable std::once_flag boxes_once;
  mutable std::optional<CasterTree> box_tree;
};

ExactReference::ExactReference(const std::vector<Caster>& casters)
    : impl_(std::make_unique<Impl>(casters)) {}
ExactReference::~ExactReference() = default;

bool ExactReference::dark(const LightPoint& p, std::uint32_t object, Semantics semantics) const {
  if (semantics == Semantics::kPhysical) {
    return impl_->any_nearer(p.x, p.y, p.z, [](std::uint32_t) { return true; });
  }
  return impl_->any_nearer(p.x, p.y, p.z, [object](std::uint32_t o) { return o != object; });
}

bool ExactReference::covered_by(std::int32_t x, std::int32_t y, std::uint32_t object,
                                std::uint32_t nearer_than) const {
  return impl_->any_nearer(x, y, nearer_than, [object](std::uint32_t o) { return o == object; });
}

DepthSample ExactReference::nearest(std::int32_t x, std::int32_t y) const {
  DepthSample best;
  if (!impl_->tree.contains(x, y)) return best;
  std::uint32_t best_caster = std::numeric_limits<std::uint32_t>::max();
  auto consider = [&](std::uint32_t nearest, std::uint32_t caster) {
    if (nearest > best.depth) return CasterTree::kSkipNode;
    const Caster& c = impl_->casters[caster];
    const Weights w = weights_at(c, x, y);
    if (!w.inside()) return CasterTree::kNext;
    const std::uint32_t depth = floor_depth(c, w);
    if (depth < best.depth || (depth == best.depth && caster < best_caster)) {
      best = {depth, c.object};
      best_caster = caster;
    }
    return CasterTree::kNext;
  };
  impl_->tree.visit_point(
      x, y, [&](const CasterTree::Cover& c) { return consider(c.nearest, c.caster); },
      [&](const CasterTree::Ref& r) { return consider(r.nearest, r.caster); });
  return best;
}

double ExactReference::contact_distance(const LightPoint& p, std::uint32_t object,
                                        Semantics semantics) const {
  const bool all = semantics == Semantics::kPhysical;
  return std::abs(
      impl_->nearest_surface(p.x, p.y, [=](std::uint32_t o) { return all || o != object; }) - p.z);
}

double ExactReference::boundary_distance(const LightPoint& p, std::uint32_t object,
                                         Semantics semantics, double limit) const {
  if (!(limit > 0)) return limit;
  return impl_->boundary().distance({p, object, semantics}, dark(p, object, semantics), limit);
}

bool ExactReference::in_band(const LightPoint& p, std::uint32_t object, Semantics semantics,
                             double radius) const {
  if (!dark(p, object, semantics)) {
    return impl_->boundary().edge_within({p, object, semantics, Outline::kEdges}, radius);
  }
  const auto moved = [](std::int32_t from, double by) {
    return static_cast<std::int32_t>(
        std::clamp<double>(std::round(from + by), kCoordinateMin, kCoordinateMax));
  };
  constexpr double kDiagonal = 0.70710678118654752;
  constexpr double kDirections[8][2] = {{1, 0},
                                        {0, 1},
                                        {-1, 0},
                                        {0, -1},
                                        {kDiagonal, kDiagonal},
                                        {-kDiagonal, kDiagonal},
                                        {-kDiagonal, -kDiagonal},
                                        {kDiagonal, -kDiagonal}};
  for (int quarter = 4; quarter > 0; --quarter) {
    for (const auto& direction : kDirections) {
      const double reach = radius * quarter / 4;
      const LightPoint probe{moved(p.x, direction[0] * reach), moved(p.y, direction[1] * reach),
                             p.z};
      if (!dark(probe, object, semantics)) return true;
    }
  }
  return false;
}

void ExactReference::casters_in(std::int32_t x0, std::int32_t y0, std::int32_t x1, std::int32_t y1,
                                std::vector<std::uint32_t>& out) const {
  const auto first = std::ptrdiff_t(out.size());
  const Box box{x0, y0, x1, y1};
  auto add = [&](std::uint32_t caster) {
    if (bounding_box(impl_->casters[caster]).meets(box)) out.push_back(caster);
  };
  const CasterTree& tree = impl_->boxes();
  tree.visit_box(
      box, [](std::uint32_t) { return true; },
      [&](const CasterTree::Node& node) {
        for (std::uint32_t i = node.covers_begin; i != node.covers_end; ++i)
          add(tree.covers()[i].caster);
        for (std::uint32_t i = node.refs_begin; i != node.refs_end; ++i) add(tree.refs()[i].caster);
        return true;
      });
  std::sort(out.begin() + first, out.end());
  out.erase(std::unique(out.begin() + first, out.end()), out.end());
}

}  // namespace kagesen

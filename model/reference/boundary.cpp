#include "model/reference/boundary.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "model/reference/open_edges.h"

namespace kagesen {
namespace {

constexpr double kOffset = 1.0 / 64;  ///< units outside an edge at which it is probed
constexpr double kStep = 1.0 / 16;    ///< units past the end of a covered interval

/// A linear function of the position along a line.
struct Linear {
  double at_zero, slope;
  double operator()(double s) const { return at_zero + slope * s; }
};

/// Cuts [low, high] to where f >= 0.
void cut_interval(const Linear& f, double& low, double& high) {
  if (f.slope > 0) low = std::max(low, -f.at_zero / f.slope);
  if (f.slope < 0) high = std::min(high, -f.at_zero / f.slope);
}

std::int32_t clamped(double v) {
  return std::int32_t(std::clamp(v, double(std::numeric_limits<std::int32_t>::min()),
                                 double(std::numeric_limits<std::int32_t>::max())));
}

}  // namespace

BoundaryFinder::BoundaryFinder(const CasterTree& tree)
    : tree_(tree), open_(find_open_edges(tree.casters())), summaries_(tree.nodes().size()) {
  summarise();
}

void BoundaryFinder::summarise() {
  const auto& nodes = tree_.nodes();
  // Children come after their parents.
  for (std::size_t n = nodes.size(); n-- > 0;) {
    const CasterTree::Node& node = nodes[n];
    Summary& sum = summaries_[n];
    auto cut = [&sum](std::uint32_t nearest, std::uint32_t farthest) {
      if (nearest == farthest) return;
      sum.cut_nearest = std::min(sum.cut_nearest, nearest);
      sum.cut_farthest = std::max(sum.cut_farthest, farthest);
    };
    for (std::uint32_t i = node.covers_begin; i != node.covers_end; ++i) {
      cut(tree_.covers()[i].nearest, tree_.covers()[i].farthest);
      sum.add_object(tree_.covers()[i].object);
    }
    for (std::uint32_t i = node.refs_begin; i != node.refs_end; ++i) {
      const CasterTree::Ref& ref = tree_.refs()[i];
      cut(ref.nearest, farthest_depth(tree_.casters()[ref.caster]));
      sum.add_object(tree_.casters()[ref.caster].object);
      if (open_[ref.caster] != 0) sum.open_nearest = std::min(sum.open_nearest, ref.nearest);
    }
    if (node.children == 0) continue;
    for (std::uint32_t i = 0; i != 1u << (2 * node.fan_out); ++i) {
      const Summary& child = summaries_[node.children + i];
      sum.open_nearest = std::min(sum.open_nearest, child.open_nearest);
      sum.cut_nearest = std::min(sum.cut_nearest, child.cut_nearest);
      sum.cut_farthest = std::max(sum.cut_farthest, child.cut_farthest);
      sum.add_object(child.object);
    }
  }
}

/// Calls emit(a, b, inner, caster) for the pieces of a triangle's outline at the query's depth: of
/// the given edges, and its depth line. `inner`: a point on the shadow's side. Stops when it
/// returns false.
template <class Emit>
bool BoundaryFinder::emit_segments(const Query& q, std::uint32_t caster, unsigned edges,
                                   Emit emit) const {
  const Caster& c = tree_.casters()[caster];
  const double z = q.p.z;
  Vector v[3];
  double depth[3];
  int nearer = 0;
  for (int i = 0; i < 3; ++i) {
    v[i] = {double(c.vertex[i].x) - q.p.x, double(c.vertex[i].y) - q.p.y};
    depth[i] = c.vertex[i].z;
    nearer += depth[i] < z;
  }
  // Where the edge from i to k passes the query's depth.
  auto crossing = [&](int i, int k) {
    const double t = (z - depth[i]) / (depth[k] - depth[i]);
    return Vector{v[i].x + t * (v[k].x - v[i].x), v[i].y + t * (v[k].y - v[i].y)};
  };
  for (int i = 0; i < 3; ++i) {
    const int k = (i + 1) % 3;
    if (!(edges >> i & 1) || (depth[i] >= z && depth[k] >= z)) continue;
    const Vector a = depth[i] < z ? v[i] : crossing(k, i);
    const Vector b = depth[k] < z ? v[k] : crossing(i, k);
    if (!emit(a, b, v[(i + 2) % 3], caster)) return false;
  }
  const bool crosses = q.outline == Outline::kWhole && (nearer == 1 || nearer == 2);
  for (int i = 0; i < 3 && crosses; ++i) {
    // The vertex that is alone on its side of the depth line.
    if ((depth[i] < z) != (nearer == 1)) continue;
    const int k = (i + 1) % 3, l = (i + 2) % 3;
    const Vector a = nearer == 1 ? crossing(i, k) : crossing(k, i);
    const Vector b = nearer == 1 ? crossing(i, l) : crossing(l, i);
    const Vector inner = nearer == 1 ? v[i] : depth[k] < depth[l] ? v[k] : v[l];
    return emit(a, b, inner, caster);
  }
  return true;
}

/// Calls emit(Segment) for every piece within the radius; depth lines may come more than once.
template <class Emit>
bool BoundaryFinder::visit_segments(const Query& q, double radius, Emit emit) const {
  const Box box{clamped(q.p.x - radius - 1), clamped(q.p.y - radius - 1),
                clamped(q.p.x + radius + 1), clamped(q.p.y + radius + 1)};
  auto take = [&](Vector a, Vector b, Vector inner, std::uint32_t caster) {
    const Vector d{b.x - a.x, b.y - a.y};
    const double length = d.x * d.x + d.y * d.y;
    const double t = length > 0 ? std::clamp(-(a.x * d.x + a.y * d.y) / length, 0.0, 1.0) : 0;
    const double distance = std::hypot(a.x + t * d.x, a.y + t * d.y);
    if (distance >= radius) return true;
    Vector n{d.y, -d.x};
    const Vector in{inner.x - a.x, inner.y - a.y};
    if (length == 0) n = {-in.x, -in.y};
    if (n.x * in.x + n.y * in.y > 0) n = {-n.x, -n.y};
    const double scale = std::hypot(n.x, n.y);
    return bool(emit(Segment{distance, a, b, {n.x / scale, n.y / scale}, caster}));
  };
  // A long caster is listed in many nodes: each is looked at once.
  thread_local std::vector<std::uint32_t> seen;
  thread_local std::uint32_t visit = 0;
  if (seen.size() < open_.size() || ++visit == 0) {
    seen.assign(std::max(seen.size(), open_.size()), 0);
    visit = 1;
  }
  const bool whole = q.outline == Outline::kWhole;
  const std::uint32_t z = q.p.z;
  return tree_.visit_box(
      box, [&](std::uint32_t node) { return summaries_[node].matters(q); },
      [&](const CasterTree::Node& node) {
        for (std::uint32_t i = node.covers_begin; whole && i != node.covers_end; ++i) {
          const CasterTree::Cover& cover = tree_.covers()[i];
          if (cover.nearest >= z) break;
          if (cover.farthest < z || !q.relevant(cover.object)) continue;
          if (!emit_segments(q, cover.caster, 0, take)) return false;
        }
        for (std::uint32_t i = node.refs_begin; i != node.refs_end; ++i) {
          const CasterTree::Ref& ref = tree_.refs()[i];
          if (ref.nearest >= z) break;
          if (seen[ref.caster] == visit) continue;
          seen[ref.caster] = visit;
          const Caster& c = tree_.casters()[ref.caster];
          if (open_[ref.caster] == 0 && (!whole || farthest_depth(c) < z)) continue;
          if (!q.relevant(c.object) || !bounding_box(c).meets(box)) continue;
          if (!emit_segments(q, ref.caster, open_[ref.caster], take)) return false;
        }
        return true;
      });
}

bool BoundaryFinder::edge_within(const Query& q, double radius) const {
  for (double ring = first_radius(q);; ring *= 2) {
    ring = std::min(ring, radius);
    if (!visit_segments(q, ring, [](const Segment&) { return false; })) return true;
    if (ring >= radius) return false;
  }
}

double BoundaryFinder::first_radius(const Query& q) const {
  return std::ldexp(1.0, tree_.leaf_size(q.p.x, q.p.y));
}

double BoundaryFinder::distance(const Query& q, bool dark, double limit) const {
  // Rings grow until one holds an answer, so that a far limit costs nothing where shadows are near.
  double radius = first_radius(q);
  for (;; radius *= 2) {
    radius = std::min(radius, limit);
    const double found = dark ? dark_distance(q, radius) : lit_distance(q, radius);
    if (found < radius || radius >= limit) return found;
  }
}

/// From outside, every piece of an outline is as near as the shadow behind it, covered or not.
double BoundaryFinder::lit_distance(const Query& q, double radius) const {
  double best = radius;
  visit_segments(q, radius, [&best](const Segment& s) {
    best = std::min(best, s.distance);
    return best > 0;
  });
  return best;
}

double BoundaryFinder::dark_distance(const Query& q, double radius) const {
  thread_local std::vector<Segment> segments;
  segments.clear();
  visit_segments(q, radius, [](const Segment& s) {
    segments.push_back(s);
    return true;
  });
  auto key = [](const Segment& s) {
    return std::tie(s.distance, s.caster, s.a.x, s.a.y, s.b.x, s.b.y);
  };
  std::sort(segments.begin(), segments.end(),
            [key](const Segment& s, const Segment& t) { return key(s) < key(t); });
  double best = radius;
  for (std::size_t i = 0; i < segments.size() && segments[i].distance < best; ++i) {
    if (i > 0 && key(segments[i]) == key(segments[i - 1])) continue;
    best = std::min(best, uncovered_distance(q, segments[i], best));
  }
  return best;
}

/// Distance to the nearest point of a piece with nothing but light just outside it.
double BoundaryFinder::uncovered_distance(const Query& q, const Segment& s, double best) const {
  constexpr double kNowhere = std::numeric_limits<double>::infinity();
  Vector along{s.b.x - s.a.x, s.b.y - s.a.y};
  const double length = std::hypot(along.x, along.y);
  along =
      length > 0 ? Vector{along.x / length, along.y / length} : Vector{-s.outward.y, s.outward.x};
  auto distance_at = [&](double t) {
    if (t < 0 || t > length) return kNowhere;
    return std::hypot(s.a.x + along.x * t, s.a.y + along.y * t);
  };
  const double nearest = std::clamp(-(s.a.x * along.x + s.a.y * along.y), 0.0, length);
  double low = nearest, high = nearest;  // covered so far
  for (double at = nearest, distance = distance_at(at); distance < best;) {
    double from = at, to = at;
    if (!covering_interval(q, s, along, at, from, to)) return distance;
    low = std::min({low, at, from});
    high = std::max({high, at, to});
    const double left = distance_at(low - kStep), right = distance_at(high + kStep);
    at = left < right ? low - kStep : high + kStep;
    distance = std::min(left, right);
  }
  return best;
}

/// Finds a caster other than the piece's own that shadows the probe at `at`, and the interval of
/// the probe's line that it shadows.
bool BoundaryFinder::covering_interval(const Query& q, const Segment& s, Vector along, double at,
                                       double& low, double& high) const {
  const Vector origin{s.a.x + kOffset * s.outward.x, s.a.y + kOffset * s.outward.y};
  const std::int32_t x = clamped(std::floor(q.p.x + origin.x + along.x * at));
  const std::int32_t y = clamped(std::floor(q.p.y + origin.y + along.y * at));
  if (!tree_.contains(x, y)) return false;
  const double z = q.p.z;
  bool found = false;
  auto try_caster = [&](std::uint32_t nearest, std::uint32_t caster) {
    if (nearest >= q.p.z) return CasterTree::kSkipNode;
    const Caster& c = tree_.casters()[caster];
    if (caster == s.caster || !q.relevant(c.object)) return CasterTree::kNext;
    Linear weight[3];  // [i]: opposite vertex i
    const double sign = doubled_area(c) > 0 ? 1 : -1;
    Linear behind{0, 0};
    for (int i = 0; i < 3; ++i) {
      const LightPoint &a = c.vertex[(i + 1) % 3], &b = c.vertex[(i + 2) % 3];
      const double dx = sign * (double(b.x) - a.x), dy = sign * (double(b.y) - a.y);
      const double ox = origin.x + q.p.x - a.x, oy = origin.y + q.p.y - a.y;
      weight[i] = {dx * oy - dy * ox, dx * along.y - dy * along.x};
      if (weight[i](at) < 0) return CasterTree::kNext;
      behind.at_zero -= weight[i].at_zero * (c.vertex[i].z - z);
      behind.slope -= weight[i].slope * (c.vertex[i].z - z);
    }
    if (behind(at) <= 0) return CasterTree::kNext;
    low = -std::numeric_limits<double>::infinity();
    high = std::numeric_limits<double>::infinity();
    for (const Linear& w : weight) cut_interval(w, low, high);
    cut_interval(behind, low, high);
    found = true;
    return CasterTree::kStop;
  };
  tree_.visit_point(
      x, y, [&](const CasterTree::Cover& c) { return try_caster(c.nearest, c.caster); },
      [&](const CasterTree::Ref& r) { return try_caster(r.nearest, r.caster); });
  return found;
}

}  // namespace kagesen

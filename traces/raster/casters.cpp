#include "traces/raster/casters.h"

#include <algorithm>

#include "traces/raster/clip.h"

namespace kagesen {
namespace {

/// A vertex in clip coordinates and, where it lies in the frustum, on the grid.
struct LitVertex {
  glm::dvec4 clip;
  LightPoint point;
  std::uint8_t beyond;  ///< bit i: outside sides[i]; kBeyondNear: nearer than the near plane
};
constexpr std::uint8_t kBeyondNear = 16;
constexpr glm::dvec4 kNearSide{0, 0, 1, 0};
/// Keeps w above some millionths of the near plane's (z falls to about -near there).
constexpr glm::dvec4 kApexSide{0, 0, 1e-6, 1 - 1e-6};

class CasterMaker {
 public:
  CasterMaker(const LightSpace& space, CasterSet& out) : space_(space), grid_(space), out_(out) {}

  void add_object(const Object& object, std::uint32_t number, std::uint32_t first_polygon) {
    object_ = number;
    closed_ = object.closed;
    vertices_.clear();
    vertices_.reserve(object.positions.size());
    for (const glm::dvec3& p : object.positions) vertices_.push_back(lit(p));
    polygon_ = first_polygon;
    for (const auto& t : object.triangles) {
      add_triangle(vertices_[t[0]], vertices_[t[1]], vertices_[t[2]]);
      ++polygon_;
      out_.first.push_back(static_cast<std::uint32_t>(out_.casters.size()));
    }
  }

 private:
  LitVertex lit(const glm::dvec3& p) const {
    LitVertex v{space_.clip_from_world * glm::dvec4(p, 1), {}, 0};
    for (std::size_t i = 0; i < grid_.sides.size(); ++i) {
      if (!(glm::dot(grid_.sides[i], v.clip) >= 0)) v.beyond |= static_cast<std::uint8_t>(1u << i);
    }
    if (space_.perspective && !(v.clip.z >= 0)) v.beyond |= kBeyondNear;
    if (v.beyond == 0) v.point = grid_.snap(v.clip);
    return v;
  }

  void add_triangle(const LitVertex& a, const LitVertex& b, const LitVertex& c) {
    const std::uint8_t any = a.beyond | b.beyond | c.beyond;
    if (any == 0) {
      const LightPoint points[3] = {a.point, b.point, c.point};
      count(emit(points, 3));
      return;
    }
    if ((a.beyond & b.beyond & c.beyond & ~kBeyondNear) != 0) {
      ++out_.outside;
      return;
    }
    ClipPolygon polygon;
    for (const LitVertex* v : {&a, &b, &c}) polygon.push(v->clip);
    if (space_.perspective) polygon = clip(polygon, kApexSide);
    for (const glm::dvec4& side : grid_.sides) polygon = clip(polygon, side);
    if (polygon.count < 3) {
      ++out_.outside;
      return;
    }
    ++out_.clipped;
    Outcome outcome = Outcome::kNothing;
    if ((any & kBeyondNear) == 0) {
      outcome = emit(polygon);
    } else {
      // What lies before the near plane still casts: flattened onto it, it is nearer than all else.
      outcome = std::max(emit(clip(polygon, kNearSide)), emit(flattened(polygon)));
    }
    count(outcome);
  }

  ClipPolygon flattened(const ClipPolygon& polygon) const {
    ClipPolygon before = clip(polygon, -kNearSide);
    for (int i = 0; i < before.count; ++i) before.vertex[static_cast<std::size_t>(i)].z = 0;
    return before;
  }

  enum class Outcome { kNothing, kDegenerate, kCulled, kDrawn };

  Outcome emit(const ClipPolygon& polygon) {
    if (polygon.count < 3) return Outcome::kNothing;
    std::array<LightPoint, 16> points;
    for (int i = 0; i < polygon.count; ++i) {
      points[static_cast<std::size_t>(i)] = grid_.snap(polygon.vertex[static_cast<std::size_t>(i)]);
    }
    return emit(points.data(), polygon.count);
  }

  /// A fan. The side is decided by the whole outline: snapping may turn a thin piece of it round.
  Outcome emit(const LightPoint* points, int n) {
    std::int64_t sum = 0;
    bool any_area = false;
    for (int i = 2; i < n; ++i) {
      const std::int64_t area = doubled_area(points[0], points[i - 1], points[i]);
      sum += area;
      any_area = any_area || area != 0;
    }
    if (!any_area || (closed_ && sum == 0)) return Outcome::kDegenerate;
    if (closed_ && sum < 0) return Outcome::kCulled;
    for (int i = 2; i < n; ++i) {
      if (doubled_area(points[0], points[i - 1], points[i]) == 0) continue;
      out_.casters.push_back({{points[0], points[i - 1], points[i]}, object_, polygon_});
    }
    return Outcome::kDrawn;
  }

  void count(Outcome outcome) {
    if (outcome == Outcome::kDegenerate) ++out_.degenerate;
    if (outcome == Outcome::kCulled) ++out_.culled;
  }

  const LightSpace& space_;
  const UnitGrid grid_;
  CasterSet& out_;
  std::vector<LitVertex> vertices_;
  std::uint32_t object_ = 0, polygon_ = 0;
  bool closed_ = false;
};

}  // namespace

CasterSet make_casters(const Scene& scene, const LightSpace& space) {
  CasterSet set;
  set.first.reserve(scene.triangle_count() + 1);
  set.first.push_back(0);
  CasterMaker maker(space, set);
  for (std::uint32_t i = 0; i < scene.objects.size(); ++i) {
    const Object& object = scene.objects[i];
    if (object.caster) {
      maker.add_object(object, i, static_cast<std::uint32_t>(set.first.size() - 1));
    } else {
      set.first.insert(set.first.end(), object.triangles.size(),
                       static_cast<std::uint32_t>(set.casters.size()));
    }
  }
  return set;
}

}  // namespace kagesen

#pragma once
/// Exact predicates on a caster's snapped outline and plane.
///
/// Bounds: coordinates have kCoordinateBits = 28 bits, so a difference has 29, a product 57 and an
/// edge function 58, which int64 holds. A depth has at most 32 bits, so a depth sum has at most 93.
#include <algorithm>
#include <cstdint>

#include "traces/format/records.h"

namespace kagesen {

/// GCC's 128-bit integer, spelt so that -Wpedantic accepts it.
__extension__ typedef __int128 Int128;

/// Twice the signed areas that a point spans with the three edges; weight i is opposite vertex i.
/// They add up to twice the triangle's signed area. Exact.
struct Weights {
  std::int64_t w0 = 0, w1 = 0, w2 = 0;

  std::int64_t area() const { return w0 + w1 + w2; }
  /// The point lies inside or on the outline of a triangle that has an area.
  bool inside() const {
    const bool all_positive = (w0 | w1 | w2) >= 0;
    const bool all_negative = w0 <= 0 && w1 <= 0 && w2 <= 0;
    return (all_positive || all_negative) && area() != 0;
  }
};

/// (b - a) x (p - a), units squared. Exact.
inline std::int64_t edge_function(const LightPoint& a, const LightPoint& b, std::int64_t x,
                                  std::int64_t y) {
  return (std::int64_t{b.x} - a.x) * (y - a.y) - (std::int64_t{b.y} - a.y) * (x - a.x);
}

inline Weights weights_at(const Caster& c, std::int32_t x, std::int32_t y) {
  return {edge_function(c.vertex[1], c.vertex[2], x, y),
          edge_function(c.vertex[2], c.vertex[0], x, y),
          edge_function(c.vertex[0], c.vertex[1], x, y)};
}

/// Twice the signed area, units squared. Exact.
inline std::int64_t doubled_area(const Caster& c) {
  return edge_function(c.vertex[0], c.vertex[1], c.vertex[2].x, c.vertex[2].y);
}

inline std::uint32_t nearest_depth(const Caster& c) {
  return std::min({c.vertex[0].z, c.vertex[1].z, c.vertex[2].z});
}
inline std::uint32_t farthest_depth(const Caster& c) {
  return std::max({c.vertex[0].z, c.vertex[1].z, c.vertex[2].z});
}

/// Is the plane strictly nearer than z where the weights were taken? `w` must be inside. Exact.
inline bool plane_nearer(const Caster& c, const Weights& w, std::uint32_t z) {
  const Int128 sum = Int128{w.w0} * (std::int64_t{c.vertex[0].z} - z) +
                     Int128{w.w1} * (std::int64_t{c.vertex[1].z} - z) +
                     Int128{w.w2} * (std::int64_t{c.vertex[2].z} - z);
  return w.area() > 0 ? sum < 0 : sum > 0;
}

/// Depth of the plane, depth units; `w` must be inside. Error below 2^-20 for 24-bit depths.
inline double plane_depth(const Caster& c, const Weights& w) {
  const double sum =
      double(w.w0) * c.vertex[0].z + double(w.w1) * c.vertex[1].z + double(w.w2) * c.vertex[2].z;
  return sum / double(w.area());
}

/// Floor of the plane's depth; `w` must be inside. Exact.
inline std::uint32_t floor_depth(const Caster& c, const Weights& w) {
  // All terms have one sign, so the double is right to a few parts in 2^53; only near an integer
  // can its floor be wrong.
  constexpr double kMargin = 1.0 / (1 << 16);
  const double depth = plane_depth(c, w);
  const auto floor = std::uint32_t(depth);
  const double fraction = depth - floor;
  if (fraction > kMargin && fraction < 1 - kMargin) return floor;
  const Int128 sum =
      Int128{w.w0} * c.vertex[0].z + Int128{w.w1} * c.vertex[1].z + Int128{w.w2} * c.vertex[2].z;
  return std::uint32_t(sum / w.area());
}

/// Bounding box in light-space units, inclusive.
struct Box {
  std::int32_t x0 = 0, y0 = 0, x1 = 0, y1 = 0;
  bool meets(const Box& b) const { return x0 <= b.x1 && b.x0 <= x1 && y0 <= b.y1 && b.y0 <= y1; }
};

inline Box bounding_box(const Caster& c) {
  const LightPoint* v = c.vertex;
  return {std::min({v[0].x, v[1].x, v[2].x}), std::min({v[0].y, v[1].y, v[2].y}),
          std::max({v[0].x, v[1].x, v[2].x}), std::max({v[0].y, v[1].y, v[2].y})};
}

}  // namespace kagesen

#pragma once
/// Exact geometry of edges and facets for the measurements: rationals where the unit has ramps.
#include <algorithm>
#include <optional>
#include <utility>

#include "tests/stress/numerics/quantity.h"
#include "traces/format/records.h"

namespace kagesen::stress {

inline bool is_coordinate(std::int64_t v) { return v >= kCoordinateMin && v <= kCoordinateMax; }
inline bool is_depth(std::int64_t v) { return v >= 0 && v <= kDepthMax; }

/// The point that starts at `at` in the inputs: x, y, z.
inline std::optional<LightPoint> point_of(const Inputs& in, std::size_t at) {
  if (!is_coordinate(in[at]) || !is_coordinate(in[at + 1]) || !is_depth(in[at + 2])) return {};
  return LightPoint{static_cast<std::int32_t>(in[at]), static_cast<std::int32_t>(in[at + 1]),
                    static_cast<std::uint32_t>(in[at + 2])};
}
inline std::optional<Caster> caster_of(const Inputs& in) {
  Caster c;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto p = point_of(in, 3 * i);
    if (!p) return {};
    c.vertex[i] = *p;
  }
  return c;
}

/// floor(value) of a rational.
inline boost::multiprecision::cpp_int floor_of(const Exact& value) {
  using boost::multiprecision::cpp_int;
  const cpp_int n = numerator(value), d = denominator(value);
  const cpp_int q = n / d;
  return n % d < 0 ? q - 1 : q;
}

/// Depth of a facet's plane at a point, units; nothing for a facet without area.
inline std::optional<Exact> plane_at(const Caster& c, const Exact& x, const Exact& y) {
  const auto weight = [&](int i) -> Exact {
    const LightPoint &a = c.vertex[(i + 1) % 3], &b = c.vertex[(i + 2) % 3];
    return (Exact(b.x) - a.x) * (y - a.y) - (Exact(b.y) - a.y) * (x - a.x);
  };
  const Exact w[3] = {weight(0), weight(1), weight(2)};
  const Exact area = w[0] + w[1] + w[2];
  if (area == 0) return {};
  return Exact((w[0] * c.vertex[0].z + w[1] * c.vertex[1].z + w[2] * c.vertex[2].z) / area);
}

/// An end of a segment, units.
struct ExactPoint {
  Exact x, y;
};
/// The part of a segment in a closed box; nothing if they are apart.
std::optional<std::pair<ExactPoint, ExactPoint>> clip(const LightPoint& a, const LightPoint& b,
                                                      std::int64_t x, std::int64_t y,
                                                      std::int64_t side);

/// An edge of any length and direction: x0 y0 z0 x1 y1 z1.
Inputs draw_edge(Dice& dice);
/// A facet of any size: x y z of three vertices.
Inputs draw_facet(Dice& dice);

}  // namespace kagesen::stress

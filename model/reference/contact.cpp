#include "model/reference/contact.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "model/reference/triangle.h"

namespace kagesen {
namespace {

/// An edge as a vector: units, depth units. 29 bits each.
struct Edge {
  std::int64_t x, y, z;
  std::int64_t squared() const { return x * x + y * y; }  // 59 bits
  /// |dz/dx| + |dz/dy| of a plane that changes along the edge alone, a unit.
  double gradient() const {
    return double(std::abs(z)) * double(std::abs(x) + std::abs(y)) / double(squared());
  }
};

Edge between(const LightPoint& from, const LightPoint& to) {
  return {std::int64_t{to.x} - from.x, std::int64_t{to.y} - from.y, std::int64_t{to.z} - from.z};
}

/// |dz/dx| + |dz/dy| of the plane through both edges, a unit. Products of 54 bits: exact until the
/// division.
double plane_gradient(const Edge& a, const Edge& b) {
  const std::int64_t x = a.z * b.y - b.z * a.y, y = b.z * a.x - a.z * b.x;
  return (double(std::abs(x)) + double(std::abs(y))) / double(std::abs(a.x * b.y - a.y * b.x));
}

/// What a facet's stored plane leaves out: all of it where it is narrow.
struct Shape {
  double gradient = 0;  ///< |dz/dx| + |dz/dy| a unit
  double rise = 0;      ///< depth that the stored plane lies behind the facet because of that
};

/// Of a narrow facet whose longest edge is i to i + 1: the depth along that edge, raised to the
/// third vertex where that lies behind.
Shape along_edge(const Caster& facet, int i) {
  const Edge e = between(facet.vertex[i], facet.vertex[(i + 1) % 3]);
  const Edge third = between(facet.vertex[i], facet.vertex[(i + 2) % 3]);
  const double share = double(e.x * third.x + e.y * third.y) / double(e.squared());
  return {e.gradient(), std::abs(double(third.z) - double(e.z) * share)};
}

Shape shape_of(const Caster& facet, int radius_bits) {
  const Edge edges[3] = {between(facet.vertex[0], facet.vertex[1]),
                         between(facet.vertex[1], facet.vertex[2]),
                         between(facet.vertex[2], facet.vertex[0])};
  const std::int64_t longest =
      std::max({edges[0].squared(), edges[1].squared(), edges[2].squared()});
  // length <= r / 4 and area / length <= r / 4, both squared: 63 and 122 bits.
  const Int128 radius_squared = Int128{1} << (2 * radius_bits);
  if (Int128{16} * longest <= radius_squared) {
    return {0, double(farthest_depth(facet)) - double(nearest_depth(facet))};
  }
  const Int128 area = doubled_area(facet);
  if (16 * area * area > radius_squared * longest) return {plane_gradient(edges[0], edges[1]), 0};
  Shape most;
  for (int i = 0; i < 3; ++i) {
    if (edges[i].squared() < longest) continue;
    const Shape shape = along_edge(facet, i);
    most = {std::max(most.gradient, shape.gradient), std::max(most.rise, shape.rise)};
  }
  return most;
}

/// Inside or on the outline; where p lies on its texel's left or lower border, seen from within the
/// texel: what only touches the border there is no part of the texel.
bool covers_within_texel(const Caster& caster, const LightPoint& p, std::uint32_t fraction_bits) {
  const std::int32_t mask = (1 << fraction_bits) - 1;
  const bool on_left = (p.x & mask) == 0, on_lower = (p.y & mask) == 0;
  const std::int64_t turn = doubled_area(caster) > 0 ? 1 : -1;
  for (int i = 0; i < 3; ++i) {
    const LightPoint& a = caster.vertex[i];
    const Edge e = between(a, caster.vertex[(i + 1) % 3]);
    std::int64_t side = e.x * (std::int64_t{p.y} - a.y) - e.y * (std::int64_t{p.x} - a.x);
    if (side == 0 && on_lower) side = e.x;
    if (side == 0 && on_left) side = -e.y;
    if (turn * side < 0) return false;
  }
  return true;
}

}  // namespace

double contact_distance(const Caster& facet, const UnitConfig& config,
                        std::uint32_t fraction_bits) {
  const int radius_bits = static_cast<int>(fraction_bits) - static_cast<int>(config.fraction_bits);
  const Shape shape = shape_of(facet, radius_bits);
  const int mantissa =
      std::min<int>(10, static_cast<int>(std::max(config.gradient_bits, config.fraction_bits - 1)));
  const double share =
      std::ldexp(1, radius_bits) + std::ldexp(1, static_cast<int>(fraction_bits) - mantissa - 1);
  return 2 * double(config.plane_tolerance) +
         std::ldexp(2, static_cast<int>(config.plane_step_bits)) + 4 + shape.rise +
         shape.gradient * share;
}

bool clear_of_contact(const ExactReference& reference, const std::vector<Caster>& casters,
                      const Fragment& f, Semantics semantics, const UnitConfig& config,
                      std::uint32_t fraction_bits) {
  const LightPoint& p = f.position;
  std::vector<std::uint32_t> near;
  reference.casters_in(p.x, p.y, p.x, p.y, near);
  return std::any_of(near.begin(), near.end(), [&](std::uint32_t index) {
    const Caster& caster = casters[index];
    if (semantics == Semantics::kPaper && caster.object == f.object) return false;
    if (nearest_depth(caster) >= p.z || !covers_within_texel(caster, p, fraction_bits)) {
      return false;
    }
    return double(p.z) - plane_depth(caster, weights_at(caster, p.x, p.y)) >
           contact_distance(caster, config, fraction_bits);
  });
}

}  // namespace kagesen

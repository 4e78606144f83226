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

double gradient_a_unit(const Caster& facet, int radius_bits) {
  const Edge edges[3] = {between(facet.vertex[0], facet.vertex[1]),
                         between(facet.vertex[1], facet.vertex[2]),
                         between(facet.vertex[2], facet.vertex[0])};
  std::int64_t longest = 0;
  double along = 0;
  for (const Edge& e : edges) {
    if (e.squared() < longest) continue;
    along = e.squared() > longest ? e.gradient() : std::max(along, e.gradient());
    longest = e.squared();
  }
  // length <= r / 4 and area / length <= r / 4, both squared: 63 and 122 bits.
  const Int128 radius_squared = Int128{1} << (2 * radius_bits);
  if (Int128{16} * longest <= radius_squared) return 0;
  const Int128 area = doubled_area(facet);
  if (16 * area * area <= radius_squared * longest) return along;
  return plane_gradient(edges[0], edges[1]);
}

}  // namespace

double contact_gradient(const Caster& facet, const UnitConfig& config,
                        std::uint32_t fraction_bits) {
  const int bits = static_cast<int>(fraction_bits);
  const int radius_bits = bits - static_cast<int>(config.fraction_bits);
  return std::ldexp(gradient_a_unit(facet, radius_bits), bits);
}

double contact_distance(const Caster& facet, const UnitConfig& config,
                        std::uint32_t fraction_bits) {
  const int step_bits = static_cast<int>(config.plane_step_bits);
  const double reach = std::ldexp(contact_gradient(facet, config, fraction_bits),
                                  -static_cast<int>(config.fraction_bits));
  return 2 * double(config.plane_tolerance) + std::ldexp(2, step_bits) + 4 + 2 * reach;
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
    if (nearest_depth(caster) >= p.z) return false;
    const Weights weights = weights_at(caster, p.x, p.y);
    return weights.inside() && double(p.z) - plane_depth(caster, weights) >
                                   contact_distance(caster, config, fraction_bits);
  });
}

}  // namespace kagesen

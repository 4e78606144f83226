#include "model/facets.h"

#include <algorithm>
#include <array>
#include <cstdlib>

#include "model/caster_edges.h"
#include "model/reference/triangle.h"

namespace kagesen {
namespace {

constexpr int kGradientSteps = 8;  // log2 of steps a depth unit
constexpr std::uint32_t kNobody = 0xffffffffu;

/// By x, y, z: one form for all ways to write a triangle.
std::array<LightPoint, 3> canonical(const Caster& c) {
  std::array<LightPoint, 3> v{c.vertex[0], c.vertex[1], c.vertex[2]};
  std::sort(v.begin(), v.end(), point_less);
  return v;
}

/// Change of depth over r, 2^-kGradientSteps depth units.
struct Gradient {
  std::int64_t x = 0, y = 0;
  std::int64_t sum() const { return std::abs(x) + std::abs(y); }
};

/// @param radius_shift  log2 of r in units. The numerators have 55 bits, the quotients at most 37,
///                      as a caster that is not narrow is at least r / 4 wide.
Gradient gradient_of(const Caster& c, int radius_shift) {
  const LightPoint* v = c.vertex;
  const std::int64_t area = doubled_area(c);
  const std::int64_t x1 = v[1].x - v[0].x, y1 = v[1].y - v[0].y;
  const std::int64_t x2 = v[2].x - v[0].x, y2 = v[2].y - v[0].y;
  const std::int64_t z1 = std::int64_t{v[1].z} - v[0].z, z2 = std::int64_t{v[2].z} - v[0].z;
  const auto over_radius = [&](std::int64_t numerator) {
    const Int128 scaled = Int128{area < 0 ? -numerator : numerator} *
                          (std::int64_t{1} << (radius_shift + kGradientSteps));
    return std::int64_t(scaled / std::abs(area));
  };
  return {over_radius(z1 * y2 - z2 * y1), over_radius(z2 * x1 - z1 * x2)};
}

bool vertices_within(const Caster& c, const Caster& seed, std::int64_t tolerance) {
  for (const LightPoint& p : c.vertex) {
    const Weights w = weights_at(seed, p.x, p.y);
    const Int128 off = Int128{w.w0} * (std::int64_t{seed.vertex[0].z} - p.z) +
                       Int128{w.w1} * (std::int64_t{seed.vertex[1].z} - p.z) +
                       Int128{w.w2} * (std::int64_t{seed.vertex[2].z} - p.z);
    if ((off < 0 ? -off : off) > Int128{std::abs(w.area())} * tolerance) return false;
  }
  return true;
}

class Grouping {
 public:
  Grouping(const std::vector<Caster>& casters, std::uint32_t trace_fraction_bits,
           const UnitConfig& config)
      : casters_(casters),
        radius_shift_(int(trace_fraction_bits) - int(config.fraction_bits)),
        tolerance_(config.plane_tolerance) {
    std::vector<std::uint8_t> takes_part(casters.size());
    for (std::size_t i = 0; i < casters.size(); ++i) {
      takes_part[i] = !is_narrow(casters[i], trace_fraction_bits, int(config.fraction_bits));
    }
    out_.facets.resize(casters.size());
    find_neighbours(takes_part);
  }

  FacetGroups run() {
    for (const Seed& seed : seeds()) {
      if (out_.facets[seed.caster].plane == Facet::kOwnPlane) grow(seed.caster);
    }
    mark_inner_edges();
    return std::move(out_);
  }

 private:
  /// What seeds are ordered by, as far as it is worth keeping at hand: in a regular mesh all areas
  /// are equal, and two facets have their lowest vertex in common.
  struct Seed {
    std::int64_t area;
    LightPoint low, middle;  ///< first two vertices by x, y, z
    std::uint32_t caster;
  };

  std::uint32_t neighbour(std::size_t caster, std::size_t edge) const {
    return neighbours_[3 * caster + edge];
  }

  void find_neighbours(const std::vector<std::uint8_t>& takes_part) {
    const EdgeNumbers edges = number_edges(casters_, takes_part);
    // What an edge has on its sides: nobody, one 3 x caster + edge, or too many.
    constexpr std::uint32_t kTooMany = kNobody - 1;
    std::vector<std::array<std::uint32_t, 2>> sides(edges.count, {kNobody, kNobody});
    for (std::uint32_t i = 0; i < casters_.size(); ++i) {
      if (!takes_part[i]) continue;
      for (std::uint32_t k = 0; k < 3; ++k) {
        std::uint32_t& side = sides[edges.at(i, k)][lies_left_of_edge(casters_[i], k)];
        side = side == kNobody ? 3 * i + k : kTooMany;
      }
    }
    neighbours_.assign(casters_.size() * 3, kNobody);
    for (const auto& [right, left] : sides) {
      if (std::max(right, left) >= kTooMany) continue;
      neighbours_[right] = left / 3;
      neighbours_[left] = right / 3;
    }
  }

  /// Largest first. Only exact duplicates tie, and they share their edges, so none is here.
  std::vector<Seed> seeds() const {
    std::vector<Seed> out;
    for (std::uint32_t i = 0; i < casters_.size(); ++i) {
      const std::uint32_t* n = &neighbours_[std::size_t{i} * 3];
      if ((n[0] & n[1] & n[2]) == kNobody) continue;
      const auto v = canonical(casters_[i]);
      out.push_back({std::abs(doubled_area(casters_[i])), v[0], v[1], i});
    }
    std::sort(out.begin(), out.end(), [&](const Seed& a, const Seed& b) {
      if (a.area != b.area) return a.area > b.area;
      if (!same_point(a.low, b.low)) return point_less(a.low, b.low);
      if (!same_point(a.middle, b.middle)) return point_less(a.middle, b.middle);
      const Caster &ca = casters_[a.caster], &cb = casters_[b.caster];
      const LightPoint high_a = canonical(ca)[2], high_b = canonical(cb)[2];
      if (!same_point(high_a, high_b)) return point_less(high_a, high_b);
      return ca.object < cb.object;
    });
    return out;
  }

  bool fits(std::uint32_t caster, std::uint32_t seed, const Gradient& seed_gradient) const {
    if (!vertices_within(casters_[caster], casters_[seed], tolerance_)) return false;
    const Gradient g = gradient_of(casters_[caster], radius_shift_);
    const Gradient apart{g.x - seed_gradient.x, g.y - seed_gradient.y};
    return apart.sum() <= tolerance_ << kGradientSteps &&
           seed_gradient.sum() <= g.sum() + (1 << kGradientSteps) / 4;
  }

  /// Takes all free casters that the seed reaches. A seed that finds none stays free itself.
  void grow(std::uint32_t seed) {
    const Gradient gradient = gradient_of(casters_[seed], radius_shift_);
    const auto plane = std::uint32_t(out_.planes.size());
    out_.facets[seed].plane = plane;
    members_.assign(1, seed);
    for (std::size_t at = 0; at < members_.size(); ++at) {
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t next = neighbour(members_[at], k);
        if (next == kNobody || out_.facets[next].plane != Facet::kOwnPlane) continue;
        if (!fits(next, seed, gradient)) continue;
        out_.facets[next].plane = plane;
        members_.push_back(next);
      }
    }
    if (members_.size() == 1) {
      out_.facets[seed].plane = Facet::kOwnPlane;
      return;
    }
    Caster shared = casters_[seed];
    const auto vertices = canonical(shared);
    std::copy(vertices.begin(), vertices.end(), shared.vertex);
    out_.planes.push_back(shared);
  }

  void mark_inner_edges() {
    for (std::size_t i = 0; i < casters_.size(); ++i) {
      Facet& facet = out_.facets[i];
      if (facet.plane == Facet::kOwnPlane) continue;
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t other = neighbour(i, k);
        if (other == kNobody || out_.facets[other].plane != facet.plane) continue;
        facet.inner_edges |= std::uint8_t(1u << k);
      }
    }
  }

  const std::vector<Caster>& casters_;
  const int radius_shift_;  ///< log2 of r, units
  const std::int64_t tolerance_;
  std::vector<std::uint32_t> neighbours_;  ///< [3 x caster + edge]: a caster or kNobody
  std::vector<std::uint32_t> members_;     ///< of the group that grows
  FacetGroups out_;
};

}  // namespace

bool is_narrow(const Caster& caster, std::uint32_t trace_fraction_bits, int radius_bits) {
  const std::int64_t area = std::abs(doubled_area(caster));  // at most 58 bits
  std::int64_t longest = 0;                                  // squared
  for (int i = 0; i < 3; ++i) {
    const LightPoint &a = caster.vertex[i], &b = caster.vertex[(i + 1) % 3];
    const std::int64_t dx = std::int64_t{b.x} - a.x, dy = std::int64_t{b.y} - a.y;
    longest = std::max(longest, dx * dx + dy * dy);
  }
  // The height is at most the longest edge, so one test does for both. height <= r / 4 iff 4 x
  // doubled area <= longest edge x r; squared: at most 120 and 107 bits.
  const Int128 scaled = Int128{4 * area};
  const int shift = 2 * (int(trace_fraction_bits) - radius_bits);
  return scaled * scaled <= Int128{longest} * (Int128{1} << shift);
}

FacetGroups group_facets(const std::vector<Caster>& casters, std::uint32_t trace_fraction_bits,
                         const UnitConfig& config) {
  return Grouping(casters, trace_fraction_bits, config).run();
}

}  // namespace kagesen

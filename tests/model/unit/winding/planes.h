#pragma once
/// Random facets of every kind, their planes and the documented bias, in exact rationals.
#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <random>
#include <string>

#include "model/reference/triangle.h"
#include "model/unit/winding/plane.h"

namespace kagesen::unit::winding {

using Rational = boost::multiprecision::cpp_rational;

struct Point {
  Rational x, y;
};
struct Plane {
  Rational x, y, z, gradient_x, gradient_y;
  Rational at(const Point& p) const { return z + gradient_x * (p.x - x) + gradient_y * (p.y - y); }
  /// Depth per texel, |dz/dx| + |dz/dy|.
  Rational steepness(int texel_bits) const {
    return (abs(gradient_x) + abs(gradient_y)) * (std::int64_t{1} << texel_bits);
  }
};

inline Plane plane_of(const Caster& c) {
  const LightPoint* v = c.vertex;
  const Rational ax = v[1].x - v[0].x, ay = v[1].y - v[0].y, bx = v[2].x - v[0].x,
                 by = v[2].y - v[0].y;
  const Rational az = std::int64_t{v[1].z} - v[0].z, bz = std::int64_t{v[2].z} - v[0].z;
  const Rational area = ax * by - ay * bx;
  return {v[0].x, v[0].y, v[0].z, (az * by - bz * ay) / area, (ax * bz - bx * az) / area};
}

/// B of docs/unit.md: how much farther than its facet a threshold may be.
inline Rational documented_bias(const Caster& c, const UnitConfig& config, int texel_bits) {
  const auto fraction_bits = int(config.fraction_bits);
  const int m =
      int(std::min<std::int64_t>(10, std::max(config.gradient_bits, config.fraction_bits - 1)));
  const Rational r(1, std::int64_t{1} << fraction_bits);
  // The outline's two steps and the place's one: three quarters of r with the default guard bits.
  const int end_bits = std::min(fraction_bits + int(config.end_guard_bits), texel_bits);
  const Rational three_steps(3, std::int64_t{1} << end_bits);
  const Rational slack = std::max(r, three_steps) + Rational(1, std::int64_t{2} << m);
  Rational bias = 2 * config.plane_tolerance + (std::int64_t{2} << config.plane_step_bits) + 8;
  int longest = 0;
  const auto squared = [&](int i) {
    const LightPoint &a = c.vertex[i], &b = c.vertex[(i + 1) % 3];
    const Rational x = b.x - a.x, y = b.y - a.y;
    return Rational(x * x + y * y);
  };
  for (int i = 1; i < 3; ++i) {
    if (squared(i) > squared(longest)) longest = i;
  }
  const Rational units = std::int64_t{1} << texel_bits;
  const Rational quarter = units * r / 4;
  if (squared(longest) <= quarter * quarter) {
    return bias + (farthest_depth(c) - nearest_depth(c));
  }
  const Rational area = doubled_area(c);
  if (area * area > squared(longest) * quarter * quarter) {
    return bias + plane_of(c).steepness(texel_bits) * slack;
  }
  const LightPoint &a = c.vertex[longest], &b = c.vertex[(longest + 1) % 3];
  const LightPoint& third = c.vertex[(longest + 2) % 3];
  const Rational rise = Rational(std::int64_t{b.z} - a.z) / squared(longest);
  const Plane along{a.x, a.y, a.z, rise * (b.x - a.x), rise * (b.y - a.y)};
  const Rational off = third.z - along.at({third.x, third.y});
  return bias + abs(off) + along.steepness(texel_bits) * slack;
}

enum class Kind { kOrdinary, kSliver, kTiny, kSteep, kSteepest };
inline constexpr Kind kKinds[] = {Kind::kOrdinary, Kind::kSliver, Kind::kTiny, Kind::kSteep,
                                  Kind::kSteepest};

class Facets {
 public:
  Facets(const UnitConfig& config, int texel_bits, unsigned seed)
      : radius_(std::max<std::int64_t>(1, std::int64_t{1} << (texel_bits - config.fraction_bits))),
        texel_(std::int64_t{1} << texel_bits),
        random_(seed) {}

  std::int64_t in(std::int64_t low, std::int64_t high) {
    return low + std::int64_t(random_() % std::uint64_t(high - low + 1));
  }
  std::uint32_t depth() { return std::uint32_t(in(0, kDepthMax)); }

  Caster next(Kind kind) {
    for (;;) {
      const Caster c = attempt(kind);
      bool fits = doubled_area(c) != 0;
      for (const LightPoint& p : c.vertex) {
        fits = fits && std::abs(std::int64_t{p.x}) < kCoordinateMax &&
               std::abs(std::int64_t{p.y}) < kCoordinateMax;
      }
      if (fits) return c;
    }
  }

 private:
  Caster attempt(Kind kind) {
    const std::int64_t far = kCoordinateMax / 2;
    const std::int64_t x = in(-far, far) >> in(0, 12), y = in(-far, far) >> in(0, 12);
    const auto place = [&](std::int64_t dx, std::int64_t dy, std::uint32_t z) {
      return LightPoint{
          std::int32_t(std::clamp<std::int64_t>(x + dx, kCoordinateMin, kCoordinateMax)),
          std::int32_t(std::clamp<std::int64_t>(y + dy, kCoordinateMin, kCoordinateMax)), z};
    };
    const auto any = [&](std::int64_t size) {
      return place(in(-size, size), in(-size, size), depth());
    };
    switch (kind) {
      case Kind::kOrdinary: {
        const std::int64_t size =
            std::max<std::int64_t>(2, std::min<std::int64_t>(8 * texel_, far / 2) >> in(0, 12));
        Caster c{{any(size), any(size), any(size)}, 0, 0};
        const std::uint32_t range = 1u << in(0, 24);
        for (LightPoint& p : c.vertex) p.z = c.vertex[0].z / 2 + p.z % range / 2;
        return c;
      }
      case Kind::kTiny: {
        const std::int64_t size = std::max<std::int64_t>(1, radius_ / 8);
        return {{any(size), any(size), any(size)}, 0, 0};
      }
      default: {
        // Long by `length`, high by `height` in any direction; the depth is all in the height, or
        // anywhere.
        const std::int64_t length =
            std::max<std::int64_t>(2, std::min<std::int64_t>(4 * texel_, far / 2) >> in(0, 14));
        const std::int64_t dx = in(-length, length), dy = in(-length, length);
        const double from = kind == Kind::kSliver ? 0.05 : kind == Kind::kSteep ? 2 : 0.2501;
        const double height = from * (1 + double(in(0, 1000)) / 4000) * double(radius_) + 1;
        const double unit = height / std::max(1.0, std::hypot(double(dx), double(dy)));
        const LightPoint a = place(0, 0, depth()), b = place(dx, dy, depth());
        const LightPoint third = place(dx / 2 + std::llround(double(-dy) * unit),
                                       dy / 2 + std::llround(double(dx) * unit), depth());
        Caster c{{a, b, third}, 0, 0};
        if (kind == Kind::kSteepest) {
          c.vertex[0].z = c.vertex[1].z = in(0, 1) ? 0 : kDepthMax;
          c.vertex[2].z = kDepthMax - c.vertex[0].z;
        }
        return c;
      }
    }
  }

  std::int64_t radius_, texel_;
  std::mt19937_64 random_;
};

inline std::string text(const Caster& c) {
  std::string out;
  for (const LightPoint& v : c.vertex) {
    out += "(" + std::to_string(v.x) + "," + std::to_string(v.y) + "," + std::to_string(v.z) + ")";
  }
  return out;
}

/// A point of the facet and the units round it that a stored outline may reach.
struct Probe {
  Point of_facet;
  std::int64_t x, y;
};
inline Probe probe(const Caster& c, Facets& random, std::int64_t reach) {
  std::int64_t w[3] = {random.in(0, 1000), random.in(0, 1000), random.in(0, 1000)};
  if (random.in(0, 2) == 0) w[random.in(0, 2)] = 0;  // on an edge, or at a vertex
  if (random.in(0, 2) == 0) w[random.in(0, 2)] = 0;
  if (w[0] + w[1] + w[2] == 0) w[0] = 1;
  const Rational sum = w[0] + w[1] + w[2];
  Probe out;
  for (int i = 0; i < 3; ++i) {
    out.of_facet.x += w[i] / sum * c.vertex[i].x;
    out.of_facet.y += w[i] / sum * c.vertex[i].y;
  }
  const auto beside = [&](const Rational& at) {
    const std::int64_t low = -std::int64_t(-numerator(at) / denominator(at));
    std::int64_t p = low + random.in(-reach - 1, reach + 1);
    while (abs(Rational(p) - at) > reach) p += Rational(p) < at ? 1 : -1;
    return std::clamp<std::int64_t>(p, kCoordinateMin, kCoordinateMax);
  };
  out.x = beside(out.of_facet.x);
  out.y = beside(out.of_facet.y);
  return out;
}

inline std::int64_t threshold_at(const FacetPlane& plane, const Probe& p, const Widths& w) {
  const std::int64_t mask = (std::int64_t{1} << w.texel_bits) - 1;
  const int shift = w.texel_bits - w.end_bits;
  const Threshold t =
      plane.in(std::int32_t(p.x >> w.texel_bits), std::int32_t(p.y >> w.texel_bits));
  return ThresholdPlane(t, w).at((p.x & mask) >> shift, (p.y & mask) >> shift, w);
}

struct Shape {
  int texel_bits, fraction_bits, guard_bits, gradient_bits, step_bits, tolerance;
};
inline void PrintTo(const Shape& s, std::ostream* out) {
  *out << s.texel_bits << " F " << s.fraction_bits << " guard " << s.guard_bits << " gradient "
       << s.gradient_bits << " step " << s.step_bits << " tolerance " << s.tolerance;
}
inline UnitConfig config_of(const Shape& s) {
  UnitConfig c;
  c.fraction_bits = s.fraction_bits;
  c.end_guard_bits = s.guard_bits;
  c.gradient_bits = s.gradient_bits;
  c.plane_step_bits = s.step_bits;
  c.plane_tolerance = s.tolerance;
  return c;
}

}  // namespace kagesen::unit::winding

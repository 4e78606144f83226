// Stored thresholds against the facets' planes, in exact rationals.
#include "model/unit/winding/plane.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <random>
#include <string>

#include "model/facets.h"
#include "model/reference/triangle.h"

namespace kagesen::unit::winding {
namespace {

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

Plane plane_of(const Caster& c) {
  const LightPoint* v = c.vertex;
  const Rational ax = v[1].x - v[0].x, ay = v[1].y - v[0].y, bx = v[2].x - v[0].x,
                 by = v[2].y - v[0].y;
  const Rational az = std::int64_t{v[1].z} - v[0].z, bz = std::int64_t{v[2].z} - v[0].z;
  const Rational area = ax * by - ay * bx;
  return {v[0].x, v[0].y, v[0].z, (az * by - bz * ay) / area, (ax * bz - bx * az) / area};
}

/// B of docs/unit.md: how much farther than its facet a threshold may be.
Rational documented_bias(const Caster& c, const UnitConfig& config, int texel_bits) {
  const auto fraction_bits = int(config.fraction_bits);
  const int m =
      int(std::min<std::int64_t>(10, std::max(config.gradient_bits, config.fraction_bits - 1)));
  const Rational r(1, std::int64_t{1} << fraction_bits);
  const Rational slack = r + Rational(1, std::int64_t{2} << m);
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
constexpr Kind kKinds[] = {Kind::kOrdinary, Kind::kSliver, Kind::kTiny, Kind::kSteep,
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

std::string text(const Caster& c) {
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
Probe probe(const Caster& c, Facets& random, std::int64_t reach) {
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

std::int64_t threshold_at(const FacetPlane& plane, const Probe& p, const Widths& w) {
  const std::int64_t mask = (std::int64_t{1} << w.texel_bits) - 1;
  const int shift = w.texel_bits - w.end_bits;
  const Threshold t =
      plane.in(std::int32_t(p.x >> w.texel_bits), std::int32_t(p.y >> w.texel_bits));
  return ThresholdPlane(t, w).at((p.x & mask) >> shift, (p.y & mask) >> shift, w);
}

struct Shape {
  int texel_bits, fraction_bits, guard_bits, gradient_bits, step_bits, tolerance;
};
void PrintTo(const Shape& s, std::ostream* out) {
  *out << s.texel_bits << " F " << s.fraction_bits << " guard " << s.guard_bits << " gradient "
       << s.gradient_bits << " step " << s.step_bits << " tolerance " << s.tolerance;
}
UnitConfig config_of(const Shape& s) {
  UnitConfig c;
  c.fraction_bits = s.fraction_bits;
  c.end_guard_bits = s.guard_bits;
  c.gradient_bits = s.gradient_bits;
  c.plane_step_bits = s.step_bits;
  c.plane_tolerance = s.tolerance;
  return c;
}

class WindingPlane : public testing::TestWithParam<Shape> {};

/// The threshold is never nearer than the facet, at and a step round it; and within the facet no
/// farther than the documented bias.
TEST_P(WindingPlane, ThresholdsLieBetweenTheFacetAndItsBias) {
  const Shape shape = GetParam();
  const UnitConfig config = config_of(shape);
  const Widths w(config, shape.texel_bits);
  for (const Kind kind : kKinds) {
    Facets random(config, shape.texel_bits, 17 + unsigned(kind));
    for (int run = 0; run < 400; ++run) {
      const Caster c = random.next(kind);
      const FacetPlane stored(c, nullptr, w);
      const Plane exact = plane_of(c);
      const Rational bias = documented_bias(c, config, shape.texel_bits);
      for (int i = 0; i < 12; ++i) {
        const Probe p = probe(c, random, std::int64_t{1} << (w.texel_bits - w.end_bits));
        const std::int64_t threshold = threshold_at(stored, p, w);
        ASSERT_GE(threshold, exact.at(p.of_facet)) << text(c) << " at " << p.x << ',' << p.y;
        if (!weights_at(c, std::int32_t(p.x), std::int32_t(p.y)).inside()) continue;
        ASSERT_LE(threshold, exact.at({p.x, p.y}) + bias)
            << text(c) << " at " << p.x << ',' << p.y << ", kind " << int(kind);
      }
    }
  }
}

/// Members of a group: their vertices lie within the tolerance of the seed's plane.
TEST_P(WindingPlane, SharedThresholdsAreNeverNearerThanAnyMember) {
  const Shape shape = GetParam();
  const UnitConfig config = config_of(shape);
  const Widths w(config, shape.texel_bits);
  Facets random(config, shape.texel_bits, 5);
  int members = 0;
  for (int run = 0; run < 3000; ++run) {
    const Caster seed = random.next(Kind::kOrdinary);
    if (is_narrow(seed, std::uint32_t(shape.texel_bits), shape.fraction_bits)) continue;
    Caster member = seed;
    const Plane plane = plane_of(seed);
    const std::int64_t size = std::int64_t{1} << random.in(2, shape.texel_bits);
    bool fits = true;
    for (LightPoint& p : member.vertex) {
      p.x = std::int32_t(
          std::clamp<std::int64_t>(p.x + random.in(-size, size), kCoordinateMin, kCoordinateMax));
      p.y = std::int32_t(
          std::clamp<std::int64_t>(p.y + random.in(-size, size), kCoordinateMin, kCoordinateMax));
      const Rational z = plane.at({p.x, p.y});
      if (z < shape.tolerance || z > kDepthMax - shape.tolerance) {
        fits = false;
        break;
      }
      const auto floor = std::int64_t(numerator(z) / denominator(z));
      p.z = std::uint32_t(floor + (random.in(0, 1) ? shape.tolerance : 1 - shape.tolerance));
      if (shape.tolerance == 0) p.z = std::uint32_t(floor);
      fits = fits && abs(Rational(p.z) - z) <= shape.tolerance;
    }
    if (!fits || doubled_area(member) == 0) continue;
    ++members;
    const FacetPlane stored(member, &seed, w);
    const Plane exact = plane_of(member);
    for (int i = 0; i < 8; ++i) {
      const Probe p = probe(member, random, std::int64_t{1} << (w.texel_bits - w.end_bits));
      ASSERT_GE(threshold_at(stored, p, w), exact.at(p.of_facet)) << text(seed) << text(member);
    }
  }
  EXPECT_TRUE(members > 100 || shape.tolerance == 0) << members;
}

TEST_P(WindingPlane, ARampIsThePlaneTexelByTexel) {
  const Shape shape = GetParam();
  const UnitConfig config = config_of(shape);
  const Widths w(config, shape.texel_bits);
  Facets random(config, shape.texel_bits, 99);
  for (int run = 0; run < 200; ++run) {
    const FacetPlane plane(random.next(kKinds[run % 5]), nullptr, w);
    const auto x = std::int32_t(random.in(-60, 60)), y = std::int32_t(random.in(-60, 60));
    ExactRamp ramp = plane.ramp(x, y);
    for (int i = 0; i < 20; ++i, ramp.advance()) ASSERT_EQ(plane.at(ramp), plane.in(x + i, y));
  }
}

/// No place of a texel is nearer or farther than its bounds say, where the facet is.
TEST_P(WindingPlane, BoundsHoldRoundTheFacet) {
  const Shape shape = GetParam();
  const UnitConfig config = config_of(shape);
  const Widths w(config, shape.texel_bits);
  for (const Kind kind : kKinds) {
    Facets random(config, shape.texel_bits, 31 + unsigned(kind));
    for (int run = 0; run < 200; ++run) {
      const Caster c = random.next(kind);
      const FacetPlane stored(c, nullptr, w);
      for (int i = 0; i < 8; ++i) {
        const Probe p = probe(c, random, std::int64_t{1} << (w.texel_bits - w.end_bits));
        const ThresholdPlane plane(
            stored.in(std::int32_t(p.x >> w.texel_bits), std::int32_t(p.y >> w.texel_bits)), w);
        const std::int64_t at = threshold_at(stored, p, w);
        ASSERT_LE(plane.nearest(), at) << text(c);
        ASSERT_GE(plane.farthest(), at) << text(c);
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Shapes, WindingPlane,
                         testing::Values(Shape{16, 8, 2, 7, 4, 16}, Shape{20, 8, 2, 7, 4, 16},
                                         Shape{26, 8, 2, 7, 4, 16}, Shape{16, 4, 2, 3, 0, 0},
                                         Shape{16, 8, 2, 3, 12, 4000}, Shape{22, 8, 4, 10, 2, 1},
                                         Shape{16, 1, 2, 7, 4, 16}, Shape{16, 12, 2, 7, 4, 16},
                                         Shape{16, 14, 2, 7, 0, 16}, Shape{20, 13, 3, 7, 4, 16},
                                         Shape{26, 15, 4, 10, 4, 16}, Shape{16, 15, 2, 7, 4, 16},
                                         Shape{16, 8, 1, 7, 4, 16}, Shape{16, 8, 3, 7, 4, 16}));

TEST(WindingPlaneBounds, HoldOverEveryPlaceOfASmallTexel) {
  std::mt19937 random(4);
  for (int run = 0; run < 20000; ++run) {
    Widths w;
    w.end_bits = 1 + run % 5;
    w.step_bits = run % 7;
    w.gradient_bits = 3 + run % 8;
    Threshold t;
    t.base = std::int32_t(random() % (1u << 24)) >> w.step_bits;
    const std::uint32_t codes = 1u << w.gradient_code_bits();
    t.gradient_x = std::uint16_t(random() % codes);
    t.gradient_y = std::uint16_t(random() % codes);
    const ThresholdPlane plane(t, w);
    if (plane.steep()) {
      ASSERT_EQ(plane.nearest(), -ThresholdPlane::kUnbounded);
      ASSERT_EQ(plane.farthest(), ThresholdPlane::kUnbounded);
      continue;
    }
    for (int y = 0; y < 1 << w.end_bits; ++y) {
      for (int x = 0; x < 1 << w.end_bits; ++x) {
        ASSERT_LE(plane.nearest(), plane.at(x, y, w));
        ASSERT_GE(plane.farthest(), plane.at(x, y, w));
      }
    }
  }
}

TEST(WindingGradient, EveryCodeComesBackAndEveryValueFindsTheNearest) {
  std::mt19937_64 random(6);
  for (int gradient_bits = 3; gradient_bits <= 10; ++gradient_bits) {
    for (int step_bits = 0; step_bits <= 12; ++step_bits) {
      Widths w;
      w.gradient_bits = gradient_bits;
      w.step_bits = step_bits;
      const int sizes = 1 << (w.gradient_code_bits() - 1);
      for (int size = 0; size < sizes; ++size) {
        const std::int64_t value = decode_gradient(std::uint16_t(size), w);
        ASSERT_EQ(encode_gradient(value, w), size);
        if (size == 0) continue;
        const auto negative = std::uint16_t(size | sizes);
        ASSERT_EQ(decode_gradient(negative, w), -value);
        ASSERT_EQ(encode_gradient(-value, w), negative);
        // A value between this one and the one before takes the nearer; ties either.
        const std::int64_t before = decode_gradient(std::uint16_t(size - 1), w);
        ASSERT_LT(before, value);
        const std::int64_t gap = value - before;
        for (const std::int64_t between : {before + 1, before + gap / 2, value - 1,
                                           before + std::int64_t(random() % std::uint64_t(gap))}) {
          const std::int64_t got = decode_gradient(encode_gradient(between, w), w);
          ASSERT_LE(2 * std::abs(got - between), gap) << between;
          const std::int64_t other = decode_gradient(encode_gradient(-between, w), w);
          ASSERT_EQ(other, -got);
        }
      }
      const std::int64_t largest = decode_gradient(std::uint16_t(sizes - 1), w);
      ASSERT_EQ(encode_gradient(largest + largest, w), sizes - 1) << "saturates";
    }
  }
}

}  // namespace
}  // namespace kagesen::unit::winding

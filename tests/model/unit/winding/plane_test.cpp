// Stored thresholds against the facets' planes, in exact rationals.
#include "model/unit/winding/plane.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "model/facets.h"
#include "tests/model/unit/winding/planes.h"

namespace kagesen::unit::winding {
namespace {

class WindingPlane : public testing::TestWithParam<Shape> {};

/// The threshold is never nearer than the facet, at and a step round it; and within the facet no
/// farther than the documented bias.
TEST_P(WindingPlane, ThresholdsLieBetweenTheFacetAndItsBias) {
  const Shape shape = GetParam();
  const UnitConfig config = config_of(shape);
  const Widths w(config, shape.texel_bits);
  for (const Kind kind : kKinds) {
    Facets random(config, shape.texel_bits, 17 + unsigned(kind));
    for (int run = 0; run < 200; ++run) {
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

/// Two neighbours that the host groups: a small one beside the seed, off its plane by as much as
/// may be.
TEST_P(WindingPlane, GroupedThresholdsKeepWithinTheBiasOfEveryMember) {
  const Shape shape = GetParam();
  const UnitConfig config = config_of(shape);
  const Widths w(config, shape.texel_bits);
  Facets random(config, shape.texel_bits, 8);
  const std::int64_t r =
      std::max<std::int64_t>(1, std::int64_t{1} << (shape.texel_bits - shape.fraction_bits));
  for (int run = 0; run < 3000; ++run) {
    const std::int64_t length = random.in(1, 8) * 4 * r, width = random.in(1, 24) * r / 8 + 1;
    const std::int64_t slope = random.in(-2, 4) * shape.tolerance / 2;  // over r
    const std::int64_t level = 1 << 23;
    const auto at = [&](std::int64_t x, std::int64_t y, std::int64_t off) {
      const std::int64_t z = level + slope * x / r + off;
      return LightPoint{std::int32_t(x + 5 * r), std::int32_t(y + 3 * r),
                        std::uint32_t(std::clamp<std::int64_t>(z, 0, kDepthMax))};
    };
    const LightPoint a = at(0, 0, 0), b = at(0, length, 0);
    const std::vector<Caster> casters = {
        {{a, b, at(-4 * width - r, length / 2, 0)}, 0, 0},
        {{a, b,
          at(width, random.in(0, length),
             random.in(0, 1) ? -shape.tolerance : random.in(-shape.tolerance, shape.tolerance))},
         0,
         1}};
    const FacetGroups groups = group_facets(casters, std::uint32_t(shape.texel_bits), config);
    for (std::size_t i = 0; i < 2; ++i) {
      if (groups.facets[i].plane == Facet::kOwnPlane) continue;
      const FacetPlane stored(casters[i], &groups.planes[groups.facets[i].plane], w);
      const Plane exact = plane_of(casters[i]);
      // The seed may be twice as steep as its member.
      const Rational bias = std::max(
          documented_bias(casters[i], config, shape.texel_bits),
          documented_bias(groups.planes[groups.facets[i].plane], config, shape.texel_bits));
      for (int n = 0; n < 6; ++n) {
        Probe p = probe(casters[i], random, std::int64_t{1} << (w.texel_bits - w.end_bits));
        if (n == 0) {  // the vertex that is off
          const LightPoint& v = casters[i].vertex[2];
          p = {{v.x, v.y}, v.x, v.y};
        }
        ASSERT_GE(threshold_at(stored, p, w), exact.at(p.of_facet));
        if (!weights_at(casters[i], std::int32_t(p.x), std::int32_t(p.y)).inside()) continue;
        const Rational off = threshold_at(stored, p, w) - exact.at({p.x, p.y});
        ASSERT_LE(off, bias) << text(casters[0]) << text(casters[1]) << " at " << p.x << ',' << p.y
                             << ", by " << double(off - bias) << " of " << double(bias);
      }
    }
  }
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
                                         Shape{16, 8, 1, 7, 4, 16}, Shape{16, 8, 1, 10, 0, 0},
                                         Shape{16, 8, 2, 7, 0, 4000}, Shape{20, 8, 2, 3, 0, 1000},
                                         Shape{16, 8, 3, 7, 4, 16}));

/// Two sides equally long, each of which could give the depth.
TEST(WindingPlaneBounds, OfANarrowFacetDoNotDependOnItsVerticesOrder) {
  UnitConfig config;
  config.fraction_bits = 12;
  const Widths w(config, 16);
  Caster c{{{458753, -458752, 0}, {458752, -589824, 0}, {458751, -458752, 9437184}}, 0, 0};
  const auto later = [](const LightPoint& a, const LightPoint& b) {
    return a.x != b.x ? a.x < b.x : a.y < b.y;
  };
  std::sort(c.vertex, c.vertex + 3, later);
  const Threshold first = FacetPlane(c, nullptr, w).in(6, -8);
  while (std::next_permutation(c.vertex, c.vertex + 3, later)) {
    ASSERT_TRUE(FacetPlane(c, nullptr, w).in(6, -8) == first);
  }
}

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

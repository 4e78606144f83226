// The contact distance on facets whose gradient is known by hand, and who is clear of it.
#include "model/reference/contact.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

namespace kagesen {
namespace {

constexpr std::uint32_t kBits = 16;
constexpr std::int32_t kT = 1 << kBits;  // units a texel
constexpr double kLevel = 2 * 16 + 2 * 16 + 4;

/// r = 256 units, r / 4 = 64 units; the contact distance of a level facet is kLevel.
UnitConfig defaults() {
  UnitConfig config;
  config.fraction_bits = 8;
  config.plane_tolerance = 16;
  config.plane_step_bits = 4;
  return config;
}

double distance(const Caster& c) { return contact_distance(c, defaults(), kBits); }

Caster level(std::uint32_t z, std::uint32_t object) {
  return {{{-10 * kT, -10 * kT, z}, {10 * kT, -10 * kT, z}, {0, 10 * kT, z}}, object, 0};
}

/// Rises by 64,000 a texel from `z` at the origin.
Caster steep(std::uint32_t z, std::uint32_t object) {
  const std::uint32_t low = z - 64'000, high = z + 64'000;
  return {{{-kT, -kT, low}, {kT, -kT, high}, {0, kT, z}}, object, 1};
}

Fragment at_origin(std::uint32_t z, std::uint32_t object) {
  Fragment f;
  f.position = {0, 0, z};
  f.object = object;
  return f;
}

bool clear(const std::vector<Caster>& casters, const Fragment& f, Semantics semantics) {
  const ExactReference reference(casters);
  return clear_of_contact(reference, casters, f, semantics, defaults(), kBits);
}

TEST(Contact, GradientIsATexel) {
  const Caster c{{{0, 0, 5000}, {4 * kT, 0, 5400}, {0, 2 * kT, 4920}}, 0, 0};  // +100, -40
  EXPECT_DOUBLE_EQ(distance(c), kLevel + 2 * 140.0 / 256);
  UnitConfig wide = defaults();
  wide.plane_tolerance = 0;
  wide.plane_step_bits = 10;
  wide.fraction_bits = 4;
  EXPECT_DOUBLE_EQ(contact_distance(c, wide, kBits), 2 * 1024 + 4 + 140.0 * (1 / 16.0 + 1 / 256.0));
}

TEST(Contact, OfATinyFacetItsRangeCounts) {
  const Caster tiny{{{0, 0, 5000}, {64, 0, 9000}, {30, 30, 100}}, 0, 0};
  EXPECT_EQ(distance(tiny), kLevel + 8900);
  const Caster larger{{{0, 0, 5000}, {65, 0, 9000}, {30, 65, 100}}, 0, 0};
  EXPECT_GT(distance(larger), kLevel + 30'000);
}

// Its longest edge rises by 8 a texel; a quarter along it the third vertex is off by 900.
TEST(Contact, OfASliverItsLongestEdgeAndThirdVertexCount) {
  const Caster sliver{{{0, 0, 1000}, {4 * kT, 0, 1032}, {kT, 64, 1908}}, 0, 0};
  EXPECT_DOUBLE_EQ(distance(sliver), kLevel + 900 + 2 * 8.0 / 256);
  const Caster wider{{{0, 0, 1000}, {4 * kT, 0, 1032}, {kT, 65, 1908}}, 0, 0};
  EXPECT_GT(distance(wider), kLevel + 7000);
}

TEST(Contact, OfEdgesEquallyLongTheWorseCounts) {
  Caster sliver{{{0, 0, 1000}, {4 * kT, 30, 1032}, {4 * kT, -30, 936}}, 0, 0};
  EXPECT_NEAR(distance(sliver), kLevel + 96 + 2 * 16.0 / 256, 0.01);
  std::swap(sliver.vertex[1], sliver.vertex[2]);
  EXPECT_NEAR(distance(sliver), kLevel + 96 + 2 * 16.0 / 256, 0.01);
}

// A surface that ends on the texel's left border covers the point on it, but is not in the texel.
TEST(Contact, OnABorderItMustBeClearWithinTheTexel) {
  const Caster left{{{-10 * kT, -10 * kT, 1000}, {0, -10 * kT, 1000}, {0, 10 * kT, 1000}}, 0, 0};
  EXPECT_FALSE(clear({left}, at_origin(5000, 1), Semantics::kPaper));
  Fragment inside = at_origin(5000, 1);
  inside.position.x = -1;
  EXPECT_TRUE(clear({left}, inside, Semantics::kPaper));
}

RC_GTEST_PROP(Contact, HoldsForAnyOrderAndMirroring, ()) {
  const auto point = [] {
    const int reach = *rc::gen::element(40, 200, 70'000, kCoordinateMax);
    return LightPoint{*rc::gen::inRange(-reach, reach), *rc::gen::inRange(-reach, reach),
                      *rc::gen::inRange(0u, kDepthMax)};
  };
  Caster c{{point(), point(), point()}, 0, 0};
  const std::int64_t area =
      (std::int64_t{c.vertex[1].x} - c.vertex[0].x) *
          (std::int64_t{c.vertex[2].y} - c.vertex[0].y) -
      (std::int64_t{c.vertex[1].y} - c.vertex[0].y) * (std::int64_t{c.vertex[2].x} - c.vertex[0].x);
  RC_PRE(area != 0);
  const double expected = distance(c);
  const auto expect_same = [&] { RC_ASSERT(std::abs(distance(c) - expected) <= 1e-9 * expected); };
  std::swap(c.vertex[0], c.vertex[1]);
  expect_same();
  std::rotate(c.vertex, c.vertex + 1, c.vertex + 3);
  expect_same();
  for (LightPoint& p : c.vertex) std::swap(p.x, p.y);
  expect_same();
  for (LightPoint& p : c.vertex) p.z = kDepthMax - p.z;
  expect_same();
}

TEST(Contact, ClearMeansBeyondTheDistance) {
  const std::vector<Caster> casters{level(1000, 0)};
  EXPECT_FALSE(clear(casters, at_origin(1000 + 68, 1), Semantics::kPaper));
  EXPECT_TRUE(clear(casters, at_origin(1000 + 69, 1), Semantics::kPaper));
  Fragment aside = at_origin(5000, 1);
  aside.position.x = 9 * kT;  // in the box, not in the triangle
  aside.position.y = 9 * kT;
  EXPECT_FALSE(clear(casters, aside, Semantics::kPaper));
}

TEST(Contact, OnesOwnObjectCountsPhysically) {
  const std::vector<Caster> casters{level(1000, 0)};
  EXPECT_FALSE(clear(casters, at_origin(5000, 0), Semantics::kPaper));
  EXPECT_TRUE(clear(casters, at_origin(5000, 0), Semantics::kPhysical));
}

// The nearest surface excuses nothing if another one does not.
TEST(Contact, EveryCoveringCasterIsAsked) {
  const Caster near = steep(100'000, 0), far = level(100'300, 0);
  EXPECT_DOUBLE_EQ(distance(near), kLevel + 500);
  EXPECT_FALSE(clear({near}, at_origin(100'400, 1), Semantics::kPaper));
  EXPECT_TRUE(clear({near, far}, at_origin(100'400, 1), Semantics::kPaper));
  EXPECT_TRUE(clear({far, near}, at_origin(100'400, 1), Semantics::kPaper));
  EXPECT_FALSE(clear({near, far}, at_origin(100'360, 1), Semantics::kPaper));
}

}  // namespace
}  // namespace kagesen

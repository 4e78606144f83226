#include "model/unit/edge_setup.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <tuple>

#include "tests/model/unit/rational.h"

namespace kagesen::unit {
namespace {

constexpr int kBits = 3;  // units a texel: 8

LightPoint at(std::int32_t x, std::int32_t y, std::uint32_t z = 0) { return {x, y, z}; }

/// Everything but L/R.
auto fields(const EdgeSetup& e) {
  const auto ramp = [](const ExactRamp& r) {
    return std::tuple(r.whole, r.rest, r.step_whole, r.step_rest, r.base);
  };
  return std::tuple(e.x_major, e.x_positive, e.first_major, e.last_major, e.first_minor,
                    e.last_minor, e.slope, ramp(e.minor), ramp(e.major_depth),
                    e.minor_moves ? ramp(e.minor_depth) : ramp({}), e.minor_moves, e.first_depth,
                    e.last_depth);
}

TEST(EdgeSetup, ClassifiesTheFourKindsOfLine) {
  const struct {
    LightPoint from, to;
    bool x_major, x_positive;
  } kinds[] = {{at(0, 0), at(9, 5), true, true},   {at(9, 0), at(0, 5), true, false},
               {at(0, 0), at(5, 9), false, true},  {at(5, 0), at(0, 9), false, false},
               {at(0, 0), at(5, 5), false, true},   // slope 1 is y-major
               {at(5, 0), at(0, 5), false, false},  // towards -x too
               {at(0, 0), at(0, 5), false, true},   // vertical
               {at(0, 0), at(5, 0), true, true}};   // horizontal
  for (const auto& kind : kinds) {
    for (const bool swapped : {false, true}) {
      const EdgeSetup e = setup_edge(swapped ? kind.to : kind.from, swapped ? kind.from : kind.to,
                                     at(-7, 11), kBits, 4);
      EXPECT_EQ(e.x_major, kind.x_major) << kind.to.x << ',' << kind.to.y;
      EXPECT_EQ(e.x_positive, kind.x_positive) << kind.to.x << ',' << kind.to.y;
    }
  }
}

TEST(EdgeSetup, LeftMeansThatThePolygonLiesRightOfTheTravel) {
  EXPECT_TRUE(setup_edge(at(0, 0), at(0, 8), at(5, 0), kBits, 4).left);  // up, polygon at +x
  EXPECT_FALSE(setup_edge(at(0, 0), at(0, 8), at(-5, 0), kBits, 4).left);
  EXPECT_TRUE(setup_edge(at(8, 0), at(0, 0), at(3, -5), kBits, 4).left);  // towards +x, at -y
  EXPECT_FALSE(setup_edge(at(8, 0), at(0, 0), at(3, 5), kBits, 4).left);
}

TEST(EdgeSetup, StoredOneSaturates) {
  EXPECT_EQ(setup_edge(at(0, 0), at(8, 8), at(0, 9), kBits, 4).slope, 15u);
  // 31/32 is 15.5/16, rounds to 16, saturates; 15/16 is exact.
  EXPECT_EQ(setup_edge(at(0, 0), at(31, 32), at(0, 9), kBits, 4).slope, 15u);
  EXPECT_EQ(setup_edge(at(0, 0), at(15, 16), at(0, 9), kBits, 4).slope, 15u);
  EXPECT_EQ(setup_edge(at(0, 0), at(29, 32), at(0, 9), kBits, 4).slope, 15u);  // 14.5, ties up
  EXPECT_EQ(setup_edge(at(0, 0), at(28, 32), at(0, 9), kBits, 4).slope, 14u);
}

/// Unit.md 1.2 to 1.5 for every edge of a small grid.
TEST(EdgeSetup, SlopeIsNearestAndBothTrianglesOfAnEdgeAgree) {
  const int slope_bits = 3;
  for (int dx = -20; dx <= 20; ++dx) {
    for (int dy = -20; dy <= 20; ++dy) {
      if (dx == 0 && dy == 0) continue;
      const LightPoint a = at(3, -5, 100), b = at(3 + dx, -5 + dy, 177);
      const LightPoint one_side = at(a.x - dy, a.y + dx), other_side = at(b.x + dy, b.y - dx);
      const EdgeSetup one = setup_edge(a, b, one_side, kBits, slope_bits);
      const EdgeSetup other = setup_edge(b, a, other_side, kBits, slope_bits);
      ASSERT_EQ(fields(one), fields(other)) << dx << ',' << dy;
      ASSERT_NE(one.left, other.left) << dx << ',' << dy;

      const int major = std::max(std::abs(dx), std::abs(dy));
      const int minor = std::min(std::abs(dx), std::abs(dy));
      const std::int64_t nearest = (Rational(minor * 8, major) + Rational(1, 2)).floor();
      ASSERT_EQ(one.slope, static_cast<std::uint32_t>(std::min<std::int64_t>(nearest, 7)))
          << dx << ',' << dy;
    }
  }
}

TEST(EdgeSetup, EndsFollowTheTravel) {
  // From (16, 8) to (0, 24) towards -x: u = -x runs from -16 to 0; the ends on borders take the
  // texels within, u texels -2 and -1, that is x texels 1 and 0.
  const EdgeSetup e = setup_edge(at(16, 8), at(0, 24), at(30, 30), kBits, 4);
  EXPECT_EQ(e.first_minor, -2);
  EXPECT_EQ(e.last_minor, -1);
  EXPECT_EQ(e.first_major, 1);
  EXPECT_EQ(e.last_major, 2);
  // On a border without extent across it: the floor side.
  const EdgeSetup border = setup_edge(at(8, 0), at(8, 16), at(30, 30), kBits, 4);
  EXPECT_EQ(border.first_minor, 1);
  EXPECT_EQ(border.last_minor, 1);
}

TEST(EdgeSetup, TakesTheWidestCoordinates) {
  // Across the whole space at scale 1024: nothing may overflow (the sanitizers watch).
  const EdgeSetup e =
      setup_edge({kCoordinateMin, kCoordinateMin, 0}, {kCoordinateMax, kCoordinateMax, kDepthMax},
                 {kCoordinateMax, kCoordinateMin, 0}, kMaxFractionBits, 15);
  EXPECT_EQ(e.slope, 32767u);
  EXPECT_TRUE(e.left);
  EXPECT_EQ(e.first_major, -2);
  EXPECT_EQ(e.last_major, 1);
}

}  // namespace
}  // namespace kagesen::unit

#include "model/unit/silhouette_detector.h"

#include <gtest/gtest.h>

namespace kagesen::unit {
namespace {

Line line(unsigned flags, unsigned fraction = 5, unsigned slope = 6, unsigned polygon = 7) {
  Line out;
  out.flags = flags;
  out.fraction = static_cast<std::uint16_t>(fraction);
  out.slope = static_cast<std::uint16_t>(slope);
  out.polygon = polygon;
  return out;
}

/// Every pair of flags: the two sides of an edge differ in L/R, and in nothing that is published.
TEST(SilhouetteDetector, OnlyOppositeLeftCancelsAndStartHereDoesNotCount) {
  for (unsigned a = 0; a < 64; ++a) {
    for (unsigned b = 0; b < 64; ++b) {
      const unsigned published = (a ^ b) & (Line::kLeft | Line::kCross | Line::kXMajor |
                                            Line::kXPositive | Line::kEndHere);
      const bool expected = published == Line::kLeft;
      EXPECT_EQ(cancels(line(a), line(b, 5, 6, 8), true), expected) << a << ' ' << b;
      EXPECT_EQ(cancels(line(b), line(a, 5, 6, 8), false), expected) << a << ' ' << b;
    }
  }
}

TEST(SilhouetteDetector, FractionAndSlopeMustBeEqual) {
  EXPECT_TRUE(cancels(line(0), line(Line::kLeft, 5, 6, 8), true));
  EXPECT_FALSE(cancels(line(0), line(Line::kLeft, 4, 6, 8), true));
  EXPECT_FALSE(cancels(line(0), line(Line::kLeft, 5, 7, 8), true));
  EXPECT_FALSE(cancels(line(0), line(Line::kLeft, 5 + 32768, 6, 8), true));
}

TEST(SilhouetteDetector, LinesOfOnePolygonNeverAreWhereTheIdCounts) {
  EXPECT_FALSE(cancels(line(0), line(Line::kLeft), true));
  EXPECT_TRUE(cancels(line(0), line(Line::kLeft), false));
}

}  // namespace
}  // namespace kagesen::unit

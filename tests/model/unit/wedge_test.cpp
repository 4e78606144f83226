// How two lines combine (Table 7, 4.2.1), against the wedges that real outlines make.
#include <gtest/gtest.h>

#include <cstdlib>
#include <random>
#include <vector>

#include "model/unit/edge_walker.h"
#include "model/unit/shadow_decision.h"

namespace kagesen::unit {
namespace {

constexpr int kBits = 16, kFieldBits = 15;
constexpr std::int32_t kTexel = 1 << kBits;

struct Ray {
  int dx, dy;
};

std::int64_t cross(Ray a, Ray b) { return std::int64_t{a.dx} * b.dy - std::int64_t{a.dy} * b.dx; }

/// The word that the edge a-b leaves in texel (0, 0).
Line word_in_texel(const LightPoint& a, const LightPoint& b, const LightPoint& inside, int bits) {
  for (EdgeWalker w(setup_edge(a, b, inside, kBits, bits), kBits, bits);; w.step()) {
    const OutlineTexel t = w.texel();
    if (t.x == 0 && t.y == 0) return t.line;
    if (w.last()) break;
  }
  ADD_FAILURE() << "the edge misses the texel";
  return {};
}

LightPoint along(const LightPoint& from, Ray ray, std::int32_t times) {
  return {from.x + ray.dx * times, from.y + ray.dy * times, 0};
}

ShadowDecision decision_of(int bits) {
  UnitConfig config;
  config.fraction_bits = config.slope_bits = bits;
  return ShadowDecision(config);
}

Line turned(Line l) {
  l.flags = l.flags ^ Line::kLeft;
  return l;
}

/// The wedge at `vertex` between two rays that leave the texel: the convex part is the product of
/// the two half planes, the rest of the plane is their sum.
void expect_wedge(const LightPoint& vertex, Ray r, Ray s) {
  if (cross(r, s) == 0) return;
  const ShadowDecision decision = decision_of(kFieldBits);
  const LightPoint far_r = along(vertex, r, 2 * kTexel), far_s = along(vertex, s, 2 * kTexel);
  const Line a = word_in_texel(vertex, far_r, far_s, kFieldBits);
  const Line b = word_in_texel(vertex, far_s, far_r, kFieldBits);
  const auto name = [&] {
    return testing::Message() << '(' << r.dx << ',' << r.dy << ") (" << s.dx << ',' << s.dy << ')';
  };
  ASSERT_EQ(decision.combine(a, b, true), Combine::kAnd) << name();
  ASSERT_EQ(decision.combine(b, a, true), Combine::kAnd) << name();
  ASSERT_EQ(decision.combine(turned(a), turned(b), true), Combine::kOr) << name();
  ASSERT_EQ(decision.combine(turned(b), turned(a), true), Combine::kOr) << name();
}

TEST(Wedge, Table7CorrectedIsRightForEveryPairOfSmallDirections) {
  const LightPoint vertex{kTexel / 2 + 77, kTexel / 3, 0};
  for (int n = 0; n < 81 * 81; ++n) {
    const Ray r{n % 9 - 4, n / 9 % 9 - 4}, s{n / 81 % 9 - 4, n / 729 - 4};
    if ((r.dx == 0 && r.dy == 0) || (s.dx == 0 && s.dy == 0)) continue;
    expect_wedge(vertex, r, s);
    if (HasFatalFailure()) return;
  }
}

TEST(Wedge, Table7CorrectedIsRightForRandomWedges) {
  std::mt19937 random(7);
  const auto coordinate = [&] { return static_cast<int>(random() % 201) - 100; };
  for (int n = 0; n < 100000; ++n) {
    const LightPoint vertex{static_cast<std::int32_t>(1 + random() % (kTexel - 1)),
                            static_cast<std::int32_t>(1 + random() % (kTexel - 1)), 0};
    const Ray r{coordinate(), coordinate()}, s{coordinate(), coordinate()};
    // A ray shorter than the texel would end in it.
    if (std::abs(r.dx) + std::abs(r.dy) < 2 || std::abs(s.dx) + std::abs(s.dy) < 2) continue;
    expect_wedge(vertex, r, s);
    if (HasFatalFailure()) return;
  }
}

/// x+ 0, y+ 1, y- 2, x- 3: by angle.
int kind_of(const Line& l) {
  const bool positive = l.has(Line::kXPositive);
  return l.has(Line::kXMajor) ? (positive ? 0 : 3) : (positive ? 1 : 2);
}

TEST(Wedge, Table7AsPrintedIsWrongExactlyWhereUnitMdSaysSo) {
  // Its last row for (y, +) and (x, -), and the two pairs that are not printed.
  UnitConfig config;
  config.fraction_bits = config.slope_bits = kFieldBits;
  config.table7 = Table7::kPrinted;
  const ShadowDecision printed(config);
  std::mt19937 random(8);
  const auto coordinate = [&] { return static_cast<int>(random() % 201) - 100; };
  const LightPoint vertex{kTexel / 2, kTexel / 2, 0};
  for (int n = 0; n < 20000; ++n) {
    const Ray r{coordinate(), coordinate()}, s{coordinate(), coordinate()};
    if (cross(r, s) == 0) continue;
    const LightPoint far_r = along(vertex, r, 2 * kTexel), far_s = along(vertex, s, 2 * kTexel);
    const Line a = word_in_texel(vertex, far_r, far_s, kFieldBits);
    const Line b = word_in_texel(vertex, far_s, far_r, kFieldBits);
    const int kind_a = kind_of(a), kind_b = kind_of(b);
    if ((kind_a == 1 && kind_b == 0) || (kind_a == 2 && kind_b == 3)) continue;  // not printed
    const bool last_row = kind_a == kind_b && (kind_a == 1 || kind_a == 3);
    // Of equal slopes, after rounding, neither is first.
    if (kind_a == kind_b && a.slope == b.slope) continue;
    ASSERT_EQ(printed.combine(a, b, true), last_row ? Combine::kOr : Combine::kAnd);
  }
}

/// Every point of a grid, but those within `margin` of an outline, against the exact wedge.
TEST(Wedge, InsideIsTheExactWedgeAwayFromItsSides) {
  const ShadowDecision decision = decision_of(kFieldBits);
  std::mt19937 random(9);
  const auto coordinate = [&] { return static_cast<int>(random() % 41) - 20; };
  for (int n = 0; n < 3000; ++n) {
    const LightPoint vertex{static_cast<std::int32_t>(1 + random() % (kTexel - 1)),
                            static_cast<std::int32_t>(1 + random() % (kTexel - 1)), 0};
    const Ray r{coordinate(), coordinate()}, s{coordinate(), coordinate()};
    if (cross(r, s) <= 0) continue;
    const LightPoint far_r = along(vertex, r, 2 * kTexel), far_s = along(vertex, s, 2 * kTexel);
    const Line a = word_in_texel(vertex, far_r, far_s, kFieldBits);
    const Line b = word_in_texel(vertex, far_s, far_r, kFieldBits);
    const Line convex[] = {a, b}, reflex[] = {turned(a), turned(b)};
    for (int i = 0; i < 64; ++i) {
      const Ray p{static_cast<int>(random() % kTexel) - vertex.x,
                  static_cast<int>(random() % kTexel) - vertex.y};
      const std::int64_t at_r = cross(r, p), at_s = cross(p, s);
      // 8 x 2^-15 texel from either line: the stored words are that exact.
      const std::int64_t margin = 16 * 21;
      if (std::abs(at_r) < margin || std::abs(at_s) < margin) continue;
      const bool within = at_r > 0 && at_s > 0;
      const SubTexel point{vertex.x + p.dx, vertex.y + p.dy, kBits};
      ASSERT_EQ(decision.inside(convex, 2, true, point), within);
      ASSERT_EQ(decision.inside(reflex, 2, true, point), !within);
    }
  }
}

/// An edge that lies wholly in the texel, and one that leaves it: which end they share is not
/// stored, and yet decided rightly.
TEST(Wedge, AnEdgeWithBothEndsInTheTexelMeetsALineThatLeavesIt) {
  const ShadowDecision decision = decision_of(kFieldBits);
  std::mt19937 random(10);
  const auto coordinate = [&] { return static_cast<int>(random() % 41) - 20; };
  const LightPoint vertex{kTexel / 2, kTexel / 2, 0};
  for (int n = 0; n < 20000; ++n) {
    const Ray r{coordinate(), coordinate()}, s{coordinate(), coordinate()};
    if (cross(r, s) == 0) continue;
    const LightPoint near_end = along(vertex, r, kTexel / 64);
    const LightPoint far_end = along(vertex, s, 2 * kTexel);
    const Line a = word_in_texel(vertex, near_end, far_end, kFieldBits);
    const Line b = word_in_texel(vertex, far_end, near_end, kFieldBits);
    ASSERT_TRUE(a.has(Line::kStartHere) && a.has(Line::kEndHere));
    const auto name = [&] {
      return testing::Message() << r.dx << ',' << r.dy << ' ' << s.dx << ',' << s.dy;
    };
    ASSERT_EQ(decision.combine(a, b, true), Combine::kAnd) << name();
    ASSERT_EQ(decision.combine(b, a, true), Combine::kAnd) << name();
    ASSERT_EQ(decision.combine(turned(a), turned(b), true), Combine::kOr) << name();
    ASSERT_EQ(decision.combine(turned(b), turned(a), true), Combine::kOr) << name();
  }
}

/// 4.2.1 (Fig. 6, 2-a and 2-b): two lines that run through, x = 1/4 and x = 3/4.
TEST(Wedge, LinesWithoutAVertexCombineByTheirFractions) {
  const ShadowDecision decision = decision_of(3);
  Line low, high;
  low.fraction = 2;
  high.fraction = 6;
  low.flags = high.flags = Line::kXPositive;
  const auto with = [](Line l, bool left) {
    l.flags = left ? l.flags | Line::kLeft : l.flags & ~unsigned{Line::kLeft};
    return l;
  };
  const Line band[] = {with(low, true), with(high, false)};   // 1/4 <= x < 3/4
  const Line holes[] = {with(low, false), with(high, true)};  // x < 1/4 or 3/4 <= x
  EXPECT_EQ(decision.combine(band[0], band[1], false), Combine::kAnd);
  EXPECT_EQ(decision.combine(holes[0], holes[1], false), Combine::kOr);
  for (int x = 0; x < 8; ++x) {
    EXPECT_EQ(decision.inside(band, 2, false, {x, 3, 3}), x >= 2 && x < 6) << x;
    EXPECT_EQ(decision.inside(holes, 2, false, {x, 3, 3}), x < 2 || x >= 6) << x;
  }
  // One within the other, both the same way, are layers that overlap: the sum, which is the wider. A
  // line that ends in the texel keeps the product.
  EXPECT_EQ(decision.combine(with(low, true), with(high, true), false), Combine::kOr);
  Line ending = with(high, true);
  ending.flags |= Line::kEndHere;
  EXPECT_EQ(decision.combine(with(low, true), ending, false), Combine::kAnd);
  EXPECT_EQ(decision.combine(ending, with(low, true), false), Combine::kAnd);
  // The tie of two equal lines: AND.
  EXPECT_EQ(decision.combine(with(low, true), with(low, true), false), Combine::kAnd);
}

TEST(Wedge, VertexRuleTakesTheFlagsOfTheLinesOrTheEntrys) {
  // From x = 1/4 (Left, slope 1/8) and x = 3/4 (Right): 4.2.1 says AND. Table 7 with both ends
  // elsewhere: A is the line of lesser angle, End of A 0, L/R of B 0: Exp1 = 1, OR.
  Line a, b;
  a.fraction = 2;
  a.slope = 1;
  b.fraction = 6;
  a.flags = Line::kXPositive | Line::kLeft;
  b.flags = Line::kXPositive;
  UnitConfig config;
  config.fraction_bits = config.slope_bits = 3;
  EXPECT_EQ(ShadowDecision(config).combine(a, b, true), Combine::kAnd);
  config.vertex_rule = VertexRule::kPerEntry;
  EXPECT_EQ(ShadowDecision(config).combine(a, b, false), Combine::kAnd);
  EXPECT_EQ(ShadowDecision(config).combine(a, b, true), Combine::kOr);
}

TEST(Wedge, ManyLinesAreInsideIfOneIsWithAllThatItIsAndedWith) {
  // A band 1/8 <= x < 3/8 and a half plane 6/8 <= x: (1 AND 2) OR 3 by 4.2.1.
  const ShadowDecision decision = decision_of(3);
  std::vector<Line> lines(3);
  const unsigned fraction[] = {1, 3, 6};
  for (int i = 0; i < 3; ++i) {
    lines[i].fraction = static_cast<std::uint16_t>(fraction[i]);
    lines[i].flags = Line::kXPositive | (i == 1 ? 0 : Line::kLeft);
  }
  ASSERT_EQ(decision.combine(lines[0], lines[1], false), Combine::kAnd);
  ASSERT_EQ(decision.combine(lines[1], lines[2], false), Combine::kOr);
  ASSERT_EQ(decision.combine(lines[0], lines[2], false), Combine::kOr);
  for (int x = 0; x < 8; ++x) {
    EXPECT_EQ(decision.inside(lines.data(), 3, false, {x, 3, 3}), (x >= 1 && x < 3) || x >= 6) << x;
  }
}

}  // namespace
}  // namespace kagesen::unit

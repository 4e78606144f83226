#include "model/unit/shadow_decision.h"

#include <gtest/gtest.h>

#include <string>

#include "tests/model/unit/rational.h"

namespace kagesen::unit {
namespace {

constexpr unsigned kFlagsOfTable5 = 8;  // x major, x positive, cross

UnitConfig with_bits(int bits, Table7 table7 = Table7::kCorrected,
                     VertexRule rule = VertexRule::kPerLine) {
  UnitConfig c;
  c.fraction_bits = c.slope_bits = bits;
  c.table7 = table7;
  c.vertex_rule = rule;
  return c;
}

Line line(unsigned flags, unsigned fraction = 0, unsigned slope = 0) {
  Line out;
  out.flags = flags;
  out.fraction = static_cast<std::uint16_t>(fraction);
  out.slope = static_cast<std::uint16_t>(slope);
  return out;
}

unsigned flags_of(unsigned n) {
  return (n & 1 ? Line::kXMajor : 0) | (n & 2 ? Line::kXPositive : 0) | (n & 4 ? Line::kCross : 0);
}

/// Is Mx < x, with x from the equation as Table 5 prints it?
bool left_of_table5(const Line& l, Rational mx, Rational my, int bits) {
  const std::int64_t one = std::int64_t{1} << bits;
  const Rational frac(l.fraction, one), slope(l.slope, one);
  const bool cross = l.has(Line::kCross), positive = l.has(Line::kXPositive);
  if (!l.has(Line::kXMajor)) {
    const Rational along = cross ? my - 1 : my;
    return mx < (positive ? slope * along + frac : Rational(0) - slope * along + (1 - frac));
  }
  const Rational rise = my - frac;
  // 1 / slope at slope 0: the sign of the rise decides.
  if (l.slope == 0) return positive ? Rational(0) < rise : rise < Rational(0);
  const Rational run = rise / slope;
  if (positive) return mx < (cross ? run + 1 : run);
  return mx < (cross ? Rational(0) - run : 1 - run);
}

TEST(ShadowDecision, Table5EveryEquationAndTable6EveryRow) {
  const ShadowDecision decision(with_bits(3));
  for (const int point_bits : {3, 4}) {
    const int one = 1 << point_bits;
    for (unsigned n = 0; n < kFlagsOfTable5; ++n) {
      for (unsigned fraction = 0; fraction < 8; ++fraction) {
        for (unsigned slope = 0; slope < 8; ++slope) {
          const Line right = line(flags_of(n), fraction, slope);
          const Line left = line(flags_of(n) | Line::kLeft, fraction, slope);
          for (int x = 0; x < one; ++x) {
            for (int y = 0; y < one; ++y) {
              const bool mx_below = left_of_table5(right, Rational(x, one), Rational(y, one), 3);
              // Table 6: Left, TRUE: outside; Left, FALSE: inside; Right, TRUE: inside; Right,
              // FALSE: outside.
              ASSERT_EQ(decision.contains(left, {x, y, point_bits}), !mx_below)
                  << n << ' ' << fraction << ' ' << slope << ' ' << x << ' ' << y;
              ASSERT_EQ(decision.contains(right, {x, y, point_bits}), mx_below)
                  << n << ' ' << fraction << ' ' << slope << ' ' << x << ' ' << y;
            }
          }
        }
      }
    }
  }
}

TEST(ShadowDecision, OffsetIsExact) {
  // Fraction and Slope of different widths, so that neither stands in for the other.
  UnitConfig config;
  config.fraction_bits = 3;
  config.slope_bits = 2;
  const ShadowDecision decision(config);
  for (unsigned n = 0; n < kFlagsOfTable5; ++n) {
    for (unsigned fraction = 0; fraction < 8; ++fraction) {
      for (unsigned slope = 0; slope < 4; ++slope) {
        for (int x = 0; x < 16; ++x) {
          for (int y = 0; y < 16; ++y) {
            const Line l = line(flags_of(n), fraction, slope);
            const Rational mx(x, 16), my(y, 16);
            const Rational u = l.has(Line::kXPositive) ? mx : 1 - mx;
            const Rational major = l.has(Line::kXMajor) ? u : my;
            const Rational minor = l.has(Line::kXMajor) ? my : u;
            const Rational exact = minor - Rational(fraction, 8) -
                                   Rational(slope, 4) * (l.has(Line::kCross) ? major - 1 : major);
            ASSERT_TRUE(Rational(decision.offset(l, {x, y, 4}), 16 * 4) == exact);
          }
        }
      }
    }
  }
}

TEST(ShadowDecision, Table6ByHand) {
  const ShadowDecision decision(with_bits(3));
  // x = 4/8 for every y; the point at Mx = 2/8 lies below it.
  const unsigned up = Line::kXPositive;
  EXPECT_FALSE(decision.contains(line(up | Line::kLeft, 4), {2, 5, 3})) << "Left, TRUE";
  EXPECT_TRUE(decision.contains(line(up | Line::kLeft, 4), {6, 5, 3})) << "Left, FALSE";
  EXPECT_TRUE(decision.contains(line(up, 4), {2, 5, 3})) << "Right, TRUE";
  EXPECT_FALSE(decision.contains(line(up, 4), {6, 5, 3})) << "Right, FALSE";
}

constexpr unsigned kKinds[] = {Line::kXMajor | Line::kXPositive, Line::kXPositive, 0u,
                               Line::kXMajor};  // x+ y+ y- x-, by angle
const char* const kKindNames[] = {"x+", "y+", "y-", "x-"};

enum class Exp { kExp1, kExp2, kBySlope, kNotPrinted };

/// Table 7 as printed: row A, column B. A minus for B's Xsign means either.
const Exp kPrinted[4][4] = {
    //            B: x+            y+                y-                x-
    /* A x+ */ {Exp::kBySlope, Exp::kExp1, Exp::kExp1, Exp::kExp1},
    /* A y+ */ {Exp::kNotPrinted, Exp::kBySlope, Exp::kExp1, Exp::kExp1},
    /* A y- */ {Exp::kExp2, Exp::kExp2, Exp::kBySlope, Exp::kNotPrinted},
    /* A x- */ {Exp::kExp2, Exp::kExp2, Exp::kExp2, Exp::kBySlope},
};

Combine evaluate(Exp exp, const Line& a, const Line& b) {
  const bool left = b.has(Line::kLeft), end = a.has(Line::kEndHere);
  return (exp == Exp::kExp1 ? left == end : left != end) ? Combine::kOr : Combine::kAnd;
}

/// Every row with every L/R of both and End of A; one line ends or starts where the other does.
template <typename Check>
void for_every_pair(Check check) {
  for (int a = 0; a < 4; ++a) {
    for (int b = 0; b < 4; ++b) {
      for (unsigned bits = 0; bits < 16; ++bits) {
        for (const auto& [slope_a, slope_b] : {std::pair(2u, 5u), {5u, 2u}, {3u, 3u}}) {
          const auto end = [&](unsigned bit) {
            return bits & bit ? Line::kEndHere : Line::kStartHere;
          };
          const Line one = line(kKinds[a] | end(1) | (bits & 2 ? Line::kLeft : 0), 4, slope_a);
          const Line two = line(kKinds[b] | end(4) | (bits & 8 ? Line::kLeft : 0), 4, slope_b);
          check(a, b, one, two);
        }
      }
    }
  }
}

TEST(ShadowDecision, Table7EveryRowAsPrinted) {
  const ShadowDecision decision(with_bits(3, Table7::kPrinted));
  for_every_pair([&](int a, int b, const Line& one, const Line& two) {
    Exp exp = kPrinted[a][b];
    // Last row: A Slope <= B Slope, TRUE Exp1, FALSE Exp2.
    if (exp == Exp::kBySlope) exp = one.slope <= two.slope ? Exp::kExp1 : Exp::kExp2;
    // The gaps follow the order of the angles: (y+, x+) Exp2, (y-, x-) Exp1.
    if (exp == Exp::kNotPrinted) exp = a == 1 ? Exp::kExp2 : Exp::kExp1;
    EXPECT_EQ(decision.combine(one, two, false), evaluate(exp, one, two))
        << kKindNames[a] << ' ' << kKindNames[b] << ' ' << one.slope << ' ' << two.slope;
  });
}

TEST(ShadowDecision, Table7EveryRowCorrected) {
  const ShadowDecision decision(with_bits(3));
  for_every_pair([&](int a, int b, const Line& one, const Line& two) {
    ASSERT_EQ(decision.combine(one, two, false), decision.combine(two, one, false))
        << kKindNames[a] << ' ' << kKindNames[b] << ' ' << one.slope << ' ' << two.slope;
    // Two outlines that meet have equal L/R iff one ends where the other starts.
    const bool opposite_ends = one.has(Line::kEndHere) != two.has(Line::kEndHere);
    if ((one.has(Line::kLeft) == two.has(Line::kLeft)) != opposite_ends) return;
    bool first = a < b;
    if (a == b) {
      if (one.slope == two.slope) return;  // no wedge: ParallelLinesCombineByTheirFractions
      // Signed dy/dx grows with Slope for x+ and y-, and falls for y+ and x-.
      const bool grows = a == 0 || a == 2;
      first = (one.slope < two.slope) == grows;
    }
    EXPECT_EQ(decision.combine(one, two, false),
              evaluate(first ? Exp::kExp1 : Exp::kExp2, one, two))
        << kKindNames[a] << ' ' << kKindNames[b] << ' ' << one.slope << ' ' << two.slope;
  });
}

TEST(ShadowDecision, ParallelLinesCombineByTheirFractions) {
  // x = 1/4 (Left) and x = 3/4 (Right), both starting here: a strip, whichever line comes first.
  const ShadowDecision decision(with_bits(3));
  const unsigned up = Line::kXPositive | Line::kStartHere;
  const Line low = line(up | Line::kLeft, 2), high = line(up, 6);
  EXPECT_EQ(decision.combine(low, high, true), Combine::kAnd);
  EXPECT_EQ(decision.combine(high, low, true), Combine::kAnd);
  const Line low_right = line(up, 2), high_left = line(up | Line::kLeft, 6);
  EXPECT_EQ(decision.combine(low_right, high_left, true), Combine::kOr);
  EXPECT_EQ(decision.combine(high_left, low_right, true), Combine::kOr);
}

TEST(ShadowDecision, LinesThatCannotMeetCombineByTheirFractions) {
  // Both end here and both are Left: no outline has such a vertex, so Table 7 does not apply.
  const ShadowDecision decision(with_bits(3));
  const unsigned end = Line::kXPositive | Line::kLeft | Line::kEndHere;
  const Line narrow = line(end, 6, 1), wide = line(end, 2, 0);
  EXPECT_EQ(decision.combine(narrow, wide, true), Combine::kAnd);
  EXPECT_EQ(decision.combine(wide, narrow, true), Combine::kAnd);
  // Nor do two edges that both lie wholly here tell where they meet.
  const Line strip = line(end | Line::kStartHere, 2, 1);
  const Line other = line((end | Line::kStartHere) & ~unsigned{Line::kLeft}, 6, 0);
  EXPECT_EQ(decision.combine(strip, other, true), Combine::kAnd);
  EXPECT_EQ(decision.combine(other, strip, true), Combine::kAnd);
}

}  // namespace
}  // namespace kagesen::unit

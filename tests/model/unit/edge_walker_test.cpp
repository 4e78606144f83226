#include "model/unit/edge_walker.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "tests/model/unit/rational.h"

namespace kagesen::unit {
namespace {

constexpr int kBits = 3;  // units a texel: 8
constexpr int kTexel = 1 << kBits;

std::vector<OutlineTexel> walk(const LightPoint& a, const LightPoint& b, int fraction_bits,
                               std::vector<Exit>* exits = nullptr) {
  const LightPoint aside{a.x + 1000, a.y + 3, 0};
  std::vector<OutlineTexel> out;
  for (EdgeWalker w(setup_edge(a, b, aside, kBits, 2), kBits, fraction_bits);; w.step()) {
    out.push_back(w.texel());
    if (w.last()) return out;
    if (exits != nullptr) exits->push_back(w.exit());
  }
}

/// The same texel from the segment's geometry alone.
struct Expected {
  std::int64_t fraction, nearest;
  bool cross, start, end;
};

/// The texels that hold a point P(t), 0 <= t < 1, of the segment; sides count as docs/unit.md has it.
std::map<std::pair<int, int>, Expected> crossed(LightPoint a, LightPoint b, int fraction_bits) {
  if (b.y < a.y || (b.y == a.y && b.x < a.x)) std::swap(a, b);
  const int sign = b.x < a.x ? -1 : 1;
  const int u0 = sign * a.x, u1 = sign * b.x;
  const bool x_major = u1 - u0 > b.y - a.y;
  std::map<std::pair<int, int>, Expected> out;
  const auto when = [](int from, int to, int at) { return Rational(at - from, to - from); };
  for (int i = u0 / kTexel - 2; i <= u1 / kTexel + 1; ++i) {
    for (int j = a.y / kTexel - 2; j <= b.y / kTexel + 1; ++j) {
      Rational enter = 0, leave = 1;
      const auto clip = [&](int from, int to, int texel) {
        if (from == to) return Rational(from, kTexel).floor() == texel;
        enter = std::max(enter, when(from, to, texel * kTexel));
        leave = std::min(leave, when(from, to, (texel + 1) * kTexel));
        return true;
      };
      if (!clip(u0, u1, i) || !clip(a.y, b.y, j) || !(enter < leave)) continue;
      const Rational slope = x_major ? Rational(b.y - a.y, u1 - u0) : Rational(u1 - u0, b.y - a.y);
      const auto minor_at = [&](int major) {
        return (x_major ? Rational(a.y) + slope * (major - u0) - j * kTexel
                        : Rational(u0) + slope * (major - a.y) - i * kTexel) /
               kTexel;
      };
      const int near_side = (x_major ? i : j) * kTexel;
      Expected e;
      e.cross = minor_at(near_side) < 0;
      const Rational exact = minor_at(e.cross ? near_side + kTexel : near_side);
      const std::int64_t one = std::int64_t{1} << fraction_bits;
      e.fraction = std::min((exact * one + Rational(1, 2)).floor(), one - 1);
      const Rational z0 = std::int64_t{a.z}, dz = std::int64_t{b.z} - std::int64_t{a.z};
      e.nearest = std::min(z0 + dz * enter, z0 + dz * leave).floor();
      e.start = enter == 0;
      e.end = leave == 1;
      out[{sign > 0 ? i : -i - 1, j}] = e;
    }
  }
  return out;
}

void expect_exact(const LightPoint& a, const LightPoint& b, int fraction_bits) {
  auto left = crossed(a, b, fraction_bits);
  for (const OutlineTexel& t : walk(a, b, fraction_bits)) {
    const auto it = left.find({t.x, t.y});
    ASSERT_NE(it, left.end()) << "texel " << t.x << ',' << t.y << " of (" << a.x << ',' << a.y
                              << ") (" << b.x << ',' << b.y << ')';
    const Expected& e = it->second;
    ASSERT_TRUE(t.line.fraction == e.fraction && t.nearest == e.nearest &&
                t.line.has(Line::kCross) == e.cross && t.line.has(Line::kStartHere) == e.start &&
                t.line.has(Line::kEndHere) == e.end)
        << "texel " << t.x << ',' << t.y << " of (" << a.x << ',' << a.y << ") (" << b.x << ','
        << b.y << "): fraction " << t.line.fraction << " for " << e.fraction << ", nearest "
        << t.nearest << " for " << e.nearest;
    left.erase(it);
  }
  ASSERT_TRUE(left.empty()) << left.size() << " texels missed of (" << a.x << ',' << a.y << ") ("
                            << b.x << ',' << b.y << ')';
}

TEST(EdgeWalker, VisitsExactlyTheTexelsThatEverySmallSegmentCrosses) {
  for (int x0 = -9; x0 <= 9; ++x0) {
    for (int y0 = -9; y0 <= 9; ++y0) {
      for (int x1 = -9; x1 <= 9; ++x1) {
        for (int y1 = -9; y1 <= 9; ++y1) {
          if (x0 == x1 && y0 == y1) continue;
          // A fall, a rise and an equal depth come round with the coordinates.
          const auto z = static_cast<std::uint32_t>(40 + (x1 * 5 + y1 * 3) % 23);
          expect_exact({x0, y0, 40}, {x1, y1, z}, 2);
          if (HasFatalFailure()) return;
        }
      }
    }
  }
}

TEST(EdgeWalker, StaysExactOnLongSegments) {
  for (int i = 1; i <= 150; ++i) {
    const LightPoint from{-i, 3 * i % 17 - 200, static_cast<std::uint32_t>(7 * i)};
    expect_exact(from, {(i * 37) % 301 - 150, (i * 53) % 211 - 90, 5000u}, 1);
    if (HasFatalFailure()) return;
  }
}

struct Leg {
  const char* row;
  LightPoint from, to;
  Exit exit;
  int dx, dy;
};

// A point of Table 2 is the texel that follows: 0 (-1,+1), 1 (-1,0), 2 (+1,0), 3 (+1,+1), 4 (0,+1).
const Leg kTable2[] = {
    // Half slope from the texel's corner side: reaches x = 8 at y = 7 (2), 8 (3), 11 (4).
    {"x + minor axis: point 2", {0, 3, 0}, {16, 11, 0}, Exit::kAlongMajor, 1, 0},
    {"x + vertex: point 3", {0, 4, 0}, {16, 12, 0}, Exit::kVertex, 1, 1},
    {"x + major axis: point 4", {0, 7, 0}, {16, 15, 0}, Exit::kAlongMinor, 0, 1},
    {"x - minor axis: point 1", {8, 3, 0}, {-8, 11, 0}, Exit::kAlongMajor, -1, 0},
    {"x - vertex: point 0", {8, 4, 0}, {-8, 12, 0}, Exit::kVertex, -1, 1},
    {"x - major axis: point 4", {8, 7, 0}, {-8, 15, 0}, Exit::kAlongMinor, 0, 1},
    {"y + minor axis: point 4", {3, 0, 0}, {11, 16, 0}, Exit::kAlongMajor, 0, 1},
    {"y + vertex: point 3", {4, 0, 0}, {12, 16, 0}, Exit::kVertex, 1, 1},
    {"y + major axis: point 2", {7, 0, 0}, {15, 16, 0}, Exit::kAlongMinor, 1, 0},
    {"y - minor axis: point 4", {5, 0, 0}, {-3, 16, 0}, Exit::kAlongMajor, 0, 1},
    {"y - vertex: point 0", {4, 0, 0}, {-4, 16, 0}, Exit::kVertex, -1, 1},
    {"y - major axis: point 1", {1, 0, 0}, {-7, 16, 0}, Exit::kAlongMinor, -1, 0},
};

TEST(EdgeWalker, Table2ExitsOfEveryKindOfLine) {
  for (const Leg& leg : kTable2) {
    std::vector<Exit> exits;
    const auto texels = walk(leg.from, leg.to, 2, &exits);
    ASSERT_GE(texels.size(), 2u) << leg.row;
    EXPECT_EQ(exits[0], leg.exit) << leg.row;
    EXPECT_EQ(texels[1].x - texels[0].x, leg.dx) << leg.row;
    EXPECT_EQ(texels[1].y - texels[0].y, leg.dy) << leg.row;
  }
}

struct First {
  const char* row;
  LightPoint from, to;
  bool cross;
  int fraction;  // eighths are stored as quarters
};

// Slope 1/2. fr = My - Mx / 2 (x, +) and its likes; fr >= 0: fraction fr, else fr + slope.
const First kTable3[] = {
    {"x +, true: 6/8 - 4/16 = 4/8", {4, 6, 0}, {20, 14, 0}, false, 2},
    {"x +, false: 0 - 4/16 < 0, + 1/2 = 2/8", {4, 0, 0}, {20, 8, 0}, true, 1},
    {"x -, true: 6/8 - (1 - 4/8)/2 = 4/8", {4, 6, 0}, {-12, 14, 0}, false, 2},
    {"x -, false: 0 - (1 - 4/8)/2 < 0, + 1/2 = 2/8", {4, 0, 0}, {-12, 8, 0}, true, 1},
    {"y +, true: 6/8 - 4/16 = 4/8", {6, 4, 0}, {14, 20, 0}, false, 2},
    {"y +, false: 0 - 4/16 < 0, + 1/2 = 2/8", {0, 4, 0}, {8, 20, 0}, true, 1},
    {"y -, true: (1 - 2/8) - 4/16 = 4/8", {2, 4, 0}, {-6, 20, 0}, false, 2},
    {"y -, false: (1 - 7/8) - 4/16 < 0, + 1/2 = 3/8, ties up", {7, 4, 0}, {-1, 20, 0}, true, 2},
    {"x +, equal: 2/8 - 4/16 = 0 is true", {4, 2, 0}, {20, 10, 0}, false, 0},
};

TEST(EdgeWalker, Table3FirstTexelOfEveryKindOfLine) {
  for (const First& first : kTable3) {
    const OutlineTexel t = walk(first.from, first.to, 2).front();
    EXPECT_EQ(t.line.has(Line::kCross), first.cross) << first.row;
    EXPECT_EQ(t.line.fraction, first.fraction) << first.row;
    EXPECT_EQ(t.x, 0) << first.row;
    EXPECT_EQ(t.y, 0) << first.row;
  }
}

TEST(EdgeWalker, AnEdgeOnABorderBelongsToTheFloorSide) {
  for (const OutlineTexel& t : walk({8, 0, 0}, {8, 24, 0}, 2)) EXPECT_EQ(t.x, 1);
  for (const OutlineTexel& t : walk({0, 8, 0}, {24, 8, 0}, 2)) EXPECT_EQ(t.y, 1);
  EXPECT_EQ(walk({8, 0, 0}, {8, 24, 0}, 2).size(), 3u);
}

TEST(EdgeWalker, FractionSaturatesBelowOne) {
  // 7/8 of a texel in one bit: 1.75 rounds to 2 = 1.0, stored as 1/2.
  EXPECT_EQ(walk({0, 7, 0}, {40, 7, 0}, 1).front().line.fraction, 1);
}

TEST(EdgeWalker, LineWordsOfTheTwoTrianglesOfAnEdgeDifferInLeftAlone) {
  const LightPoint a{3, -17, 9}, b{-41, 22, 77};
  EdgeWalker one(setup_edge(a, b, {50, 0, 0}, kBits, 2), kBits, 2);
  EdgeWalker other(setup_edge(b, a, {-50, 0, 0}, kBits, 2), kBits, 2);
  for (;; one.step(), other.step()) {
    const OutlineTexel p = one.texel(), q = other.texel();
    ASSERT_EQ(p.x, q.x);
    ASSERT_EQ(p.y, q.y);
    EXPECT_EQ(p.nearest, q.nearest);
    EXPECT_EQ(p.line.fraction, q.line.fraction);
    EXPECT_EQ(p.line.slope, q.line.slope);
    EXPECT_EQ(p.line.flags ^ q.line.flags, Line::kLeft);
    ASSERT_EQ(one.last(), other.last());
    if (one.last()) break;
  }
}

}  // namespace
}  // namespace kagesen::unit

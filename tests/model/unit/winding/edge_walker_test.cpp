#include "model/unit/winding/edge_walker.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <utility>
#include <vector>

#include "model/unit/edge_walker.h"
#include "tests/model/unit/rational.h"

namespace kagesen::unit::winding {
namespace {

struct RationalPoint {
  Rational x = 0, y = 0;
};

/// One texel of an edge, by exact clipping and nothing else.
struct Piece {
  Rational enter = 0, leave = 1;  // along the edge
  bool stored = false;
  Segment segment;
};

/// > 0: q lies left of the direction from `from` to `to`.
Rational side(const LightPoint& from, const LightPoint& to, const RationalPoint& q) {
  return Rational(std::int64_t{to.x} - from.x) * (q.y - Rational(from.y)) -
         Rational(std::int64_t{to.y} - from.y) * (q.x - Rational(from.x));
}

struct Edge {
  Edge(LightPoint a, LightPoint b, LightPoint third, int texel_bits, int bits)
      : from(a), to(b), opposite(third), texel(std::int64_t{1} << texel_bits), end_bits(bits) {
    if (b.y < a.y || (b.y == a.y && b.x < a.x)) std::swap(from, to);
  }

  bool westward() const { return to.x < from.x; }
  RationalPoint at(Rational t) const {
    return {Rational(from.x) + t * (std::int64_t{to.x} - from.x),
            Rational(from.y) + t * (std::int64_t{to.y} - from.y)};
  }
  bool clip(std::int64_t a, std::int64_t b, std::int64_t index, Piece& p) const {
    if (a == b) return Rational(a, texel).floor() == index;
    Rational low(index * texel - a, b - a), high((index + 1) * texel - a, b - a);
    if (high < low) std::swap(low, high);
    p.enter = std::max(p.enter, low);
    p.leave = std::min(p.leave, high);
    return true;
  }
  /// Steps from the texel's corner, ties up; along x ties go the way the edge travels.
  std::int32_t snap(Rational value, std::int64_t index, bool mirrored) const {
    const std::int64_t one = std::int64_t{1} << end_bits;
    const Rational steps = (value - Rational(index * texel)) / texel * one;
    const std::int64_t out = mirrored ? one - (Rational(one) - steps + Rational(1, 2)).floor()
                                      : (steps + Rational(1, 2)).floor();
    return static_cast<std::int32_t>(out);
  }

  /// False where the edge does not run through the texel.
  bool piece(std::int64_t x, std::int64_t y, Piece& p) const {
    p = Piece{};
    if (!clip(from.x, to.x, x, p) || !clip(from.y, to.y, y, p) || !(p.enter < p.leave)) {
      return false;
    }
    const std::int64_t left = x * texel, low = y * texel;
    if ((from.x == to.x && from.x == left) || (from.y == to.y && from.y == low)) return true;
    RationalPoint end[2] = {at(p.enter), at(p.leave)};
    const auto on_left = [&](const RationalPoint& q) { return q.x == left && Rational(low) < q.y; };
    const bool crosses = on_left(end[0]) || on_left(end[1]);
    RationalPoint probe = end[0];  // its side tells the sign
    if (crosses) {
      if (on_left(end[1])) std::swap(end[0], end[1]);
      probe = {end[0].x, end[0].y + 1};  // above the crossing
    } else {
      probe = {probe.x + Rational(std::int64_t{to.y} - from.y),
               probe.y - Rational(std::int64_t{to.x} - from.x)};  // right of the edge
    }
    const RationalPoint third{opposite.x, opposite.y};
    const bool positive =
        (Rational(0) < side(from, to, probe)) == (Rational(0) < side(from, to, third));
    p.segment.x0 = snap(end[0].x, x, westward());
    p.segment.x1 = snap(end[1].x, x, westward());
    p.segment.y0 = snap(end[0].y, y, false);
    p.segment.y1 = snap(end[1].y, y, false);
    p.segment.flags =
        static_cast<std::uint8_t>(positive * Segment::kPositive + crosses * Segment::kCrossesLeft);
    p.stored = true;
    const bool dot = p.segment.x0 == p.segment.x1 && p.segment.y0 == p.segment.y1;
    if (dot && !crosses) p.segment.flags = 0;
    return true;
  }

  LightPoint from, to, opposite;
  std::int64_t texel;
  int end_bits;
};

bool equal(const Segment& a, const Segment& b) {
  return a.x0 == b.x0 && a.y0 == b.y0 && a.x1 == b.x1 && a.y1 == b.y1 && a.flags == b.flags;
}

testing::Message& operator<<(testing::Message& m, const LightPoint& p) {
  return m << '(' << p.x << ',' << p.y << ')';
}

/// Every texel's piece is that of exact clipping, and each goes on where the one before it ended.
void expect_exact(const LightPoint& a, const LightPoint& b, const LightPoint& opposite,
                  int texel_bits, int end_bits) {
  const Edge edge(a, b, opposite, texel_bits, end_bits);
  const unit::EdgeSetup setup = setup_edge(a, b, opposite, texel_bits, 1);
  unit::EdgeWalker paper(setup, texel_bits, 1);
  Rational reached = 0;
  testing::Message where;
  where << a << ' ' << b << " opposite " << opposite << ", bits " << texel_bits << ' ' << end_bits;
  for (EdgeWalker w(a, b, opposite, texel_bits, end_bits);; w.step(), paper.step()) {
    Piece expected;
    ASSERT_TRUE(edge.piece(w.x(), w.y(), expected)) << where << " not in " << w.x() << ',' << w.y();
    ASSERT_TRUE(expected.enter == reached) << where << ": jumps to " << w.x() << ',' << w.y();
    reached = expected.leave;
    ASSERT_TRUE(paper.texel().x == w.x() && paper.texel().y == w.y()) << where;
    ASSERT_EQ(paper.last(), w.last()) << where;
    Segment s;
    ASSERT_EQ(w.segment(s), expected.stored) << where << " in " << w.x() << ',' << w.y();
    const Segment& e = expected.segment;
    ASSERT_TRUE(!expected.stored || equal(s, e))
        << where << " in " << w.x() << ',' << w.y() << ": " << s.x0 << ',' << s.y0 << ' ' << s.x1
        << ',' << s.y1 << ' ' << int(s.flags) << " for " << e.x0 << ',' << e.y0 << ' ' << e.x1
        << ',' << e.y1 << ' ' << int(e.flags);
    if (w.last()) break;
  }
  ASSERT_TRUE(reached == 1) << where << ": stops early";
}

/// The other facet of the edge, written the other way round, cancels every piece.
void expect_opposed(const LightPoint& a, const LightPoint& b, int texel_bits, int end_bits) {
  const std::int32_t dx = b.x - a.x, dy = b.y - a.y;
  EdgeWalker one(a, b, {a.x + dy, a.y - dx, 0}, texel_bits, end_bits);
  EdgeWalker other(b, a, {b.x - dy, b.y + dx, 0}, texel_bits, end_bits);
  for (;; one.step(), other.step()) {
    Segment s, t;
    const bool stored = one.segment(s);
    ASSERT_EQ(stored, other.segment(t));
    ASSERT_TRUE(one.x() == other.x() && one.y() == other.y() && one.last() == other.last());
    s.flags |= Segment::kInner;
    t.flags |= Segment::kInner;
    ASSERT_TRUE(!stored || (s.dot() ? s.same_ends(t) : s.opposes(t)))
        << a.x << ',' << a.y << ' ' << b.x << ',' << b.y;
    if (one.last()) return;
  }
}

/// Rows without steps within them are those of the steps.
void expect_rows(const LightPoint& a, const LightPoint& b, int texel_bits) {
  EdgeWalker rows(a, b, a, texel_bits, texel_bits), steps = rows;
  for (;;) {
    std::int32_t low = 0, high = 0;
    rows.row(low, high);
    std::int32_t least = steps.x(), most = steps.x();
    const std::int32_t y = steps.y();
    ASSERT_EQ(rows.y(), y);
    bool ended = steps.last();
    while (!ended) {
      steps.step();
      if (steps.y() != y) break;
      least = std::min(least, steps.x());
      most = std::max(most, steps.x());
      ended = steps.last();
    }
    ASSERT_TRUE(low == least && high == most)
        << "row " << y << " of " << a.x << ',' << a.y << ' ' << b.x << ',' << b.y << ": " << low
        << ".." << high << " for " << least << ".." << most;
    ASSERT_EQ(rows.last_row(), ended);
    if (ended) return;
    rows.next_row();
  }
}

template <typename Check>
void every_edge(int reach, Check check) {
  for (int x0 = -reach; x0 <= reach; ++x0) {
    for (int y0 = -reach; y0 <= reach; ++y0) {
      for (int x1 = -reach; x1 <= reach; ++x1) {
        for (int y1 = -reach; y1 <= reach; ++y1) {
          if (x0 == x1 && y0 == y1) continue;
          check(LightPoint{x0, y0, 0}, LightPoint{x1, y1, 0});
          if (testing::Test::HasFatalFailure()) return;
        }
      }
    }
  }
}

TEST(WindingEdgeWalker, PiecesOfEverySmallEdgeAreThoseOfExactClipping) {
  for (int end_bits = 1; end_bits <= 2; ++end_bits) {
    every_edge(6, [&](const LightPoint& a, const LightPoint& b) {
      const std::int32_t dx = b.x - a.x, dy = b.y - a.y;
      expect_exact(a, b, {a.x + dy, a.y - dx, 0}, 2, end_bits);
      expect_exact(a, b, {a.x - dy + dx, a.y + dx + dy, 0}, 2, end_bits);
    });
  }
}

TEST(WindingEdgeWalker, EightUnitsATexel) {
  every_edge(9, [&](const LightPoint& a, const LightPoint& b) {
    expect_exact(a, b, {a.x + 40, a.y + 3, 0}, 3, 2);
  });
}

TEST(WindingEdgeWalker, BothFacetsOfAnEdgeGetOpposedPieces) {
  for (int end_bits = 1; end_bits <= 3; ++end_bits) {
    every_edge(
        7, [&](const LightPoint& a, const LightPoint& b) { expect_opposed(a, b, 3, end_bits); });
  }
}

TEST(WindingEdgeWalker, RowsAreThoseOfTheSteps) {
  every_edge(9, [&](const LightPoint& a, const LightPoint& b) { expect_rows(a, b, 2); });
}

TEST(WindingEdgeWalker, FullRangeOfCoordinatesAndScales) {
  std::mt19937_64 random(7);
  for (int i = 0; i < 300; ++i) {
    const int texel_bits = 16 + i % 11;
    const int end_bits = std::min(texel_bits, 2 + i % 18);
    // Extents from a unit to the whole range, and vertices on borders and corners.
    const int extent = 1 + static_cast<int>(random() % 28);
    const auto coordinate = [&](std::int32_t about) {
      const std::int64_t spread = std::int64_t{1} << extent;
      std::int64_t c = about + static_cast<std::int64_t>(random() % (2 * spread)) - spread;
      if (random() % 4 == 0) c &= -(std::int64_t{1} << texel_bits);
      return static_cast<std::int32_t>(std::clamp<std::int64_t>(c, kCoordinateMin, kCoordinateMax));
    };
    const auto anywhere = static_cast<std::int32_t>(random() % (1u << 28)) + kCoordinateMin;
    const LightPoint a{coordinate(anywhere), coordinate(anywhere / 3), 0};
    const LightPoint b{coordinate(a.x), coordinate(a.y), 0};
    const LightPoint c{coordinate(a.x), coordinate(a.y), 0};
    const std::int64_t area = (std::int64_t{b.x} - a.x) * (c.y - a.y) -
                              (std::int64_t{b.y} - a.y) * (std::int64_t{c.x} - a.x);
    if (area == 0) continue;
    expect_exact(a, b, c, texel_bits, end_bits);
    expect_rows(a, b, texel_bits);
    if (HasFatalFailure()) return;
  }
}

}  // namespace
}  // namespace kagesen::unit::winding

#include "model/unit/span_filler.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>
#include <utility>

#include "model/unit/edge_walker.h"
#include "tests/model/unit/rational.h"

namespace kagesen::unit {
namespace {

constexpr int kBits = 2;  // units a texel: 4
constexpr int kTexel = 1 << kBits;

std::int64_t turn(const LightPoint& a, const LightPoint& b, std::int64_t x, std::int64_t y) {
  return (std::int64_t{b.x} - a.x) * (y - a.y) - (std::int64_t{b.y} - a.y) * (x - a.x);
}

Caster counter_clockwise(Caster c) {
  if (turn(c.vertex[0], c.vertex[1], c.vertex[2].x, c.vertex[2].y) < 0)
    std::swap(c.vertex[1], c.vertex[2]);
  return c;
}

/// Do the insides of the triangle and of the texel's square meet? By separating axes.
bool insides_meet(const Caster& ccw, int i, int j) {
  const auto& v = ccw.vertex;
  const auto [x0, x1] = std::minmax({v[0].x, v[1].x, v[2].x});
  const auto [y0, y1] = std::minmax({v[0].y, v[1].y, v[2].y});
  const int left = i * kTexel, low = j * kTexel;
  if (x1 <= left || x0 >= left + kTexel || y1 <= low || y0 >= low + kTexel) return false;
  for (int e = 0; e < 3; ++e) {
    bool any = false;
    for (const int x : {left, left + kTexel}) {
      for (const int y : {low, low + kTexel}) any |= turn(v[e], v[(e + 1) % 3], x, y) > 0;
    }
    if (!any) return false;
  }
  return true;
}

bool wholly_covered(const Caster& ccw, int i, int j) {
  for (int e = 0; e < 3; ++e) {
    for (const int x : {i * kTexel, (i + 1) * kTexel}) {
      for (const int y : {j * kTexel, (j + 1) * kTexel}) {
        if (turn(ccw.vertex[e], ccw.vertex[(e + 1) % 3], x, y) < 0) return false;
      }
    }
  }
  return true;
}

using Texels = std::set<std::pair<int, int>>;

void draw(const Caster& c, Texels& visited, Texels& gaps) {
  const auto [low, high] = std::minmax({c.vertex[0].y, c.vertex[1].y, c.vertex[2].y});
  static VisitedRows rows;  // reused, as the unit does
  rows.begin(low >> kBits, high >> kBits);
  for (int i = 0; i < 3; ++i) {
    const EdgeSetup edge =
        setup_edge(c.vertex[i], c.vertex[(i + 1) % 3], c.vertex[(i + 2) % 3], kBits, 1);
    for (EdgeWalker w(edge, kBits, 1);; w.step()) {
      visited.insert({w.texel().x, w.texel().y});
      rows.visit(i, w.texel().x, w.texel().y);
      if (w.last()) break;
    }
  }
  rows.gaps([&](int y, int from, int to) {
    for (int x = from; x <= to; ++x) EXPECT_TRUE(gaps.insert({x, y}).second);
  });
}

/// Texels of the outline, and gaps between them: what the triangle meets, and what it covers.
void expect_partition(const Caster& caster) {
  Texels visited, gaps;
  draw(caster, visited, gaps);
  const Caster ccw = counter_clockwise(caster);
  const auto name = [&](int i, int j) {
    std::string out = std::to_string(i) + ',' + std::to_string(j) + " of";
    for (const LightPoint& v : caster.vertex)
      out += " (" + std::to_string(v.x) + ',' + std::to_string(v.y) + ')';
    return out;
  };
  for (int i = -4; i <= 3; ++i) {
    for (int j = -4; j <= 3; ++j) {
      const bool seen = visited.count({i, j}) != 0, gap = gaps.count({i, j}) != 0;
      ASSERT_EQ(gap, insides_meet(ccw, i, j) && !seen) << name(i, j);
      ASSERT_TRUE(!gap || wholly_covered(ccw, i, j)) << name(i, j);
      // Covered and yet visited: an edge runs along its border, on its floor side.
      if (seen && wholly_covered(ccw, i, j)) {
        bool along = false;
        for (int e = 0; e < 3; ++e) {
          const LightPoint &a = ccw.vertex[e], &b = ccw.vertex[(e + 1) % 3];
          along |= (a.x == b.x && a.x == i * kTexel) || (a.y == b.y && a.y == j * kTexel);
          along |= a.x % kTexel == 0 && a.y % kTexel == 0;  // a vertex on its corner
          along |= turn(a, b, i * kTexel, j * kTexel) == 0 ||
                   turn(a, b, (i + 1) * kTexel, j * kTexel) == 0;
        }
        ASSERT_TRUE(along) << name(i, j);
      }
    }
  }
}

TEST(SpanFiller, OutlineAndGapsAreWhatEverySmallTriangleMeetsAndCovers) {
  // Over three texels a side; every position of two vertices, the third thinned.
  const auto point = [](int n) { return LightPoint{n % 13 - 6, n / 13 - 6, 0}; };
  for (int a = 0; a < 169; ++a) {
    for (int b = a + 1; b < 169; ++b) {
      for (int c = b + 1 + (a + b) % 3; c < 169; c += 3) {
        const Caster caster{{point(a), point(b), point(c)}, 0, 0};
        if (Polygon(caster, kBits).degenerate()) continue;
        expect_partition(caster);
        if (HasFatalFailure()) return;
      }
    }
  }
}

/// The corner moved by a real (e^2, e), e = 1/1000, on coordinates so small that it is tiny.
bool covers_moved_corner(const Caster& ccw, int i, int j) {
  constexpr std::int64_t kScale = 1000000;
  const auto big = [](const LightPoint& p, std::int64_t* out) {
    out[0] = p.x * kScale;
    out[1] = p.y * kScale;
  };
  const std::int64_t x = i * kTexel * kScale + 1, y = j * kTexel * kScale + 1000;
  int above = 0;  // crossings of the ray towards +y from the point
  for (int e = 0; e < 3; ++e) {
    std::int64_t a[2], b[2];
    big(ccw.vertex[e], a);
    big(ccw.vertex[(e + 1) % 3], b);
    if ((a[0] < x) == (b[0] < x)) continue;
    const Rational height =
        Rational(a[1]) + Rational(b[1] - a[1]) * Rational(x - a[0], b[0] - a[0]);
    above += Rational(y) < height;
  }
  return above % 2 == 1;
}

TEST(Polygon, CornerIsCoveredAsIfItWereMoved) {
  const auto point = [](int n) { return LightPoint{n % 11 - 5, n / 11 - 5, 0}; };
  for (int a = 0; a < 121; ++a) {
    for (int b = 0; b < 121; b += 1 + a % 2) {
      for (int c = (a + b) % 5; c < 121; c += 5) {
        const Caster caster{{point(a), point(b), point(c)}, 0, 0};
        const Polygon polygon(caster, kBits);
        if (polygon.degenerate()) continue;
        for (int i = -1; i <= 1; ++i) {
          for (int j = -1; j <= 1; ++j) {
            ASSERT_EQ(polygon.covers_corner(i, j), covers_moved_corner(caster, i, j))
                << i << ',' << j << " of " << a << ' ' << b << ' ' << c;
          }
        }
      }
    }
  }
}

/// Depth of the triangle's plane at a point in half units.
Rational plane_depth(const Caster& c, std::int64_t x2, std::int64_t y2) {
  const auto& v = c.vertex;
  Rational sum = 0;
  for (int i = 0; i < 3; ++i) {
    const LightPoint &a = v[(i + 1) % 3], &b = v[(i + 2) % 3];
    const std::int64_t weight =
        std::int64_t{b.x - a.x} * (y2 - 2 * a.y) - std::int64_t{b.y - a.y} * (x2 - 2 * a.x);
    sum = sum + Rational(weight) * std::int64_t{v[i].z};
  }
  return sum / (turn(v[0], v[1], v[2].x, v[2].y) * 2);
}

TEST(Polygon, DepthIsTheFloorOfThePlaneAtTheTexelsCentre) {
  std::mt19937 random(1);
  for (int n = 0; n < 3000; ++n) {
    Caster c;
    for (LightPoint& v : c.vertex)
      v = {int(random() % 41) - 20, int(random() % 41) - 20, std::uint32_t(random() % 1000)};
    const Polygon polygon(c, kBits);
    if (polygon.degenerate()) continue;
    const auto [least, most] = std::minmax({c.vertex[0].z, c.vertex[1].z, c.vertex[2].z});
    for (int j = -3; j <= 3; ++j) {
      ExactRamp ramp = polygon.centre_ramp(-3, j);
      for (int i = -3; i <= 3; ++i, ramp.advance()) {
        const std::int64_t x2 = i * 2 * kTexel + kTexel, y2 = j * 2 * kTexel + kTexel;
        const std::int64_t exact = plane_depth(c, x2, y2).floor();
        ASSERT_EQ(ramp.whole, exact);
        const auto clamped = static_cast<std::uint32_t>(
            std::clamp<std::int64_t>(exact, std::int64_t{least}, std::int64_t{most}));
        ASSERT_EQ(polygon.centre_depth(i, j), clamped);
        Rational far = 0;
        for (const int dx : {-kTexel, kTexel}) {
          for (const int dy : {-kTexel, kTexel})
            far = std::max(far, plane_depth(c, x2 + dx, y2 + dy));
        }
        if (exact != clamped) continue;
        // Stored depths are floors too: a bound of the floor is enough.
        ASSERT_GE(polygon.farthest(clamped), std::min<std::int64_t>(far.floor(), most));
        ASSERT_LE(polygon.farthest(clamped), std::min<std::int64_t>(far.floor() + 1, most));
      }
    }
  }
}

TEST(Polygon, AStraightLineIsDegenerate) {
  EXPECT_TRUE(Polygon({{{0, 0, 1}, {4, 8, 2}, {8, 16, 3}}, 0, 0}, kBits).degenerate());
  EXPECT_FALSE(Polygon({{{0, 0, 1}, {4, 8, 2}, {8, 17, 3}}, 0, 0}, kBits).degenerate());
}

TEST(Polygon, TakesTheWidestSliver) {
  // A plane that leaves 64 bits far from the sliver; the sanitizers watch.
  const Caster c{{{kCoordinateMin, kCoordinateMin, 0},
                  {kCoordinateMax, kCoordinateMax, kDepthMax},
                  {kCoordinateMax, kCoordinateMax - 1, 0}},
                 0,
                 0};
  const Polygon polygon(c, kMinFractionBits);
  EXPECT_LE(polygon.centre_depth(2047, -2048), kDepthMax);
  EXPECT_EQ(polygon.farthest(kDepthMax - 1), kDepthMax);
}

}  // namespace
}  // namespace kagesen::unit

// What points learn of stored segments, against the exact outlines.
#include "model/unit/winding/segment.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <utility>

#include "model/reference/triangle.h"
#include "tests/model/unit/rational.h"
#include "tests/model/unit/winding/region.h"

namespace kagesen::unit::winding {
namespace {

/// Does a-b meet the closed square of side 2^shift * `sides` round p? By clipping, exactly.
bool meets_square(const LightPoint& a, const LightPoint& b, const Place& p, int shift, int sides) {
  const Rational half(std::int64_t{sides} << shift, 2);
  Rational enter = 0, leave = 1;
  const auto clip = [&](std::int64_t from, std::int64_t to, std::int64_t centre) {
    Rational low = Rational(centre - from) - half, high = Rational(centre - from) + half;
    if (from == to) return low <= 0 && Rational(0) <= high;
    low = low / (to - from);
    high = high / (to - from);
    if (high < low) std::swap(low, high);
    enter = std::max(enter, low);
    leave = std::min(leave, high);
    return true;
  };
  return clip(a.x, b.x, p.x) && clip(a.y, b.y, p.y) && enter <= leave;
}
bool outline_meets_square(const std::vector<Caster>& casters, const Place& p, int shift,
                          int sides) {
  for (const Caster& c : casters) {
    for (int i = 0; i < 3; ++i) {
      if (meets_square(c.vertex[i], c.vertex[(i + 1) % 3], p, shift, sides)) return true;
    }
  }
  return false;
}

bool strictly_inside(const Caster& c, const Place& p) {
  const Weights w = weights_at(c, int(p.x), int(p.y));
  return w.inside() && w.w0 != 0 && w.w1 != 0 && w.w2 != 0;
}
bool covered(const Caster& c, const Place& p) { return weights_at(c, int(p.x), int(p.y)).inside(); }

std::string text(const std::vector<Caster>& casters, const Place& p, int end_bits) {
  std::string out;
  for (const Caster& c : casters) {
    for (const LightPoint& v : c.vertex) {
      out += "(" + std::to_string(v.x) + "," + std::to_string(v.y) + ")";
    }
    out += " ";
  }
  return out + "at " + std::to_string(p.x) + "," + std::to_string(p.y) + ", end bits " +
         std::to_string(end_bits);
}

/// Checks every point of the texel at the origin.
/// - Where no outline passes within half a step, the winding number is the number of triangles.
/// - Every point within a triangle is inside, where all pieces are kept.
/// - No point is inside that is more than a step an axis, so sqrt(2) steps, from all triangles.
void expect_bounds(const std::vector<Caster>& casters, int texel_bits, int end_bits) {
  Region kept, cancelled;
  for (const Caster& c : casters) {
    kept.add(c, 0, 0, texel_bits, end_bits, false);
    cancelled.add(c, 0, 0, texel_bits, end_bits, true);
  }
  const int shift = texel_bits - end_bits;
  for (Place p{0, 0}; p.y < 1 << texel_bits; ++p.y) {
    for (p.x = 0; p.x < 1 << texel_bits; ++p.x) {
      int exact = 0;
      bool any = false;
      for (const Caster& c : casters) {
        exact += strictly_inside(c, p);
        any = any || covered(c, p);
      }
      const Crossing all = kept.at(p, shift), rest = cancelled.at(p, shift);
      ASSERT_EQ(all.winding, rest.winding) << text(casters, p, end_bits);
      if (all.winding != exact || rest.near != all.near) {
        ASSERT_TRUE(all.winding == exact || outline_meets_square(casters, p, shift, 1))
            << all.winding << " for " << exact << " by " << text(casters, p, end_bits);
        ASSERT_TRUE(all.near || !rest.near);
      }
      const bool inside = all.near || all.winding > 0;
      if (exact > 0 && !kept.left_out) {
        ASSERT_TRUE(inside) << text(casters, p, end_bits);
      }
      if (inside && !any) {
        ASSERT_TRUE(outline_meets_square(casters, p, shift, 2)) << text(casters, p, end_bits);
      }
    }
  }
}

TEST(WindingSegment, EveryTriangleInAndAroundASmallTexel) {
  constexpr int kFirst = -1, kSide = 7;  // texel: 4 x 4 units
  const auto point = [](int n) { return LightPoint{kFirst + n % kSide, kFirst + n / kSide, 0}; };
  for (int end_bits = 1; end_bits <= 2; ++end_bits) {
    for (int a = 0; a < kSide * kSide; ++a) {
      for (int b = 0; b < a; ++b) {
        for (int c = 0; c < b; ++c) {
          expect_bounds({{{point(a), point(b), point(c)}, 0, 0}}, 2, end_bits);
          if (HasFatalFailure()) return;
        }
      }
    }
  }
}

TEST(WindingSegment, SumsOverSeveralTriangles) {
  std::mt19937 random(11);
  for (int run = 0; run < 4000; ++run) {
    const int texel_bits = 4, end_bits = 1 + run % 4;
    const int grid = 1 << random() % 3;
    std::vector<LightPoint> points(5);  // shared vertices and edges
    for (LightPoint& p : points) {
      const auto coordinate = [&] { return (int(random() % 41) - 12) / grid * grid; };
      p = {coordinate(), coordinate(), 0};
    }
    std::vector<Caster> casters(2 + random() % 5);
    for (Caster& c : casters) {
      std::shuffle(points.begin(), points.end(), random);
      c = {{points[0], points[1], points[2]}, 0, 0};
    }
    expect_bounds(casters, texel_bits, end_bits);
    if (HasFatalFailure()) return;
  }
}

/// Two triangles beside an edge, one of them split at points of that edge: nothing opens there,
/// though the pieces of one side are not those of the other.
TEST(WindingSegment, TJunctionsStayClosed) {
  std::mt19937 random(5);
  int junctions = 0;
  for (int run = 0; run < 20000; ++run) {
    const int texel_bits = 5, end_bits = 1 + run % 5, shift = texel_bits - end_bits;
    const auto coordinate = [&] { return int(random() % 80) - 24; };
    const LightPoint a{coordinate(), coordinate(), 0};
    const int steps = 2 + int(random() % 4);
    const int dx = int(random() % 31) - 15, dy = int(random() % 31) - 15;
    const LightPoint b{a.x + steps * dx, a.y + steps * dy, 0};
    const LightPoint c{coordinate(), coordinate(), 0}, d{coordinate(), coordinate(), 0};
    if (edge_function(a, b, c.x, c.y) <= 0 || edge_function(a, b, d.x, d.y) >= 0) continue;
    std::vector<Caster> casters{{{a, b, c}, 0, 0}};
    LightPoint last = a;
    for (int i = 1; i <= steps; ++i) {
      const LightPoint next{a.x + i * dx, a.y + i * dy, 0};
      casters.push_back({{last, next, d}, 0, 0});
      last = next;
    }
    ++junctions;
    Region region;
    for (const Caster& t : casters) region.add(t, 0, 0, texel_bits, end_bits, true);
    const std::pair<LightPoint, LightPoint> outer[] = {{a, c}, {c, b}, {b, d}, {d, a}};
    for (Place p{0, 0}; p.y < 1 << texel_bits; ++p.y) {
      for (p.x = 0; p.x < 1 << texel_bits; ++p.x) {
        if (region.inside(p, shift)) continue;
        const bool any = std::any_of(casters.begin(), casters.end(),
                                     [&](const Caster& t) { return covered(t, p); });
        if (!any) continue;
        const bool at_boundary = std::any_of(
            std::begin(outer), std::end(outer),
            [&](const auto& e) { return meets_square(e.first, e.second, p, shift, 1); });
        ASSERT_TRUE(at_boundary) << text(casters, p, end_bits);
      }
    }
  }
  EXPECT_GT(junctions, 3000);
}

TEST(WindingSegment, OpposedSegmentsAddUpToNothing) {
  std::mt19937 random(3);
  for (int run = 0; run < 20000; ++run) {
    const int shift = int(random() % 3);
    const auto end = [&] { return int(random() % 9); };
    Segment s{end(), end(), end(), end(), std::uint8_t(random() % 4 | Segment::kInner)}, t = s;
    if (s.crosses_left()) s.x0 = t.x0 = 0;
    t.flags ^= Segment::kPositive;
    ASSERT_TRUE(s.opposes(t) && t.opposes(s) && !s.opposes(s));
    Segment outer = s, needle = t;  // sides of a needle, as equal, stay
    outer.flags ^= Segment::kInner;
    needle.flags ^= Segment::kInner;
    ASSERT_FALSE(outer.opposes(needle) || outer.opposes(t) || s.opposes(needle));
    const Place p{std::int64_t(random() % (8u << shift)), std::int64_t(random() % (8u << shift))};
    const Crossing one = crossing(s, p, shift), other = crossing(t, p, shift);
    ASSERT_EQ(one.winding + other.winding, 0);
    ASSERT_EQ(one.near, other.near);
  }
}

/// Near: the closed square of one step round the point meets the segment.
TEST(WindingSegment, NearIsASquareOfOneStep) {
  for (int shift = 0; shift <= 2; ++shift) {
    for (int n = 0; n < 625; ++n) {
      const Segment s{n % 5, n / 5 % 5, n / 25 % 5, n / 125, 0};
      const LightPoint a{s.x0 << shift, s.y0 << shift, 0}, b{s.x1 << shift, s.y1 << shift, 0};
      for (Place p{0, 0}; p.y < 4 << shift; ++p.y) {
        for (p.x = 0; p.x < 4 << shift; ++p.x) {
          ASSERT_EQ(crossing(s, p, shift).near, meets_square(a, b, p, shift, 1))
              << n << ' ' << p.x << ',' << p.y << " shift " << shift;
        }
      }
    }
  }
}

}  // namespace
}  // namespace kagesen::unit::winding

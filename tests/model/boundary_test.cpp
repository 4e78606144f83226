#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "model/reference/open_edges.h"
#include "tests/model/random_casters.h"

namespace kagesen {
namespace {

constexpr Semantics kBoth[] = {Semantics::kPaper, Semantics::kPhysical};
constexpr double kInfinite = std::numeric_limits<double>::infinity();

bool relevant(const Caster& c, std::uint32_t object, Semantics s) {
  return s == Semantics::kPhysical || c.object != object;
}

/// dark() at any point, in doubles, by trying every caster.
bool dark_at(const std::vector<Caster>& casters, double x, double y, double z, std::uint32_t object,
             Semantics s) {
  for (const Caster& c : casters) {
    if (!relevant(c, object, s)) continue;
    double w[3], area = 0, depth = 0;
    for (int i = 0; i < 3; ++i) {
      const LightPoint &a = c.vertex[(i + 1) % 3], &b = c.vertex[(i + 2) % 3];
      w[i] = (double(b.x) - a.x) * (y - a.y) - (double(b.y) - a.y) * (x - a.x);
      area += w[i];
      depth += w[i] * (c.vertex[i].z - z);
    }
    if (area == 0) continue;
    const double sign = area > 0 ? 1 : -1;
    if (sign * w[0] >= 0 && sign * w[1] >= 0 && sign * w[2] >= 0 && sign * depth < 0) return true;
  }
  return false;
}

/// Nearest change of the verdict, by walking every edge and every depth line of every relevant
/// caster in small steps and looking at both sides. Knows nothing of trees, shared edges or
/// intervals.
double sampled_distance(const std::vector<Caster>& casters, const LightPoint& p,
                        std::uint32_t object, Semantics s, double limit) {
  double best = limit;
  auto walk = [&](std::array<double, 2> a, std::array<double, 2> b) {
    const double length = std::hypot(b[0] - a[0], b[1] - a[1]);
    if (length == 0) return;
    const double nx = (b[1] - a[1]) / length / 64, ny = -(b[0] - a[0]) / length / 64;
    const int steps = int(length * 4) + 4;
    for (int i = 0; i <= steps; ++i) {
      const double x = a[0] + (b[0] - a[0]) * i / steps, y = a[1] + (b[1] - a[1]) * i / steps;
      const double distance = std::hypot(x - p.x, y - p.y);
      if (distance >= best) continue;
      if (dark_at(casters, x + nx, y + ny, p.z, object, s) !=
          dark_at(casters, x - nx, y - ny, p.z, object, s)) {
        best = distance;
      }
    }
  };
  for (const Caster& c : casters) {
    if (!relevant(c, object, s) || doubled_area(c) == 0) continue;
    std::vector<std::array<double, 2>> cut;
    for (int i = 0; i < 3; ++i) {
      const LightPoint &a = c.vertex[i], &b = c.vertex[(i + 1) % 3];
      walk({double(a.x), double(a.y)}, {double(b.x), double(b.y)});
      if ((a.z < p.z) == (b.z < p.z)) continue;
      const double t = (double(p.z) - a.z) / (double(b.z) - a.z);
      cut.push_back({a.x + t * (double(b.x) - a.x), a.y + t * (double(b.y) - a.y)});
    }
    if (cut.size() == 2) walk(cut[0], cut[1]);
  }
  return best;
}

/// A jittered height field of `side` x `side` points 12 units apart: almost every edge is shared.
std::vector<Caster> height_field(int side, Generator& g) {
  std::vector<LightPoint> grid;
  for (int j = 0; j < side; ++j) {
    for (int i = 0; i < side; ++i) {
      grid.push_back({std::int32_t(12 * i - 6 * side + 6 + g.in(-4, 4)),
                      std::int32_t(12 * j - 6 * side + 6 + g.in(-4, 4)),
                      std::uint32_t(g.in(100, 140))});
    }
  }
  std::vector<Caster> casters;
  for (int j = 0; j + 1 < side; ++j) {
    for (int i = 0; i + 1 < side; ++i) {
      const LightPoint* p = &grid[std::size_t(j * side + i)];
      casters.push_back({{p[0], p[1], p[side]}, 0, 0});
      casters.push_back({{p[side], p[1], p[side + 1]}, 0, 0});
    }
  }
  return casters;
}

/// Triangles some tens of units in size: every kind of overlap, and small enough to sample.
std::vector<Caster> small_scene(std::size_t count, std::uint64_t seed, bool mesh) {
  Generator g(seed);
  std::vector<Caster> casters;
  if (mesh) casters = height_field(7, g);
  for (std::size_t i = 0; i < count; ++i) {
    Caster c;
    const LightPoint centre = g.point(-30, 30, 90, 150);
    for (auto& v : c.vertex) v = g.near(centre, g.in(4, 30), 20);
    c.object = std::uint32_t(g.in(0, 2));
    casters.push_back(c);
  }
  return casters;
}

TEST(Boundary, DistanceAgreesWithSampling) {
  std::size_t dark = 0, lit = 0;
  for (std::uint64_t seed = 1; seed <= 24; ++seed) {
    const auto casters = small_scene(seed % 3 ? 4 + seed : 3, seed, seed % 2 == 0);
    const ExactReference reference(casters);
    Generator g(seed);
    for (int i = 0; i < 12; ++i) {
      const LightPoint p = g.point(-40, 40, 80, 160);
      const auto object = std::uint32_t(g.in(0, 3));
      for (Semantics s : kBoth) {
        const double limit = i % 4 ? 200 : 5;
        const double expected = sampled_distance(casters, p, object, s, 200);
        const double got = reference.boundary_distance(p, object, s, limit);
        const bool is_dark = reference.dark(p, object, s);
        ASSERT_NEAR(got, std::min(expected, limit), 1.0)
            << "seed " << seed << " at " << p.x << ' ' << p.y << ' ' << p.z
            << (is_dark ? " dark" : " lit");
        if (expected < limit) ++(is_dark ? dark : lit);
        for (double radius : {0.5, 3.0, 17.0, 60.0}) {
          if (expected > radius + 1) {
            ASSERT_FALSE(reference.in_band(p, object, s, radius)) << radius;
          }
        }
      }
    }
  }
  EXPECT_GT(dark, 100u);
  EXPECT_GT(lit, 100u);
}

/// In the middle of a mesh there are only depth lines, in a tree many levels deep.
TEST(Boundary, DepthLinesOfAMesh) {
  Generator g(5);
  const auto casters = height_field(60, g);
  const ExactReference reference(casters);
  std::size_t found = 0;
  for (int i = 0; i < 40; ++i) {
    const LightPoint p = g.point(-300, 300, 98, 142);
    const double expected = sampled_distance(casters, p, 1, Semantics::kPaper, 12);
    ASSERT_NEAR(reference.boundary_distance(p, 1, Semantics::kPaper, 12), expected, 1);
    found += expected < 12;
  }
  EXPECT_GT(found, 20u);
}

/// A point of the other verdict can never be nearer than the distance.
TEST(Boundary, NoOtherVerdictIsNearer) {
  for (Soup soup : {Soup::kTiny, Soup::kDegenerate, Soup::kConcentrated}) {
    for (std::uint64_t seed = 1; seed <= 12; ++seed) {
      const auto casters = random_soup(soup, seed % 2 ? 5 : 50, seed);
      const ExactReference reference(casters);
      Generator g(seed);
      for (int i = 0; i < 20; ++i) {
        const LightPoint p = random_query(casters, g);
        const auto object = std::uint32_t(g.in(0, 4));
        for (Semantics s : kBoth) {
          const double distance = reference.boundary_distance(p, object, s, 12);
          const bool dark = reference.dark(p, object, s);
          if (distance >= 12) {
            ASSERT_FALSE(reference.in_band(p, object, s, 11));
          }
          for (int dy = -12; dy <= 12; ++dy) {
            for (int dx = -12; dx <= 12; ++dx) {
              if (std::hypot(dx, dy) >= distance - 0.02) continue;
              ASSERT_EQ(reference.dark({p.x + dx, p.y + dy, p.z}, object, s), dark)
                  << "soup " << int(soup) << " seed " << seed << " distance " << distance;
            }
          }
        }
      }
    }
  }
}

TEST(Boundary, KnownDistances) {
  // Two triangles of one object make a square of 2,000; a third object covers its right border.
  const LightPoint a{-1000, -1000, 50}, b{1000, -1000, 50}, c{1000, 1000, 50}, d{-1000, 1000, 50};
  const std::vector<Caster> casters = {{{a, b, c}, 0, 0},
                                       {{a, c, d}, 0, 1},
                                       {{{900, -5000, 60}, {3000, 0, 60}, {900, 5000, 60}}, 1, 2}};
  const ExactReference reference(casters);
  const LightPoint p{500, 0, 100};
  EXPECT_NEAR(reference.boundary_distance(p, 9, Semantics::kPaper, 1e6), 1000,
              0.1);  // the upper border
  EXPECT_NEAR(reference.boundary_distance(p, 1, Semantics::kPaper, 1e6), 500, 0.1);
  EXPECT_NEAR(reference.boundary_distance(p, 0, Semantics::kPaper, 1e6), 400, 0.1);  // lit: outside
  EXPECT_EQ(reference.boundary_distance(p, 9, Semantics::kPaper, 300), 300);
  EXPECT_TRUE(reference.in_band(p, 9, Semantics::kPaper, 1001));
  EXPECT_FALSE(reference.in_band(p, 9, Semantics::kPaper, 999));
  EXPECT_FALSE(reference.in_band({500, 0, 50}, 1, Semantics::kPaper, 1e6));
  EXPECT_EQ(reference.boundary_distance({500, 0, 50}, 1, Semantics::kPaper, 1e6), 1e6);
}

TEST(Boundary, DepthLinesCount) {
  // A ramp from depth 0 at x = 0 to 1000 at x = 1000: at depth 400 only its first 400 units shadow.
  const std::vector<Caster> casters = {{{{0, -90'000, 0}, {0, 90'000, 0}, {1000, 0, 1000}}, 0, 0}};
  const ExactReference reference(casters);
  EXPECT_NEAR(reference.boundary_distance({300, 0, 400}, 1, Semantics::kPaper, 1e6), 100, 0.1);
  EXPECT_NEAR(reference.boundary_distance({700, 0, 400}, 1, Semantics::kPaper, 1e6), 300, 0.1);
  EXPECT_NEAR(reference.boundary_distance({-40, 0, 400}, 1, Semantics::kPaper, 1e6), 40, 0.1);
  EXPECT_EQ(reference.boundary_distance({400, 0, 400}, 1, Semantics::kPaper, 1e6), 0);
}

TEST(Boundary, ContactDistanceLooksAtTheNearestSurface) {
  const LightPoint a{0, 0, 50}, b{100, 0, 50}, c{0, 100, 50};
  std::vector<Caster> casters = {{{a, b, c}, 0, 0}, {{a, b, c}, 1, 1}};
  for (auto& v : casters[1].vertex) v.z = 80;
  const ExactReference reference(casters);
  EXPECT_EQ(reference.contact_distance({10, 10, 90}, 5, Semantics::kPaper), 40);
  EXPECT_EQ(reference.contact_distance({10, 10, 90}, 0, Semantics::kPaper), 10);
  EXPECT_EQ(reference.contact_distance({10, 10, 45}, 0, Semantics::kPhysical), 5);
  EXPECT_EQ(reference.contact_distance({90, 90, 45}, 0, Semantics::kPhysical), kInfinite);
}

TEST(OpenEdges, SharedEdgesCloseOnlyFromBothSides) {
  const LightPoint a{0, 0, 1}, b{10, 0, 2}, c{0, 10, 3}, d{10, 10, 4}, e{-10, -10, 5},
      middle{5, 5, 6};
  EXPECT_EQ(find_open_edges({{{a, b, c}, 0, 0}}), (std::vector<std::uint8_t>{7}));
  EXPECT_EQ(find_open_edges({{{a, b, c}, 0, 0}, {{d, c, b}, 0, 0}}),
            (std::vector<std::uint8_t>{5, 5}));
  EXPECT_EQ(find_open_edges({{{a, b, c}, 0, 0}, {{d, c, b}, 1, 0}}),
            (std::vector<std::uint8_t>{7, 7}));
  EXPECT_EQ(find_open_edges({{{a, b, c}, 0, 0}, {{e, c, b}, 0, 0}}),
            (std::vector<std::uint8_t>{7, 7}));
  LightPoint deeper = b;
  deeper.z = 9;
  EXPECT_EQ(find_open_edges({{{a, b, c}, 0, 0}, {{d, c, deeper}, 0, 0}}),
            (std::vector<std::uint8_t>{7, 7}));
  // Without area: closes nothing, has nothing.
  EXPECT_EQ(find_open_edges({{{a, b, c}, 0, 0}, {{b, c, middle}, 0, 0}}),
            (std::vector<std::uint8_t>{7, 0}));
}

// A tilted plate, and a point on it: the plate's own depth line passes through, its edges are far.
TEST(Boundary, TheBandLeavesOutTheDepthLineOfATiltedSurface) {
  const std::vector<Caster> plate = {
      {{{-1000, -1000, 0}, {3000, -1000, 4000}, {-1000, 3000, 0}}, 1, 0}};
  const ExactReference reference(plate);
  const LightPoint on_plate{0, 0, 1000};
  EXPECT_LT(reference.boundary_distance(on_plate, 1, Semantics::kPhysical, 10), 1);
  EXPECT_FALSE(reference.in_band(on_plate, 1, Semantics::kPhysical, 10));
  EXPECT_TRUE(reference.in_band(on_plate, 1, Semantics::kPhysical, 1001));
}

/// On both sides of a straight edge the band ends at its width.
TEST(Boundary, TheBandIsAsWideAsItsRadius) {
  const std::vector<Caster> half_plane = {
      {{{0, -100'000, 10}, {0, 100'000, 10}, {-100'000, 0, 10}}, 1, 0}};
  const ExactReference reference(half_plane);
  for (int x = -60; x <= 60; ++x) {
    if (std::abs(x) == 20) continue;
    EXPECT_EQ(reference.in_band({x, 7, 50}, 2, Semantics::kPaper, 20), std::abs(x) < 20) << x;
  }
}

/// How far one looks does not change what is found: also where an open edge runs along the borders
/// of the tree's nodes, and the nodes beside it are covered all over.
TEST(Boundary, AnEdgeOnTheBordersOfNodesIsFoundAtAnyLimit) {
  constexpr std::int32_t kSide = 1 << 16;
  std::vector<Caster> casters{{{{0, 0, 100}, {kSide, 0, 100}, {0, kSide, 100}}, 0, 0},
                              {{{0, -kSide, 900}, {9, -kSide, 900}, {0, 9 - kSide, 900}}, 0, 0}};
  Generator g(3);
  for (int i = 0; i < 400; ++i) {  // makes nodes small
    const LightPoint at = g.point(0, kSide / 2, 500, 900);
    casters.push_back({{g.near(at, 900, 9), g.near(at, 900, 9), g.near(at, 900, 9)}, 0, 0});
  }
  const ExactReference reference(casters);
  for (std::int32_t x = 100; x < kSide; x += 997) {
    const LightPoint p{x, -50, 200};
    for (const double limit : {60.0, 100.0, 500.0, 4000.0, 60'000.0}) {
      ASSERT_NEAR(reference.boundary_distance(p, 1, Semantics::kPhysical, limit), 50, 1)
          << x << ", limit " << limit;
    }
  }
}

}  // namespace
}  // namespace kagesen

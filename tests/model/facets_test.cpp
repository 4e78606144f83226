// Groups of facets: meshes whose groups are known by hand, and what holds for any.
#include "model/facets.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <bitset>
#include <boost/multiprecision/cpp_int.hpp>
#include <tuple>

#include "tests/model/random_meshes.h"

namespace kagesen {
namespace {

using Rational = boost::multiprecision::cpp_rational;

constexpr std::uint32_t kBits = 16;
constexpr std::int32_t kT = 1 << kBits;     // units a texel
constexpr std::int32_t kRadius = kT / 256;  // at 8 fraction bits

Caster triangle(LightPoint a, LightPoint b, LightPoint c, std::uint32_t object = 0) {
  return {{a, b, c}, object, 0};
}

FacetGroups group(const std::vector<Caster>& casters, std::int64_t tolerance) {
  UnitConfig config;
  config.plane_tolerance = tolerance;
  return group_facets(casters, kBits, config);
}

std::vector<std::uint32_t> planes_of(const FacetGroups& groups) {
  std::vector<std::uint32_t> out;
  for (const Facet& f : groups.facets) out.push_back(f.plane);
  return out;
}
std::vector<int> inner_of(const FacetGroups& groups) {
  std::vector<int> out;
  for (const Facet& f : groups.facets) out.push_back(f.inner_edges);
  return out;
}
constexpr std::uint32_t kOwn = Facet::kOwnPlane;
using Planes = std::vector<std::uint32_t>;
using Inner = std::vector<int>;

auto as_tuple(const LightPoint& p) { return std::tie(p.x, p.y, p.z); }
bool same_vertices(const Caster& a, const Caster& b) {
  for (int i = 0; i < 3; ++i) {
    if (as_tuple(a.vertex[i]) != as_tuple(b.vertex[i])) return false;
  }
  return true;
}

// Two neighbours: a large one left of the line x = 0, and one right of it that reaches to x =
// width.
const LightPoint kLow{0, 0, 1000}, kHigh{0, 4 * kT, 1000}, kFarLeft{-8 * kT, 0, 1000};
std::vector<Caster> pair(std::int32_t width, std::uint32_t z) {
  return {triangle(kLow, kHigh, kFarLeft), triangle(kHigh, kLow, {width, 2 * kT, z})};
}

TEST(Facets, AQuadIsOneGroup) {
  const LightPoint a{0, 0, 500}, b{kT, 0, 600}, c{kT, kT, 900}, d{0, kT, 800};
  const FacetGroups g = group({triangle(a, b, c), triangle(c, d, a)}, 0);
  EXPECT_EQ(planes_of(g), (Planes{0, 0}));
  EXPECT_EQ(inner_of(g), (Inner{4, 4}));  // from c to a; from a to c
  // Equal areas: the seed is the one whose vertices come first by x, y, z.
  ASSERT_EQ(g.planes.size(), 1u);
  EXPECT_TRUE(same_vertices(g.planes[0], triangle(a, d, c)));
}

TEST(Facets, ACubeHasAGroupASide) {
  // Three sides as a light sees them from a corner; (x, y) = corner + i u + j v + k w.
  const auto corner = [](int i, int j, int k) {
    return LightPoint{(i * 10 - j * 7 - k * 2) * kT, (i * 3 + j * 8 - k * 11) * kT,
                      std::uint32_t(5000 + 900 * i + 800 * j + 700 * k)};
  };
  std::vector<Caster> casters;
  const auto side = [&](LightPoint a, LightPoint b, LightPoint c, LightPoint d) {
    casters.push_back(triangle(a, b, c));
    casters.push_back(triangle(a, c, d));
  };
  side(corner(0, 0, 0), corner(1, 0, 0), corner(1, 1, 0), corner(0, 1, 0));
  side(corner(0, 0, 0), corner(0, 1, 0), corner(0, 1, 1), corner(0, 0, 1));
  side(corner(0, 0, 0), corner(0, 0, 1), corner(1, 0, 1), corner(1, 0, 0));
  const FacetGroups g = group(casters, 16);
  // By falling area: u x v = 101, w x u = 104, v x w = 93.
  EXPECT_EQ(planes_of(g), (Planes{1, 1, 2, 2, 0, 0}));
  EXPECT_EQ(inner_of(g), (Inner{4, 1, 4, 1, 4, 1}));
}

TEST(Facets, AFlatSheetIsOneGroup) {
  constexpr int kSide = 20;
  std::vector<Caster> casters;
  const auto at = [](int i, int j) {
    return LightPoint{i * kT, j * kT / 2, std::uint32_t(100'000 + 321 * i - 123 * j)};
  };
  for (int i = 0; i < kSide; ++i) {
    for (int j = 0; j < kSide; ++j) {
      casters.push_back(triangle(at(i, j), at(i + 1, j), at(i, j + 1)));
      casters.push_back(triangle(at(i + 1, j), at(i, j + 1), at(i + 1, j + 1)));
    }
  }
  const FacetGroups g = group(casters, 0);
  ASSERT_EQ(g.planes.size(), 1u);
  std::size_t inner = 0;
  for (const Facet& f : g.facets) {
    EXPECT_EQ(f.plane, 0u);
    inner += std::bitset<8>(f.inner_edges).count();
  }
  EXPECT_EQ(inner, 6u * kSide * kSide - 4 * kSide);  // all but the rim
}

TEST(Facets, ATJunctionIsNoSharedEdge) {
  const LightPoint a{0, 0, 9}, b{4 * kT, 0, 9}, middle{2 * kT, 0, 9}, top{kT, 3 * kT, 9},
      bottom{kT, -3 * kT, 9};
  const FacetGroups g =
      group({triangle(a, b, top), triangle(a, middle, bottom), triangle(middle, b, bottom)}, 1000);
  EXPECT_EQ(planes_of(g), (Planes{kOwn, 0, 0}));
  EXPECT_EQ(inner_of(g), (Inner{0, 2, 4}));
}

TEST(Facets, OnlyTwoOnEitherSideShareAnEdge) {
  const LightPoint a{0, 0, 9}, b{4 * kT, 0, 9}, top{kT, 3 * kT, 9}, bottom{kT, -3 * kT, 9},
      other{2 * kT, 3 * kT, 9};
  const Caster above = triangle(a, b, top), below = triangle(a, b, bottom);
  const auto grouped = [](const std::vector<Caster>& casters) {
    return !group(casters, 1000).planes.empty();
  };
  EXPECT_TRUE(grouped({above, below}));
  EXPECT_FALSE(grouped({above, triangle(a, b, other)}));                // on one side
  EXPECT_FALSE(grouped({above, below, triangle(a, b, other)}));         // three
  EXPECT_FALSE(grouped({above, below, above}));                         // a duplicate
  EXPECT_FALSE(grouped({above, triangle(a, b, bottom, 1)}));            // another object's
  EXPECT_FALSE(grouped({above, triangle(a, {b.x, b.y, 10}, bottom)}));  // other depths
  EXPECT_TRUE(grouped({above, below, triangle(a, b, other, 1)}));
}

TEST(Facets, ZeroAreaAndNarrowOnesTakeNoPart) {
  const LightPoint a{0, 0, 9}, b{4 * kT, 0, 9}, top{kT, 3 * kT, 9}, bottom{kT, -3 * kT, 9};
  const LightPoint on_it{kT, 0, 9}, close{kT, kRadius / 4, 9}, beyond{kT, kRadius / 4 + 1, 9};
  EXPECT_EQ(
      planes_of(group({triangle(a, b, top), triangle(a, b, bottom), triangle(a, b, on_it)}, 16)),
      (Planes{0, 0, kOwn}));
  EXPECT_EQ(planes_of(group({triangle(a, b, close), triangle(a, b, bottom)}, 16)),
            (Planes{kOwn, kOwn}));
  EXPECT_EQ(planes_of(group({triangle(a, b, beyond), triangle(a, b, bottom)}, 16)), (Planes{0, 0}));
}

TEST(Facets, NarrowMeansAQuarterOfTheRadius) {
  const auto narrow = [](LightPoint a, LightPoint b, LightPoint c, int bits) {
    return is_narrow(triangle(a, b, c), kBits, bits);
  };
  const std::int32_t q = kRadius / 4;
  EXPECT_TRUE(narrow({0, 0, 0}, {q, 0, 0}, {0, q, 0}, 8));           // height q / sqrt 2
  EXPECT_FALSE(narrow({0, 0, 0}, {2 * q, 0, 0}, {0, 2 * q, 0}, 8));  // height q sqrt 2
  EXPECT_TRUE(narrow({0, 0, 0}, {5 * q, 0, 0}, {7, q, 0}, 8));
  EXPECT_FALSE(narrow({0, 0, 0}, {5 * q, 0, 0}, {7, q + 1, 0}, 8));
  // Over an edge of slope 3 / 4, five units high a step: 60 and 65 where a quarter of r is 64.
  EXPECT_TRUE(narrow({0, 0, 0}, {400, 300, 0}, {200 - 3 * 12, 150 + 4 * 12, 0}, 8));
  EXPECT_FALSE(narrow({0, 0, 0}, {400, 300, 0}, {200 - 3 * 13, 150 + 4 * 13, 0}, 8));
  EXPECT_TRUE(narrow({1, 1, 5}, {1, 1, 6}, {1, 1, 7}, 15));
  // The largest there is, and one as long as can be and 0.7 units high.
  const std::int32_t lo = kCoordinateMin, hi = kCoordinateMax;
  EXPECT_FALSE(is_narrow(triangle({lo, lo, 0}, {hi, lo, 0}, {lo, hi, 0}), 26, 1));
  const Caster thin = triangle({lo, lo, 0}, {hi, hi, 0}, {hi - 1, hi - 2, 0});
  EXPECT_FALSE(is_narrow(thin, 16, 15));
  EXPECT_TRUE(is_narrow(thin, 17, 15));
}

TEST(Facets, ToleranceIsExact) {
  EXPECT_EQ(planes_of(group(pair(4 * kT, 1016), 16)), (Planes{0, 0}));
  EXPECT_EQ(planes_of(group(pair(4 * kT, 984), 16)), (Planes{0, 0}));
  EXPECT_EQ(planes_of(group(pair(4 * kT, 1017), 16)), (Planes{kOwn, kOwn}));
  EXPECT_EQ(planes_of(group(pair(4 * kT, 983), 16)), (Planes{kOwn, kOwn}));
  EXPECT_EQ(planes_of(group(pair(4 * kT, 1000), 0)), (Planes{0, 0}));
  EXPECT_EQ(planes_of(group(pair(4 * kT, 1001), 0)), (Planes{kOwn, kOwn}));
}

TEST(Facets, TheLargestIsTheSeed) {
  // Three in a row along x, each edge a fold. The middle one is the largest, so both others are
  // measured against it; had the first been the seed, the last would be off by 20.
  const LightPoint p[] = {{0, 0, 1010},
                          {2 * kT, 4 * kT, 1000},
                          {3 * kT, -4 * kT, 1000},
                          {9 * kT, 0, 1000},
                          {12 * kT, -kT, 1010}};
  const std::vector<Caster> casters = {triangle(p[0], p[1], p[2]), triangle(p[1], p[2], p[3]),
                                       triangle(p[2], p[3], p[4])};
  const FacetGroups g = group(casters, 10);
  EXPECT_EQ(planes_of(g), (Planes{0, 0, 0}));
  ASSERT_EQ(g.planes.size(), 1u);
  EXPECT_TRUE(same_vertices(g.planes[0], casters[1]));
  EXPECT_EQ(planes_of(group(casters, 9)), (Planes{kOwn, kOwn, kOwn}));
}

TEST(Facets, DepthsDriftApartByTheToleranceOverTheRadiusAtMost) {
  // The vertices are within tolerance, yet the narrow one rises by 16 over its width.
  EXPECT_EQ(planes_of(group(pair(kRadius, 1016), 16)), (Planes{0, 0}));
  EXPECT_EQ(planes_of(group(pair(kRadius - 1, 1016), 16)), (Planes{kOwn, kOwn}));
  EXPECT_EQ(planes_of(group(pair(kRadius / 2, 1008), 16)), (Planes{0, 0}));
}

TEST(Facets, ASeedIsNotMuchSteeperThanItsMembers) {
  // The seed rises by 40 over r; the member, as wide as r, by what is left.
  const auto steep = [](std::uint32_t z) {
    std::vector<Caster> casters = pair(kRadius, z);
    for (Caster& c : casters) {
      for (LightPoint& p : c.vertex) p.z += 200'000;
    }
    casters[0].vertex[2].z -= 40 * 8 * 256;
    return planes_of(group(casters, 100));
  };
  EXPECT_EQ(steep(1000 + 20), (Planes{0, 0}));
  EXPECT_EQ(steep(1000 + 19), (Planes{kOwn, kOwn}));  // 40 > 2 x 19 + 1
}

TEST(Facets, NothingInNothingOut) {
  EXPECT_TRUE(group({}, 16).facets.empty());
  EXPECT_EQ(planes_of(group({triangle(kLow, kHigh, kFarLeft)}, 16)), (Planes{kOwn}));
}

// Properties, on meshes and on soups.

struct Case {
  std::vector<Caster> casters;
  UnitConfig config;
  std::uint32_t bits;
};

Case any_case() {
  Case c;
  const auto seed = *rc::gen::arbitrary<std::uint64_t>();
  c.config.plane_tolerance = *rc::gen::element(0, 1, 16, 64, 1000, 1 << 16);
  c.config.fraction_bits = *rc::gen::element(8, 12, 15);
  c.bits = *rc::gen::element(16u, 18u, 26u);
  if (*rc::gen::inRange(0, 4) != 0) {
    // About as fine as the radius, up to far larger.
    const int radius = int(c.bits) - int(c.config.fraction_bits);
    c.casters = random_mesh(*rc::gen::inRange(1, 12), radius + *rc::gen::inRange(-1, 5), seed);
  } else {
    const int soup = *rc::gen::inRange(0, int(std::size(kAllSoups)));
    c.casters = random_soup(kAllSoups[soup], *rc::gen::inRange<std::size_t>(0, 120), seed);
    for (Caster& caster : c.casters) caster.object %= 2;
  }
  return c;
}

/// Several cases a test of RapidCheck, which stops at 100.
template <class Property>
bool holds(Property property) {
  return rc::check([&] {
    for (int i = 0; i < 8; ++i) property(any_case());
  });
}

TEST(Facets, DoNotDependOnHowTheCastersAreWritten) {
  std::size_t grouped = 0;
  EXPECT_TRUE(holds([&](const Case& c) {
    const FacetGroups one = group_facets(c.casters, c.bits, c.config);
    std::vector<Rewritten> how;
    const auto casters = rewrite(c.casters, *rc::gen::arbitrary<std::uint64_t>(), how);
    const FacetGroups other = group_facets(casters, c.bits, c.config);
    RC_ASSERT(one.planes.size() == other.planes.size());
    for (std::size_t i = 0; i < one.planes.size(); ++i) {
      RC_ASSERT(same_vertices(one.planes[i], other.planes[i]));
      RC_ASSERT(one.planes[i].object == other.planes[i].object);
      RC_ASSERT(one.planes[i].polygon == other.planes[i].polygon);
    }
    for (std::size_t i = 0; i < casters.size(); ++i) {
      const Facet &old = one.facets[how[i].caster], &facet = other.facets[i];
      RC_ASSERT(facet.plane == old.plane);
      for (std::size_t k = 0; k < 3; ++k) {
        RC_ASSERT((facet.inner_edges >> k & 1) == (old.inner_edges >> how[i].old_edge(k) & 1));
      }
      grouped += facet.plane != kOwn;
    }
  }));
  EXPECT_GT(grouped, 1000u);
}

/// How far a point lies behind a triangle's plane, from the plane's normal.
Rational behind(const Caster& plane, const LightPoint& p) {
  const LightPoint &a = plane.vertex[0], &b = plane.vertex[1], &c = plane.vertex[2];
  const Rational ux = Rational(b.x) - a.x, uy = Rational(b.y) - a.y, uz = Rational(b.z) - a.z;
  const Rational vx = Rational(c.x) - a.x, vy = Rational(c.y) - a.y, vz = Rational(c.z) - a.z;
  const Rational nx = uy * vz - uz * vy, ny = uz * vx - ux * vz, nz = ux * vy - uy * vx;
  return (nx * (Rational(p.x) - a.x) + ny * (Rational(p.y) - a.y)) / nz + Rational(p.z) - a.z;
}

TEST(Facets, LieWithinTheToleranceOfTheirPlane) {
  EXPECT_TRUE(holds([](const Case& c) {
    const FacetGroups groups = group_facets(c.casters, c.bits, c.config);
    RC_ASSERT(groups.facets.size() == c.casters.size());
    std::vector<std::size_t> members(groups.planes.size());
    std::vector<bool> seeded(groups.planes.size());
    for (std::size_t i = 0; i < c.casters.size(); ++i) {
      const std::uint32_t number = groups.facets[i].plane;
      if (number == kOwn) continue;
      RC_ASSERT(number < groups.planes.size());
      const Caster& plane = groups.planes[number];
      RC_ASSERT(plane.object == c.casters[i].object);
      for (const LightPoint& p : c.casters[i].vertex) {
        RC_ASSERT(abs(behind(plane, p)) <= c.config.plane_tolerance);
      }
      ++members[number];
      Caster canonical = c.casters[i];
      std::sort(canonical.vertex, canonical.vertex + 3,
                [](const auto& a, const auto& b) { return as_tuple(a) < as_tuple(b); });
      if (same_vertices(canonical, plane)) seeded[number] = true;
    }
    for (const std::size_t n : members) RC_ASSERT(n >= 2);
    for (const bool s : seeded) RC_ASSERT(s);
  }));
}

TEST(Facets, InnerEdgesAreThoseOfTwoMembers) {
  EXPECT_TRUE(holds([](const Case& c) {
    const FacetGroups groups = group_facets(c.casters, c.bits, c.config);
    const auto takes_part = [&](const Caster& caster) {
      return !is_narrow(caster, c.bits, int(c.config.fraction_bits));
    };
    for (std::size_t i = 0; i < c.casters.size(); ++i) {
      for (int k = 0; k < 3; ++k) {
        const LightPoint &a = c.casters[i].vertex[k], &b = c.casters[i].vertex[(k + 1) % 3];
        // All others on the edge, by trying every one.
        std::vector<std::size_t> others;
        bool opposite = false;
        for (std::size_t j = 0; j < c.casters.size(); ++j) {
          const Caster& o = c.casters[j];
          if (j == i || o.object != c.casters[i].object || !takes_part(o)) continue;
          for (int m = 0; m < 3; ++m) {
            const LightPoint &d = o.vertex[m], &e = o.vertex[(m + 1) % 3];
            const bool along = as_tuple(d) == as_tuple(a) && as_tuple(e) == as_tuple(b);
            const bool against = as_tuple(d) == as_tuple(b) && as_tuple(e) == as_tuple(a);
            if (!along && !against) continue;
            others.push_back(j);
            const LightPoint &mine = c.casters[i].vertex[(k + 2) % 3], &its = o.vertex[(m + 2) % 3];
            opposite = (edge_function(a, b, mine.x, mine.y) > 0) !=
                       (edge_function(a, b, its.x, its.y) > 0);
          }
        }
        const bool inner = takes_part(c.casters[i]) && others.size() == 1 && opposite &&
                           groups.facets[i].plane != kOwn &&
                           groups.facets[others[0]].plane == groups.facets[i].plane;
        RC_ASSERT((groups.facets[i].inner_edges >> k & 1) == inner);
      }
    }
  }));
}

}  // namespace
}  // namespace kagesen

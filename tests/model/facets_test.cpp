// Groups of facets: meshes whose groups are known by hand.
#include "model/facets.h"

#include <gtest/gtest.h>

#include <bitset>
#include <tuple>

#include "model/reference/triangle.h"

namespace kagesen {
namespace {

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

TEST(Facets, ASeedIsHardlySteeperThanItsMembers) {
  // The seed rises by 40 over r, the member by `rise` over four times that.
  const auto steep = [](std::uint32_t rise) {
    std::vector<Caster> casters = pair(4 * kRadius, 1000 + rise);
    for (Caster& c : casters) {
      for (LightPoint& p : c.vertex) p.z += 200'000;
    }
    casters[0].vertex[2].z -= 40 * 8 * 256;
    return planes_of(group(casters, 100));
  };
  EXPECT_EQ(steep(4 * 40), (Planes{0, 0}));
  EXPECT_EQ(steep(4 * 40 + 10), (Planes{0, 0}));
  EXPECT_EQ(steep(4 * 40 - 1), (Planes{0, 0}));
  EXPECT_EQ(steep(4 * 40 - 2), (Planes{kOwn, kOwn}));
}

TEST(Facets, NothingInNothingOut) {
  EXPECT_TRUE(group({}, 16).facets.empty());
  EXPECT_EQ(planes_of(group({triangle(kLow, kHigh, kFarLeft)}, 16)), (Planes{kOwn}));
}

}  // namespace
}  // namespace kagesen

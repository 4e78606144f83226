// Groups of facets: what holds for any mesh and any soup.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <tuple>

#include "model/facets.h"
#include "tests/model/random_meshes.h"

namespace kagesen {
namespace {

using Rational = boost::multiprecision::cpp_rational;

constexpr std::uint32_t kOwn = Facet::kOwnPlane;

auto as_tuple(const LightPoint& p) { return std::tie(p.x, p.y, p.z); }
bool same_vertices(const Caster& a, const Caster& b) {
  for (int i = 0; i < 3; ++i) {
    if (as_tuple(a.vertex[i]) != as_tuple(b.vertex[i])) return false;
  }
  return true;
}

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

#include "model/reference/reference.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <optional>

#include "tests/model/random_casters.h"
#include "tests/model/vectors.h"

namespace kagesen {
namespace {

using Rational = boost::multiprecision::cpp_rational;

constexpr Semantics kBoth[] = {Semantics::kPaper, Semantics::kPhysical};

/// The plane's depth at (x, y) where the closed triangle covers it, by Cramer's rule in rationals.
std::optional<Rational> rational_depth(const Caster& c, std::int32_t x, std::int32_t y) {
  const LightPoint &a = c.vertex[0], &b = c.vertex[1], &d = c.vertex[2];
  const Rational ux = Rational(b.x) - a.x, uy = Rational(b.y) - a.y;
  const Rational vx = Rational(d.x) - a.x, vy = Rational(d.y) - a.y;
  const Rational px = Rational(x) - a.x, py = Rational(y) - a.y;
  const Rational determinant = ux * vy - uy * vx;
  if (determinant == 0) return std::nullopt;
  const Rational s = (px * vy - py * vx) / determinant;
  const Rational t = (ux * py - uy * px) / determinant;
  if (s < 0 || t < 0 || s + t > 1) return std::nullopt;
  return Rational(a.z) + s * (Rational(b.z) - a.z) + t * (Rational(d.z) - a.z);
}

bool rational_dark(const std::vector<Caster>& casters, const LightPoint& p, std::uint32_t object,
                   Semantics semantics) {
  return std::any_of(casters.begin(), casters.end(), [&](const Caster& c) {
    if (semantics == Semantics::kPaper && c.object == object) return false;
    const auto depth = rational_depth(c, p.x, p.y);
    return depth && *depth < p.z;
  });
}

TEST(ExactReference, AgreesWithRationals) {
  for (Soup soup : kAllSoups) {
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
      const auto casters = random_soup(soup, seed % 2 ? 6 : 40, seed);
      const ExactReference reference(casters);
      Generator g(seed);
      for (int i = 0; i < 150; ++i) {
        const LightPoint p = random_query(casters, g);
        const auto object = std::uint32_t(g.in(0, 4));
        for (Semantics s : kBoth) {
          ASSERT_EQ(reference.dark(p, object, s), rational_dark(casters, p, object, s))
              << "soup " << int(soup) << " seed " << seed << " at " << p.x << ' ' << p.y << ' '
              << p.z;
        }
      }
    }
  }
}

TEST(ExactReference, NearestAgreesWithRationals) {
  for (Soup soup : kAllSoups) {
    const auto casters = random_soup(soup, 30, 7);
    const ExactReference reference(casters);
    Generator g(8);
    for (int i = 0; i < 200; ++i) {
      const LightPoint p = random_query(casters, g);
      DepthSample expected;
      std::optional<Rational> exact;
      for (const Caster& c : casters) {
        const auto depth = rational_depth(c, p.x, p.y);
        if (!depth) continue;
        if (!exact || *depth < *exact) exact = depth;
        const auto floor =
            std::uint32_t(boost::multiprecision::cpp_int(numerator(*depth) / denominator(*depth)));
        if (!expected.hit() || floor < expected.depth) expected = {floor, c.object};
      }
      const DepthSample got = reference.nearest(p.x, p.y);
      ASSERT_EQ(got.depth, expected.depth) << "soup " << int(soup);
      ASSERT_EQ(got.object, expected.object) << "soup " << int(soup);
      const double contact = reference.contact_distance(p, 0, Semantics::kPhysical);
      if (exact) {
        ASSERT_NEAR(contact, std::abs(double(*exact - Rational(p.z))), 1e-6);
      } else {
        ASSERT_TRUE(std::isinf(contact));
      }
    }
  }
}

TEST(ExactReference, TreeAgreesWithTryingEveryCaster) {
  for (Soup soup : kAllSoups) {
    for (std::size_t count : {1, 3, 17, 200, 3000}) {
      const auto casters = random_soup(soup, count, count);
      const ExactReference reference(casters);
      Generator g(count);
      std::size_t dark = 0;
      for (int i = 0; i < 300; ++i) {
        const LightPoint p = random_query(casters, g);
        const auto object = std::uint32_t(g.in(0, 4));
        for (Semantics s : kBoth) {
          const bool expected = dark_by_trying_all(casters, p, object, s);
          dark += expected;
          ASSERT_EQ(reference.dark(p, object, s), expected) << "soup " << int(soup);
        }
        const bool covered = std::any_of(casters.begin(), casters.end(), [&](const Caster& c) {
          const Weights w = weights_at(c, p.x, p.y);
          return c.object == object && w.inside() && plane_nearer(c, w, p.z);
        });
        ASSERT_EQ(reference.covered_by(p.x, p.y, object, p.z), covered);
      }
      if (count >= 200) {
        EXPECT_GT(dark, 0u) << "soup " << int(soup) << " tests nothing";
      }
    }
  }
}

TEST(ExactReference, CoveredByCountsEveryDepthUnlessToldOtherwise) {
  const std::vector<Caster> casters = {
      {{{0, 0, kDepthMax}, {8, 0, kDepthMax}, {0, 8, kDepthMax}}, 3, 0}};
  const ExactReference reference(casters);
  EXPECT_TRUE(reference.covered_by(0, 0, 3));
  EXPECT_TRUE(reference.covered_by(4, 4, 3));
  EXPECT_FALSE(reference.covered_by(5, 4, 3));
  EXPECT_FALSE(reference.covered_by(0, 0, 2));
  EXPECT_FALSE(reference.covered_by(0, 0, 3, kDepthMax));
}

TEST(Weights, NothingIsInsideATriangleWithoutArea) {
  const Caster line{{{0, 0, 1}, {4, 4, 1}, {8, 8, 1}}, 0, 0},
      point{{{2, 2, 1}, {2, 2, 1}, {2, 2, 1}}, 0, 0};
  EXPECT_FALSE(weights_at(line, 4, 4).inside());
  EXPECT_FALSE(weights_at(line, 0, 1).inside());
  EXPECT_FALSE(weights_at(point, 2, 2).inside());
}

TEST(ExactReference, FlagsDecideBeforeGeometry) {
  const std::vector<Caster> casters = {{{{0, 0, 5}, {8, 0, 5}, {0, 8, 5}}, 0, 0}};
  const ExactReference reference(casters);
  Fragment f;
  f.position = {1, 1, 9};
  f.object = 1;
  EXPECT_TRUE(reference.dark(f, Semantics::kPaper));
  f.flags = Fragment::kOutside;
  EXPECT_FALSE(reference.dark(f, Semantics::kPaper));
  f.flags = Fragment::kAverted;
  f.position = {100, 100, 9};
  EXPECT_TRUE(reference.dark(f, Semantics::kPaper));
}

TEST(ExactReference, NoCastersAtAll) {
  const std::vector<Caster> none;
  const ExactReference reference(none);
  EXPECT_FALSE(reference.dark({0, 0, kDepthMax}, 0, Semantics::kPhysical));
  EXPECT_FALSE(reference.nearest(0, 0).hit());
  std::vector<std::uint32_t> found;
  reference.casters_in(kCoordinateMin, kCoordinateMin, kCoordinateMax, kCoordinateMax, found);
  EXPECT_TRUE(found.empty());
}

TEST(ExactReference, CastersInFindsEveryBoundingBoxOnce) {
  for (Soup soup : kAllSoups) {
    const auto casters = random_soup(soup, 700, 21);
    const ExactReference reference(casters);
    Generator g(22);
    for (int i = 0; i < 60; ++i) {
      const LightPoint p = random_query(casters, g),
                       q = i % 3 ? g.near(p, 1 << g.in(0, 20), 0) : random_query(casters, g);
      const Box box{std::min(p.x, q.x), std::min(p.y, q.y), std::max(p.x, q.x), std::max(p.y, q.y)};
      std::vector<std::uint32_t> expected = {99}, found = {99};  // appended to what is there
      for (std::uint32_t k = 0; k < casters.size(); ++k) {
        if (bounding_box(casters[k]).meets(box)) expected.push_back(k);
      }
      reference.casters_in(box.x0, box.y0, box.x1, box.y1, found);
      ASSERT_EQ(found.at(0), 99u);
      std::sort(found.begin() + 1, found.end());
      ASSERT_EQ(found, expected) << "soup " << int(soup);
    }
  }
}

/// Every verdict of the independent implementation, at every fragment.
TEST(ConformanceVectors, EveryExactVerdict) {
  for (const char* scene : kVectorScenes) {
    const ExactVectors v = read_exact_vectors(scene);
    ASSERT_GT(v.trace.all_fragments.size(), 69'000u);
    const ExactReference reference(v.trace.all_casters);
    std::size_t wrong_paper = 0, wrong_physical = 0;
    for (std::size_t i = 0; i < v.trace.all_fragments.size(); ++i) {
      const Fragment& f = v.trace.all_fragments[i];
      wrong_paper += reference.dark(f, Semantics::kPaper) != bool(v.paper[i]);
      wrong_physical += reference.dark(f, Semantics::kPhysical) != bool(v.physical[i]);
    }
    EXPECT_EQ(wrong_paper, 0u) << scene;
    EXPECT_EQ(wrong_physical, 0u) << scene;
  }
}

TEST(ConformanceVectors, BufferFilesAreWhole) {
  for (const char* scene : {"glyphs", "torus"}) {
    for (int scale : {1, 16}) {
      const SlbVectors four = read_slb_vectors(scene, scale, 4),
                       eight = read_slb_vectors(scene, scale, 8);
      for (const SlbVectors* v : {&four, &eight}) {
        ASSERT_GT(v->entries.size(), 200u) << scene << scale;
        for (const TexelEntry& e : v->entries) {
          ASSERT_FALSE(e.lines.empty());
          ASSERT_LT(std::max(e.texel_x, e.texel_y), 1024u);
        }
      }
    }
  }
}

}  // namespace
}  // namespace kagesen

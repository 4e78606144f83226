#include "model/rivals/conservative_map.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <string>

#include "tests/model/random_casters.h"

namespace kagesen {
namespace {

constexpr CoverageTest kTests[] = {CoverageTest::kCorners, CoverageTest::kCircle};
constexpr Semantics kBoth[] = {Semantics::kPaper, Semantics::kPhysical};

/// A soup and a map whose texels suit it, so that some of them are covered wholly.
struct Case {
  std::vector<Caster> casters;
  std::uint32_t width, height, fraction_bits;
  std::uint64_t seed;
};

Case random_case() {
  const auto any = rc::gen::inRange<std::uint64_t>(0, 1u << 30);
  const auto seed = *rc::gen::noShrink(rc::gen::resize(rc::kNominalSize, any));
  Generator g(seed);
  const Soup soup = kAllSoups[g.in(0, std::int64_t(std::size(kAllSoups)) - 1)];
  Case c;
  c.seed = seed;
  c.casters = random_soup(soup, std::size_t(g.in(1, 30)), seed);
  c.width = std::uint32_t(g.in(1, 40));
  c.height = std::uint32_t(g.in(1, 40));
  switch (soup) {
    case Soup::kTiny:
      c.fraction_bits = std::uint32_t(g.in(0, 3));
      break;
    case Soup::kDegenerate:
      c.fraction_bits = std::uint32_t(g.in(0, 6));
      break;
    case Soup::kConcentrated:  // brought to the map, which lies round the origin
      c.fraction_bits = std::uint32_t(g.in(2, 8));
      for (Caster& caster : c.casters) {
        for (LightPoint& p : caster.vertex) {
          p.x -= 70'001'000;
          p.y -= 70'001'000;
        }
      }
      break;
    default:
      c.fraction_bits = std::uint32_t(g.in(16, 26));
  }
  return c;
}

Fragment random_fragment(const Case& c, Generator& g) {
  Fragment f;
  f.position = random_query(c.casters, g);
  if (g.in(0, 1) == 0) {  // anywhere on the map, borders of texels above all
    const auto along = [&](std::uint32_t side) {
      const std::int64_t texel = std::int64_t{1} << c.fraction_bits;
      const std::int64_t v = (g.in(0, side) - side / 2) * texel + g.in(-1, 1) * g.in(0, texel);
      return std::int32_t(std::clamp<std::int64_t>(v, kCoordinateMin, kCoordinateMax));
    };
    f.position.x = along(c.width);
    f.position.y = along(c.height);
  }
  f.object = std::uint32_t(g.in(0, 4));
  return f;
}

/// As rc::check, but with many cases for one of its own: these are small and fast.
template <class Property>
bool holds_always(Property property) {
  return rc::check([&] {
    for (int i = 0; i < 10; ++i) property(random_case());
  });
}

TEST(ConservativeMap, IsNeverDarkWhereTheExactVerdictIsLit) {
  std::uint64_t decided[2][2] = {};
  EXPECT_TRUE(holds_always([&](const Case& c) {
    const ExactReference reference(c.casters);
    Generator g(c.seed + 1);
    for (const CoverageTest test : kTests) {
      ConservativeMap map(c.width, c.height, c.fraction_bits, test);
      for (const Caster& caster : c.casters) map.draw(caster);
      for (int i = 0; i < 200; ++i) {
        Fragment f = random_fragment(c, g);
        // Depths round the stored one are where a map can go wrong.
        const std::int64_t column = (f.position.x >> c.fraction_bits) + std::int64_t{c.width / 2};
        const std::int64_t row = (f.position.y >> c.fraction_bits) + std::int64_t{c.height / 2};
        if (column >= 0 && row >= 0 && column < c.width && row < c.height && g.in(0, 1)) {
          const std::int64_t stored = map.at(std::uint32_t(column), std::uint32_t(row)).depth;
          f.position.z =
              std::uint32_t(std::clamp<std::int64_t>(stored + g.in(-2, 2), 0, kDepthMax));
        }
        for (const Semantics s : kBoth) {
          if (!map.surely_dark(f, s)) continue;
          ++decided[std::size_t(test)][std::size_t(s)];
          RC_ASSERT(reference.dark(f, s));
        }
      }
    }
  }));
  for (const auto& by_semantics : decided) {
    for (const std::uint64_t count : by_semantics) EXPECT_GT(count, 300u);
  }
}

/// As the definition has it, a texel and a triangle at a time.
bool covers(const Caster& c, CoverageTest test, std::int64_t x, std::int64_t y,
            std::int64_t texel) {
  if (doubled_area(c) == 0) return false;
  if (test == CoverageTest::kCorners) {
    for (const std::int64_t cx : {x, x + texel}) {
      for (const std::int64_t cy : {y, y + texel}) {
        if (!weights_at(c, std::int32_t(cx), std::int32_t(cy)).inside()) return false;
      }
    }
    return true;
  }
  for (int i = 0; i < 3; ++i) {
    const LightPoint &a = c.vertex[i], &b = c.vertex[(i + 1) % 3];
    const Int128 dx = std::int64_t{b.x} - a.x, dy = std::int64_t{b.y} - a.y;
    // Twice the edge function at the centre, inwards; its square against twice the squared length
    // times the squared side, which is where the distance is half the diagonal.
    Int128 twice =
        dx * (2 * y + texel - 2 * std::int64_t{a.y}) - dy * (2 * x + texel - 2 * std::int64_t{a.x});
    if (doubled_area(c) < 0) twice = -twice;
    if (twice < 0 || twice * twice < 2 * (dx * dx + dy * dy) * texel * texel) return false;
  }
  return true;
}

/// Smallest integer that no point of the texel's corners lies behind.
std::uint32_t farthest_corner(const Caster& c, std::int64_t x, std::int64_t y, std::int64_t texel) {
  std::uint32_t farthest = 0;
  for (const std::int64_t cx : {x, x + texel}) {
    for (const std::int64_t cy : {y, y + texel}) {
      const Weights w = weights_at(c, std::int32_t(cx), std::int32_t(cy));
      Int128 sum = Int128{w.w0} * c.vertex[0].z + Int128{w.w1} * c.vertex[1].z +
                   Int128{w.w2} * c.vertex[2].z;
      const Int128 area = w.area() < 0 ? -w.area() : w.area();
      if (w.area() < 0) sum = -sum;
      farthest = std::max(farthest, std::uint32_t((sum + area - 1) / area));
    }
  }
  return farthest;
}

TEST(ConservativeMap, HoldsWhatTheDefinitionSays) {
  std::uint64_t covered[2] = {};
  EXPECT_TRUE(holds_always([&](Case c) {
    c.width = std::min(c.width, 9u);
    c.height = std::min(c.height, 9u);
    const std::int64_t texel = std::int64_t{1} << c.fraction_bits;
    for (const CoverageTest test : kTests) {
      ConservativeMap map(c.width, c.height, c.fraction_bits, test);
      for (const Caster& caster : c.casters) map.draw(caster);
      for (std::uint32_t row = 0; row < c.height; ++row) {
        for (std::uint32_t column = 0; column < c.width; ++column) {
          const std::int64_t x = (std::int64_t{column} - c.width / 2) * texel;
          const std::int64_t y = (std::int64_t{row} - c.height / 2) * texel;
          ConservativeMap::Texel expected;
          for (const Caster& caster : c.casters) {
            // Corners that no coordinate reaches lie in no triangle.
            if (std::min(x, y) < kCoordinateMin || std::max(x, y) + texel > kCoordinateMax) break;
            if (!covers(caster, test, x, y, texel)) continue;
            const std::uint32_t depth = farthest_corner(caster, x, y, texel);
            if (depth > expected.depth) continue;
            if (depth == expected.depth && caster.object > expected.object) continue;
            expected = {depth, caster.object};
          }
          const ConservativeMap::Texel& t = map.at(column, row);
          RC_ASSERT(t.depth == expected.depth);
          RC_ASSERT(t.object == expected.object);
          covered[std::size_t(test)] += t.object != ConservativeMap::Texel{}.object;
        }
      }
    }
  }));
  EXPECT_GT(covered[0], covered[1]);
  EXPECT_GT(covered[1], 300u);
}

TEST(ConservativeMap, CornersDecideAllThatTheCircleDoes) {
  EXPECT_TRUE(holds_always([](const Case& c) {
    ConservativeMap corners(c.width, c.height, c.fraction_bits, CoverageTest::kCorners);
    ConservativeMap circle(c.width, c.height, c.fraction_bits, CoverageTest::kCircle);
    for (const Caster& caster : c.casters) {
      corners.draw(caster);
      circle.draw(caster);
    }
    RC_ASSERT(corners.covered_texels() >= circle.covered_texels());
    Generator g(c.seed + 2);
    for (int i = 0; i < 200; ++i) {
      const Fragment f = random_fragment(c, g);
      if (circle.surely_dark(f, Semantics::kPhysical)) {
        RC_ASSERT(corners.surely_dark(f, Semantics::kPhysical));
      }
      if (!circle.surely_dark(f, Semantics::kPaper)) continue;
      // A texel has room for one object: the fragment's own may have taken it.
      const auto& t = corners.at((f.position.x >> c.fraction_bits) + c.width / 2,
                                 (f.position.y >> c.fraction_bits) + c.height / 2);
      RC_ASSERT(corners.surely_dark(f, Semantics::kPaper) || t.object == f.object);
    }
  }));
}

/// Six rows of six texels of four units; '#' where it is covered.
std::string picture(const Caster& c, CoverageTest test) {
  ConservativeMap map(6, 6, 2, test);
  map.draw(c);
  std::string out;
  for (std::uint32_t row = 0; row < 6; ++row) {
    for (std::uint32_t column = 0; column < 6; ++column) {
      out += map.at(column, row).object == c.object ? '#' : '.';
    }
    out += '\n';
  }
  return out;
}

TEST(ConservativeMap, BordersCountAsCoveredAndCirclesAskForMore) {
  // Its legs lie on the map's upper and left border, its other side runs through texel corners.
  Caster c{{{-12, -12, 5}, {12, -12, 5}, {-12, 12, 5}}, 3, 0};
  EXPECT_EQ(picture(c, CoverageTest::kCorners), "#####.\n####..\n###...\n##....\n#.....\n......\n");
  EXPECT_EQ(picture(c, CoverageTest::kCircle), "......\n.###..\n.##...\n.#....\n......\n......\n");
  std::swap(c.vertex[1], c.vertex[2]);
  EXPECT_EQ(picture(c, CoverageTest::kCorners), "#####.\n####..\n###...\n##....\n#.....\n......\n");
}

TEST(ConservativeMap, DepthIsTheFarthestCornersRoundedUp) {
  // One unit deeper every 3 units of x: 4/3 over a texel.
  const Caster c{{{-60, -60, 100}, {60, -60, 140}, {-60, 60, 100}}, 3, 0};
  ConservativeMap map(2, 2, 2, CoverageTest::kCorners);
  map.draw(c);
  EXPECT_EQ(map.at(0, 0).depth, 120u);
  EXPECT_EQ(map.at(1, 0).depth, ConservativeMap::Texel{}.depth);  // (4, 0) is past the long side
  map.draw({{{-60, -60, 90}, {60, -60, 130}, {-60, 60, 110}}, 1, 0});
  EXPECT_EQ(map.at(0, 0).depth, 120u);
  EXPECT_EQ(map.at(0, 0).object, 1u);  // of two as near, the lower one
  Fragment f;
  f.position = {-1, -1, 120};
  f.object = 1;
  EXPECT_FALSE(map.surely_dark(f, Semantics::kPhysical));
  f.position.z = 121;
  EXPECT_TRUE(map.surely_dark(f, Semantics::kPhysical));
  EXPECT_FALSE(map.surely_dark(f, Semantics::kPaper));
  f.object = 2;
  EXPECT_TRUE(map.surely_dark(f, Semantics::kPaper));
  f.flags = Fragment::kOutside;
  EXPECT_FALSE(map.surely_dark(f, Semantics::kPaper));
}

TEST(ReductionRates, CountJudgedFragmentsAndShareOfThem) {
  Trace trace;
  trace.header.fraction_bits = 16;
  constexpr std::int32_t kTexel = 1 << 16;
  trace.all_casters = {
      {{{-3 * kTexel, -3 * kTexel, 5}, {3 * kTexel, -3 * kTexel, 5}, {-3 * kTexel, 3 * kTexel, 5}},
       3,
       0}};
  const auto add = [&](std::int32_t x, std::int32_t y, std::uint32_t z, std::uint8_t flags = 0) {
    Fragment f;
    f.position = {x, y, z};
    f.flags = flags;
    trace.all_fragments.push_back(f);
  };
  add(-3 * kTexel, -3 * kTexel, 6);  // corners alone decide it
  add(-kTexel, -kTexel, 6);          // both do
  add(-kTexel, -kTexel, 5);          // on the surface
  add(kTexel, kTexel, 9);            // beside it
  add(-kTexel, -kTexel, 9, Fragment::kAverted);
  add(3 * kTexel, 0, 9);  // off the map
  UnitConfig config;
  config.map_width = config.map_height = 6;
  const ReductionRates rates = reduction_rates(trace, config, Semantics::kPaper);
  EXPECT_EQ(rates.judged, 4u);
  EXPECT_EQ(rates.corners.decided, 2u);
  EXPECT_EQ(rates.circle.decided, 1u);
  EXPECT_EQ(rates.corners.texels, 15u);
  EXPECT_EQ(rates.circle.texels, 6u);
  EXPECT_EQ(rates.share(rates.corners), 0.5);
  EXPECT_GT(rates.corners.generation_s, 0);
}

}  // namespace
}  // namespace kagesen

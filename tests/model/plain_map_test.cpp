#include "model/rivals/plain_map.h"

#include <gtest/gtest.h>

#include "tests/model/random_casters.h"
#include "tests/model/vectors.h"

namespace kagesen {
namespace {

constexpr Semantics kBoth[] = {Semantics::kPaper, Semantics::kPhysical};

struct MapCase {
  std::uint32_t side, map_width, map_height, fraction_bits;
};

void expect_dense_equals_sparse(const std::vector<Caster>& casters,
                                const std::vector<Fragment>& fragments, const MapCase& m) {
  const ExactReference reference(casters);
  PlainMap map(m.side, m.side, m.map_width, m.map_height, m.fraction_bits);
  for (const Caster& c : casters) map.draw(c);
  for (const Fragment& f : fragments) {
    for (Semantics s : kBoth) {
      ASSERT_EQ(map.decide(f, s), plain_map_verdict(reference, f, s, m.side, m.map_width,
                                                    m.map_height, m.fraction_bits))
          << "side " << m.side << " at " << f.position.x << ' ' << f.position.y;
    }
  }
}

TEST(PlainMap, DenseEqualsSparseOnSoups) {
  constexpr MapCase kCases[] = {{64, 1024, 1024, 16}, {100, 1024, 1024, 16}, {97, 333, 512, 17},
                                {256, 5, 7, 16},      {1, 1024, 1024, 16},   {300, 4096, 4096, 26}};
  for (Soup soup : kAllSoups) {
    const auto casters = random_soup(soup, 60, 3);
    Generator g(4);
    std::vector<Fragment> fragments(300);
    for (Fragment& f : fragments) {
      f.position = random_query(casters, g);
      f.object = std::uint32_t(g.in(0, 4));
      f.flags = std::uint8_t(g.in(0, 15) == 0 ? g.in(0, 7) : 0);
    }
    for (const MapCase& m : kCases) expect_dense_equals_sparse(casters, fragments, m);
  }
}

TEST(PlainMap, DenseEqualsSparseOnTheVectors) {
  const ExactVectors v = read_exact_vectors("torus", 16);
  for (std::uint32_t side : {256u, 1000u}) {
    expect_dense_equals_sparse(v.trace.all_casters, v.trace.all_fragments,
                               {side, 1024, 1024, v.trace.header.fraction_bits});
  }
}

TEST(PlainMap, SamplesTexelCentresAndCountsEdges) {
  // Texels of 4 units; samples at -6, -2, 2, 6. The right-angled corner lies on a sample.
  const Caster c{{{-2, -2, 10}, {2, -2, 10}, {-2, 2, 10}}, 1, 0};
  PlainMap map(4, 4, 16, 16, 0);
  map.draw(c);
  Fragment f;
  f.object = 2;
  std::string picture;
  for (int y : {-8, -1, 0, 7}) {
    for (int x : {-5, -4, 3, 4}) {
      f.position = {x, y, 11};
      picture += map.decide(f, Semantics::kPaper) == Verdict::kDark ? '#' : '.';
    }
  }
  EXPECT_EQ(picture, ".....##..#......");
}

TEST(PlainMap, TiesKeepTheFirstAndBiasIsStrict) {
  const Caster a{{{-8, -8, 10}, {8, -8, 10}, {0, 8, 10}}, 1, 0};
  Caster b = a;
  b.object = 2;
  PlainMap map(1, 1, 4, 4, 1);
  map.draw(a);
  map.draw(b);
  Fragment f;
  f.position = {0, 0, 12};
  f.object = 1;
  EXPECT_EQ(map.decide(f, Semantics::kPaper), Verdict::kLit);
  f.object = 2;
  EXPECT_EQ(map.decide(f, Semantics::kPaper), Verdict::kDark);
  EXPECT_EQ(map.decide(f, Semantics::kPhysical, 1), Verdict::kDark);
  EXPECT_EQ(map.decide(f, Semantics::kPhysical, 2), Verdict::kLit);
}

TEST(PlainMap, FarthestDepthStillLeavesItsObject) {
  const Caster c{{{-8, -8, kDepthMax}, {8, -8, kDepthMax}, {0, 8, kDepthMax}}, 1, 0};
  const std::vector<Caster> casters = {c};
  Fragment f;
  f.position = {0, 0, kDepthMax};
  f.object = 2;
  expect_dense_equals_sparse(casters, {f}, {1, 4, 4, 1});
  EXPECT_EQ(ExactReference(casters).nearest(0, 0).object, 1u);
}

TEST(PlainMap, PackedBytes) {
  EXPECT_EQ(PlainMap(16, 16, 16, 16, 16).bytes(), 16u * 16 * 5);
  EXPECT_EQ(PlainMap(16, 16, 16, 16, 16).bytes(32, 32), 16u * 16 * 8);
}

/// At a side where texels are single units the plain map is exact but for depth's fraction.
TEST(PlainMap, UnitTexelsSampleTheFragmentItself) {
  const PlainAxis axis(1024u << 16, 1024, 16);
  for (std::int32_t v : {-(512 << 16), -1, 0, 1, (512 << 16) - 1}) {
    EXPECT_EQ(axis.sample(axis.texel(v)), v);
    EXPECT_EQ(axis.first_from(v), axis.texel(v));
  }
}

}  // namespace
}  // namespace kagesen

// What the host prepares: which parts for which profile, and objects that nothing can shadow.
#include "model/frame_setup.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "model/facets.h"
#include "model/unit_ids.h"
#include "model/unshadowable.h"
#include "tests/model/random_meshes.h"

namespace kagesen {
namespace {

constexpr std::int32_t kT = 1 << kMinFractionBits;  // units a texel

UnitConfig winding(Semantics semantics, std::int64_t width = 64, std::int64_t height = 64) {
  UnitConfig config;
  config.profile = Profile::kWinding;
  config.semantics = semantics;
  config.map_width = width;
  config.map_height = height;
  return config;
}

Fragment fragment(std::int32_t x, std::int32_t y, std::uint32_t z, std::uint32_t object,
                  std::uint8_t flags = 0) {
  Fragment f;
  f.position = {x, y, z};
  f.object = object;
  f.flags = flags;
  return f;
}

/// A sheet at depth 1000 of object 0 over texels (0, 0) to (4, 4), and a fragment of object 1.
Trace sheet_and(const Fragment& f) {
  Trace trace;
  trace.header.objects.resize(2);
  const LightPoint a{0, 0, 1000}, b{4 * kT, 0, 1000}, c{4 * kT, 4 * kT, 1000}, d{0, 4 * kT, 1000};
  trace.all_casters = {{{a, b, c}, 0, 0}, {{a, c, d}, 0, 1}};
  trace.all_fragments = {f};
  return trace;
}

TEST(FrameSetup, ThePaperProfileGetsIdsAlone) {
  Trace trace = sheet_and(fragment(kT, kT, 500, 1));
  trace.header.fraction_bits = 20;
  UnitConfig config;
  std::uint64_t aliased = 99;
  FrameSetup setup = make_frame_setup(trace, config, &aliased);
  EXPECT_EQ(setup.fraction_bits, 20u);
  EXPECT_TRUE(setup.unit_ids.empty());
  EXPECT_TRUE(setup.facets.empty());
  EXPECT_TRUE(setup.planes.empty());
  EXPECT_TRUE(setup.unshadowable.empty());
  EXPECT_EQ(aliased, 0u);

  trace.header.objects.resize(3);
  trace.all_fragments.push_back(fragment(kT, kT, 500, 2));
  config.id_bits = 1;
  setup = make_frame_setup(trace, config, &aliased);
  EXPECT_EQ(setup.unit_ids, assign_unit_ids(trace, 20, 1).ids);
  EXPECT_EQ(setup.unit_ids.size(), 3u);
  EXPECT_EQ(aliased, 1u);
}

TEST(FrameSetup, TheWindingProfileGetsGroupsWhateverItSkips) {
  const Trace trace = sheet_and(fragment(kT, kT, 500, 1));
  for (const bool skip : {false, true}) {
    UnitConfig config = winding(Semantics::kPhysical);
    config.skip_edges = config.skip_fragments = skip;
    const FrameSetup setup = make_frame_setup(trace, config);
    ASSERT_EQ(setup.facets.size(), 2u);
    EXPECT_EQ(setup.facets[0].plane, 0u);
    EXPECT_EQ(setup.facets[1].plane, 0u);
    EXPECT_EQ(setup.planes.size(), 1u);
    EXPECT_EQ(setup.unshadowable,
              skip ? (std::vector<std::uint8_t>{1, 1}) : std::vector<std::uint8_t>{});
  }
}

TEST(FrameSetup, PhysicalSemanticsNeedNoIds) {
  Trace trace = sheet_and(fragment(kT, kT, 500, 1));
  trace.header.objects.resize(3);
  trace.all_fragments.push_back(fragment(kT, kT, 500, 2));
  std::uint64_t aliased = 99;
  UnitConfig config = winding(Semantics::kPhysical);
  config.id_bits = 1;
  EXPECT_TRUE(make_frame_setup(trace, config, &aliased).unit_ids.empty());
  EXPECT_EQ(aliased, 0u);
  config.semantics = Semantics::kPaper;
  EXPECT_EQ(make_frame_setup(trace, config, &aliased).unit_ids.size(), 3u);
  EXPECT_EQ(aliased, 1u);
}

bool flagged(const Fragment& f, Semantics semantics = Semantics::kPhysical) {
  return find_unshadowable(sheet_and(f), winding(semantics))[f.object];
}

TEST(Unshadowable, MeansNothingNearerInTheTile) {
  EXPECT_TRUE(flagged(fragment(kT, kT, 1000, 1)));  // in contact is not nearer
  EXPECT_FALSE(flagged(fragment(kT, kT, 1001, 1)));
  EXPECT_FALSE(flagged(fragment(7 * kT, 7 * kT, 1001, 1)));  // beside the sheet, in its tile
  EXPECT_TRUE(flagged(fragment(8 * kT, kT, kDepthMax, 1)));  // in the next tile
  // The sheet's border lies on a tile's: what its texels hold may reach beyond.
  EXPECT_FALSE(flagged(fragment(-1, kT, 1001, 1)));
  EXPECT_FALSE(flagged(fragment(kT, -8 * kT, 1001, 1)));
  EXPECT_TRUE(flagged(fragment(-8 * kT - 1, kT, 1001, 1)));
  // So at its far side: a texel of the sheet in the tile's last column, or only in the one before.
  for (const std::int32_t end : {8 * kT - 1, 7 * kT - 1}) {
    Trace trace = sheet_and(fragment(8 * kT, kT, 1001, 1));
    for (Caster& c : trace.all_casters) {
      for (LightPoint& p : c.vertex) p.x = std::min(p.x * 2, end);
    }
    EXPECT_EQ(find_unshadowable(trace, winding(Semantics::kPhysical))[1], end < 7 * kT) << end;
  }
}

TEST(Unshadowable, AnObjectShadowsItselfInPhysicalSemanticsOnly) {
  EXPECT_FALSE(flagged(fragment(kT, kT, 1001, 0), Semantics::kPhysical));
  EXPECT_TRUE(flagged(fragment(kT, kT, 1001, 0), Semantics::kPaper));
  EXPECT_FALSE(flagged(fragment(kT, kT, 1001, 1), Semantics::kPaper));
  // Its own surface is the nearest, but another object's lies before the fragment too.
  for (const bool own_first : {false, true}) {
    Trace trace = sheet_and(fragment(kT, kT, 3000, 0));
    Caster farther = trace.all_casters[0];
    farther.object = 1;
    for (LightPoint& p : farther.vertex) p.z = 2000;
    auto& casters = trace.all_casters;
    casters.insert(own_first ? casters.end() : casters.begin(), farther);
    EXPECT_FALSE(find_unshadowable(trace, winding(Semantics::kPaper))[0]) << own_first;
    trace.all_fragments[0].position.z = 2000;
    EXPECT_TRUE(find_unshadowable(trace, winding(Semantics::kPaper))[0]) << own_first;
  }
}

TEST(Unshadowable, FragmentsDecidedByDefinitionDoNotCount) {
  EXPECT_TRUE(flagged(fragment(kT, kT, 1001, 1, Fragment::kAverted)));
  EXPECT_TRUE(flagged(fragment(kT, kT, 1001, 1, Fragment::kOutside)));
  EXPECT_FALSE(flagged(fragment(kT, kT, 1001, 1, Fragment::kVisible)));
  EXPECT_TRUE(flagged(fragment(32 * kT, kT, 1001, 1)));  // off the map
  EXPECT_TRUE(flagged(fragment(kT, -32 * kT - 1, 1001, 1)));
}

TEST(Unshadowable, FlatPointsAndLinesShadowNothing) {
  Trace trace = sheet_and(fragment(kT, kT, 1001, 1));
  for (Caster& c : trace.all_casters) c.vertex[2] = c.vertex[1];
  EXPECT_TRUE(find_unshadowable(trace, winding(Semantics::kPhysical))[1]);
}

TEST(Unshadowable, LargeCastersReachAllTheirTiles) {
  // Any size and any map, from one tile to hundreds an axis; the last column and row included.
  for (const auto& [width, height] : {std::pair{4096, 4096}, {1000, 37}, {65, 129}, {1, 1}}) {
    for (const std::int32_t spread : {1, 20, 60, 200, 700, 1500, 4096}) {
      Trace trace = sheet_and({});
      const std::int32_t left = -(width / 2) * kT, top = -(height / 2) * kT;
      const std::int32_t right =
          std::int32_t(std::min<std::int64_t>(left + std::int64_t{spread} * kT, kCoordinateMax));
      const std::int32_t bottom =
          std::int32_t(std::min<std::int64_t>(top + std::int64_t{spread} * kT, kCoordinateMax));
      trace.all_casters = {{{{left, top, 1000}, {right, top, 1000}, {left, bottom, 1000}}, 0, 0}};
      const auto at = [&](std::int64_t x, std::int64_t y) {  // texels of the map
        trace.all_fragments = {
            fragment(std::int32_t(left + x * kT), std::int32_t(top + y * kT), 1001, 1)};
        return find_unshadowable(trace, winding(Semantics::kPhysical, width, height))[1] != 0;
      };
      const std::int32_t x = std::min(spread, width) - 1, y = std::min(spread, height) - 1;
      EXPECT_FALSE(at(0, 0));
      EXPECT_FALSE(at(x, 0)) << width << " " << spread;
      EXPECT_FALSE(at(0, y)) << height << " " << spread;
      EXPECT_FALSE(at(x, y)) << width << "x" << height << " " << spread;
      // Not farther than a quarter of its size beyond it, a tile and a texel.
      const std::int32_t beyond = spread + spread / 4 + 16;
      if (beyond < width) {
        EXPECT_TRUE(at(beyond, 0)) << width << " " << spread;
      }
      if (beyond < height) {
        EXPECT_TRUE(at(0, beyond)) << height << " " << spread;
      }
    }
  }
}

TEST(Unshadowable, IsNeverWrong) {
  constexpr std::uint32_t kObjects = 6;
  std::size_t known = 0, tried = 0;
  EXPECT_TRUE(rc::check([&] {
    const auto seed = *rc::gen::arbitrary<std::uint64_t>();
    const Soup soup = kAllSoups[*rc::gen::inRange(0, int(std::size(kAllSoups)))];
    Trace trace;
    trace.header.objects.resize(kObjects);
    trace.header.fraction_bits = *rc::gen::element(16u, 18u, 20u, 26u);
    trace.all_casters = random_soup(soup, *rc::gen::inRange<std::size_t>(1, 60), seed);
    const std::int64_t width = *rc::gen::element(64, 1000, 1024, 4096);
    const UnitConfig config =
        winding(*rc::gen::element(Semantics::kPaper, Semantics::kPhysical), width, 1024);
    Generator g(seed);
    for (std::uint32_t object = 0; object < kObjects; ++object) {
      // Few fragments near one place, some in front, so that a flag is not out of reach.
      const LightPoint p = random_query(trace.all_casters, g);
      for (std::int64_t n = g.in(1, 4); n > 0; --n) {
        LightPoint q = g.near(p, std::int64_t{1} << g.in(0, 22), 1000);
        if (g.in(0, 2) == 0) q.z = std::uint32_t(g.in(0, q.z));
        trace.all_fragments.push_back(fragment(q.x, q.y, q.z, object));
      }
    }
    const std::vector<std::uint8_t> flags = find_unshadowable(trace, config);
    const ExactReference reference(trace.all_casters);
    RC_ASSERT(flags.size() == kObjects);
    for (const Fragment& f : trace.all_fragments) {
      const std::int64_t x = (f.position.x >> trace.header.fraction_bits) + config.map_width / 2;
      const std::int64_t y = (f.position.y >> trace.header.fraction_bits) + config.map_height / 2;
      if (x < 0 || y < 0 || x >= config.map_width || y >= config.map_height) continue;
      ++tried;
      if (!flags[f.object]) continue;
      ++known;
      RC_ASSERT(!reference.dark(f, config.semantics));
    }
  }));
  EXPECT_GT(known, tried / 50);
  EXPECT_LT(known, tried);
}

}  // namespace
}  // namespace kagesen

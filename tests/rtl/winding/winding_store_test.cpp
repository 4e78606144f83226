#include <gtest/gtest.h>

#include <random>
#include <sstream>

#include "Vwinding_store_test_dut.h"
#include "model/frame_setup.h"
#include "model/unit/winding/shadow_unit.h"
#include "tests/model/unit/winding/soups.h"
#include "tests/rtl/winding/store_bench.h"
#include "tests/stress/case.h"

namespace kagesen::rtl {
namespace {

using Bench = StoreBench<Vwinding_store_test_dut>;

MemorySettings random_memory(std::mt19937_64& random) {
  MemorySettings settings;
  settings.seed = random();
  if (random() % 4 == 0) return settings;  // 20 cycles, always ready
  settings.least_latency = 1 + random() % 20;
  settings.most_latency = settings.least_latency + random() % 60;
  settings.read_ready_percent = 20 + random() % 81;
  settings.write_ready_percent = 20 + random() % 81;
  return settings;
}

UnitConfig random_policies(std::mt19937_64& random, UnitConfig config) {
  config.profile = Profile::kWinding;
  config.semantics = random() % 2 ? Semantics::kPaper : Semantics::kPhysical;
  config.skip_receiver_mask = random() % 3 != 0;
  config.skip_edges = random() % 2;
  config.skip_fragments = random() % 2;
  return config;
}

UnitConfig random_capacities(std::mt19937_64& random, UnitConfig config) {
  if (random() % 2) config.cluster_records = 1 + static_cast<std::int64_t>(random() % 50);
  if (random() % 2) config.chain_records = 1 + static_cast<std::int64_t>(random() % 5);
  return config;
}

std::string in_words(const TexelCluster& c) {
  std::ostringstream out;
  out << "texel " << c.texel_x << ',' << c.texel_y << " object " << c.object << " base " << c.base
      << " gradients " << c.gradient_x << ' ' << c.gradient_y << " corner " << c.corner << " full "
      << c.full;
  for (const SegmentRecord& s : c.segments) {
    out << " | " << s.x0 << ',' << s.y0 << ' ' << s.x1 << ',' << s.y1 << ' ' << s.positive
        << s.crosses_left;
  }
  return out.str();
}

/// What the tiles say, as golden's bounds clamped to a depth's range and one below.
void compare_tiles(const Bench& bench, const unit::winding::ShadowUnit& golden) {
  using unit::winding::Texel;
  using unit::winding::Tile;
  const WindingLayout::Tile& t = bench.layout().tile;
  const auto clamped = [](std::int64_t depth) {
    return static_cast<std::uint64_t>(std::clamp<std::int64_t>(depth, -1, kDepthMax)) & 0x1ffffff;
  };
  const unit::winding::TexelBuffers& texels = golden.texels();
  for (std::uint32_t y = 0; y < texels.height(); y += 8) {
    for (std::uint32_t x = 0; x < texels.width(); x += 8) {
      SCOPED_TRACE("tile at " + std::to_string(x) + ',' + std::to_string(y));
      const Tile& tile = texels.tile(x, y);
      const Word word = bench.tile(x, y);
      ASSERT_EQ(t.touched.get(word), tile.slot != Tile::kUntouched);
      if (tile.slot != Tile::kUntouched) {
        ASSERT_EQ(t.slot.get(word), tile.slot);
      }
      ASSERT_EQ(t.nearest.get(word), clamped(tile.nearest));
      ASSERT_EQ(t.farthest.get(word), clamped(tile.farthest));
      ASSERT_EQ(t.mask.get(word), tile.occupied);
      ASSERT_EQ(t.last.get(word), tile.last_fragment);
      ASSERT_EQ(t.object_valid.get(word), tile.object != Texel::kNobody);
      ASSERT_EQ(t.several.get(word), tile.object == Tile::kSeveral);
      if (tile.object < Tile::kSeveral) {
        ASSERT_EQ(t.object.get(word), tile.object);
      }
    }
  }
}

/// The store against golden on the same frame: buffers, SLB, tiles, counters.
void compare(Bench& bench, const UnitConfig& config, const FrameSetup& setup,
             const std::vector<Caster>& casters, const std::vector<Fragment>& fragments,
             unsigned offer_percent, const std::string& name) {
  SCOPED_TRACE(name);
  const auto golden = make_golden_engine();
  golden->begin(config, setup);
  golden->announce(fragments.data(), fragments.size());
  golden->draw(casters.data(), casters.size());
  const MapContents expected = golden->contents();
  const UnitCounters c = golden->counters();
  const StoreCounts counts =
      bench.run(fragments, setup, golden_visits(casters, setup, config), offer_percent);
  std::uint64_t records = 0;
  const MapContents got = bench.contents(&records);
  ASSERT_EQ(got.overflowed, expected.overflowed);
  ASSERT_EQ(got.object, expected.object);
  ASSERT_EQ(got.depth, expected.depth);
  for (std::size_t i = 0; i < std::min(got.clusters.size(), expected.clusters.size()); ++i) {
    ASSERT_TRUE(got.clusters[i] == expected.clusters[i])
        << "cluster " << i << "\nis       " << in_words(got.clusters[i]) << "\nis to be "
        << in_words(expected.clusters[i]);
  }
  ASSERT_EQ(got.clusters.size(), expected.clusters.size());
  EXPECT_EQ(counts.stored, c.lines_stored);
  EXPECT_EQ(counts.cancelled, c.lines_cancelled);
  EXPECT_EQ(counts.lines_hidden, c.lines_hidden);
  EXPECT_EQ(counts.emptied_covered, c.emptied_covered);
  EXPECT_EQ(counts.overflow_lines, c.overflow_lines);
  EXPECT_EQ(counts.overflow_texels, c.overflow_texels);
  EXPECT_EQ(counts.peak, c.peak_entries);
  EXPECT_EQ(counts.texel_visits, c.skips.texel_visits);
  EXPECT_EQ(counts.masked, c.skips.masked_visits);
  EXPECT_EQ(counts.hidden, c.skips.hidden_visits);
  EXPECT_EQ(counts.touched * 64, c.skips.cleared_texels);
  EXPECT_EQ(bench.records(), records);

  unit::winding::ShadowUnit unit;
  unit.begin(config, setup);
  unit.announce(fragments.data(), fragments.size());
  for (const Caster& caster : casters) unit.draw(caster);
  unit.settle();
  compare_tiles(bench, unit);
}

void random_traces(std::uint64_t first, std::uint64_t last, bool tight) {
  for (std::uint64_t seed = first; seed <= last; ++seed) {
    std::mt19937_64 random(seed);
    const int texel_bits = 16 + static_cast<int>(random() % 11);
    const RandomTrace scene(kScenes[seed % 4], texel_bits, 8, seed,
                            20 + static_cast<int>(random() % 600));
    UnitConfig config = random_policies(random, scene.fit(UnitConfig{}));
    if (tight) config = random_capacities(random, config);
    config.map_width -= static_cast<std::int64_t>(random() % 3);
    config.map_height -= static_cast<std::int64_t>(random() % 3);
    Bench bench(config, WindingWidths{}, random_memory(random));
    const FrameSetup setup = make_frame_setup(scene.trace, config);
    for (int frame = 0; frame < 2; ++frame) {
      compare(bench, config, setup, scene.trace.all_casters, scene.trace.all_fragments,
              1 + random() % 100, "seed " + std::to_string(seed));
      if (testing::Test::HasFailure()) return;
    }
  }
}

TEST(WindingStore, EqualsGoldenOnRandomTraces) { random_traces(1, 8, false); }
TEST(WindingStore, EqualsGoldenAtTightCapacities) { random_traces(1000, 1010, true); }

/// Everything in a handful of texels: long lists, records that go on, pieces that cancel.
TEST(WindingStore, EqualsGoldenInCrowdedTexels) {
  for (unsigned seed = 1; seed <= 50; ++seed) {
    std::mt19937_64 random(seed);
    UnitConfig config = random_policies(random, small_config(4));
    if (seed % 3 == 0) config = random_capacities(random, config);
    const unsigned depths = 1 + random() % 12, objects = 1 + random() % 4, grid = 1 + random() % 6;
    FrameSetup setup;
    setup.facets.clear();
    std::vector<Caster> casters;
    for (unsigned i = 0; i < 20 + random() % 80; ++i) {
      Caster c;
      for (LightPoint& v : c.vertex) {
        v.x = (static_cast<std::int32_t>(random() % (2 * grid)) - static_cast<std::int32_t>(grid)) *
              static_cast<std::int32_t>(110000 / grid);
        v.y = (static_cast<std::int32_t>(random() % (2 * grid)) - static_cast<std::int32_t>(grid)) *
              static_cast<std::int32_t>(110000 / grid);
        v.z = 1000 + static_cast<std::uint32_t>(random() % depths) * 100'000;
      }
      if (random() % 2) {  // level: planes repeat
        c.vertex[1].z = c.vertex[2].z = c.vertex[0].z;
      }
      if (random() % 4 == 0) {  // as good as a point
        c.vertex[1] = c.vertex[2] = c.vertex[0];
        c.vertex[1].x += 1 + static_cast<std::int32_t>(random() % 40);
        c.vertex[2].y += 1 + static_cast<std::int32_t>(random() % 40);
      }
      c.object = static_cast<std::uint32_t>(random() % objects);
      casters.push_back(c);
      Facet facet;
      facet.inner_edges = static_cast<std::uint8_t>(random() % 8);
      setup.facets.push_back(facet);
      if (random() % 2 == 0) {  // its neighbour beyond an inner edge: pieces cancel
        std::swap(c.vertex[0], c.vertex[1]);
        casters.push_back(c);
        setup.facets.push_back(facet);
      }
    }
    config.skip_receiver_mask = false;
    Bench bench(config, WindingWidths{}, random_memory(random));
    compare(bench, config, setup, casters, {}, 100, "seed " + std::to_string(seed));
    if (testing::Test::HasFailure()) return;
  }
}

TEST(WindingStore, EqualsGoldenOnStressCases) {
  stress::CaseOptions options;
  options.profile = Profile::kWinding;
  for (std::uint64_t number = 0; number < stress::families().size(); ++number) {
    std::mt19937_64 random(number);
    const stress::StressCase c = stress::make_case(7, number, options);
    UnitConfig config;
    config.map_width = c.trace.header.map_width;
    config.map_height = c.trace.header.map_height;
    if (config.map_width > 128 || config.map_height > 128) continue;
    config = random_policies(random, config);
    if (number % 2) config = random_capacities(random, config);
    Bench bench(config, WindingWidths{}, random_memory(random));
    compare(bench, config, make_frame_setup(c.trace, config), c.trace.all_casters,
            c.trace.all_fragments, 100, c.family->name + " " + std::to_string(number));
    if (testing::Test::HasFailure()) return;
  }
}

/// An abort in mid-frame leaves nothing behind.
TEST(WindingStore, StartsAnewAfterClear) {
  for (unsigned seed = 1; seed <= 8; ++seed) {
    std::mt19937_64 random(seed);
    const RandomTrace scene(kScenes[seed % 4], 20, 8, seed, 300);
    UnitConfig config = random_policies(random, scene.fit(UnitConfig{}));
    Bench bench(config, WindingWidths{}, random_memory(random));
    const FrameSetup setup = make_frame_setup(scene.trace, config);
    UnitConfig unmasked = config;
    unmasked.skip_receiver_mask = false;
    bench.run_and_clear(setup, golden_visits(scene.trace.all_casters, setup, unmasked),
                        random() % 3000);
    compare(bench, config, setup, scene.trace.all_casters, scene.trace.all_fragments, 100,
            "seed " + std::to_string(seed));
    if (testing::Test::HasFailure()) return;
  }
}

}  // namespace
}  // namespace kagesen::rtl

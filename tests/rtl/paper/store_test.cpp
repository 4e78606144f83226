#include <gtest/gtest.h>

#include <iostream>
#include <random>
#include <sstream>

#include "Vstore_test_dut.h"
#include "model/frame_setup.h"
#include "model/golden.h"
#include "model/unit/shadow_unit.h"
#include "tests/model/random_casters.h"
#include "tests/model/unit/frame.h"
#include "tests/rtl/paper/store_bench.h"
#include "tests/stress/case.h"
#include "traces/raster/capture.h"
#include "traces/scene/scene.h"

namespace kagesen::rtl {
namespace {

using Bench = StoreBench<Vstore_test_dut>;

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
  config.depth_writes = random() % 2 ? DepthWrites::kAll : DepthWrites::kCovered;
  config.hidden_removal = static_cast<HiddenRemoval>(random() % 3);
  config.match_polygon_id = random() % 2;
  return config;
}

/// Few records, few buckets, short chains.
UnitConfig random_capacities(std::mt19937_64& random, UnitConfig config) {
  config.slb_buckets = std::int64_t{1} << random() % 8;
  if (random() % 2) config.slb_entries = 1 + static_cast<std::int64_t>(random() % 50);
  if (random() % 2) config.link_depth = 1 + static_cast<std::int64_t>(random() % 5);
  return config;
}

std::string in_words(const TexelEntry& entry) {
  std::ostringstream out;
  out << "texel " << entry.texel_x << ',' << entry.texel_y << " object " << entry.object
      << " nearest " << entry.nearest << " vertex " << entry.vertex;
  for (const LineRecord& l : entry.lines) {
    out << " | " << l.polygon << ' ' << l.fraction << ' ' << l.slope << ' ' << l.left << l.cross
        << l.x_major << l.x_positive << l.start_here << l.end_here;
  }
  return out.str();
}

/// The store against golden on the same casters: buffers, SLB, its chains' order, counters.
void compare(Bench& bench, const UnitConfig& config, const FrameSetup& setup,
             const std::vector<Caster>& casters, unsigned offer_percent, const std::string& name) {
  SCOPED_TRACE(name);
  const auto unit = std::make_shared<unit::ShadowUnit>();
  const auto golden = make_golden_paper_engine(unit);
  golden->begin(config, setup);
  golden->draw(casters.data(), casters.size());
  std::vector<Caster> numbered = casters;
  for (Caster& c : numbered) {
    if (c.object < setup.unit_ids.size()) c.object = setup.unit_ids[c.object];
  }
  const int texel_bits = static_cast<int>(setup.fraction_bits);
  const std::vector<GoldenVisit> visits = golden_visits(numbered, config, texel_bits);
  const StoreCounts counts = bench.run(visits, setup.fraction_bits, offer_percent);
  const MapContents expected = golden->contents(), got = bench.contents();
  ASSERT_EQ(got.depth, expected.depth);
  ASSERT_EQ(got.object, expected.object);
  ASSERT_EQ(got.overflowed, expected.overflowed);
  ASSERT_EQ(got.entries.size(), expected.entries.size());
  for (std::size_t i = 0; i < got.entries.size(); ++i) {
    const TexelEntry &a = got.entries[i], &b = expected.entries[i];
    ASSERT_TRUE(a == b) << "entry " << i << "\nis       " << in_words(a) << "\nis to be " << in_words(b);
  }
  for (std::uint32_t bucket = 0; bucket < unit->slb().buckets(); ++bucket) {
    std::vector<EntryName> chain;
    for (std::uint32_t at = unit->slb().head(bucket); at != unit::SilhouetteBuffer::kNone;
         at = unit->slb()[at].next) {
      const unit::Record& r = unit->slb()[at];
      chain.push_back({r.texel % expected.width, r.texel / expected.width, r.object});
    }
    ASSERT_EQ(bench.chain(bucket), chain) << "bucket " << bucket;
  }
  const UnitCounters c = golden->counters();
  EXPECT_EQ(counts.stored, c.lines_stored);
  EXPECT_EQ(counts.cancelled, c.lines_cancelled);
  EXPECT_EQ(counts.hidden, c.lines_hidden);
  EXPECT_EQ(counts.emptied_covered, c.emptied_covered);
  EXPECT_EQ(counts.overflow_lines, c.overflow_lines);
  EXPECT_EQ(counts.overflow_texels, c.overflow_texels);
  EXPECT_EQ(counts.peak, c.peak_entries);
  EXPECT_EQ(bench.linked_records(), bench.records());
  EXPECT_EQ(counts.causes[0], counts.edge_visits);
  EXPECT_EQ(counts.causes[1], counts.span_visits);
}

/// Soups on maps of 4 to 64 texels a side that they fill, two frames back to back.
void soups(std::uint64_t first, std::uint64_t last, std::size_t triangles, bool tight) {
  for (std::uint64_t seed = first; seed <= last; ++seed) {
    std::mt19937_64 random(seed);
    for (const Soup soup : kAllSoups) {
      const unsigned side_log2 = 2 + random() % 5;
      UnitConfig config = random_policies(random, small_config());
      config.slb_buckets = 1 << (4 + random() % 8);
      if (tight) config = random_capacities(random, config);
      config.map_width = (1 << side_log2) - static_cast<std::int64_t>(random() % 3);
      config.map_height = (1 << side_log2) - static_cast<std::int64_t>(random() % 3);
      FrameSetup setup;
      setup.fraction_bits = 26 - side_log2;
      if (soup == Soup::kTiny || soup == Soup::kDegenerate || soup == Soup::kConcentrated)
        setup.fraction_bits = 16;
      Bench bench(config, PaperWidths{}, random_memory(random));
      for (int frame = 0; frame < 2; ++frame) {
        const std::size_t count = 1 + random() % triangles;
        compare(bench, config, setup, random_soup(soup, count, seed * 2 + frame),
                1 + random() % 100,
                "soup " + std::to_string(static_cast<int>(soup)) + " seed " + std::to_string(seed));
        if (testing::Test::HasFatalFailure()) return;
      }
    }
  }
}

TEST(Store, EqualsGoldenOnSoups) { soups(1, 1, 16, false); }
TEST(Store, EqualsGoldenOnSoupsAtTightCapacities) { soups(100, 101, 16, true); }

/// Closed solids cancel, empty and cover; tight capacities meet all the rest.
TEST(Store, EqualsGoldenOnSolids) {
  for (unsigned seed = 1; seed <= 40; ++seed) {
    std::mt19937_64 random(seed);
    const int side = 16 << random() % 3;
    UnitConfig config = random_policies(random, small_config(side));
    config.slb_buckets = 64;
    if (seed % 2) config = random_capacities(random, config);
    const RandomScene scene(seed, side, 2 + static_cast<int>(random() % 12), 0);
    Bench bench(config, PaperWidths{}, random_memory(random));
    compare(bench, config, FrameSetup{}, scene.frame.casters, 100, "seed " + std::to_string(seed));
    if (testing::Test::HasFatalFailure()) return;
  }
}

/// Many triangles and objects in a handful of texels: long chains, continuations, ties of depth.
TEST(Store, EqualsGoldenInCrowdedTexels) {
  for (unsigned seed = 1; seed <= 60; ++seed) {
    std::mt19937_64 random(seed);
    UnitConfig config = random_policies(random, small_config(4));
    config.slb_buckets = 1 << random() % 4;
    if (seed % 3 == 0) config = random_capacities(random, config);
    std::vector<Caster> casters;
    const unsigned depths = 2 + random() % 30, objects = 1 + random() % 6, grid = 1 + random() % 12;
    for (unsigned i = 0; i < 20 + random() % 60; ++i) {
      Caster c;
      for (LightPoint& v : c.vertex) {
        v.x = (static_cast<std::int32_t>(random() % (2 * grid)) - static_cast<std::int32_t>(grid)) *
              static_cast<std::int32_t>(110000 / grid);
        v.y = (static_cast<std::int32_t>(random() % (2 * grid)) - static_cast<std::int32_t>(grid)) *
              static_cast<std::int32_t>(110000 / grid);
        v.z = 1000 + static_cast<std::uint32_t>(random() % depths);
      }
      c.object = static_cast<std::uint32_t>(random() % objects);
      c.polygon = i;
      casters.push_back(c);
      if (random() % 3 == 0) {  // its back: cancels
        std::swap(c.vertex[0], c.vertex[1]);
        c.polygon = 1000 + i;
        LightPoint& moved = c.vertex[2];
        moved.x = -moved.x;
        casters.push_back(c);
      }
    }
    Bench bench(config, PaperWidths{}, random_memory(random));
    compare(bench, config, FrameSetup{}, casters, 100, "seed " + std::to_string(seed));
    if (testing::Test::HasFatalFailure()) return;
  }
}

TEST(Store, EqualsGoldenOnStressCases) {
  stress::CaseOptions options;
  options.profile = Profile::kPaper;
  for (std::uint64_t number = 0; number < 2 * stress::families().size(); ++number) {
    std::mt19937_64 random(number);
    const stress::StressCase c = stress::make_case(7, number, options);
    UnitConfig config;
    config.map_width = c.trace.header.map_width;
    config.map_height = c.trace.header.map_height;
    if (config.map_width > 256 || config.map_height > 256) continue;
    config = random_policies(random, config);
    config.slb_buckets = 256;
    if (number % 2) config = random_capacities(random, config);
    Bench bench(config, PaperWidths{}, random_memory(random));
    compare(bench, config, make_frame_setup(c.trace, config), c.trace.all_casters, 100,
            c.family->name + " " + std::to_string(number));
    if (testing::Test::HasFatalFailure()) return;
  }
}

/// An abort in mid-frame leaves nothing behind.
TEST(Store, StartsAnewAfterClear) {
  for (unsigned seed = 1; seed <= 30; ++seed) {
    std::mt19937_64 random(seed);
    UnitConfig config = random_policies(random, small_config(16));
    config.slb_buckets = 16;
    const RandomScene scene(seed, 16, 6, 0);
    Bench bench(config, PaperWidths{}, random_memory(random));
    const auto visits = golden_visits(scene.frame.casters, config, 16);
    bench.run_and_clear(visits, 16, random() % 1500);
    compare(bench, config, FrameSetup{}, scene.frame.casters, 100, "seed " + std::to_string(seed));
    if (testing::Test::HasFatalFailure()) return;
  }
}

/// Cycles a visit on a scene, with a memory of 20 cycles and a front that always has a visit.
void scene_speed(double scale, double bound) {
  CaptureOptions options;
  options.image_width = options.image_height = 16;  // fragments play no part
  options.scale_x = options.scale_y = scale;
  Trace trace;
  capture(make_builtin("solids"), options, trace);
  const UnitConfig config;
  const FrameSetup setup = make_frame_setup(trace, config);
  std::vector<Caster> casters = trace.all_casters;
  for (Caster& c : casters) {
    if (c.object < setup.unit_ids.size()) c.object = setup.unit_ids[c.object];
  }
  const auto visits = golden_visits(casters, config, static_cast<int>(setup.fraction_bits));
  Bench bench(config, PaperWidths{}, MemorySettings{});
  const StoreCounts counts = bench.run(visits, setup.fraction_bits, 100);
  const std::uint64_t items = counts.edge_visits + counts.span_visits;
  const double each = static_cast<double>(counts.cycles) / static_cast<double>(items);
  std::ostringstream causes;
  for (std::size_t i = 0; i < 10; ++i) causes << ' ' << counts.causes[i];
  std::cout << "scale " << scale << ": " << counts.edge_visits << " edge visits, "
            << counts.span_visits << " span words, " << each << " cycles each; causes"
            << causes.str() << '\n';
  EXPECT_LT(each, bound);
}
TEST(Store, CyclesOfAScene) {
  scene_speed(1, 2.1);
  scene_speed(16, 2.7);
}

}  // namespace
}  // namespace kagesen::rtl

// Pass 2 of the winding profile: the lane against the golden unit, on the golden unit's own buffers.
//
// With arguments `cycles [WIDTH [LATENCY [SCENE]]]` the program prints cycles a fragment on the built-in
// scenes, or one of them, instead.
#include <gtest/gtest.h>

#include <cstdio>
#include <cstring>
#include <string>

#include "model/unit/winding/shadow_unit.h"
#include "tests/rtl/winding/lane_bench.h"
#include "tests/stress/case.h"
#include "traces/raster/capture.h"
#include "traces/scene/scene.h"

namespace kagesen::rtl {
namespace {

Trace frame_of(const std::string& scene, double scale, unsigned width, unsigned map) {
  CaptureOptions options;
  options.image_width = width;
  options.image_height = width * 9 / 16;
  options.map_width = options.map_height = map;
  options.scale_x = options.scale_y = scale;
  Trace trace;
  capture(make_builtin(scene), options, trace);
  return trace;
}

UnitConfig config_of(const Trace& trace, Semantics semantics = Semantics::kPhysical) {
  UnitConfig config;
  config.profile = Profile::kWinding;
  config.semantics = semantics;
  config.map_width = trace.header.map_width;
  config.map_height = trace.header.map_height;
  return config;
}

struct Settings {
  MemorySettings memory;
  LaneStalls stalls;
};
Settings stalling(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  Settings s;
  const auto percent = [&] { return random() % 3 == 0 ? 100u : 20 + unsigned(random() % 80); };
  s.memory.least_latency = 1 + unsigned(random() % 30);
  s.memory.most_latency = s.memory.least_latency + unsigned(random() % 3) * unsigned(random() % 40);
  s.memory.read_ready_percent = percent();
  s.memory.seed = seed;
  s.stalls = {percent(), percent()};
  return s;
}

struct Frame {
  Frame(const Trace& trace, const UnitConfig& config, const Settings& settings, std::uint64_t seed,
        bool uneven = true)
      : fragments(trace.all_fragments), setup(make_frame_setup(trace, config)) {
    unit.begin(config, setup);
    unit.announce(fragments.data(), fragments.size());
    for (const Caster& caster : trace.all_casters) unit.draw(caster);
    unit.settle();
    MemoryWidths widths;
    widths.uneven = uneven;
    ContentsEncoder encoder(unit, widths, seed);
    texels = std::make_unique<Memory>(encoder.texel_data_bits(), settings.memory);
    slb = std::make_unique<Memory>(encoder.record_bits(), settings.memory);
    encoder.encode(*texels, *slb);
  }
  const std::vector<Fragment>& fragments;
  FrameSetup setup;
  unit::winding::ShadowUnit unit;
  std::unique_ptr<Memory> texels, slb;
};

LaneCounters expect_golden(const Trace& trace, const UnitConfig& config, const Settings& settings,
                           std::uint64_t seed, bool aborted = false) {
  Frame frame(trace, config, settings, seed);
  LaneBench lane(config, frame.setup, *frame.texels, *frame.slb);
  if (aborted) {
    LaneCounters unused;
    lane.run(frame.fragments, settings.stalls, unused, seed + 1, seed % 500);
    lane.clear();
  }
  LaneCounters n;
  const auto found = lane.run(frame.fragments, settings.stalls, n, seed);
  std::vector<Verdict> expected(frame.fragments.size());
  frame.unit.decide(frame.fragments.data(), expected.size(), expected.data());
  const UnitCounters& golden = frame.unit.counters();
  EXPECT_EQ(found.size(), expected.size());
  std::uint64_t different = 0;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    if (found[i] != expected[i] && different++ == 0) ADD_FAILURE() << "first at fragment " << i;
  }
  EXPECT_EQ(different, 0u);
  EXPECT_EQ(n.slb_lookups, golden.slb_lookups);
  EXPECT_EQ(n.entries_read, golden.entries_read);
  EXPECT_EQ(n.lines_read, golden.lines_read);
  EXPECT_EQ(n.known, golden.skips.known_fragments);
  EXPECT_EQ(n.tile_lit, golden.skips.tile_lit);
  EXPECT_EQ(n.tile_dark, golden.skips.tile_dark);
  EXPECT_EQ(n.texel_lookups, golden.skips.texel_lookups);
  EXPECT_EQ(n.first_test, golden.skips.first_test_dark);
  EXPECT_EQ(n.by_dark[0], golden.averted);
  EXPECT_EQ(n.by_lit[1], golden.outside);
  EXPECT_EQ(n.by_dark[3] + n.by_dark[5], golden.dark_by_buffer);
  EXPECT_EQ(n.by_dark[5], golden.skips.tile_dark);
  EXPECT_EQ(n.by_lit[5], golden.skips.tile_lit);
  EXPECT_EQ(n.by_dark[4], golden.dark_by_lines);
  EXPECT_EQ(n.by_lit[2] + n.by_lit[5], golden.lit);
  return n;
}

UnitConfig random_policy(UnitConfig config, std::mt19937_64& random) {
  config.semantics = random() % 2 ? Semantics::kPaper : Semantics::kPhysical;
  for (bool UnitConfig::*skip :
       {&UnitConfig::skip_receiver_mask, &UnitConfig::skip_first_test, &UnitConfig::skip_tiles,
        &UnitConfig::skip_edges, &UnitConfig::skip_fragments}) {
    config.*skip = random() % 3 != 0;
  }
  if (random() % 4 == 0) config.cluster_records = 64 + std::int64_t(random() % 4096);
  if (random() % 4 == 0) config.chain_records = 1 + std::int64_t(random() % 12);
  return config;
}

TEST(ShadowLane, DecidesScenesAsTheGoldenUnitDoesUnderEveryPolicy) {
  std::mt19937_64 random(11);
  std::uint64_t seed = 0, lists = 0;
  for (const SceneInfo& scene : builtin_scenes()) {
    if (scene.name == "sphere1m") continue;  // seconds for its geometry alone
    for (const double scale : {1.0, 16.0, 256.0}) {
      // At scale 256 the scene lies in a few texels: lists of thousands of records.
      const Trace trace = frame_of(scene.name, scale, scale > 16 ? 16 : 72, 128);
      for (int i = 0; i < 2; ++i) {
        SCOPED_TRACE(testing::Message() << scene.name << " scale " << scale << " seed " << ++seed);
        const UnitConfig config = i == 0 ? config_of(trace) : random_policy(config_of(trace), random);
        lists += expect_golden(trace, config, i == 0 ? Settings{} : stalling(seed), seed, i != 0)
                     .slb_lookups;
        if (testing::Test::HasFailure()) return;
      }
    }
  }
  EXPECT_GT(lists, 1000u);
}

TEST(ShadowLane, DecidesStressCasesAsTheGoldenUnitDoes) {
  std::mt19937_64 random(12);
  stress::CaseOptions options;
  options.profile = Profile::kWinding;
  std::uint64_t entries = 0;
  for (std::uint64_t number = 0; number < 80; ++number) {
    const stress::StressCase made = stress::make_case(3, number, options);
    const auto& header = made.trace.header;
    if (header.map_width > 1024 || header.map_height > 1024) continue;
    SCOPED_TRACE(testing::Message() << "case " << number);
    const UnitConfig config = random_policy(config_of(made.trace), random);
    entries += expect_golden(made.trace, config, stalling(number), number, number % 3 == 0).entries_read;
    if (testing::Test::HasFailure()) return;
  }
  EXPECT_GT(entries, 5000u);
}

int print_cycles(unsigned width, unsigned latency, const std::string& only) {
  Settings settings;
  settings.memory.least_latency = settings.memory.most_latency = latency;
  static const char* const kCauses[] = {"fragment", "input",    "texel",    "texelport", "slb",
                                        "slbport",  "decision", "verdict", "drain"};
  double sum = 0;
  int frames = 0;
  for (const SceneInfo& scene : builtin_scenes()) {
    for (const double scale : {1.0, 4.0, 16.0}) {
      if (!only.empty() && scene.name != only) continue;
      if (scene.name == "sphere1m" && scale > 1) continue;  // dozens of records a fragment: minutes
      const Trace trace = frame_of(scene.name, scale, width, 1024);
      const UnitConfig config = config_of(trace);
      Frame frame(trace, config, settings, 1, false);
      LaneBench lane(config, frame.setup, *frame.texels, *frame.slb);
      LaneCounters n;
      const auto verdicts = lane.run(frame.fragments, {}, n, 1);
      const double per = double(n.cycles) / double(verdicts.size());
      sum += per, ++frames;
      std::printf("%-10s %3g %8zu fragments %6.3f cycles/fragment, reads texel %.3f slb %.3f;", scene.name.c_str(),
                  scale, verdicts.size(), per, double(frame.texels->reads()) / double(verdicts.size()),
                  double(frame.slb->reads()) / double(verdicts.size()));
      for (int i = 1; i < 9; ++i)
        std::printf(" %s %.3f", kCauses[i], double(n.causes[std::size_t(i)]) / double(verdicts.size()));
      std::printf("\n");
      std::fflush(stdout);
    }
  }
  std::printf("mean %.3f\n", sum / frames);
  return 0;
}

}  // namespace
}  // namespace kagesen::rtl

int main(int argc, char** argv) {
  if (argc > 1 && std::strcmp(argv[1], "cycles") == 0) {
    return kagesen::rtl::print_cycles(argc > 2 ? unsigned(std::atoi(argv[2])) : 480,
                                      argc > 3 ? unsigned(std::atoi(argv[3])) : 20, argc > 4 ? argv[4] : "");
  }
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}

// The lane against pass 2 of the golden unit: every verdict, what decided it, and what was read.
// `shadow_lane_test cycles [WIDTH HEIGHT]` prints the cycles a fragment of every scene instead.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <string>

#include "tests/rtl/paper/lane_driver.h"
#include "tests/stress/case.h"
#include "traces/raster/capture.h"
#include "traces/scene/scene.h"

namespace kagesen::rtl {
namespace {

Trace frame_of(const std::string& scene, double scale, std::uint32_t width, std::uint32_t height,
               std::uint32_t side) {
  CaptureOptions options;
  options.image_width = width;
  options.image_height = height;
  options.map_width = options.map_height = side;
  options.scale_x = options.scale_y = scale;
  Trace trace;
  capture(make_builtin(scene), options, trace);
  return trace;
}

UnitConfig config_of(const Trace& trace, unsigned policies) {
  UnitConfig config;
  config.map_width = trace.header.map_width;
  config.map_height = trace.header.map_height;
  if (policies & 1) config.own_id_rule = OwnIdRule::kLiteral;
  if (policies & 2) config.vertex_rule = VertexRule::kPerEntry;
  if (policies & 4) config.table7 = Table7::kPrinted;
  if (policies & 8) config.hidden_removal = HiddenRemoval::kOff;
  if (policies & 16) config.link_depth = 3;
  return config;
}

/// The trace at another f: 2^by times finer, where its coordinates allow.
bool refine(Trace& trace, unsigned by) {
  const std::int64_t limit = std::int64_t{1} << 27;
  if (trace.header.fraction_bits + by > 26) return false;
  const auto fits = [&](const LightPoint& p) {
    return std::abs(std::int64_t{p.x} << by) < limit && std::abs(std::int64_t{p.y} << by) < limit;
  };
  for (const Caster& c : trace.all_casters) {
    for (const LightPoint& v : c.vertex) {
      if (!fits(v)) return false;
    }
  }
  for (const Fragment& f : trace.all_fragments) {
    if (!fits(f.position)) return false;
  }
  trace.header.fraction_bits += by;
  for (Caster& c : trace.all_casters) {
    for (LightPoint& v : c.vertex) v = {v.x * (1 << by), v.y * (1 << by), v.z};
  }
  for (Fragment& f : trace.all_fragments) {
    f.position.x *= 1 << by;
    f.position.y *= 1 << by;
  }
  return true;
}

struct Golden {
  std::vector<Verdict> verdicts;
  MapContents contents;
  UnitCounters counters;
};
Golden golden(const Trace& trace, const UnitConfig& config, const FrameSetup& setup) {
  const auto engine = make_golden_engine();
  engine->begin(config, setup);
  engine->draw(trace.all_casters.data(), trace.all_casters.size());
  Golden out;
  out.verdicts.resize(trace.all_fragments.size());
  engine->decide(trace.all_fragments.data(), out.verdicts.size(), out.verdicts.data());
  out.contents = engine->contents();
  out.counters = engine->counters();
  return out;
}

LaneRun random_run(unsigned seed) {
  std::mt19937 random(seed);
  const auto percent = [&] { return random() % 3 != 0 ? 100 : 30 + static_cast<unsigned>(random() % 70); };
  const auto memory = [&] {
    MemorySettings m;
    m.least_latency = 1 + static_cast<unsigned>(random() % 30);
    m.most_latency = m.least_latency + static_cast<unsigned>(random() % 2 != 0 ? random() % 60 : 0);
    m.read_ready_percent = percent();
    m.seed = random();
    return m;
  };
  LaneRun run;
  run.texel_memory = memory();
  run.slb_memory = memory();
  run.fragment_percent = percent();
  run.verdict_percent = percent();
  run.buckets_log2 = static_cast<unsigned>(random() % 15);
  run.seed = seed;
  return run;
}

void expect_same(const Trace& trace, const Golden& expected, const LaneResult& got) {
  ASSERT_EQ(got.verdicts.size(), expected.verdicts.size());
  for (std::size_t i = 0; i < got.verdicts.size(); ++i) {
    const Fragment& f = trace.all_fragments[i];
    ASSERT_EQ(got.verdicts[i], expected.verdicts[i])
        << "fragment " << i << " at " << f.position.x << ' ' << f.position.y << ' ' << f.position.z
        << ", object " << f.object;
  }
  const UnitCounters &a = expected.counters, &b = got.counters;
  EXPECT_EQ(b.averted, a.averted);
  EXPECT_EQ(b.outside, a.outside);
  EXPECT_EQ(b.lit, a.lit);
  EXPECT_EQ(b.dark_by_buffer, a.dark_by_buffer);
  EXPECT_EQ(b.dark_by_lines, a.dark_by_lines);
  EXPECT_EQ(b.slb_lookups, a.slb_lookups);
  EXPECT_EQ(b.entries_read, a.entries_read);
  EXPECT_EQ(b.lines_read, a.lines_read);
}

void check(LaneDriver& lane, const Trace& trace, unsigned policies, unsigned seed) {
  const UnitConfig config = config_of(trace, policies);
  const FrameSetup setup = make_frame_setup(trace, config);
  const Golden expected = golden(trace, config, setup);
  LaneRun run = random_run(seed);
  // Several texels a bucket, but not hundreds.
  while (expected.contents.entries.size() >> run.buckets_log2 > 8) ++run.buckets_log2;
  const LaneResult got =
      lane.decide(trace.all_fragments, expected.contents, config, setup, run);
  expect_same(trace, expected, got);
}

class ShadowLane : public testing::TestWithParam<std::string> {};

TEST_P(ShadowLane, DecidesScenesAsTheGoldenUnitDoes) {
  LaneDriver lane;
  unsigned seed = 1;
  for (const double scale : {1.0, 16.0, 256.0}) {
    Trace trace = frame_of(GetParam(), scale, 48, 27, 256);
    // Chains are long where everything falls into a few texels.
    if (scale > 16) trace.all_fragments.resize(trace.all_fragments.size() / 4);
    for (const unsigned policies : {0u, seed % 8}) {
      SCOPED_TRACE(fmt::format("scale {}, policies {}, seed {}", scale, policies, seed));
      check(lane, trace, policies, seed++);
      if (HasFatalFailure()) return;
    }
  }
}

std::vector<std::string> scene_names() {
  std::vector<std::string> out;
  for (const SceneInfo& scene : builtin_scenes()) {
    if (scene.name != "sphere1m") out.push_back(scene.name);
  }
  return out;
}
INSTANTIATE_TEST_SUITE_P(Scenes, ShadowLane, testing::ValuesIn(scene_names()),
                         [](const auto& info) { return info.param; });

TEST(ShadowLaneStress, DecidesTheFamiliesUnderEveryPolicyAndFractionWidth) {
  LaneDriver lane;
  stress::CaseOptions options;
  options.profile = Profile::kPaper;
  std::set<unsigned> fractions;
  unsigned used = 0;
  for (std::uint64_t number = 0; number < 33; ++number) {
    Trace trace = stress::make_case(17, number, options).trace;
    if (trace.header.map_width > 1024 || trace.header.map_height > 1024) continue;
    refine(trace, static_cast<unsigned>(number % 11));
    fractions.insert(trace.header.fraction_bits);
    const auto policies = static_cast<unsigned>(number % 32);
    SCOPED_TRACE(fmt::format("case {}, f {}", number, trace.header.fraction_bits));
    check(lane, trace, policies, static_cast<unsigned>(number) + 100);
    if (HasFatalFailure()) return;
    ++used;
  }
  EXPECT_GT(used, 20u);
  EXPECT_GE(fractions.size(), 9u);
}

TEST(ShadowLaneAbort, ClearDropsEverything) {
  LaneDriver lane;
  const Trace trace = frame_of("glyphs", 16, 48, 27, 128);
  const FrameSetup setup = make_frame_setup(trace, config_of(trace, 0));
  for (const int cycles : {1, 2, 5, 63, 200}) {
    lane.abort_after(trace.all_fragments, setup, cycles);
    check(lane, trace, 0, static_cast<unsigned>(cycles));
    if (HasFatalFailure()) return;
  }
}

void print_cycles(std::uint32_t width, std::uint32_t height) {
  const char* const names[] = {"fragment", "input",    "texel",    "texel port", "slb",
                               "slb port", "decision", "verdict"};
  fmt::print("{:9} {:>5} {:>9} {:>6} {:>10} {:>10}  lost to\n", "scene", "scale", "fragments",
             "cycles", "reads/frag", "entries/f.");
  double sum = 0;
  int runs = 0;
  for (const SceneInfo& scene : builtin_scenes()) {
    for (const double scale : {1.0, 4.0, 16.0}) {
      const Trace trace = frame_of(scene.name, scale, width, height, 1024);
      const UnitConfig config = config_of(trace, 0);
      const FrameSetup setup = make_frame_setup(trace, config);
      const Golden expected = golden(trace, config, setup);
      LaneDriver lane;
      const LaneResult got =
          lane.decide(trace.all_fragments, expected.contents, config, setup, LaneRun{});
      const auto count = static_cast<double>(got.verdicts.size());
      sum += static_cast<double>(got.cycles) / count;
      ++runs;
      std::string lost;
      for (int i = 1; i < 8; ++i) {
        if (got.causes[i] * 1000 > got.cycles) {
          lost += fmt::format(" {} {:.3f}", names[i], static_cast<double>(got.causes[i]) / count);
        }
      }
      fmt::print("{:9} {:5} {:9} {:6.3f} {:10.3f} {:10.3f} {}{}\n", scene.name, scale, count,
                 static_cast<double>(got.cycles) / count, static_cast<double>(got.slb_reads) / count,
                 static_cast<double>(got.counters.entries_read) / count, lost,
                 got.verdicts == expected.verdicts ? "" : "  VERDICTS DIFFER");
      std::fflush(stdout);
    }
  }
  fmt::print("mean of {} runs: {:.3f} cycles a fragment\n", runs, sum / runs);
}

}  // namespace
}  // namespace kagesen::rtl

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  if (argc > 1 && std::string(argv[1]) == "cycles") {
    const auto number = [&](int i, unsigned long otherwise) {
      return static_cast<std::uint32_t>(argc > i ? std::stoul(argv[i]) : otherwise);
    };
    kagesen::rtl::print_cycles(number(2, 480), number(3, 270));
    return 0;
  }
  return RUN_ALL_TESTS();
}

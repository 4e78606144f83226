/// SystemC and the Verilated unit, winding profile: every fragment's cycles, every pass's and cause's
/// total.
///
/// With arguments `more COUNT [SEED]` the program compares so many frames of random configurations, which
/// need models of their own, a minute each.
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <random>

#include "tests/sim/systemc/side_by_side.h"
#include "tests/stress/case.h"

namespace kagesen {
namespace {

UnitConfig config_of(const Trace& trace) {
  UnitConfig config;
  config.profile = Profile::kWinding;
  config.map_width = trace.header.map_width;
  config.map_height = trace.header.map_height;
  return config;
}

class Dice {
 public:
  explicit Dice(std::uint32_t seed) : random_(seed) {}
  template <typename T = std::uint32_t>
  T one_of(std::initializer_list<T> values) {
    return values.begin()[random_() % values.size()];
  }
  Timing timing() {
    Timing timing;
    timing.latency = one_of({1, 2, 3, 7, 20, 61, 200});
    timing.spread = one_of({0, 0, 1, 5, 100});
    timing.memory_stall = one_of({0, 0, 10, 70});
    timing.stream_stall = one_of({0, 0, 10, 70});
    timing.interval = one_of({1, 1, 2, 5});
    timing.outstanding = one_of({0, 0, 1, 3, 16});
    timing.banks = one_of({1, 2, 8});
    timing.bank_busy = one_of({1, 1, 3});
    timing.row_words = one_of({0, 4, 64});
    timing.row_miss = one_of({0, 0, 6});
    timing.seed = random_();
    return timing;
  }
  /// What is a register, and needs no model of its own.
  UnitConfig policy(UnitConfig config) {
    if (one_of({0, 1}) != 0) config.semantics = Semantics::kPaper;
    for (bool UnitConfig::*skip :
         {&UnitConfig::skip_receiver_mask, &UnitConfig::skip_first_test, &UnitConfig::skip_tiles,
          &UnitConfig::skip_edges, &UnitConfig::skip_fragments}) {
      config.*skip = one_of({0, 1, 1}) != 0;
    }
    if (one_of({0, 0, 0, 1}) != 0) config.cluster_records = one_of({64, 500, 4000});
    if (one_of({0, 0, 0, 1}) != 0) config.chain_records = one_of({1, 3, 12});
    return config;
  }

 private:
  std::mt19937 random_;
};

// Of a stress case: more, and it may take the Verilated unit half a minute.
constexpr std::size_t kFewCasters = 400;
constexpr std::uint32_t kSmallMap = 256;

TEST(WindingCycles, ScenesAtDefaultTiming) {
  const struct {
    const char* scene;
    double scale;
  } runs[] = {{"solids", 1}, {"torus", 4}, {"glyphs", 16}};
  for (const auto& run : runs) {
    SCOPED_TRACE(testing::Message() << run.scene << " scale " << run.scale);
    const Trace trace = small_trace(run.scene, 64, 40, run.scale);
    expect_equal_cycles(trace, config_of(trace), {});
    if (HasFailure()) return;
  }
}

TEST(WindingCycles, ScenesAtRandomTimingsUnderRandomPolicies) {
  Dice dice(1);
  const Trace traces[] = {small_trace("glyphs", 64, 32, 4), small_trace("solids", 128, 40, 2)};
  for (int round = 0; round < 8; ++round) {
    SCOPED_TRACE(testing::Message() << "round " << round);
    const Trace& trace = traces[round % 2];
    const Timing timing = dice.timing();
    const UnitConfig config = dice.policy(config_of(trace));
    expect_equal_cycles(trace, config, timing, dice.one_of({0, 0, 1, 97}));
    if (HasFailure()) return;
  }
}

TEST(WindingCycles, StressCases) {
  Dice dice(2);
  stress::CaseOptions options;
  options.profile = Profile::kWinding;
  int cases = 0;
  for (std::uint64_t number = 0; number < 24; ++number) {
    const stress::StressCase made = stress::make_case(5, number, options);
    if (made.trace.all_casters.size() > kFewCasters || made.trace.header.map_width > kSmallMap) continue;
    SCOPED_TRACE(testing::Message() << "case " << number);
    const Timing timing = dice.timing();
    expect_equal_cycles(made.trace, dice.policy(config_of(made.trace)), timing);
    if (HasFailure()) return;
    ++cases;
  }
  EXPECT_GT(cases, 12);
}

int compare_more(int count, std::uint32_t seed) {
  Dice dice(seed);
  for (int round = 0; round < count; ++round) {
    const char* scene = dice.one_of<const char*>({"solids", "glyphs", "torus", "slivers"});
    const double scale = dice.one_of({1., 4., 16.});
    const Trace trace = small_trace(scene, 64, scale > 4 ? 16 : 40, scale);
    UnitConfig config = config_of(trace);
    config.fragment_slots = dice.one_of({1, 8, 16, 64});
    config.visit_fifo_depth = dice.one_of({1, 2, 8, 32});
    config.texel_lines = dice.one_of({8, 64});
    config.record_lines = dice.one_of({8, 128});
    config.segments_per_record = dice.one_of({1, 2, 3, 6});
    config.lanes = dice.one_of({1, 2, 3, 4});
    for (int of_model = 0; of_model < 20; ++of_model) {
      const Timing timing = dice.timing();
      expect_equal_cycles(trace, dice.policy(config), timing, dice.one_of({0, 0, 1, 97}));
    }
    stress::CaseOptions options;
    options.profile = Profile::kWinding;
    for (std::uint64_t number = 0; number < 10; ++number) {
      const stress::StressCase made = stress::make_case(seed + round, number, options);
      if (made.trace.header.map_width > 1024 || made.trace.header.map_height > 1024) continue;
      config.map_width = made.trace.header.map_width;
      config.map_height = made.trace.header.map_height;
      expect_equal_cycles(made.trace, dice.policy(config), dice.timing());
    }
    std::printf("%d: %s at scale %g, %d slots, %d segments a record, %d lanes, queues of %d visits, "
                "%d words and %d records on chip: %s\n",
                round, scene, scale, int(config.fragment_slots), int(config.segments_per_record),
                int(config.lanes), int(config.visit_fifo_depth), int(config.texel_lines),
                int(config.record_lines), testing::Test::HasFailure() ? "differs" : "equal");
    std::fflush(stdout);
  }
  return testing::Test::HasFailure();
}

}  // namespace
}  // namespace kagesen

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  if (argc > 2 && std::strcmp(argv[1], "more") == 0) {
    return kagesen::compare_more(std::atoi(argv[2]), argc > 3 ? std::strtoul(argv[3], nullptr, 0) : 1);
  }
  return RUN_ALL_TESTS();
}

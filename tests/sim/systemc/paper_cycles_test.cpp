/// SystemC and the Verilated unit, paper profile: every fragment's cycles, every pass's and cause's
/// total.
#include <random>

#include "tests/sim/systemc/side_by_side.h"

namespace kagesen {
namespace {

UnitConfig small_config() {
  UnitConfig config;
  config.map_width = config.map_height = 64;
  config.slb_buckets = 256;  // quick to wipe, and texels share them
  return config;
}

TEST(PaperCycles, DefaultTiming) {
  for (const char* scene : {"solids", "glyphs", "torus"}) {
    for (const double scale : {1., 16.}) {
      SCOPED_TRACE(scene);
      expect_equal_cycles(small_trace(scene, 64, 48, scale), small_config(), {});
    }
  }
}

TEST(PaperCycles, RandomTimings) {
  std::mt19937 random(1);
  const auto one_of = [&](std::initializer_list<std::uint32_t> values) {
    return values.begin()[random() % values.size()];
  };
  const Trace trace = small_trace("glyphs", 64, 32, 4);
  for (int round = 0; round < 20; ++round) {
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
    timing.seed = random();
    SCOPED_TRACE(testing::Message()
                 << "round " << round << ": latency " << timing.latency << ", spread "
                 << timing.spread << ", stalls " << timing.memory_stall << " and "
                 << timing.stream_stall << ", interval " << timing.interval << ", outstanding "
                 << timing.outstanding << ", " << timing.banks << " banks busy for "
                 << timing.bank_busy << ", rows of " << timing.row_words << " cost "
                 << timing.row_miss);
    UnitConfig config = small_config();
    if (one_of({0, 0, 1}) != 0) config.slb_entries = one_of({40, 300});
    if (one_of({0, 0, 1}) != 0) config.link_depth = one_of({2, 5});
    expect_equal_cycles(trace, config, timing, one_of({0, 0, 1, 97}));
    if (HasFailure()) return;
  }
}

}  // namespace
}  // namespace kagesen

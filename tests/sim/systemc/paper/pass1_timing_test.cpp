/// Pass 1's model against the Verilated unit: wiping, drawing, and where their cycles go.
#include <gtest/gtest.h>

#include "sim/memory/configured_timing.h"
#include "sim/systemc/paper/pass1.h"
#include "tests/sim/systemc/paper/random_frame.h"
#include "tests/sim/systemc/side_by_side.h"

namespace kagesen::tlm_model::paper {
namespace {

CycleReport model(const Trace& trace, const UnitConfig& config, const Timing& timing) {
  static Pass1 pass1("pass1");
  const FrameSetup setup = make_frame_setup(trace, config);
  unit::ShadowUnit golden;
  golden.begin(config, setup);
  pass1.begin_frame(config, setup, timing, 32, 64);
  pass1.draw(golden, trace.all_casters.data(), trace.all_casters.size());
  CycleReport report;
  pass1.report(report, golden.counters());
  return report;
}

void expect_equal(const Trace& trace, const UnitConfig& config, const Timing& timing) {
  RtlEngine rtl({BuildKind::kFast, timing, false, nullptr, {}});
  rtl.begin(config, make_frame_setup(trace, config));
  rtl.draw(trace.all_casters.data(), trace.all_casters.size());
  const CycleReport theirs = *rtl.cycles(), ours = model(trace, config, timing);
  EXPECT_EQ(ours.clear, theirs.clear);
  EXPECT_EQ(ours.pass1->total, theirs.pass1->total);
  EXPECT_EQ(ours.pass1->causes, theirs.pass1->causes);
  EXPECT_EQ(ours.pass1->items, theirs.pass1->items);
}

TEST(PaperPass1Timing, Scenes) {
  for (const char* scene : {"solids", "boxes", "slivers"}) {
    for (const double scale : {1.0, 16.0}) {
      SCOPED_TRACE(::testing::Message() << scene << " at scale " << scale);
      const Trace trace = small_trace(scene, 256, 16, scale);
      UnitConfig config;
      config.map_width = config.map_height = 256;
      config.slb_buckets = 4096;
      expect_equal(trace, config, configured_timing(config));
      if (HasFailure()) return;
    }
  }
}

TEST(PaperPass1Timing, StressCasesWithRandomConfigurations) {
  for (std::uint64_t number = 0; number < random_frames(); ++number) {
    const RandomFrame f(number);
    SCOPED_TRACE(f.text);
    expect_equal(f.trace, f.config, f.timing);
    if (HasFailure()) return;
  }
}

}  // namespace
}  // namespace kagesen::tlm_model::paper

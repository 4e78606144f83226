#pragma once
/// A frame through SystemC and the Verilated unit, fragment by fragment.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "model/frame_setup.h"
#include "sim/systemc/engine.h"
#include "testbench/verilator/rtl_engine.h"
#include "traces/raster/capture.h"
#include "traces/scene/scene.h"

namespace kagesen {

inline Trace small_trace(const std::string& scene, int side, int width, double scale = 1) {
  CaptureOptions options;
  options.map_width = options.map_height = side;
  options.image_width = width;
  options.image_height = width * 9 / 16;
  options.scale_x = options.scale_y = scale;
  Trace trace;
  capture(make_builtin(scene), options, trace);
  return trace;
}

/// Runs a whole frame, pass 2 in portions of up to so many fragments (0: at once).
inline std::vector<Verdict> run_frame(Engine& engine, const Trace& trace, const UnitConfig& config,
                                      std::size_t portion = 0) {
  const std::vector<Fragment>& fragments = trace.all_fragments;
  engine.begin(config, make_frame_setup(trace, config));
  engine.announce(fragments.data(), fragments.size());
  engine.draw(trace.all_casters.data(), trace.all_casters.size());
  std::vector<Verdict> verdicts(fragments.size());
  const std::size_t by = portion ? portion : fragments.size() + 1;
  for (std::size_t at = 0; at < fragments.size(); at += by) {
    engine.decide(fragments.data() + at, std::min(by, fragments.size() - at), verdicts.data() + at);
  }
  return verdicts;
}

inline void expect_equal_pass(const char* name, const PassCycles& ours, const PassCycles& theirs) {
  EXPECT_EQ(ours.total, theirs.total) << name;
  EXPECT_EQ(ours.items, theirs.items) << name;
  EXPECT_EQ(ours.causes, theirs.causes) << name;
}

/// Expects equal verdicts, equal cycles of every fragment, equal totals of all passes and causes of
/// both.
inline void expect_equal_cycles(const Trace& trace, const UnitConfig& config, const Timing& timing,
                                std::size_t portion = 0) {
  SystemcEngine model({timing, true});
  RtlEngine rtl({BuildKind::kFast, timing, true, nullptr, {}});
  const std::vector<Verdict> verdicts = run_frame(model, trace, config, portion);
  ASSERT_EQ(verdicts, run_frame(rtl, trace, config, portion));
  const std::vector<FragmentCycles>&a = model.fragment_cycles(), &b = rtl.fragment_cycles();
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    ASSERT_TRUE(a[i] == b[i]) << "fragment " << i << ": systemc " << a[i].accepted << " to "
                              << a[i].retired << ", rtl " << b[i].accepted << " to "
                              << b[i].retired;
  }
  const CycleReport ours = *model.cycles(), theirs = *rtl.cycles();
  expect_equal_pass("pass 1", *ours.pass1, *theirs.pass1);
  expect_equal_pass("pass 2", *ours.pass2, *theirs.pass2);
  EXPECT_EQ(ours.clear, theirs.clear);
  EXPECT_EQ(ours.settle, theirs.settle);
  if (ours.announce) {
    EXPECT_EQ(ours.announce, theirs.announce);
  }
}

}  // namespace kagesen

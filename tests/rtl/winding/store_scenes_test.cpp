#include <gtest/gtest.h>

#include <iostream>
#include <sstream>

#include "Vwinding_store_test_dut.h"
#include "model/frame_setup.h"
#include "tests/rtl/winding/store_bench.h"
#include "traces/raster/capture.h"
#include "traces/scene/scene.h"

namespace kagesen::rtl {
namespace {

using Bench = StoreBench<Vwinding_store_test_dut>;

/// Cycles a visit on a scene, with a memory of 20 cycles and a front that always has a visit.
void scene_speed(double scale, double bound) {
  CaptureOptions options;
  options.image_width = 320;
  options.image_height = 240;
  options.scale_x = options.scale_y = scale;
  Trace trace;
  capture(make_builtin("solids"), options, trace);
  UnitConfig config;
  config.profile = Profile::kWinding;
  const FrameSetup setup = make_frame_setup(trace, config);
  const auto visits = golden_visits(trace.all_casters, setup, config);
  Bench bench(config, WindingWidths{}, MemorySettings{});
  const StoreCounts counts = bench.run(trace.all_fragments, setup, visits, 100);
  const std::uint64_t items = counts.edge_visits + counts.span_visits;
  const double each = static_cast<double>(counts.draw_cycles) / static_cast<double>(items);
  std::ostringstream causes;
  for (std::size_t i = 0; i < 10; ++i) causes << ' ' << counts.causes[i];
  std::cout << "scale " << scale << ": " << counts.edge_visits << " edge visits, "
            << counts.span_visits << " span words, " << each << " cycles each; masked "
            << counts.masked << " of " << counts.texel_visits << " texels; causes" << causes.str()
            << "; announce " << counts.announce_cycles << " of " << trace.all_fragments.size()
            << " fragments, settle " << counts.settle_cycles << " of " << counts.touched
            << " tiles\n";
  EXPECT_LT(each, bound);
}
TEST(WindingStore, CyclesOfAScene) {
  scene_speed(1, 4);
  scene_speed(16, 40);
}

}  // namespace
}  // namespace kagesen::rtl

#include <gtest/gtest.h>

#include "tests/sim/systemc/winding/front_timeline.h"
#include "traces/raster/capture.h"
#include "traces/scene/scene.h"

namespace kagesen::tlm_model::winding {
namespace {

TEST(WindingFrontTiming, ScenesAtEveryScale) {
  unsigned seed = 0;
  for (const char* scene : {"solids", "boxes", "slivers"}) {
    for (const double scale : {1.0, 16.0, 256.0}) {
      CaptureOptions options;
      options.image_width = 16;
      options.image_height = 9;
      options.scale_x = options.scale_y = scale;
      Trace trace;
      capture(make_builtin(scene), options, trace);
      UnitConfig config;
      config.profile = Profile::kWinding;
      config.semantics = Semantics::kPhysical;
      const FrameSetup setup = make_frame_setup(trace, config);
      if (trace.all_casters.size() > 300) trace.all_casters.resize(300);
      ++seed;
      const Case run{trace.all_casters, setup, config, Stalls(),
                     stalls(seed % 2 * 40, seed, Channel::kVerdicts)};
      const FrontTimeline expected = Verilog(run).timeline();
      expect_same(model(run), expected);
      ASSERT_FALSE(testing::Test::HasFailure()) << scene << " at scale " << scale;
    }
  }
}

}  // namespace
}  // namespace kagesen::tlm_model::winding

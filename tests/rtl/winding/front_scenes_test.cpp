#include <gtest/gtest.h>

#include <cstdio>

#include "model/frame_setup.h"
#include "tests/rtl/winding/front_driver.h"
#include "traces/raster/capture.h"
#include "traces/scene/scene.h"

namespace kagesen::rtl {
namespace {

/// A built-in scene, and what it costs: cycles an edge texel with a sink that takes everything.
TEST(WindingFront, SolidsGiveTheGoldenVisits) {
  for (const double scale : {1.0, 16.0}) {
    CaptureOptions options;
    options.image_width = 16;
    options.image_height = 9;
    options.scale_x = options.scale_y = scale;
    Trace trace;
    capture(make_builtin("solids"), options, trace);
    UnitConfig config;
    config.profile = Profile::kWinding;
    config.semantics = Semantics::kPhysical;
    const FrameSetup setup = make_frame_setup(trace, config);
    FrontDriver driver(config, setup);
    if (trace.all_casters.size() > 4000) trace.all_casters.resize(4000);
    ASSERT_TRUE(front_agrees(driver, trace.all_casters, setup, config, 10, 10, 1));
    const auto& n = driver.counts;
    std::printf("scale %g: %llu triangles, %llu edge texels, %llu inner, %llu span texels; %llu cycles (%llu setup, "
                "%llu visits), %.2f an edge texel, %.1f a triangle\n",
                scale, (unsigned long long)n.casters, (unsigned long long)n.edge_texels,
                (unsigned long long)n.inner_texels, (unsigned long long)n.span_texels,
                (unsigned long long)driver.cycles.all, (unsigned long long)driver.cycles.setup,
                (unsigned long long)driver.cycles.visits, double(driver.cycles.all) / double(n.edge_texels),
                double(driver.cycles.all) / double(n.casters));
  }
}

}  // namespace
}  // namespace kagesen::rtl

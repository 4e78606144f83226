/// The front's model against the Verilated front: the cycle of every beat and every visit.
#include <gtest/gtest.h>

#include <random>

#include "tests/model/unit/winding/soups.h"
#include "tests/sim/systemc/winding/front_timeline.h"

namespace kagesen::tlm_model::winding {
namespace {

TEST(WindingFrontTiming, RandomFramesAtEveryTexelSize) {
  for (int texel_bits = 16; texel_bits <= 26; ++texel_bits) {
    for (const Scene scene : kScenes) {
      for (unsigned seed = 1; seed <= 2; ++seed) {
        std::mt19937 dice(seed * 1000 + static_cast<unsigned>(texel_bits));
        const RandomTrace random(scene, texel_bits, 8,
                                 seed * 100 + static_cast<std::uint64_t>(texel_bits), 0);
        const auto semantics = dice() % 2 ? Semantics::kPaper : Semantics::kPhysical;
        UnitConfig config = random.fit(winding_config(semantics));
        config.skip_edges = dice() % 4 != 0;
        const FrameSetup setup = make_frame_setup(random.trace, config);
        const Case run{random.trace.all_casters, setup, config,
                       stalls(dice() % 2 ? 0 : dice() % 90, seed, Channel::kTriangles),
                       stalls(dice() % 2 ? 0 : dice() % 90, seed, Channel::kVerdicts)};
        const FrontTimeline expected = Verilog(run).timeline();
        expect_same(model(run), expected);
        ASSERT_FALSE(testing::Test::HasFailure())
            << "f " << texel_bits << " scene " << static_cast<int>(scene) << " seed " << seed;
      }
    }
  }
}

}  // namespace
}  // namespace kagesen::tlm_model::winding

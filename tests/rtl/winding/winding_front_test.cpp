#include <gtest/gtest.h>

#include <vector>

#include "model/frame_setup.h"
#include "tests/model/random_meshes.h"
#include "tests/model/unit/winding/soups.h"
#include "tests/rtl/winding/front_driver.h"
#include "tests/stress/case.h"

namespace kagesen::rtl {
namespace {

/// Random traces at every f, with and without inner edges skipped and groups told of; fails if any visit, its
/// order or a counter differs.
TEST(WindingFront, RandomFramesGiveTheGoldenVisits) {
  for (int texel_bits = 16; texel_bits <= 26; ++texel_bits) {
    for (const Scene scene : kScenes) {
      for (std::uint64_t seed = 1; seed <= 3; ++seed) {
        SCOPED_TRACE(::testing::Message() << "f " << texel_bits << " scene " << int(scene) << " seed " << seed);
        const RandomTrace random(scene, texel_bits, 8, seed * 100 + std::uint64_t(texel_bits), 0);
        UnitConfig config = random.fit(winding_config(seed % 2 ? Semantics::kPaper : Semantics::kPhysical));
        config.skip_edges = seed != 2;
        const FrameSetup setup = make_frame_setup(random.trace, config);
        FrontDriver driver(config, setup);
        const unsigned stall = unsigned(seed);
        ASSERT_TRUE(front_agrees(driver, random.trace.all_casters, setup, config, 11 - 3 * stall,
                                 13 - 3 * stall, seed));
      }
    }
  }
}

/// Every family of adversarial geometry; nothing may differ there either.
TEST(WindingFront, StressFamiliesGiveTheGoldenVisits) {
  stress::CaseOptions options;
  options.profile = Profile::kWinding;
  for (std::uint64_t number = 0; number < 6 * stress::families().size(); ++number) {
    const stress::StressCase c = stress::make_case(3, number, options);
    SCOPED_TRACE(::testing::Message() << "case " << number << " " << c.family->name);
    UnitConfig config = winding_config(Semantics::kPhysical);
    config.map_width = c.trace.header.map_width;
    config.map_height = c.trace.header.map_height;
    if (config.map_width > 1024 || config.map_height > 1024) continue;
    config.skip_edges = number % 3 != 0;
    const FrameSetup setup = make_frame_setup(c.trace, config);
    FrontDriver driver(config, setup);
    std::vector<Caster> casters = c.trace.all_casters;
    if (casters.size() > 300) casters.resize(300);
    ASSERT_TRUE(front_agrees(driver, casters, setup, config, 9, 9, number));
  }
}

/// Triangles dropped at any moment leave nothing behind.
TEST(WindingFront, ClearForgetsWhatIsInFlight) {
  const RandomTrace random(Scene::kSoup, 20, 8, 5, 0);
  const UnitConfig config = random.fit(winding_config(Semantics::kPhysical));
  const FrameSetup setup = make_frame_setup(random.trace, config);
  const auto tris = golden_tris(random.trace.all_casters, setup, config);
  FrontDriver driver(config, setup);
  for (int i = 0; i < 200; ++i) driver.disturb(tris[std::size_t(i) % tris.size()], 1 + i);
  EXPECT_TRUE(front_agrees(driver, random.trace.all_casters, setup, config, 10, 10, 1));
}

}  // namespace
}  // namespace kagesen::rtl

#include <gtest/gtest.h>

#include <cstdio>
#include <random>

#include "Vfront_other_dut.h"
#include "Vfront_test_dut.h"
#include "model/frame_setup.h"
#include "tests/model/random_casters.h"
#include "tests/rtl/paper/front_driver.h"
#include "tests/stress/case.h"
#include "traces/raster/capture.h"
#include "traces/scene/scene.h"

namespace kagesen::rtl {
namespace {

using Driver = FrontDriver<Vfront_test_dut>;

UnitConfig config_of(std::int64_t width, std::int64_t height, HiddenRemoval removal) {
  UnitConfig config;
  config.map_width = width;
  config.map_height = height;
  config.hidden_removal = removal;
  return config;
}

TEST(Front, RandomSoupsAtEveryTexelSize) {
  Driver driver;
  unsigned seed = 1;
  for (int f = 16; f <= 26; ++f) {
    for (const Soup soup : kAllSoups) {
      std::mt19937 random(++seed);
      const auto side = [&] { return std::int64_t{1} << (random() % 11); };
      const UnitConfig config = config_of(
          random() % 2 ? side() : 1 + random() % 1024, random() % 2 ? side() : 1 + random() % 1024,
          random() % 2 ? HiddenRemoval::kFarthest : HiddenRemoval::kCentre);
      FrontRun run;
      run.triangle_percent = random() % 2 ? 100 : 5 + random() % 95;
      run.visit_percent = random() % 2 ? 100 : 20 + random() % 80;
      run.plane_percent = random() % 2 ? 0 : 10;
      run.seed = seed;
      const bool large = soup == Soup::kWalls || soup == Soup::kHuge;
      driver.draw(random_soup(soup, large ? 2 : 12, seed), config, f, run);
      ASSERT_FALSE(HasFailure()) << "soup " << static_cast<int>(soup) << " f " << f << " seed "
                                 << seed;
    }
  }
}

/// Fields of other widths, odd ones among them (front_other_dut in CMakeLists.txt).
TEST(Front, OtherFieldWidths) {
  FrontDriver<Vfront_other_dut> driver;
  UnitConfig config = config_of(100, 60, HiddenRemoval::kFarthest);
  config.depth_bits = 17;
  config.fraction_bits = 15;
  config.slope_bits = 3;
  config.id_bits = 9;
  config.polygon_id_bits = 20;
  for (int f = 16; f <= 26; ++f) {
    for (const Soup soup : kAllSoups) {
      const bool large = soup == Soup::kWalls || soup == Soup::kHuge;
      driver.draw(random_soup(soup, large ? 2 : 12, 77), config, f, {});
      ASSERT_FALSE(HasFailure()) << "soup " << static_cast<int>(soup) << " f " << f;
    }
  }
}

/// Coordinates of a few units around texel borders: ties, corners, slope 1, edges along the axes.
TEST(Front, TinyTrianglesAtBorders) {
  Driver driver;
  for (int f = 16; f <= 26; f += 5) {
    Generator g(static_cast<std::uint64_t>(f));
    std::vector<Caster> casters;
    for (int i = 0; i < 1500; ++i) {
      Caster c;
      const int finest = static_cast<int>(g.in(0, 2)), unit = finest == 0 ? f : f - finest;
      for (LightPoint& v : c.vertex) {
        v = {std::int32_t(g.in(-3, 3) * (1 << std::min(unit, 25))),
             std::int32_t(g.in(-3, 3) * (1 << std::min(unit, 25))), std::uint32_t(g.in(0, 9))};
        if (g.in(0, 9) == 0) v.x += std::int32_t(g.in(-1, 1));
        if (g.in(0, 9) == 0) v.y += std::int32_t(g.in(-1, 1));
        if (g.in(0, 3) == 0) v.z = g.in(0, 1) ? kDepthMax : 0;
      }
      c.polygon = static_cast<std::uint32_t>(i);
      casters.push_back(c);
    }
    driver.draw(casters, config_of(8, 8, HiddenRemoval::kFarthest), f, {100, 100, 0, 1});
    ASSERT_FALSE(HasFailure()) << "f " << f;
  }
}

TEST(Front, StressFamilies) {
  Driver driver;
  stress::CaseOptions options;
  options.profile = Profile::kPaper;
  std::uint64_t visits = 0;
  for (std::uint64_t number = 0; number < 3 * stress::families().size(); ++number) {
    const stress::StressCase c = stress::make_case(7, number, options);
    const TraceHeader& header = c.trace.header;
    if (header.map_width > 1024 || header.map_height > 1024) continue;
    std::vector<Caster> casters = c.trace.all_casters;
    if (casters.size() > 400) casters.resize(400);
    const FrontCycles done =
        driver.draw(casters, config_of(header.map_width, header.map_height, HiddenRemoval::kCentre),
                    static_cast<int>(header.fraction_bits), {100, number % 2 ? 100u : 60u, 0, 1});
    visits += done.counts.edge_texels;
    ASSERT_FALSE(HasFailure()) << "case " << number << " of " << c.family->name;
  }
  EXPECT_GT(visits, 20000u);
}

/// A clear in any state leaves a front that draws as a fresh one.
TEST(Front, ClearInTheMiddle) {
  Driver driver;
  for (unsigned seed = 1; seed <= 150; ++seed) {
    const UnitConfig config = config_of(64, 64, HiddenRemoval::kCentre);
    const std::vector<Caster> casters = random_soup(Soup::kFan, 3, seed);
    driver.settings(config, 20);
    driver.offer(casters[0]);
    driver.dut.tri_valid_i = 1;
    driver.dut.visit_ready_i = 1;
    driver.dut.eval();
    for (unsigned i = 0; i < 2 * seed && !driver.dut.tri_ready_o; ++i) driver.tick();
    driver.dut.clear_i = 1;
    driver.dut.tri_valid_i = 0;
    driver.tick();
    driver.dut.clear_i = 0;
    driver.dut.eval();
    ASSERT_TRUE(driver.dut.idle_o);
    ASSERT_FALSE(driver.dut.visit_valid_o);
    driver.draw(casters, config, 20, {});
    ASSERT_FALSE(HasFailure()) << "seed " << seed;
  }
}

/// Whole scenes; prints what a texel costs when the store always takes.
TEST(Front, ScenesAndTheirCycles) {
  for (const double scale : {1.0, 16.0}) {
    Trace trace;
    CaptureOptions options;
    options.image_width = 64;
    options.image_height = 36;
    options.scale_x = options.scale_y = scale;
    capture(make_builtin("solids"), options, trace);
    Driver driver;
    const FrontCycles done =
        driver.draw(trace.all_casters, config_of(1024, 1024, HiddenRemoval::kCentre),
                    static_cast<int>(trace.header.fraction_bits), {});
    ASSERT_FALSE(HasFailure()) << "scale " << scale;
    std::printf(
        "scale %g: f %u, %llu triangles, %llu edge texels, %llu span texels, %llu cycles (%llu of "
        "setup), "
        "%.3f an edge texel\n",
        scale, trace.header.fraction_bits, static_cast<unsigned long long>(done.counts.casters),
        static_cast<unsigned long long>(done.counts.edge_texels),
        static_cast<unsigned long long>(done.counts.span_texels),
        static_cast<unsigned long long>(done.cycles), static_cast<unsigned long long>(done.setup),
        static_cast<double>(done.cycles) / static_cast<double>(done.counts.edge_texels));
    // A texel of an outline a cycle, and more than one of a span.
    EXPECT_LT(done.cycles - done.setup,
              done.counts.edge_texels + done.counts.span_texels + 20 * done.counts.casters);
  }
}

}  // namespace
}  // namespace kagesen::rtl

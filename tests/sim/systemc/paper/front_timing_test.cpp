/// The front's model against the Verilated front: the cycle of every triangle and every visit.
#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "Vfront_test_dut.h"
#include "model/unit/shadow_unit.h"
#include "sim/systemc/paper/front.h"
#include "tests/model/random_casters.h"
#include "tests/rtl/paper/front_driver.h"
#include "tests/sim/systemc/front_timeline.h"
#include "traces/raster/capture.h"
#include "traces/scene/scene.h"

namespace kagesen::tlm_model::paper {
namespace {

struct Case {
  std::vector<Caster> casters;
  UnitConfig config;
  unsigned texel_bits = 16;
  Stalls offers, store;
};

FrontTimeline model(const Case& run) {
  FrontTimeline line;
  FrameSetup setup;
  setup.fraction_bits = run.texel_bits;
  unit::ShadowUnit golden;
  golden.begin(run.config, setup);
  static Front front("front");
  StallingStore<Visit> store(run.store, front.causes(), line);
  front.begin_pass(run.config, run.texel_bits, store);
  unit::TriangleTrail trail;
  Cycle free = 0;
  for (const Caster& caster : run.casters) {
    golden.draw(caster, trail);
    const Cycle taken = front.draw(trail, run.offers.next(free));
    line.beats.push_back(taken);
    free = taken + 1;
  }
  line.idle = front.idle();
  store.count(line.idle);
  return line;
}

FrontTimeline verilog(rtl::FrontDriver<Vfront_test_dut>& driver, const Case& run) {
  FrontTimeline line;
  driver.settings(run.config, static_cast<int>(run.texel_bits));
  Vfront_test_dut& dut = driver.dut;
  dut.clear_i = 1;
  dut.tri_valid_i = 0;
  driver.tick();
  dut.clear_i = 0;
  bool offered = false;
  for (Cycle now = 0;; ++now) {
    if (!offered && line.beats.size() < run.casters.size() && !run.offers.at(now)) {
      offered = true;
      driver.offer(run.casters[line.beats.size()]);
    }
    dut.tri_valid_i = offered;
    dut.visit_ready_i = !run.store.at(now);
    dut.eval();
    if (dut.idle_o && line.beats.size() == run.casters.size()) {
      line.idle = now;
      return line;
    }
    if (!dut.visit_valid_o) ++(dut.setup_o ? line.setup : dut.idle_o ? line.none : line.walk);
    if (dut.visit_valid_o && dut.visit_ready_i) {
      const bool place = dut.kind_o == Visit::kEdge || dut.kind_o == Visit::kSpan;
      line.visits.push_back({now, dut.kind_o, place ? dut.x_o : 0, place ? dut.y_o : 0});
    }
    if (dut.tri_valid_i && dut.tri_ready_o) {
      line.beats.push_back(now);
      offered = false;
    }
    driver.tick();
  }
}

void compare(rtl::FrontDriver<Vfront_test_dut>& driver, const Case& run) {
  const FrontTimeline expected = verilog(driver, run);
  expect_same(model(run), expected);
}

class FrontTiming : public testing::Test {
 protected:
  rtl::FrontDriver<Vfront_test_dut> driver;
};

TEST_F(FrontTiming, RandomSoupsAtEveryTexelSize) {
  unsigned seed = 1;
  for (unsigned f = 16; f <= 26; ++f) {
    for (const Soup soup : kAllSoups) {
      std::mt19937 random(++seed);
      Case run;
      const bool large = soup == Soup::kWalls || soup == Soup::kHuge;
      run.casters = random_soup(soup, large ? 2 : 12, seed);
      run.config.map_width = 1 + random() % 1024;
      run.config.map_height = 1 + random() % 1024;
      run.config.hidden_removal = random() % 2 ? HiddenRemoval::kFarthest : HiddenRemoval::kCentre;
      run.texel_bits = f;
      const auto stalls = [&](Channel channel) {
        return Stalls(random() % 2 ? 0 : random() % 90, Chance(seed, {}, channel, 0));
      };
      run.offers = stalls(Channel::kTriangles);
      run.store = stalls(Channel::kVerdicts);
      compare(driver, run);
      ASSERT_FALSE(HasFailure()) << "soup " << static_cast<int>(soup) << " f " << f << " seed "
                                 << seed;
    }
  }
}

TEST_F(FrontTiming, ScenesAtEveryScale) {
  unsigned seed = 0;
  for (const char* scene : {"solids", "boxes", "slivers"}) {
    for (const double scale : {1.0, 16.0, 256.0}) {
      Trace trace;
      CaptureOptions options;
      options.image_width = 16;
      options.image_height = 9;
      options.scale_x = options.scale_y = scale;
      capture(make_builtin(scene), options, trace);
      Case run;
      run.casters = trace.all_casters;
      if (run.casters.size() > 300) run.casters.resize(300);
      run.texel_bits = trace.header.fraction_bits;
      ++seed;
      run.store = Stalls(seed % 2 * 40, Chance(seed, {}, Channel::kVerdicts, 0));
      compare(driver, run);
      ASSERT_FALSE(HasFailure()) << scene << " at scale " << scale;
    }
  }
}

}  // namespace
}  // namespace kagesen::tlm_model::paper

/// The front's model against the Verilated front: the cycle of every triangle and every visit.
#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "Vfront_test_dut.h"
#include "model/unit/shadow_unit.h"
#include "sim/systemc/paper/front.h"
#include "tests/model/random_casters.h"
#include "tests/rtl/paper/front_driver.h"
#include "traces/raster/capture.h"
#include "traces/scene/scene.h"

namespace kagesen::tlm_model::paper {
namespace {

/// What a front did, and when. Cycles count from the first one.
struct Timeline {
  struct Taken {
    Cycle at;
    int kind;
    std::int32_t x, y;
  };
  std::vector<Cycle> triangles;  ///< when each was taken
  std::vector<Taken> visits;
  std::uint64_t setup = 0, none = 0, walk = 0;  ///< cycles in which no visit was offered
  Cycle idle = 0;                               ///< the first cycle after all was done
};

/// A store that takes a visit in each cycle in which it does not stall.
struct StallingStore : VisitTaker {
  StallingStore(const Stalls& s, FrontCauses& c, Timeline& t) : stalls(s), causes(c), line(t) {}
  Cycle take(const Visit& visit, Cycle offered) override {
    count(offered);
    const Cycle at = stalls.next(offered);
    const bool place = visit.kind == Visit::kEdge || visit.kind == Visit::kSpan;
    line.visits.push_back({at, visit.kind, place ? visit.x : 0, place ? visit.y : 0});
    free = at + 1;
    return at;
  }
  bool ready(Cycle at) override { return !stalls.at(at); }
  void count(Cycle to) {
    const FrontCauses::Cycles cycles = causes.of(free, to);
    line.setup += cycles.setup;
    line.none += cycles.none;
    line.walk += cycles.walk;
  }
  Stalls stalls;
  FrontCauses& causes;
  Timeline& line;
  Cycle free = 0;  // the first cycle without a visit
};

struct Case {
  std::vector<Caster> casters;
  UnitConfig config;
  unsigned texel_bits = 16;
  Stalls offers, store;
};

Timeline model(const Case& run) {
  Timeline line;
  FrameSetup setup;
  setup.fraction_bits = run.texel_bits;
  unit::ShadowUnit golden;
  golden.begin(run.config, setup);
  static Front front("front");
  StallingStore store(run.store, front.causes(), line);
  front.begin_pass(run.config, run.texel_bits, store);
  unit::TriangleTrail trail;
  Cycle free = 0;
  for (const Caster& caster : run.casters) {
    golden.draw(caster, trail);
    const Cycle taken = front.draw(trail, run.offers.next(free));
    line.triangles.push_back(taken);
    free = taken + 1;
  }
  line.idle = front.idle();
  store.count(line.idle);
  return line;
}

Timeline verilog(rtl::FrontDriver<Vfront_test_dut>& driver, const Case& run) {
  Timeline line;
  driver.settings(run.config, static_cast<int>(run.texel_bits));
  Vfront_test_dut& dut = driver.dut;
  dut.clear_i = 1;
  dut.tri_valid_i = 0;
  driver.tick();
  dut.clear_i = 0;
  bool offered = false;
  for (Cycle now = 0;; ++now) {
    if (!offered && line.triangles.size() < run.casters.size() && !run.offers.at(now)) {
      offered = true;
      driver.offer(run.casters[line.triangles.size()]);
    }
    dut.tri_valid_i = offered;
    dut.visit_ready_i = !run.store.at(now);
    dut.eval();
    if (dut.idle_o && line.triangles.size() == run.casters.size()) {
      line.idle = now;
      return line;
    }
    if (!dut.visit_valid_o) ++(dut.setup_o ? line.setup : dut.idle_o ? line.none : line.walk);
    if (dut.visit_valid_o && dut.visit_ready_i) {
      const bool place = dut.kind_o == Visit::kEdge || dut.kind_o == Visit::kSpan;
      line.visits.push_back({now, dut.kind_o, place ? dut.x_o : 0, place ? dut.y_o : 0});
    }
    if (dut.tri_valid_i && dut.tri_ready_o) {
      line.triangles.push_back(now);
      offered = false;
    }
    driver.tick();
  }
}

void compare(rtl::FrontDriver<Vfront_test_dut>& driver, const Case& run) {
  const Timeline expected = verilog(driver, run), got = model(run);
  for (std::size_t i = 0; i < expected.visits.size(); ++i) {
    ASSERT_LT(i, got.visits.size());
    const Timeline::Taken &a = got.visits[i], &b = expected.visits[i];
    ASSERT_TRUE(a.at == b.at && a.kind == b.kind && a.x == b.x && a.y == b.y)
        << "visit " << i << ": model " << a.kind << " (" << a.x << ", " << a.y << ") in cycle "
        << a.at << ", Verilog " << b.kind << " (" << b.x << ", " << b.y << ") in cycle " << b.at;
  }
  ASSERT_EQ(got.visits.size(), expected.visits.size());
  ASSERT_EQ(got.triangles, expected.triangles);
  EXPECT_EQ(got.idle, expected.idle);
  EXPECT_EQ(got.setup, expected.setup);
  EXPECT_EQ(got.none, expected.none);
  EXPECT_EQ(got.walk, expected.walk);
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

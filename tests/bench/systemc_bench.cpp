/// Clock cycles that the SystemC model and the Verilated unit simulate a second, one thread: the
/// default scene, 1920 x 1080, and how many times as many the first one does; of the whole frame, of
/// what comes before pass 2, and of pass 2.
#include <benchmark/benchmark.h>

#include <ctime>

#include "model/frame_setup.h"
#include "sim/systemc/engine.h"
#include "testbench/verilator/rtl_engine.h"
#include "tests/bench/bench_scenes.h"

namespace kagesen {
namespace {

/// Processor time: others on the machine do not count.
double now() {
  timespec time;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return double(time.tv_sec) + 1e-9 * double(time.tv_nsec);
}

/// Cycles a second of processor time.
struct Speed {
  double frame = 0, before = 0, pass2 = 0;
};

/// The best of a few runs.
Speed speed(Engine& engine, const UnitConfig& config, int runs) {
  const Trace& trace = default_trace();
  const FrameSetup setup = make_frame_setup(trace, config);
  std::vector<Verdict> verdicts(trace.all_fragments.size());
  Speed best;
  for (int run = 0; run < runs; ++run) {
    engine.begin(config, setup);  // makes what is missing
    const double begun = now();
    engine.begin(config, setup);
    engine.announce(trace.all_fragments.data(), trace.all_fragments.size());
    engine.draw(trace.all_casters.data(), trace.all_casters.size());
    const auto before = double(engine.cycles()->total());  // ends pass 1
    const double drawn = now();
    engine.decide(trace.all_fragments.data(), verdicts.size(), verdicts.data());
    const double done = now();
    const auto pass2 = double(engine.cycles()->pass2->total);
    best.frame = std::max(best.frame, (before + pass2) / (done - begun));
    best.before = std::max(best.before, before / (drawn - begun));
    best.pass2 = std::max(best.pass2, pass2 / (done - drawn));
  }
  return best;
}

void BM_Frame(benchmark::State& state, Profile profile) {
  UnitConfig config;
  config.profile = profile;
  config.memory_spread = state.range(0);
  SystemcEngine model;
  RtlEngine rtl({});
  Speed ours, theirs;
  for (auto _ : state) {
    ours = speed(model, config, 5);
    theirs = speed(rtl, config, 1);
  }
  const auto tell = [&](const std::string& part, double Speed::*of) {
    state.counters[part + " systemc"] = ours.*of;
    state.counters[part + " rtl"] = theirs.*of;
    state.counters[part + " ratio"] = theirs.*of > 0 ? ours.*of / theirs.*of : 0;
  };
  tell("frame", &Speed::frame);
  tell("before", &Speed::before);
  tell("pass2", &Speed::pass2);
}
BENCHMARK_CAPTURE(BM_Frame, paper, Profile::kPaper)->ArgName("spread")->Arg(0)->Arg(20)->Iterations(1);
BENCHMARK_CAPTURE(BM_Frame, winding, Profile::kWinding)
    ->ArgName("spread")->Arg(0)->Arg(20)->Iterations(1);

}  // namespace
}  // namespace kagesen

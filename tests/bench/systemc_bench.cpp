/// Clock cycles of pass 2 that the SystemC model and the Verilated unit simulate a second, one thread:
/// the default scene, 1920 x 1080, and how many times as many the first one does.
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

/// Cycles of pass 2 a second of processor time, the best of a few runs.
double speed(Engine& engine, const UnitConfig& config, int runs) {
  const Trace& trace = default_trace();
  const FrameSetup setup = make_frame_setup(trace, config);
  std::vector<Verdict> verdicts(trace.all_fragments.size());
  double best = 0;
  for (int run = 0; run < runs; ++run) {
    engine.begin(config, setup);
    engine.announce(trace.all_fragments.data(), trace.all_fragments.size());
    engine.draw(trace.all_casters.data(), trace.all_casters.size());
    engine.decide(trace.all_fragments.data(), 0, verdicts.data());  // ends pass 1
    const double before = now();
    engine.decide(trace.all_fragments.data(), verdicts.size(), verdicts.data());
    const double spent = now() - before;
    best = std::max(best, double(engine.cycles()->pass2->total) / spent);
  }
  return best;
}

void BM_Pass2(benchmark::State& state, Profile profile) {
  UnitConfig config;
  config.profile = profile;
  config.memory_spread = state.range(0);
  SystemcEngine model;
  RtlEngine rtl({});
  double ours = 0, theirs = 0;
  for (auto _ : state) {
    ours = speed(model, config, 5);
    theirs = speed(rtl, config, 1);
  }
  state.counters["systemc cycles/s"] = ours;
  state.counters["rtl cycles/s"] = theirs;
  state.counters["ratio"] = theirs > 0 ? ours / theirs : 0;
}
BENCHMARK_CAPTURE(BM_Pass2, paper, Profile::kPaper)->ArgName("spread")->Arg(0)->Arg(20)->Iterations(1);
BENCHMARK_CAPTURE(BM_Pass2, winding, Profile::kWinding)
    ->ArgName("spread")->Arg(0)->Arg(20)->Iterations(1);

}  // namespace
}  // namespace kagesen

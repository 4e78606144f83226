/// Clock cycles that the Verilated unit simulates a second: whole frames of the default scene, one
/// thread, no waves, beside the golden model's time for the same frame.
#include <benchmark/benchmark.h>

#include "model/engine.h"
#include "model/frame_setup.h"
#include "testbench/verilator/rtl_engine.h"
#include "tests/bench/bench_scenes.h"

namespace kagesen {
namespace {

UnitConfig of(Profile profile) {
  UnitConfig config;
  config.profile = profile;
  return config;
}

void frame(Engine& engine, const Trace& trace, const UnitConfig& config, const FrameSetup& setup,
           std::vector<Verdict>& verdicts) {
  engine.begin(config, setup);
  engine.announce(trace.all_fragments.data(), trace.all_fragments.size());
  engine.draw(trace.all_casters.data(), trace.all_casters.size());
  engine.decide(trace.all_fragments.data(), verdicts.size(), verdicts.data());
}

void run_frames(benchmark::State& state, Engine& engine, Profile profile) {
  const Trace& trace = default_trace();
  const UnitConfig config = of(profile);
  const FrameSetup setup = make_frame_setup(trace, config);
  std::vector<Verdict> verdicts(trace.all_fragments.size());
  frame(engine, trace, config, setup, verdicts);  // builds what is missing
  std::uint64_t cycles = 0;
  for (auto _ : state) {
    frame(engine, trace, config, setup, verdicts);
    if (const auto c = engine.cycles()) {
      cycles += c->total();
    }
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(verdicts.size()));
  if (cycles > 0) {
    state.counters["cycles/s"] =
        benchmark::Counter(double(cycles), benchmark::Counter::kIsRate);
  }
}

void BM_RtlFrame(benchmark::State& state, Profile profile) {
  const auto engine = make_rtl_engine();
  run_frames(state, *engine, profile);
}
void BM_GoldenFrame(benchmark::State& state, Profile profile) {
  const auto engine = make_golden_engine();
  run_frames(state, *engine, profile);
}
BENCHMARK_CAPTURE(BM_GoldenFrame, paper, Profile::kPaper)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(BM_RtlFrame, paper, Profile::kPaper)->Unit(benchmark::kMillisecond)->Iterations(1);
BENCHMARK_CAPTURE(BM_GoldenFrame, winding, Profile::kWinding)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(BM_RtlFrame, winding, Profile::kWinding)
    ->Unit(benchmark::kMillisecond)
    ->Iterations(1);

}  // namespace
}  // namespace kagesen

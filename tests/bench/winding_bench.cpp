/// The winding profile: look-ups beside BM_PlainMap of the same run, and whole frames of every
/// built-in scene with all skips on and off.
#include <benchmark/benchmark.h>

#include "model/engine.h"
#include "model/frame_setup.h"
#include "tests/bench/bench_scenes.h"

namespace kagesen {
namespace {

UnitConfig winding(bool skips) {
  UnitConfig config;
  config.profile = Profile::kWinding;
  config.skip_receiver_mask = config.skip_first_test = config.skip_tiles = config.skip_edges =
      config.skip_fragments = skips;
  return config;
}

void draw_frame(Engine& engine, const Trace& trace, const UnitConfig& config,
                const FrameSetup& setup) {
  engine.begin(config, setup);
  engine.announce(trace.all_fragments.data(), trace.all_fragments.size());
  engine.draw(trace.all_casters.data(), trace.all_casters.size());
}

void pass2(benchmark::State& state, bool skips) {
  const Trace& trace = default_trace();
  const UnitConfig config = winding(skips);
  const auto engine = make_golden_engine();
  draw_frame(*engine, trace, config, make_frame_setup(trace, config));
  std::vector<Verdict> verdicts(trace.all_fragments.size());
  for (auto _ : state) {
    engine->decide(trace.all_fragments.data(), verdicts.size(), verdicts.data());
    benchmark::DoNotOptimize(verdicts.data());
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(verdicts.size()));
}
void BM_WindingPass2(benchmark::State& state) { pass2(state, true); }
void BM_WindingPass2NoSkips(benchmark::State& state) { pass2(state, false); }
BENCHMARK(BM_WindingPass2)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_WindingPass2NoSkips)->Unit(benchmark::kMillisecond);

/// Mask, pass 1 and pass 2; what the host prepares is left out. Argument 1: 1 with all skips.
void BM_WindingFrame(benchmark::State& state) {
  const std::string scene = builtin_scenes()[static_cast<std::size_t>(state.range(0))].name;
  const Trace& trace = scene_trace(scene);
  const UnitConfig config = winding(state.range(1) != 0);
  const FrameSetup setup = make_frame_setup(trace, config);
  const auto engine = make_golden_engine();
  std::vector<Verdict> verdicts(trace.all_fragments.size());
  for (auto _ : state) {
    draw_frame(*engine, trace, config, setup);
    engine->decide(trace.all_fragments.data(), verdicts.size(), verdicts.data());
    benchmark::DoNotOptimize(verdicts.data());
  }
  state.SetLabel(scene + (state.range(1) != 0 ? ", skips on" : ", skips off"));
}
BENCHMARK(BM_WindingFrame)
    ->ArgsProduct({benchmark::CreateDenseRange(0, 7, 1), {0, 1}})
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace kagesen

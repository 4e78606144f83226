/// Golden unit against a plain shadow map on the same fragments, and pass 1 by kind of work.
///
/// `items_per_second` is fragments, edge texels or span texels; compare BM_Pass2 with BM_PlainMap
/// of the same run.
#include <benchmark/benchmark.h>

#include <cmath>

#include "model/engine.h"
#include "model/frame_setup.h"
#include "model/rivals/plain_map.h"
#include "tests/bench/bench_scenes.h"

namespace kagesen {
namespace {

void BM_PlainMap(benchmark::State& state) {
  const Trace& trace = default_trace();
  PlainMap map(1024, 1024, 1024, 1024, trace.header.fraction_bits);
  for (const Caster& caster : trace.all_casters) map.draw(caster);
  std::vector<Verdict> verdicts(trace.all_fragments.size());
  for (auto _ : state) {
    for (std::size_t i = 0; i < verdicts.size(); ++i) {
      verdicts[i] = map.decide(trace.all_fragments[i], Semantics::kPaper);
    }
    benchmark::DoNotOptimize(verdicts.data());
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(verdicts.size()));
}
BENCHMARK(BM_PlainMap)->Unit(benchmark::kMillisecond);

void BM_Pass2(benchmark::State& state) {
  const Trace& trace = default_trace();
  const auto engine = make_golden_engine();
  engine->begin(UnitConfig{}, make_frame_setup(trace, UnitConfig{}));
  engine->draw(trace.all_casters.data(), trace.all_casters.size());
  std::vector<Verdict> verdicts(trace.all_fragments.size());
  for (auto _ : state) {
    engine->decide(trace.all_fragments.data(), verdicts.size(), verdicts.data());
    benchmark::DoNotOptimize(verdicts.data());
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(verdicts.size()));
}
BENCHMARK(BM_Pass2)->Unit(benchmark::kMillisecond);

/// Pass 1 alone, without the clearing of the map.
template <typename Count>
void pass1(benchmark::State& state, const std::vector<Caster>& casters, const FrameSetup& setup,
           Count count) {
  const auto engine = make_golden_engine();
  std::uint64_t items = 0;
  for (auto _ : state) {
    state.PauseTiming();
    engine->begin(UnitConfig{}, setup);
    state.ResumeTiming();
    engine->draw(casters.data(), casters.size());
    state.PauseTiming();
    items += count(engine->counters());
    state.ResumeTiming();
  }
  state.SetItemsProcessed(static_cast<std::int64_t>(items));
}

/// The default scene: edge texels a second, spans included in the time.
void BM_Pass1EdgeTexelsDefaultScene(benchmark::State& state) {
  const Trace& trace = default_trace();
  pass1(state, trace.all_casters, make_frame_setup(trace, UnitConfig{}),
        [](const UnitCounters& c) { return c.edge_texels; });
}
BENCHMARK(BM_Pass1EdgeTexelsDefaultScene)->Unit(benchmark::kMillisecond);

/// A hemisphere of half a million triangles of about two texels: setup and cancelling bound it.
void BM_Pass1EdgeTexelsSmallTriangles(benchmark::State& state) {
  static const std::vector<Caster> casters = [] {
    constexpr int kRings = 350, kSectors = 700;
    const auto point = [](int ring, int sector) {
      const double polar = 1.5707963 * ring / kRings,
                   azimuth = 6.2831853 * (sector % kSectors) / kSectors;
      const double radius = 450 * 65536.0 * std::sin(polar);
      return LightPoint{static_cast<std::int32_t>(std::lrint(radius * std::cos(azimuth))),
                        static_cast<std::int32_t>(std::lrint(radius * std::sin(azimuth))),
                        static_cast<std::uint32_t>(8e6 - 6e6 * std::cos(polar))};
    };
    std::vector<Caster> out;
    for (int r = 0; r < kRings; ++r) {
      for (int s = 0; s < kSectors; ++s) {
        const auto id = static_cast<std::uint32_t>(out.size());
        out.push_back({{point(r, s), point(r + 1, s), point(r + 1, s + 1)}, 0, id});
        out.push_back({{point(r, s), point(r + 1, s + 1), point(r, s + 1)}, 0, id + 1});
      }
    }
    return out;
  }();
  pass1(state, casters, FrameSetup{}, [](const UnitCounters& c) { return c.edge_texels; });
}
BENCHMARK(BM_Pass1EdgeTexelsSmallTriangles)->Unit(benchmark::kMillisecond);

/// Fifty layers of triangles as large as the map, each nearer than the last: writes bound it.
void BM_Pass1SpanTexels(benchmark::State& state) {
  std::vector<Caster> casters;
  for (int i = 0; i < 50; ++i) {
    const auto z = static_cast<std::uint32_t>(9000000 - 1000 * i);
    casters.push_back({{{-500 * 65536 + 1000 * i, -500 * 65536, z},
                        {500 * 65536, -490 * 65536 + 777 * i, z + 500000},
                        {1234 * i, 500 * 65536 - 999 * i, z + 200000}},
                       static_cast<std::uint32_t>(i),
                       static_cast<std::uint32_t>(i)});
  }
  pass1(state, casters, FrameSetup{}, [](const UnitCounters& c) { return c.span_texels; });
}
BENCHMARK(BM_Pass1SpanTexels)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace kagesen

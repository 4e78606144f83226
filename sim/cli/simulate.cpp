#include "sim/cli/simulate.h"

#include <fmt/format.h>

#include <algorithm>

#include "model/unit_ids.h"
#include "sim/cli/nearest.h"
#include "sim/cli/stopwatch.h"
#include "traces/format/error.h"

namespace kagesen {
namespace {

// Large enough to cost nothing, small enough for the progress line to move.
constexpr std::size_t kPortion = 1u << 18;

void add_warnings(RunResult& result) {
  const UnitCounters& counters = result.counters;
  if (counters.aliased_objects > 0) {
    result.warnings.push_back(
        fmt::format("{} objects share an ID with another one: {} bits are too few; raise id_bits",
                    counters.aliased_objects, result.config.id_bits));
  }
  if (counters.overflow_texels > 0) {
    result.warnings.push_back(
        fmt::format("{} lines of {} texels found no room; these texels answer as a plain map does",
                    counters.overflow_lines, counters.overflow_texels));
  }
}

}  // namespace

std::unique_ptr<Engine> make_engine(const std::string& name) {
  if (name == "golden") return make_golden_engine();
  throw UserError("--engine", fmt::format("there is no '{}'", name), suggestion(name, {"golden"}));
}

RunResult simulate(const Trace& trace, const UnitConfig& config, const SimulateOptions& options) {
  const auto progress = [&](const char* stage, double done) {
    if (options.progress) options.progress(stage, done);
  };
  RunResult result;
  result.config = config;
  result.engine = options.engine;
  result.warnings = trace.header.warnings;
  const std::unique_ptr<Engine> engine = make_engine(options.engine);

  Stopwatch watch;
  UnitIds units = assign_unit_ids(trace, trace.header.fraction_bits, int(config.id_bits));
  const FrameSetup setup{trace.header.fraction_bits, std::move(units.ids)};
  engine->begin(config, setup);
  const auto& casters = trace.all_casters;
  for (std::size_t at = 0; at < casters.size(); at += kPortion) {
    progress("pass 1", double(at) / double(casters.size()));
    engine->draw(casters.data() + at, std::min(kPortion, casters.size() - at));
  }
  result.stages_s.emplace_back("pass1", watch.lap());

  const auto& fragments = trace.all_fragments;
  result.verdicts.resize(fragments.size());
  for (std::size_t at = 0; at < fragments.size(); at += kPortion) {
    progress("pass 2", double(at) / double(fragments.size()));
    engine->decide(fragments.data() + at, std::min(kPortion, fragments.size() - at),
                   result.verdicts.data() + at);
  }
  result.stages_s.emplace_back("pass2", watch.lap());

  result.contents = engine->contents();
  result.counters = engine->counters();
  result.counters.aliased_objects = units.sharing;
  add_warnings(result);
  result.stages_s.emplace_back("contents", watch.lap());
  if (options.reference) {
    JudgeOptions judging;
    judging.equivalent_resolution = options.equivalent_resolution;
    judging.progress = options.progress;
    result.judgement = judge(trace, config, setup, *engine, result.verdicts, judging);
    result.stages_s.emplace_back("reference", watch.lap());
  }
  return result;
}

}  // namespace kagesen

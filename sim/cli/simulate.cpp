#include "sim/cli/simulate.h"

#include <fmt/format.h>

#include <algorithm>

#include "model/frame_setup.h"
#include "sim/cli/nearest.h"
#include "sim/cli/stopwatch.h"
#include "traces/format/error.h"
#include "traces/format/words.h"

namespace kagesen {
namespace {

// Large enough to cost nothing, small enough for the progress line to move.
constexpr std::size_t kPortion = 1u << 18;

void add_warnings(const Trace& trace, RunResult& result) {
  const UnitCounters& counters = result.counters;
  const std::uint64_t fragments = trace.all_fragments.size();
  if (fragments == 0) {
    result.warnings.push_back("no fragment to decide: the camera sees nothing of the scene");
  } else if (counters.averted + counters.outside >= fragments) {
    result.warnings.push_back("nothing to judge: every fragment is averted or outside the light");
  }
  if (counters.aliased_objects > 0) {
    result.warnings.push_back(
        fmt::format("{} an ID with another one: {} too few; raise id_bits",
                    counted(counters.aliased_objects, "object") +
                        (counters.aliased_objects == 1 ? " shares" : " share"),
                    counted(std::uint64_t(result.config.id_bits), "bit") +
                        (result.config.id_bits == 1 ? " is" : " are")));
  }
  if (counters.overflow_texels > 0) {
    result.warnings.push_back(fmt::format(
        "{} of {} found no room; overflowed texels answer as a plain map does",
        counted(counters.overflow_lines, "line"), counted(counters.overflow_texels, "texel")));
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
  std::uint64_t aliased_objects = 0;
  const FrameSetup setup = make_frame_setup(trace, config, &aliased_objects);
  engine->begin(config, setup);
  engine->announce(trace.all_fragments.data(), trace.all_fragments.size());
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
  result.counters.aliased_objects = aliased_objects;
  add_warnings(trace, result);
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

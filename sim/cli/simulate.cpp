#include "sim/cli/simulate.h"

#include <fmt/format.h>

#include <algorithm>

#include "model/frame_setup.h"
#include "sim/cli/nearest.h"
#include "sim/cli/stopwatch.h"
#include "sim/systemc/engine.h"
#include "testbench/verilator/rtl_engine.h"
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
  if (counters.overflow_texels > 0 && result.config.profile == Profile::kWinding) {
    result.warnings.push_back(fmt::format(
        "{} of {} found no room; raise cluster_records, "
        "chain_records or corner_bits",
        counted(counters.overflow_lines, "segment"), counted(counters.overflow_texels, "texel")));
  } else if (counters.overflow_texels > 0) {
    result.warnings.push_back(fmt::format(
        "{} of {} found no room; overflowed texels answer as a plain map does",
        counted(counters.overflow_lines, "line"), counted(counters.overflow_texels, "texel")));
  }
}

UnitConfig in_other_semantics(UnitConfig config) {
  const bool paper = config.semantics == Semantics::kPaper;
  config.semantics = paper ? Semantics::kPhysical : Semantics::kPaper;
  return config;
}

/// Takes engines through one frame.
struct Passes {
  const Trace& trace;
  const std::function<void(const std::string& stage, double done)>& progress;

  /// @param stage_done  called after each stage with its name in report.json
  template <class StageDone>
  std::vector<Verdict> run(Engine& engine, const UnitConfig& config, const FrameSetup& setup,
                           StageDone stage_done) const {
    const std::vector<Fragment>& fragments = trace.all_fragments;
    engine.begin(config, setup);
    if (config.profile == Profile::kWinding) {
      in_portions("announcing", fragments.size(), [&](std::size_t at, std::size_t count) {
        engine.announce(fragments.data() + at, count);
      });
      stage_done("announce");
    }
    in_portions("pass 1", trace.all_casters.size(), [&](std::size_t at, std::size_t count) {
      engine.draw(trace.all_casters.data() + at, count);
    });
    stage_done("pass1");
    std::vector<Verdict> verdicts(fragments.size());
    in_portions("pass 2", fragments.size(), [&](std::size_t at, std::size_t count) {
      engine.decide(fragments.data() + at, count, verdicts.data() + at);
    });
    stage_done("pass2");
    return verdicts;
  }

 private:
  template <class Use>
  void in_portions(const char* stage, std::size_t total, Use use) const {
    for (std::size_t at = 0; at < total; at += kPortion) {
      if (progress) progress(stage, double(at) / double(total));
      use(at, std::min(kPortion, total - at));
    }
  }
};

}  // namespace

std::unique_ptr<Engine> make_engine(const std::string& name) {
  if (name == "golden") return make_golden_engine();
  if (name == "systemc") return make_systemc_engine({{}, true});
  if (name == "rtl") return make_rtl_engine({BuildKind::kFast, {}, true, nullptr, {}});
  throw UserError("--engine", fmt::format("there is no '{}'", name),
                  suggestion(name, {"golden", "systemc", "rtl"}));
}

RunResult simulate(const Trace& trace, const UnitConfig& config, const SimulateOptions& options) {
  RunResult result;
  result.config = config;
  result.engine = options.engine;
  result.warnings = trace.header.warnings;
  const std::unique_ptr<Engine> engine = options.make(options.engine);
  const bool winding = config.profile == Profile::kWinding;

  Stopwatch watch;
  std::uint64_t aliased_objects = 0;
  const FrameSetup setup = make_frame_setup(trace, config, &aliased_objects);
  if (winding) result.stages_s.emplace_back("setup", watch.lap());
  const Passes passes{trace, options.progress};
  result.verdicts = passes.run(*engine, config, setup, [&](const char* stage) {
    result.stages_s.emplace_back(stage, watch.lap());
  });

  result.contents = engine->contents();
  result.counters = engine->counters();
  result.counters.aliased_objects = aliased_objects;
  result.cycles = engine->cycles();
  result.fragment_cycles = engine->fragment_cycles();
  add_warnings(trace, result);
  result.stages_s.emplace_back("contents", watch.lap());

  std::unique_ptr<Engine> other;
  if (winding && (options.reference || options.both_semantics)) {
    const UnitConfig other_config = in_other_semantics(config);
    // SystemC's verdicts are golden's.
    other = options.engine == "systemc" ? make_golden_engine() : options.make(options.engine);
    result.other_verdicts =
        passes.run(*other, other_config, make_frame_setup(trace, other_config), [](const char*) {});
    result.stages_s.emplace_back("other_semantics", watch.lap());
  }
  if (options.reference) {
    JudgeOptions judging;
    judging.equivalent_resolution = options.equivalent_resolution;
    judging.other_equivalent_resolution = options.other_equivalent_resolution;
    judging.exact = options.exact;
    judging.progress = options.progress;
    const auto run_in = [&](Semantics semantics) -> UnitRun {
      const bool main = !winding || semantics == config.semantics;
      return {main ? *engine : *other, result.verdicts_in(semantics)};
    };
    result.judgement = judge(trace, config, setup, run_in(Semantics::kPaper),
                             run_in(Semantics::kPhysical), judging);
    result.stages_s.emplace_back("reference", watch.lap());
  }
  return result;
}

}  // namespace kagesen

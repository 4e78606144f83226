#include "sim/cli/curve/measure.h"

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include "model/rivals/plain_map.h"
#include "sim/cli/simulate.h"
#include "sim/cli/stopwatch.h"

namespace kagesen {
namespace {

constexpr int kRuns = 3;

UnitConfig unit_of(const CurveRow& row) {
  UnitConfig config;
  set_field(config, "profile", row.profile);
  set_field(config, "semantics", row.semantics);
  config.fraction_bits = std::int64_t(row.fraction_bits);
  config.slope_bits = std::int64_t(row.slope_bits);
  config.map_width = config.map_height = std::int64_t(row.map);
  return config;
}

struct Seconds {
  double pass1 = std::numeric_limits<double>::infinity();
  double pass2 = std::numeric_limits<double>::infinity();
  void keep_best(double first, double second) {
    pass1 = std::min(pass1, first);
    pass2 = std::min(pass2, second);
  }
};

/// Of all stages of these names.
double seconds_of(const RunResult& result, const std::vector<std::string>& stages) {
  double sum = 0;
  for (const auto& [stage, seconds] : result.stages_s) {
    if (std::find(stages.begin(), stages.end(), stage) != stages.end()) sum += seconds;
  }
  return sum;
}

/// Draws and looks up a plain map of the trace's own side.
void run_plain(const Trace& trace, Semantics semantics, Seconds& best) {
  const TraceHeader& header = trace.header;
  Stopwatch watch;
  PlainMap map(header.map_width, header.map_height, header.map_width, header.map_height,
               header.fraction_bits);
  for (const Caster& caster : trace.all_casters) map.draw(caster);
  const double pass1 = watch.lap();
  std::vector<Verdict> verdicts(trace.all_fragments.size());
  std::transform(trace.all_fragments.begin(), trace.all_fragments.end(), verdicts.begin(),
                 [&](const Fragment& f) { return map.decide(f, semantics); });
  best.keep_best(pass1, watch.lap());
  // Something has to read the verdicts, or the compiler may leave the look-ups out.
  [[maybe_unused]] volatile auto dark =
      std::count(verdicts.begin(), verdicts.end(), Verdict::kDark);
}

}  // namespace

CurveRow measure_point(const Trace& trace, const CurveRow& setting) {
  const UnitConfig config = unit_of(setting);
  SimulateOptions options;
  options.equivalent_resolution = false;
  Seconds unit, plain;
  RunResult result;
  for (int run = 0; run < kRuns; ++run) {
    run_plain(trace, config.semantics, plain);
    options.reference = run == kRuns - 1;
    result = simulate(trace, config, options);
    // The receiver mask is made before pass 1, and for its sake.
    unit.keep_best(seconds_of(result, {"announce", "pass1"}), seconds_of(result, {"pass2"}));
  }

  const bool paper = config.semantics == Semantics::kPaper;
  const ErrorFigures& error = paper ? result.judgement->paper : result.judgement->physical;
  CurveRow row = setting;
  row.judged = error.judged;
  row.wrong = error.wrong;
  row.band = error.band;
  row.band_wrong = error.band_wrong;
  row.band_rate = error.band_rate();
  row.displacement_mean = error.displacement_mean;
  row.beyond_bound = error.beyond_bound;
  row.overflow_texels = result.counters.overflow_texels;
  row.map_bytes = result.counters.map_bytes;
  row.slb_bytes = result.counters.allocated_bytes;
  row.total_bytes = row.map_bytes + row.slb_bytes;
  row.pass1_s = unit.pass1;
  row.pass2_s = unit.pass2;
  row.fragments_per_s = double(trace.all_fragments.size()) / unit.pass2;
  row.plain_same_side_wrong = result.judgement->plain_same_side.wrong;
  row.plain_pass1_s = plain.pass1;
  row.plain_pass2_s = plain.pass2;
  row.lookup_ratio = unit.pass2 / plain.pass2;
  row.total_ratio = (unit.pass1 + unit.pass2) / (plain.pass1 + plain.pass2);
  return row;
}

}  // namespace kagesen

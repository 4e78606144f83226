#include "sim/cli/results/gather.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <stdexcept>

#include "model/rivals/plain_map.h"
#include "sim/cli/results/sheet.h"
#include "sim/cli/simulate.h"
#include "traces/raster/capture.h"
#include "traces/scene/scene.h"

namespace kagesen {
namespace {

UnitConfig unit_with(unsigned bits) {
  UnitConfig config;
  config.fraction_bits = bits;
  config.slope_bits = bits;
  return config;
}

Measurement measure(const RunResult& result, unsigned scale, unsigned bits) {
  Measurement m;
  m.scale = scale;
  m.bits = bits;
  m.fragments = result.verdicts.size();
  m.texels = result.counters.slb_texels;
  m.lines = result.counters.slb_lines;
  m.payload_bytes = result.counters.payload_bytes;
  m.allocated_bytes = result.counters.allocated_bytes;
  m.map_bytes = result.counters.map_bytes;
  m.overflow_lines = result.counters.overflow_lines;
  m.paper = result.judgement->paper;
  m.physical = result.judgement->physical;
  m.equivalent = result.judgement->equivalent_resolution;
  m.plain_same_side = result.judgement->plain_same_side;
  m.plain_equal_bytes = result.judgement->plain_equal_bytes;
  return m;
}

/// What a plain map of the unit's own size would show.
std::vector<Verdict> plain_verdicts(const Trace& trace) {
  const TraceHeader& header = trace.header;
  PlainMap map(header.map_width, header.map_height, header.map_width, header.map_height,
               header.fraction_bits);
  for (const Caster& caster : trace.all_casters) map.draw(caster);
  std::vector<Verdict> verdicts;
  verdicts.reserve(trace.all_fragments.size());
  for (const Fragment& fragment : trace.all_fragments) {
    verdicts.push_back(map.decide(fragment, Semantics::kPaper));
  }
  return verdicts;
}

/// Takes one scene through all that the page tells of it.
class SceneGathering {
 public:
  SceneGathering(const std::string& name, const ResultsOptions& options)
      : options_(options), scene_(make_builtin(name)), sheet_(options.scales) {
    results_.name = name;
    for (const SceneInfo& info : builtin_scenes()) {
      if (info.name == name) results_.description = info.description;
    }
    results_.triangles = scene_.triangle_count();
    results_.objects = scene_.objects.size();
  }

  SceneResults run() {
    for (const unsigned scale : options_.scales) {
      Trace trace;
      capture(scene_, capturing(scale), trace);
      const auto exact = std::make_shared<ExactFrame>();
      for (const unsigned bits : {8u, 4u}) paper_profile(trace, scale, bits, exact);
      sheet_.add(trace, plain_verdicts(trace), scale, Sheet::kPlain);
      winding_profile(trace, scale, exact);
    }
    results_.sheet = sheet_.picture();
    return std::move(results_);
  }

 private:
  CaptureOptions capturing(unsigned scale) const {
    CaptureOptions capturing;
    capturing.image_width = options_.image_width;
    capturing.image_height = options_.image_height;
    capturing.scale_x = capturing.scale_y = scale;
    return capturing;
  }

  Report report_of(const std::string& part) const {
    if (!options_.progress) return {};
    const std::string where = fmt::format("{}, {}: ", results_.name, part);
    return [this, where](const std::string& stage, double done) {
      options_.progress(where + stage, done);
    };
  }

  void paper_profile(const Trace& trace, unsigned scale, unsigned bits,
                     const std::shared_ptr<ExactFrame>& exact) {
    SimulateOptions simulating;
    simulating.exact = exact;
    simulating.progress = report_of(fmt::format("scale {}, {} bits", scale, bits));
    const RunResult result = simulate(trace, unit_with(bits), simulating);
    results_.runs.push_back(measure(result, scale, bits));
    if (sheet_.empty()) sheet_.choose_window(trace, result.judgement->exact_paper);
    sheet_.add(trace, result.verdicts, scale, bits == 8 ? Sheet::k8Bits : Sheet::k4Bits);
  }

  void winding_profile(const Trace& trace, unsigned scale,
                       const std::shared_ptr<ExactFrame>& exact) {
    const Report report = report_of(fmt::format("scale {}, winding", scale));
    WindingResults& winding = results_.winding;
    winding.accuracy.push_back(winding_accuracy(trace, scale, exact, report));
    if (scale == 1 || scale == 16) {
      winding.memory.push_back(winding_memory(trace, scale, report));
    }
    if (scale != 1) return;
    winding.skips = winding_skips(trace, report);
    winding.first_test = first_tests(scene_, capturing(scale), report);
  }

  const ResultsOptions& options_;
  const Scene scene_;
  SceneResults results_;
  Sheet sheet_;
};

}  // namespace

const Measurement& SceneResults::at(unsigned scale, unsigned bits) const {
  const auto found = std::find_if(runs.begin(), runs.end(), [&](const Measurement& m) {
    return m.scale == scale && m.bits == bits;
  });
  if (found == runs.end()) throw std::logic_error("no such measurement");
  return *found;
}

std::vector<SceneResults> gather_results(const ResultsOptions& options) {
  std::vector<SceneResults> results;
  for (const std::string& name : options.scenes)
    results.push_back(SceneGathering(name, options).run());
  return results;
}

}  // namespace kagesen

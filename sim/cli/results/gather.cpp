#include "sim/cli/results/gather.h"

#include <fmt/format.h>

#include <algorithm>
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

SceneResults gather_scene(const std::string& name, const ResultsOptions& options) {
  const Scene scene = make_builtin(name);
  SceneResults results;
  results.name = name;
  for (const SceneInfo& info : builtin_scenes()) {
    if (info.name == name) results.description = info.description;
  }
  results.triangles = scene.triangle_count();
  results.objects = scene.objects.size();

  Sheet sheet(options.scales);
  for (const unsigned scale : options.scales) {
    CaptureOptions capturing;
    capturing.image_width = options.image_width;
    capturing.image_height = options.image_height;
    capturing.scale_x = capturing.scale_y = scale;
    Trace trace;
    capture(scene, capturing, trace);
    for (const unsigned bits : {8u, 4u}) {
      SimulateOptions simulating;
      const std::string where = fmt::format("{}, scale {}, {} bits: ", name, scale, bits);
      if (options.progress) {
        simulating.progress = [&](const std::string& stage, double done) {
          options.progress(where + stage, done);
        };
      }
      const RunResult result = simulate(trace, unit_with(bits), simulating);
      results.runs.push_back(measure(result, scale, bits));
      if (sheet.empty()) sheet.choose_window(trace, result.judgement->exact_paper);
      sheet.add(trace, result.verdicts, scale, bits == 8 ? Sheet::k8Bits : Sheet::k4Bits);
    }
    sheet.add(trace, plain_verdicts(trace), scale, Sheet::kPlain);
  }
  results.sheet = sheet.picture();
  return results;
}

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
  for (const std::string& name : options.scenes) results.push_back(gather_scene(name, options));
  return results;
}

}  // namespace kagesen

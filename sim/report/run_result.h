#pragma once
/// Everything one run found out: what the table, the JSON and the pictures are made of.
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "model/engine.h"
#include "model/reference/judge.h"
#include "model/reference/scene_exact.h"
#include "model/unit/config.h"
#include "traces/format/records.h"

namespace kagesen {

/// The end-to-end check: rays against the meshes as they were before snapping.
struct SceneExact {
  SceneExactReport unit;                  ///< the unit's verdicts
  std::optional<SceneExactReport> trace;  ///< the exact ones on the trace: what its making cost
};

/// The clock that synthesis found for a configuration.
struct SynthesisedClock {
  double mhz = 0;
  std::string source;  ///< "osu018"
};

struct RunResult {
  UnitConfig config;
  std::string engine;
  std::vector<Verdict> verdicts;        ///< a fragment each
  std::vector<Verdict> other_verdicts;  ///< winding: in the other semantics; empty where not run
  MapContents contents;
  UnitCounters counters;
  std::optional<CycleReport> cycles;                     ///< absent where the engine has no clock
  std::vector<FragmentCycles> fragment_cycles;           ///< of pass 2; empty where not kept
  std::optional<SynthesisedClock> clock;                 ///< absent unless it was measured before
  std::optional<Judgement> judgement;                    ///< absent without the reference
  std::optional<SceneExact> scene_exact;                 ///< absent unless asked for
  std::vector<std::string> warnings;                     ///< the trace's own, then the unit's
  std::vector<std::pair<std::string, double>> stages_s;  ///< wall time of each stage, in order

  /// The verdicts to hold against a semantics: in the paper profile the same ones against both.
  const std::vector<Verdict>& verdicts_in(Semantics semantics) const {
    const bool other = config.profile == Profile::kWinding && semantics != config.semantics;
    return other ? other_verdicts : verdicts;
  }
  /// Frames a second at the synthesised clock; nothing where either is not known.
  std::optional<double> frames_per_s() const {
    if (!clock || !cycles || !cycles->whole_frame(config.profile == Profile::kWinding)) return std::nullopt;
    return clock->mhz * 1e6 / double(cycles->total());
  }
  double time_s() const {
    double sum = 0;
    for (const auto& stage : stages_s) sum += stage.second;
    return sum;
  }
};

/// Figures that follow from the trace and the verdicts alone.
struct Summary {
  std::uint64_t triangles = 0, objects = 0, closed_objects = 0, receivers = 0;
  /// Objects by what of them is drawn: their light-facing side (closed ones), every triangle (open
  /// and non-manifold ones); receivers are drawn not at all.
  std::uint64_t drawn_light_facing = 0, drawn_all = 0;
  std::uint64_t casters = 0, fragments = 0, dark = 0, lit = 0;
};
inline Summary summarise(const Trace& trace, const RunResult& result) {
  Summary s;
  for (const ObjectInfo& object : trace.header.objects) {
    s.triangles += object.triangles;
    s.closed_objects += object.closed;
    s.receivers += !object.caster;
    s.drawn_light_facing += object.caster && object.closed;
    s.drawn_all += object.caster && !object.closed;
  }
  s.objects = trace.header.objects.size();
  s.casters = trace.all_casters.size();
  s.fragments = trace.all_fragments.size();
  for (const Verdict verdict : result.verdicts) s.dark += verdict == Verdict::kDark;
  s.lit = s.fragments - s.dark;
  return s;
}

}  // namespace kagesen

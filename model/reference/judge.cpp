#include "model/reference/judge.h"

#include <algorithm>
#include <cmath>

#include "model/reference/beside_plain.h"
#include "model/reference/cause.h"
#include "model/reference/winding_cause.h"

namespace kagesen {
namespace {

constexpr double kSearchTexels = 8;  // how far a boundary is looked for
constexpr std::size_t kDisplacementSamples = 2000;

/// Paper profile: a surface this close in depth is in contact; snapping alone may turn the verdict.
constexpr double kContactDepthUnits = 4;

class Judge {
 public:
  Judge(const Trace& trace, const UnitConfig& config, const FrameSetup& setup, const UnitRun& paper,
        const UnitRun& physical, const JudgeOptions& options)
      : trace_(trace),
        config_(config),
        setup_(setup),
        paper_(paper),
        physical_(physical),
        options_(options),
        reference_(trace.all_casters) {}

  Judgement run() {
    exact_verdicts();
    if (config_.profile == Profile::kWinding) {
      winding_causes(Semantics::kPaper, paper_, out_.exact_paper, out_.cause_paper, out_.paper);
      winding_causes(Semantics::kPhysical, physical_, out_.exact_physical, out_.cause_physical,
                     out_.physical);
    } else {
      paper_causes();
    }
    band();
    figures(Semantics::kPaper, out_.paper, paper_.verdicts, out_.exact_paper, out_.cause_paper,
            in_band_paper_);
    figures(Semantics::kPhysical, out_.physical, physical_.verdicts, out_.exact_physical,
            out_.cause_physical, in_band_physical_);
    beside_plain_maps();
    return std::move(out_);
  }

 private:
  const std::vector<Fragment>& fragments() const { return trace_.all_fragments; }

  void report(const char* stage, std::size_t i) const {
    if (options_.progress && i % 65536 == 0) {
      options_.progress(stage, fragments().empty() ? 1 : double(i) / double(fragments().size()));
    }
  }

  bool on_map(const Fragment& f) const {
    const std::int64_t x = (f.position.x >> setup_.fraction_bits) + config_.map_width / 2;
    const std::int64_t y = (f.position.y >> setup_.fraction_bits) + config_.map_height / 2;
    return x >= 0 && y >= 0 && x < config_.map_width && y < config_.map_height;
  }

  void exact_verdicts() {
    const std::size_t count = fragments().size();
    out_.exact_paper.resize(count);
    out_.exact_physical.resize(count);
    judged_.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
      report("exact verdicts", i);
      const Fragment& f = fragments()[i];
      judged_[i] = (f.flags & (Fragment::kAverted | Fragment::kOutside)) == 0 && on_map(f);
      if (!judged_[i]) {  // decided by definition
        out_.exact_paper[i] = out_.exact_physical[i] = (f.flags & Fragment::kAverted) != 0;
        continue;
      }
      // What the paper calls dark is dark physically too.
      out_.exact_paper[i] = reference_.dark(f, Semantics::kPaper);
      out_.exact_physical[i] = out_.exact_paper[i] || reference_.dark(f, Semantics::kPhysical);
    }
  }

  static bool dark(const UnitRun& run, std::size_t i) { return run.verdicts[i] == Verdict::kDark; }

  void paper_causes() {
    const MapContents contents = paper_.engine.contents();
    const CauseFinder finder(trace_, config_, setup_, contents, reference_);
    out_.cause_paper.assign(fragments().size(), Cause::kNone);
    out_.cause_physical.assign(fragments().size(), Cause::kNone);
    for (std::size_t i = 0; i < fragments().size(); ++i) {
      report("causes", i);
      if (!judged_[i]) continue;
      const bool paper_wrong = dark(paper_, i) != (out_.exact_paper[i] != 0);
      const bool physical_wrong = dark(physical_, i) != (out_.exact_physical[i] != 0);
      if (paper_wrong) out_.cause_paper[i] = finder.find(fragments()[i], out_.exact_paper[i] != 0);
      // Where only the physical verdict is missed, the object shadows itself.
      if (physical_wrong)
        out_.cause_physical[i] = paper_wrong ? out_.cause_paper[i] : Cause::kIdRule;
    }
  }

  void winding_causes(Semantics semantics, const UnitRun& run,
                      const std::vector<std::uint8_t>& exact, std::vector<Cause>& causes,
                      ErrorFigures& e) {
    const MapContents contents = run.engine.contents();
    const WindingCauseFinder finder(trace_, config_, setup_, contents, reference_, semantics);
    causes.assign(fragments().size(), Cause::kNone);
    for (std::size_t i = 0; i < fragments().size(); ++i) {
      report("causes", i);
      if (!judged_[i] || dark(run, i) == (exact[i] != 0)) continue;
      const WindingFault fault = finder.find(fragments()[i], exact[i] != 0);
      causes[i] = fault.cause;
      e.beyond_bound += fault.breaks_contract;
    }
  }

  void band() {
    const double texel = std::ldexp(1.0, static_cast<int>(setup_.fraction_bits));
    in_band_paper_.resize(fragments().size());
    in_band_physical_.resize(fragments().size());
    for (std::size_t i = 0; i < fragments().size(); ++i) {
      report("band", i);
      if (!judged_[i]) continue;
      const Fragment& f = fragments()[i];
      in_band_paper_[i] = reference_.in_band(f.position, f.object, Semantics::kPaper, texel);
      in_band_physical_[i] = reference_.in_band(f.position, f.object, Semantics::kPhysical, texel);
    }
  }

  void figures(Semantics semantics, ErrorFigures& e, const std::vector<Verdict>& verdicts,
               const std::vector<std::uint8_t>& exact, const std::vector<Cause>& cause,
               const std::vector<std::uint8_t>& in_band) {
    std::vector<std::size_t> wrong;
    for (std::size_t i = 0; i < fragments().size(); ++i) {
      if (!judged_[i]) continue;
      ++e.judged;
      e.band += in_band[i];
      const bool dark = verdicts[i] == Verdict::kDark;
      if (dark == (exact[i] != 0)) continue;
      wrong.push_back(i);
      ++(dark ? e.false_dark : e.false_lit);
      e.band_wrong += in_band[i];
      ++e.causes[static_cast<std::size_t>(cause[i])];
    }
    e.wrong = wrong.size();
    displacement(semantics, wrong, e);
    if (config_.profile == Profile::kPaper) paper_beyond_bound(semantics, wrong, e);
  }

  void paper_beyond_bound(Semantics semantics, const std::vector<std::size_t>& wrong,
                          ErrorFigures& e) {
    const double bound =
        std::ldexp(1.0, static_cast<int>(setup_.fraction_bits - config_.fraction_bits));
    for (const std::size_t i : wrong) {
      const Fragment& f = fragments()[i];
      if (reference_.boundary_distance(f.position, f.object, semantics, bound + 1) <= bound)
        continue;
      e.beyond_bound +=
          reference_.contact_distance(f.position, f.object, semantics) > kContactDepthUnits;
    }
  }

  /// Over all wrong fragments, or an even sample where they are very many.
  void displacement(Semantics semantics, const std::vector<std::size_t>& wrong, ErrorFigures& e) {
    if (wrong.empty()) return;
    const double texel = std::ldexp(1.0, static_cast<int>(setup_.fraction_bits));
    const std::size_t stride = (wrong.size() + kDisplacementSamples - 1) / kDisplacementSamples;
    std::vector<double> distances;
    for (std::size_t n = 0; n < wrong.size(); n += stride) {
      const Fragment& f = fragments()[wrong[n]];
      distances.push_back(
          reference_.boundary_distance(f.position, f.object, semantics, kSearchTexels * texel) /
          texel);
    }
    std::sort(distances.begin(), distances.end());
    double sum = 0;
    for (const double d : distances) sum += d;
    e.displacement_mean = sum / double(distances.size());
    e.displacement_p99 = distances[(distances.size() - 1) * 99 / 100];
    e.displacement_max = distances.back();
    e.displacement_capped = distances.back() >= kSearchTexels;
  }

  void beside_plain_maps() {
    const Semantics semantics = main_semantics(config_);
    const bool paper = semantics == Semantics::kPaper;
    const UnitRun& run = paper ? paper_ : physical_;
    const PlainComparison frame{trace_,
                                config_,
                                setup_,
                                reference_,
                                semantics,
                                run.verdicts,
                                paper ? out_.exact_paper : out_.exact_physical,
                                judged_,
                                paper ? in_band_paper_ : in_band_physical_};
    const UnitCounters c = run.engine.counters();
    out_.plain_same_side = plain_map_figures(frame, 1);
    out_.plain_equal_bytes =
        plain_map_figures(frame, grow_to_bytes(config_, c.map_bytes + c.allocated_bytes));
    if (options_.equivalent_resolution)
      out_.equivalent_resolution = equivalent_resolution(frame, options_);
  }

  const Trace& trace_;
  const UnitConfig& config_;
  const FrameSetup& setup_;
  const UnitRun& paper_;
  const UnitRun& physical_;
  const JudgeOptions& options_;
  const ExactReference reference_;
  std::vector<std::uint8_t> judged_, in_band_paper_, in_band_physical_;
  Judgement out_;
};

}  // namespace

const char* cause_name(Cause cause) {
  switch (cause) {
    case Cause::kNone:
      return "none";
    case Cause::kQuantisation:
      return "quantisation";
    case Cause::kIdRule:
      return "id_rule";
    case Cause::kDepth:
      return "depth";
    case Cause::kCombination:
      return "combination";
    case Cause::kCancelling:
      return "cancelling";
    case Cause::kHiddenRemoval:
      return "hidden_removal";
    case Cause::kCapacity:
      return "capacity";
    case Cause::kOther:
      return "other";
  }
  return "other";
}

Judgement judge(const Trace& trace, const UnitConfig& config, const FrameSetup& setup,
                const UnitRun& paper, const UnitRun& physical, const JudgeOptions& options) {
  return Judge(trace, config, setup, paper, physical, options).run();
}

}  // namespace kagesen

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
        exact_(options.exact ? options.exact : std::make_shared<ExactFrame>()) {
    if (exact_->reference) return;
    exact_->reference = std::make_unique<ExactReference>(trace.all_casters);
    exact_verdicts();
    band();
  }

  Judgement run() {
    out_.exact_paper = exact_->paper;
    out_.exact_physical = exact_->physical;
    if (config_.profile == Profile::kWinding) {
      winding_causes(Semantics::kPaper, paper_, out_.exact_paper, out_.cause_paper, out_.paper);
      winding_causes(Semantics::kPhysical, physical_, out_.exact_physical, out_.cause_physical,
                     out_.physical);
    } else {
      paper_causes();
    }
    figures(Semantics::kPaper, out_.paper, paper_.verdicts, out_.exact_paper, out_.cause_paper,
            exact_->in_band_paper);
    figures(Semantics::kPhysical, out_.physical, physical_.verdicts, out_.exact_physical,
            out_.cause_physical, exact_->in_band_physical);
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

  const ExactReference& reference() const { return *exact_->reference; }

  void exact_verdicts() {
    const std::size_t count = fragments().size();
    ExactFrame& exact = *exact_;
    exact.paper.resize(count);
    exact.physical.resize(count);
    exact.judged.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
      report("exact verdicts", i);
      const Fragment& f = fragments()[i];
      exact.judged[i] = (f.flags & (Fragment::kAverted | Fragment::kOutside)) == 0 && on_map(f);
      if (!exact.judged[i]) {  // decided by definition
        exact.paper[i] = exact.physical[i] = (f.flags & Fragment::kAverted) != 0;
        continue;
      }
      // What the paper calls dark is dark physically too.
      exact.paper[i] = reference().dark(f, Semantics::kPaper);
      exact.physical[i] = exact.paper[i] || reference().dark(f, Semantics::kPhysical);
    }
  }

  static bool dark(const UnitRun& run, std::size_t i) { return run.verdicts[i] == Verdict::kDark; }

  void paper_causes() {
    const MapContents contents = paper_.engine.contents();
    const CauseFinder finder(trace_, config_, setup_, contents, reference());
    out_.cause_paper.assign(fragments().size(), Cause::kNone);
    out_.cause_physical.assign(fragments().size(), Cause::kNone);
    for (std::size_t i = 0; i < fragments().size(); ++i) {
      report("causes", i);
      if (!exact_->judged[i]) continue;
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
    const WindingCauseFinder finder(trace_, config_, setup_, contents, reference(), semantics);
    causes.assign(fragments().size(), Cause::kNone);
    for (std::size_t i = 0; i < fragments().size(); ++i) {
      report("causes", i);
      if (!exact_->judged[i] || dark(run, i) == (exact[i] != 0)) continue;
      const WindingFault fault = finder.find(fragments()[i], exact[i] != 0);
      causes[i] = fault.cause;
      e.beyond_bound += fault.breaks_contract;
    }
  }

  void band() {
    const double texel = std::ldexp(1.0, static_cast<int>(setup_.fraction_bits));
    exact_->in_band_paper.resize(fragments().size());
    exact_->in_band_physical.resize(fragments().size());
    for (std::size_t i = 0; i < fragments().size(); ++i) {
      report("band", i);
      if (!exact_->judged[i]) continue;
      const Fragment& f = fragments()[i];
      const auto in_band = [&](Semantics semantics) {
        return reference().in_band(f.position, f.object, semantics, texel);
      };
      exact_->in_band_paper[i] = in_band(Semantics::kPaper);
      exact_->in_band_physical[i] = in_band(Semantics::kPhysical);
    }
  }

  void figures(Semantics semantics, ErrorFigures& e, const std::vector<Verdict>& verdicts,
               const std::vector<std::uint8_t>& exact, const std::vector<Cause>& cause,
               const std::vector<std::uint8_t>& in_band) {
    std::vector<std::size_t> wrong;
    for (std::size_t i = 0; i < fragments().size(); ++i) {
      if (!exact_->judged[i]) continue;
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
      if (reference().boundary_distance(f.position, f.object, semantics, bound + 1) <= bound)
        continue;
      e.beyond_bound +=
          reference().contact_distance(f.position, f.object, semantics) > kContactDepthUnits;
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
          reference().boundary_distance(f.position, f.object, semantics, kSearchTexels * texel) /
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

  PlainComparison comparison(Semantics semantics) const {
    const bool paper = semantics == Semantics::kPaper;
    return {trace_,
            config_,
            setup_,
            reference(),
            semantics,
            (paper ? paper_ : physical_).verdicts,
            paper ? out_.exact_paper : out_.exact_physical,
            exact_->judged,
            paper ? exact_->in_band_paper : exact_->in_band_physical};
  }

  void beside_plain_maps() {
    const bool paper = main_semantics(config_) == Semantics::kPaper;
    const PlainComparison frame = comparison(main_semantics(config_));
    const UnitCounters c = (paper ? paper_ : physical_).engine.counters();
    out_.plain_same_side = plain_map_figures(frame, 1);
    out_.plain_equal_bytes =
        plain_map_figures(frame, grow_to_bytes(config_, c.map_bytes + c.allocated_bytes));
    if (options_.equivalent_resolution)
      out_.equivalent_resolution = equivalent_resolution(frame, options_);
    if (options_.other_equivalent_resolution) {
      const Semantics other = paper ? Semantics::kPhysical : Semantics::kPaper;
      out_.other_equivalent_resolution = equivalent_resolution(comparison(other), options_);
    }
  }

  const Trace& trace_;
  const UnitConfig& config_;
  const FrameSetup& setup_;
  const UnitRun& paper_;
  const UnitRun& physical_;
  const JudgeOptions& options_;
  const std::shared_ptr<ExactFrame> exact_;
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

#include "model/reference/judge.h"

#include <algorithm>
#include <cmath>

#include "model/reference/cause.h"
#include "model/rivals/plain_map.h"

namespace kagesen {
namespace {

constexpr double kSearchTexels = 8;  // how far a boundary is looked for
constexpr std::size_t kDisplacementSamples = 2000;
constexpr std::size_t kBandSamples = 50000;  // for the equivalent resolution

/// A surface this close in depth is in contact: snapping alone may turn the verdict.
constexpr double kContactDepthUnits = 4;

class Judge {
 public:
  Judge(const Trace& trace, const UnitConfig& config, const FrameSetup& setup, const Engine& engine,
        const std::vector<Verdict>& verdicts, const JudgeOptions& options)
      : trace_(trace),
        config_(config),
        setup_(setup),
        engine_(engine),
        verdicts_(verdicts),
        options_(options),
        reference_(trace.all_casters) {}

  Judgement run() {
    exact_verdicts();
    causes();
    band();
    figures(Semantics::kPaper, out_.paper, out_.exact_paper, out_.cause_paper, in_band_paper_);
    figures(Semantics::kPhysical, out_.physical, out_.exact_physical, out_.cause_physical,
            in_band_physical_);
    plain_maps();
    if (options_.equivalent_resolution) equivalent_resolution();
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

  void causes() {
    const MapContents contents = engine_.contents();
    const CauseFinder finder(trace_, config_, setup_, contents, reference_);
    out_.cause_paper.assign(fragments().size(), Cause::kNone);
    out_.cause_physical.assign(fragments().size(), Cause::kNone);
    for (std::size_t i = 0; i < fragments().size(); ++i) {
      report("causes", i);
      if (!judged_[i]) continue;
      const bool dark = verdicts_[i] == Verdict::kDark;
      const bool paper_wrong = dark != (out_.exact_paper[i] != 0);
      const bool physical_wrong = dark != (out_.exact_physical[i] != 0);
      if (paper_wrong) out_.cause_paper[i] = finder.find(fragments()[i], out_.exact_paper[i] != 0);
      // Where only the physical verdict is missed, the object shadows itself.
      if (physical_wrong)
        out_.cause_physical[i] = paper_wrong ? out_.cause_paper[i] : Cause::kIdRule;
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

  void figures(Semantics semantics, ErrorFigures& e, const std::vector<std::uint8_t>& exact,
               const std::vector<Cause>& cause, const std::vector<std::uint8_t>& in_band) {
    std::vector<std::size_t> wrong;
    for (std::size_t i = 0; i < fragments().size(); ++i) {
      if (!judged_[i]) continue;
      ++e.judged;
      e.band += in_band[i];
      const bool dark = verdicts_[i] == Verdict::kDark;
      if (dark == (exact[i] != 0)) continue;
      wrong.push_back(i);
      ++(dark ? e.false_dark : e.false_lit);
      e.band_wrong += in_band[i];
      ++e.causes[static_cast<std::size_t>(cause[i])];
    }
    e.wrong = wrong.size();
    displacement(semantics, wrong, e);
    const double bound =
        std::ldexp(1.0, static_cast<int>(setup_.fraction_bits - config_.fraction_bits));
    for (std::size_t n = 0; n < wrong.size(); ++n) {
      const Fragment& f = fragments()[wrong[n]];
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

  void plain_maps() {
    const UnitCounters c = engine_.counters();
    const double texel_bytes = double(config_.depth_bits + config_.id_bits) / 8;
    const double bytes = double(c.map_bytes + c.allocated_bytes);
    const double grow =
        std::sqrt(bytes / (texel_bytes * double(config_.map_width) * double(config_.map_height)));
    plain_map(1, texel_bytes, out_.plain_same_side);
    plain_map(grow, texel_bytes, out_.plain_equal_bytes);
  }

  void plain_map(double grow, double texel_bytes, PlainFigures& p) {
    const auto width =
        static_cast<std::uint32_t>(std::max(1.0, std::floor(double(config_.map_width) * grow)));
    const auto height =
        static_cast<std::uint32_t>(std::max(1.0, std::floor(double(config_.map_height) * grow)));
    PlainMap map(width, height, static_cast<std::uint32_t>(config_.map_width),
                 static_cast<std::uint32_t>(config_.map_height), setup_.fraction_bits);
    for (const Caster& caster : trace_.all_casters) map.draw(caster);
    p.side = width;
    p.bytes = static_cast<std::uint64_t>(texel_bytes * width * height);
    for (std::size_t i = 0; i < fragments().size(); ++i) {
      if (!judged_[i]) continue;
      const bool dark = map.decide(fragments()[i], Semantics::kPaper) == Verdict::kDark;
      if (dark == (out_.exact_paper[i] != 0)) continue;
      ++p.wrong;
      p.band_wrong += in_band_paper_[i];
    }
  }

  void equivalent_resolution() {
    std::vector<std::size_t> band;
    for (std::size_t i = 0; i < fragments().size(); ++i) {
      if (in_band_paper_[i]) band.push_back(i);
    }
    if (band.empty()) {  // any map is as good
      out_.equivalent_resolution = {1, false};
      return;
    }
    const std::size_t stride = (band.size() + kBandSamples - 1) / kBandSamples;
    std::vector<std::size_t> sample;
    std::uint64_t allowed = 0;
    for (std::size_t n = 0; n < band.size(); n += stride) {
      sample.push_back(band[n]);
      allowed += (verdicts_[band[n]] == Verdict::kDark) != (out_.exact_paper[band[n]] != 0);
    }
    const auto good = [&](std::uint64_t side) {
      std::uint64_t wrong = 0;
      for (const std::size_t i : sample) {
        const Verdict v =
            plain_map_verdict(reference_, fragments()[i], Semantics::kPaper, side,
                              static_cast<std::uint32_t>(config_.map_width),
                              static_cast<std::uint32_t>(config_.map_height), setup_.fraction_bits);
        wrong += (v == Verdict::kDark) != (out_.exact_paper[i] != 0);
        if (wrong > allowed) return false;
      }
      return true;
    };
    std::uint64_t high = 1;
    while (high < options_.largest_plain_side && !good(high)) {
      if (options_.progress)
        options_.progress("equivalent resolution",
                          double(high) / double(options_.largest_plain_side));
      high *= 2;
    }
    if (high >= options_.largest_plain_side && !good(high)) {
      out_.equivalent_resolution = {high, true};
      return;
    }
    std::uint64_t low = high / 2;
    for (int i = 0; i < 5 && high - low > 1; ++i) {
      const std::uint64_t middle = low + (high - low) / 2;
      (good(middle) ? high : low) = middle;
    }
    out_.equivalent_resolution = {high, false};
  }

  const Trace& trace_;
  const UnitConfig& config_;
  const FrameSetup& setup_;
  const Engine& engine_;
  const std::vector<Verdict>& verdicts_;
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
                const Engine& engine, const std::vector<Verdict>& verdicts,
                const JudgeOptions& options) {
  return Judge(trace, config, setup, engine, verdicts, options).run();
}

}  // namespace kagesen

#pragma once
/// A unit that answers exactly, but for a flaw that the suite must find.
#include <algorithm>
#include <memory>
#include <optional>
#include <vector>

#include "model/engine.h"
#include "model/reference/reference.h"

namespace kagesen::stress {

enum class Flaw {
  kNone,
  kHalfRadius,     ///< answers for a point half the contract's radius away: allowed
  kThreeRadii,     ///< answers for a point three radii away
  kForgetsLast,    ///< does not draw the caster that comes last
  kSkipLies,       ///< skip_tiles makes the lowest row of texels lit
  kFirstPortion,   ///< decides only the first portion of fragments
  kCellBound,      ///< texels left of the origin are lit at odd depths
  kCountsCasters,  ///< all is dark where an odd number of casters was drawn
};

class FlawedEngine : public Engine {
 public:
  explicit FlawedEngine(Flaw flaw) : flaw_(flaw) {}
  std::string name() const override { return "exact"; }

  void begin(const UnitConfig& config, const FrameSetup& setup) override {
    config_ = config;
    bits_ = setup.fraction_bits;
    casters_.clear();
    reference_.reset();
    decided_ = false;
  }
  void announce(const Fragment*, std::size_t) override {}
  void draw(const Caster* casters, std::size_t count) override {
    casters_.insert(casters_.end(), casters, casters + count);
  }
  void decide(const Fragment* fragments, std::size_t count, Verdict* verdicts) override {
    if (!reference_) {
      if (flaw_ == Flaw::kForgetsLast && !casters_.empty()) casters_.pop_back();
      reference_.emplace(casters_);
    }
    for (std::size_t i = 0; i < count; ++i) {
      verdicts[i] = dark(fragments[i]) ? Verdict::kDark : Verdict::kLit;
    }
    if (flaw_ == Flaw::kFirstPortion && decided_) std::fill_n(verdicts, count, Verdict::kLit);
    decided_ = true;
  }
  MapContents contents() const override { return {}; }
  UnitCounters counters() const override { return {}; }

 private:
  bool dark(const Fragment& f) const {
    if (f.flags & Fragment::kAverted) return true;
    const std::int64_t column = (f.position.x >> bits_) + config_.map_width / 2;
    const std::int64_t row = (f.position.y >> bits_) + config_.map_height / 2;
    if ((f.flags & Fragment::kOutside) || column < 0 || row < 0 || column >= config_.map_width ||
        row >= config_.map_height) {
      return false;
    }
    if (flaw_ == Flaw::kSkipLies && config_.skip_tiles && row == 0) return false;
    if (flaw_ == Flaw::kCellBound && column < config_.map_width / 2 && f.position.z % 2) {
      return false;
    }
    LightPoint p = f.position;
    const std::int32_t radius = 1 << (bits_ - static_cast<std::uint32_t>(config_.fraction_bits));
    if (flaw_ == Flaw::kHalfRadius) p.x -= std::min(radius / 2, p.x - kCoordinateMin);
    if (flaw_ == Flaw::kThreeRadii) p.x -= std::min(3 * radius, p.x - kCoordinateMin);
    if (flaw_ == Flaw::kCountsCasters && casters_.size() % 2) return true;
    const Semantics semantics =
        config_.profile == Profile::kPaper ? Semantics::kPaper : config_.semantics;
    return reference_->dark(p, f.object, semantics);
  }

  const Flaw flaw_;
  UnitConfig config_;
  std::uint32_t bits_ = kMinFractionBits;
  std::vector<Caster> casters_;
  std::optional<ExactReference> reference_;
  bool decided_ = false;
};

}  // namespace kagesen::stress

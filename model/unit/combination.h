#pragma once
/// How the lines of one entry combine, worked out once: many fragments ask the same entry.
#include <cstdint>
#include <vector>

#include "model/unit/shadow_decision.h"

namespace kagesen::unit {

/// The pairs of an entry's lines that are ANDed, as bits. Answers as ShadowDecision::inside does.
class Combination {
 public:
  Combination(const ShadowDecision& decision, std::vector<Line> lines, bool vertex)
      : lines_(std::move(lines)), words_((lines_.size() + 63) / 64) {
    const auto count = static_cast<std::uint32_t>(lines_.size());
    ands_.assign(count * words_, 0);
    for (std::uint32_t i = 0; i < count; ++i) {
      for (std::uint32_t j = 0; j < count; ++j) {
        if (i == j || decision.combine(lines_[i], lines_[j], vertex) == Combine::kOr) continue;
        ands_[i * words_ + j / 64] |= std::uint64_t{1} << (j % 64);
      }
    }
  }

  bool inside(const ShadowDecision& decision, const SubTexel& point) {
    return inside_if([&](std::uint32_t i) { return decision.contains(lines_[i], point); });
  }
  /// The same from given half-plane answers: `holds(i)` for line i.
  template <typename Holds>
  bool inside_if(Holds holds) {
    misses_.assign(words_, 0);
    const auto count = static_cast<std::uint32_t>(lines_.size());
    for (std::uint32_t i = 0; i < count; ++i) {
      if (!holds(i)) misses_[i / 64] |= std::uint64_t{1} << (i % 64);
    }
    for (std::uint32_t i = 0; i < count; ++i) {
      if ((misses_[i / 64] >> (i % 64) & 1) != 0) continue;
      bool all = true;
      for (std::size_t w = 0; w < words_ && all; ++w) {
        all = (ands_[i * words_ + w] & misses_[w]) == 0;
      }
      if (all) return true;
    }
    return false;
  }

  const std::vector<Line>& lines() const { return lines_; }

 private:
  std::vector<Line> lines_;
  std::size_t words_;
  std::vector<std::uint64_t> ands_;  // lines_.size() rows of words_
  std::vector<std::uint64_t> misses_;
};

}  // namespace kagesen::unit

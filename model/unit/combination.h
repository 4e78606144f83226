#pragma once
/// How the lines of one entry combine, worked out once: many fragments ask the same entry.
#include <algorithm>
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

  /// The same as shadow_decision.sv goes about it: one candidate at a time, a line that holds the
  /// point, is held against the lines of its own record, then of the further ones and the first
  /// ones; if some line kills it, the next one is looked for from where it stands.
  /// @param read  called with the number of each record that is read, in turn
  template <typename Read>
  bool walk(const ShadowDecision& decision, const SubTexel& point, std::uint32_t lines_per_record,
            Read read) {
    const auto count = static_cast<std::uint32_t>(lines_.size());
    misses_.assign(words_, 0);
    for (std::uint32_t i = 0; i < count; ++i) {
      if (!decision.contains(lines_[i], point)) misses_[i / 64] |= std::uint64_t{1} << (i % 64);
    }
    const std::uint32_t records = count == 0 ? 1 : (count - 1) / lines_per_record + 1;
    const auto end = [&](std::uint32_t record) {
      return std::min(count, (record + 1) * lines_per_record);
    };
    const auto find = [&](std::uint32_t record, std::uint32_t from) {
      while (from < end(record) && (misses_[from / 64] >> (from % 64) & 1) != 0) ++from;
      return from;
    };
    for (std::uint32_t record = 0, from = 0; record < records;) {
      read(record);
      const std::uint32_t candidate = find(record, from);
      if (candidate < end(record)) {
        std::uint32_t at = record;
        while (!kills(at * lines_per_record, end(at), candidate)) {
          at = at + 1 < records ? at + 1 : 0;
          if (at == record) return true;
          read(at);
        }
        from = find(record, candidate + 1);
        if (from < end(record)) continue;
      }
      from = ++record * lines_per_record;
    }
    return false;
  }

  const std::vector<Line>& lines() const { return lines_; }

 private:
  /// Does one of these lines miss the point and AND with the candidate?
  bool kills(std::uint32_t first, std::uint32_t last, std::uint32_t candidate) const {
    for (std::uint32_t i = first; i < last; ++i) {
      const std::uint64_t both = misses_[i / 64] & ands_[candidate * words_ + i / 64];
      if ((both >> (i % 64) & 1) != 0) return true;
    }
    return false;
  }

  std::vector<Line> lines_;
  std::size_t words_;
  std::vector<std::uint64_t> ands_;  // lines_.size() rows of words_
  std::vector<std::uint64_t> misses_;
};

}  // namespace kagesen::unit

#pragma once
/// Where a block's cycles go, by cause.
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "sim/common/timeline.h"

namespace kagesen::tlm_model {

class CauseMeter {
 public:
  /// @param names  of the causes
  template <std::size_t kNames>
  explicit CauseMeter(const char* const (&names)[kNames]) : names_(names), cycles_(kNames, 0) {}

  /// A frame begins.
  void clear() { cycles_.assign(cycles_.size(), 0); }
  /// @param timeline  takes the cause of every cycle; or null
  void trace(Timeline* timeline, const std::string& track) {
    timeline_ = timeline;
    if (timeline != nullptr) track_ = timeline->track(track, Timeline::Kind::kState);
  }
  /// Of the cycles from `from` to before `to`.
  template <typename Cause>
  void add(Cause cause, Cycle from, Cycle to) {
    const auto which = static_cast<std::size_t>(cause);
    cycles_[which] += to - from;
    if (timeline_ != nullptr) timeline_->state(track_, names_[which], from, to);
  }
  template <typename Cause>
  std::uint64_t of(Cause cause) const {
    return cycles_[static_cast<std::size_t>(cause)];
  }
  std::vector<std::pair<std::string, std::uint64_t>> figures() const {
    std::vector<std::pair<std::string, std::uint64_t>> out;
    for (std::size_t c = 0; c < cycles_.size(); ++c) out.emplace_back(names_[c], cycles_[c]);
    return out;
  }

 private:
  const char* const* names_;
  std::vector<std::uint64_t> cycles_;
  Timeline* timeline_ = nullptr;
  std::uint32_t track_ = 0;
};

}  // namespace kagesen::tlm_model

#pragma once
/// Where the cycles of pass 1 go. Why no visit came, the store cannot know; the front tells it later.
/// Twin: store_cause_o in rtl/common/shadow_unit.sv.
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "model/cycle_causes.h"
#include "sim/systemc/common/cause_meter.h"
#include "sim/systemc/common/front_causes.h"

namespace kagesen::tlm_model {

/// In the order of kStoreCauses.
enum class StoreCause : std::uint8_t {
  kEdge, kSpan, kOther, kInput, kSetup, kWalk, kTexel, kRecord, kChain, kWrite
};

class StoreCauses {
 public:
  /// A frame begins.
  void clear() {
    meter_.clear();
    waits_.clear();
  }
  void begin_pass() { waits_.clear(); }
  void trace(Timeline* timeline) { meter_.trace(timeline, "store"); }

  /// Of so many cycles from `from` on. Calls come in the order of time.
  void add(StoreCause cause, Cycle from, Cycle cycles) {
    if (cycles == 0) return;
    if (cause != StoreCause::kInput) {
      meter_.add(cause, from, from + cycles);
    } else if (!waits_.empty() && waits_.back().to == from) {
      waits_.back().to += cycles;
    } else {
      waits_.push_back({from, from + cycles});
    }
  }
  /// Cycles without a visit that end by then: the front knows why.
  void tell(FrontCauses& front, Cycle until) {
    std::size_t told = 0;
    for (; told < waits_.size() && waits_[told].to <= until; ++told) {
      front.split(waits_[told].from, waits_[told].to, [&](FrontCauses::Why why, Cycle from, Cycle to) {
        meter_.add(why == FrontCauses::kNone    ? StoreCause::kInput
                   : why == FrontCauses::kSetup ? StoreCause::kSetup
                                                : StoreCause::kWalk,
                   from, to);
      });
    }
    waits_.erase(waits_.begin(), waits_.begin() + static_cast<std::ptrdiff_t>(told));
  }
  const CauseMeter& meter() const { return meter_; }

 private:
  struct Run {
    Cycle from, to;
  };
  CauseMeter meter_{kStoreCauses};
  std::vector<Run> waits_;  // cycles without a visit that are not told yet
};

}  // namespace kagesen::tlm_model

#pragma once
/// Why a front has no visit for the store, cycle by cycle: it sets up, or no triangle is offered;
/// else it walks. Twin: setup_o and idle_o of rtl/*/front.sv.
#include <algorithm>
#include <cstdint>
#include <deque>

#include "sim/systemc/common/clock.h"

namespace kagesen::tlm_model {

class FrontCauses {
 public:
  struct Cycles {
    std::uint64_t setup = 0, none = 0, walk = 0;
  };

  void clear() { spans_.clear(); }
  /// In all cycles from `from` to before `to`. Spans come in the order of time, and do not meet.
  void setup(Cycle from, Cycle to) { add(from, to, true); }
  void none(Cycle from, Cycle to) { add(from, to, false); }

  /// Of the cycles from `from` to before `to`, which are known. Calls come in the order of time.
  Cycles of(Cycle from, Cycle to) {
    Cycles result;
    while (!spans_.empty() && spans_.front().to <= from) spans_.pop_front();
    for (const Span& span : spans_) {
      if (span.from >= to) break;
      const Cycle cycles = std::min(to, span.to) - std::max(from, span.from);
      (span.setup ? result.setup : result.none) += cycles;
    }
    result.walk = to - from - result.setup - result.none;
    return result;
  }

 private:
  struct Span {
    Cycle from, to;
    bool setup;
  };
  void add(Cycle from, Cycle to, bool setup) {
    if (from < to) spans_.push_back({from, to, setup});
  }
  std::deque<Span> spans_;
};

}  // namespace kagesen::tlm_model

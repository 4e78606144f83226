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
  enum Why : std::uint8_t { kSetup, kNone, kWalk };
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
    split(from, to, [&](Why why, Cycle begin, Cycle end) {
      (why == kSetup ? result.setup : why == kNone ? result.none : result.walk) += end - begin;
    });
    return result;
  }
  /// The same piece by piece. @param tell  (why, first cycle, the one after the last)
  template <typename Tell>
  void split(Cycle from, Cycle to, Tell tell) {
    while (!spans_.empty() && spans_.front().to <= from) spans_.pop_front();
    for (const Span& span : spans_) {
      if (span.from >= to) break;
      if (from < span.from) tell(kWalk, from, span.from);
      const Cycle begin = std::max(from, span.from), end = std::min(to, span.to);
      tell(span.setup ? kSetup : kNone, begin, end);
      from = end;
    }
    if (from < to) tell(kWalk, from, to);
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

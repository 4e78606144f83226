#pragma once
/// When the items of a stream are offered to the unit. Twin: testbench/verilator/bench_streams.h.
#include "sim/memory/timing.h"
#include "sim/systemc/common/clock.h"

namespace kagesen::tlm_model {

/// At the earliest in the cycle after the one before was taken; the first is there in a pass's
/// first cycle, unless it is held back before that.
class Offers {
 public:
  Offers(const Timing& timing, PassNumber number, Channel channel)
      : stalls_(timing.stream_stall, Chance(timing.seed, number, channel, 0)) {}
  Cycle next() const {
    const Cycle at = stalls_.next(free_);
    return at == kNever ? 0 : at;
  }
  /// Taken in this cycle, which it returns.
  Cycle take(Cycle at) {
    free_ = at + 1;
    return at;
  }

 private:
  Stalls stalls_;
  Cycle free_ = kNever;
};

}  // namespace kagesen::tlm_model

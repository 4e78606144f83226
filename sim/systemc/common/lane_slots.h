#pragma once
/// Slots of the fragments that a lane has in flight: given out in a circle, decided in any order,
/// retired in the order in which they were given out.
/// Twin: rtl/common/lane_slots.sv.
///
/// Timing: a slot whose verdict is decided in cycle n can be fetched from n + 1 on, one a cycle and
///         only once the verdict before has been taken; it is free, and its verdict offered, in the
///         cycle after.
#include <cstdint>
#include <systemc>
#include <vector>

#include "sim/systemc/common/clock.h"
#include "sim/systemc/common/queue_meter.h"

namespace kagesen::tlm_model {

class LaneSlots : public sc_core::sc_module {
 public:
  QueueMeter meter;  ///< fragments in flight

  explicit LaneSlots(const sc_core::sc_module_name& name) : sc_module(name) {}

  /// @param slots     a power of two
  /// @param refusals  cycles in which nobody takes a verdict
  void begin_pass(std::uint32_t slots, const Stalls& refusals) {
    mask_ = slots - 1;
    done_.assign(slots, kNever);
    taken_in_.resize(slots);
    meter.begin_pass();
    refusals_ = refusals;
    retired_ = 0;
    taken_ = 0;
  }
  std::uint32_t count() const { return mask_ + 1; }
  std::uint32_t slot_of(std::uint64_t fragment) const {
    return static_cast<std::uint32_t>(fragment) & mask_;
  }

  /// A fragment is taken in this cycle.
  void open(std::uint32_t slot, Cycle at) {
    done_[slot] = kNever;
    taken_in_[slot] = at;
  }
  /// The verdict is decided in this cycle.
  void decide(std::uint32_t slot, Cycle at) { done_[slot] = at + 1; }
  bool decided(std::uint32_t slot) const { return done_[slot] != kNever; }
  /// The first cycle in which the slot is known to be decided.
  Cycle done(std::uint32_t slot) const { return done_[slot]; }

  std::uint64_t retired() const { return retired_; }  ///< fragments
  /// Retires the oldest fragment, which is decided. Returns the cycle in which its slot is fetched;
  /// last_taken() is then the one in which its verdict is taken.
  Cycle retire() {
    const std::uint32_t slot = slot_of(retired_++);
    const Cycle fetched = done_[slot] > taken_ ? done_[slot] : taken_;
    taken_ = refusals_.next(fetched + 1);
    meter.word(taken_in_[slot], taken_);
    return fetched;
  }
  Cycle last_taken() const { return taken_; }

 private:
  std::uint32_t mask_ = 0;
  std::vector<Cycle> done_, taken_in_;  // a slot each
  Stalls refusals_;
  std::uint64_t retired_ = 0;
  Cycle taken_ = 0;  // when the last verdict was
};

}  // namespace kagesen::tlm_model

#pragma once
/// When a record is decided on. What comes out of it is golden's to say.
/// Twin: rtl/winding/shadow_decision.sv, with the queue of responses ahead of it (list_reader.sv).
///
/// Timing: a record is taken up two cycles after its response, in the order of the responses. It stays
///         a cycle for each of its segments whose box holds the fragment, one at least; it is answered
///         three cycles after its last one.
#include <algorithm>
#include <cstdint>
#include <systemc>

#include "sim/systemc/common/clock.h"

namespace kagesen::tlm_model::winding {

class ShadowDecision : public sc_core::sc_module {
 public:
  explicit ShadowDecision(const sc_core::sc_module_name& name) : sc_module(name) {}

  void begin_pass() { free_ = 0; }
  /// The cycle of a record's answer.
  Cycle answer(Cycle responded, std::uint32_t boxed) {
    taken_up_ = std::max(responded + 2, free_);
    free_ = taken_up_ + std::max(boxed, 1u);
    return free_ + 3;
  }
  /// When the last one was taken up.
  Cycle taken_up() const { return taken_up_; }

 private:
  Cycle taken_up_ = 0;
  Cycle free_ = 0;  // for the next record
};

}  // namespace kagesen::tlm_model::winding

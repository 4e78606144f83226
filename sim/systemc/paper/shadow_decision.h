#pragma once
/// When a record is decided on. What comes out of it is golden's to say.
/// Twin: rtl/paper/shadow_decision.sv.
///
/// Timing: a record that comes in cycle n enters in n + 1 and is through in n + 3; always taken.
#include <systemc>

#include "sim/systemc/common/clock.h"

namespace kagesen::tlm_model::paper {

class ShadowDecision : public sc_core::sc_module {
 public:
  static constexpr Cycle kCycles = 3;

  explicit ShadowDecision(const sc_core::sc_module_name& name) : sc_module(name) {}
  Cycle decided(Cycle responded) const { return responded + kCycles; }
};

}  // namespace kagesen::tlm_model::paper

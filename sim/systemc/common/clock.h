#pragma once
/// Time in the model: clock cycles from the first one of a pass, 64 bits. At a socket a cycle is a
/// period of kernel time.
#include <systemc>

#include "sim/memory/timing.h"

namespace kagesen::tlm_model {

inline constexpr Cycle kNever = ~Cycle{0};

/// Of the clock. Its length means nothing to the model: 1 ns, so that traces of it read well.
inline sc_core::sc_time period() {
  static const sc_core::sc_time period(1, sc_core::SC_NS);
  return period;
}
inline sc_core::sc_time time_of(Cycle cycles) {
  return sc_core::sc_time::from_value(cycles * period().value());
}
/// Whole cycles, rounded up: what comes between two edges is seen at the second.
inline Cycle cycles_of(const sc_core::sc_time& time) {
  return (time.value() + period().value() - 1) / period().value();
}

}  // namespace kagesen::tlm_model

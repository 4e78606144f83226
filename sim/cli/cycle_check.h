#pragma once
/// The SystemC model against the Verilated unit: the cycles of every fragment, then the totals.
#include <cstdint>
#include <string>
#include <vector>

#include "sim/systemc/engine.h"
#include "testbench/verilator/lock_step.h"

namespace kagesen {

struct CycleCheck {
  std::uint64_t verdict_differences = 0;  ///< of SystemC from golden
  /// Fragments whose cycles differ, and figures of passes: totals and causes.
  std::uint64_t cycle_differences = 0;
  std::uint64_t first_fragment = 0;
  std::vector<std::string> first;  ///< the first of them, for people
};

/// Runs the frame on the model and compares with what the Verilated unit just did.
/// @pre both engines keep cycles and have the same timing; `rtl` has run the whole frame
CycleCheck check_cycles(const Frame& frame, const Expected& expected, const RtlEngine& rtl,
                        SystemcEngine& model);

}  // namespace kagesen

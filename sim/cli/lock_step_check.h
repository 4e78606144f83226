#pragma once
/// The stress suite's cases through the Verilog: everything that a build leaves open is drawn.
#include "model/unit/config.h"
#include "testbench/verilator/lock_step.h"
#include "tests/stress/case.h"
#include "tests/stress/dice.h"

namespace kagesen {

/// Keys that are widths: they stay, so that all cases share one build.
const std::vector<std::string>& width_keys();
/// Draws policies and capacities; widths, map and profile stay.
void draw_registers(stress::Dice& dice, UnitConfig& config);
/// Memories and streams: half of them as they come, the others at random.
Timing draw_timing(stress::Dice& dice);

/// The check that Verilog and golden agree, in a suite's terms.
const stress::Check& lock_step_check();
/// Replaces a case's checks by that one, once for each setting and with drawn registers.
void plan_lock_step(stress::StressCase& test);

}  // namespace kagesen

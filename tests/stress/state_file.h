#pragma once
/// The suite's state as JSON: what a run that was stopped goes on from, and what --json prints.
#include <nlohmann/json.hpp>
#include <string>

#include "tests/stress/suite.h"

namespace kagesen::stress {

nlohmann::ordered_json state_json(const State& state);
/// Throws UserError naming the file if it cannot be read or is no state.
State read_state(const std::string& path);
/// Replaces the file in one step. Throws UserError when the disk refuses.
void write_state(const State& state, const std::string& path);

}  // namespace kagesen::stress

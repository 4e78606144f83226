#pragma once
/// The page's part about the winding profile, and about the stress suite.
#include <optional>
#include <string>
#include <vector>

#include "sim/cli/results/gather.h"

namespace kagesen {

/// All that follows under one heading.
std::string winding_section(const std::vector<SceneResults>& results);

std::string memory_section(const std::vector<SceneResults>& results);
std::string skips_section(const std::vector<SceneResults>& results);
/// Table 3 of Mizokuchi and Tokuyoshi (IIEEJ 2018) on the built-in scenes.
std::string first_test_section(const std::vector<SceneResults>& results);

/// Totals of the file that `kagesen stress --json` wrote; empty where there is none. Throws
/// UserError for another file.
std::string stress_section(const std::string& path);

}  // namespace kagesen

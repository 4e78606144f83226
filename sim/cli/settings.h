#pragma once
/// The unit's configuration from a TOML file and --set options.
#include <CLI/CLI.hpp>
#include <set>
#include <string>
#include <vector>

#include "model/unit/config.h"

namespace kagesen {

struct SettingsOptions {
  std::string file;
  std::vector<std::string> sets;  ///< "key=value", applied after the file, in order
};
void add_settings_options(CLI::App& command, SettingsOptions& options);

struct Settings {
  UnitConfig config;
  std::set<std::string> given;  ///< keys that the person set
};
/// Throws UserError naming the file and line, or the option, and the nearest valid key or value.
Settings load_settings(const SettingsOptions& options);

/// The whole configuration as TOML, each key below a comment that explains it.
std::string settings_toml(const UnitConfig& config);

}  // namespace kagesen

#include <iostream>
#include <memory>

#include "sim/cli/commands.h"
#include "sim/cli/settings.h"

namespace kagesen {

void add_config(CLI::App& app) {
  auto options = std::make_shared<SettingsOptions>();
  CLI::App& command =
      *app.add_subcommand("config", "Prints the unit's configuration as TOML, every key explained");
  add_settings_options(command, *options);
  command.callback([options] { std::cout << settings_toml(load_settings(*options).config); });
}

}  // namespace kagesen

#include <iostream>
#include <memory>

#include "sim/cli/commands.h"
#include "sim/cli/settings.h"
#include "sim/report/outputs.h"
#include "testbench/verilator/package.h"

namespace kagesen {
namespace {

struct RtlOptions {
  SettingsOptions settings;
  std::string folder;
};

void write_rtl(const RtlOptions& options) {
  const UnitConfig config = load_settings(options.settings).config;
  Outputs outputs;
  outputs.make_folder(options.folder);
  std::string list = "shadow_pkg.sv\n";
  const auto write = [&](const std::string& name, const std::string& text) {
    outputs.write(options.folder + "/" + name, text, "--out");
  };
  write("shadow_pkg.sv", shadow_package(config));
  for (const SourceText& source : rtl_sources(config.profile)) {
    const std::string name = source.path.substr(source.path.rfind('/') + 1);
    write(name, source.text);
    // Included files are found beside the ones that include them.
    if (name.size() > 3 && name.compare(name.size() - 3, 3, ".sv") == 0) list += name + "\n";
  }
  write("files.f", list);
  outputs.commit();
  for (const std::string& name : outputs.names()) std::cout << name << "\n";
}

}  // namespace

void add_rtl(CLI::App& app) {
  auto options = std::make_shared<RtlOptions>();
  CLI::App& command = *app.add_subcommand(
      "rtl",
      "Writes the unit's Verilog for a configuration: its package, its modules, a file list");
  add_settings_options(command, options->settings);
  command.add_option("--out", options->folder, "Folder for the files; files.f lists them in order")
      ->type_name("DIR")
      ->required();
  command.callback([options] { write_rtl(*options); });
}

}  // namespace kagesen

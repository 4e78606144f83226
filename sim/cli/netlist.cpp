/// kagesen netlist: the mapped netlist of a block against the recorded pins of its test.
#include "testbench/mutation/netlist.h"

#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <memory>

#include "sim/cli/commands.h"
#include "sim/cli/nearest.h"
#include "sim/cli/parse.h"
#include "sim/cli/progress.h"
#include "sim/cli/settings.h"
#include "traces/format/error.h"

namespace kagesen {
namespace {

struct NetlistArguments {
  std::vector<std::string> blocks;
  std::string library = "osu018", beats = "3000";
  SettingsOptions settings;
};

void run(const NetlistArguments& arguments) {
  std::vector<std::string> all;
  for (const MutationBlock& block : mutation_blocks()) all.push_back(block.name);
  const auto beats = static_cast<std::size_t>(parse_number("--beats", arguments.beats, 1, 1e9));
  std::size_t wrong = 0;
  Progress progress(true);
  const UnitConfig config = load_settings(arguments.settings).config;
  const auto tell = [&](const std::string& stage) { progress.update(stage, 0); };
  for (const std::string& name : arguments.blocks.empty() ? all : arguments.blocks) {
    const auto found = std::find(all.begin(), all.end(), name);
    if (found == all.end() && name != "unit") {
      throw UserError("netlist", "there is no block '" + name + "'",
                      suggestion(name, all) + ", or unit");
    }
    const NetlistRun run = name == "unit"
                               ? run_unit_netlist(config, arguments.library, beats, tell)
                               : run_netlist(mutation_blocks()[std::size_t(found - all.begin())],
                                             arguments.library, beats, tell);
    progress.clear();
    wrong += run.wrong;
    std::cout << fmt::format("{:<26}{:>9} cycles{:>9} wrong\n", name, run.beats, run.wrong)
              << std::flush;
    if (run.wrong > 0) std::cout << "  see " << run.log << "\n";
  }
  if (wrong > 0) throw CLI::RuntimeError(1);
}

}  // namespace

void add_netlist(CLI::App& app) {
  auto arguments = std::make_shared<NetlistArguments>();
  CLI::App& command = *app.add_subcommand(
      "netlist",
      "Runs the mapped netlists of blocks, four-valued, against recordings of their tests");
  command.add_option("BLOCK", arguments->blocks,
                     "Blocks, or unit: the whole one, as configured; all blocks if none is named");
  add_settings_options(command, arguments->settings);
  command.add_option("--library", arguments->library, "Cell library: osu018 or osu035")
      ->type_name("NAME")
      ->capture_default_str();
  command.add_option("--beats", arguments->beats, "Clock cycles of each, at most")
      ->type_name("N")
      ->capture_default_str();
  command.footer("Exit status 1 if an output differs, or is unknown where it has to be known.");
  command.callback([arguments] { run(*arguments); });
}

}  // namespace kagesen

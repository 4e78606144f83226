/// kagesen gates: what the unit costs in gates, memory bits and time.
#include "testbench/synthesis/gates.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iostream>
#include <memory>

#include "sim/cli/commands.h"
#include "sim/cli/progress.h"
#include "sim/cli/settings.h"
#include "sim/report/outputs.h"
#include "testbench/synthesis/gates_text.h"

namespace kagesen {
namespace {

struct GatesArguments {
  SettingsOptions settings;
  GateOptions gates;
  std::string json, page;
  bool sweep = false;
  std::vector<std::string> keys;  ///< of the sweep; empty: all
  std::size_t paths = 0;
};

/// What --sweep varies: one key at a time, all others as configured.
struct Sweep {
  const char* key;
  std::vector<const char*> values;
};
const std::vector<Sweep>& sweeps(Profile profile) {
  static const std::vector<Sweep> paper{{"fraction_bits", {"4", "6", "8", "10", "12"}},
                                        {"slope_bits", {"4", "6", "8", "10", "12"}},
                                        {"depth_bits", {"16", "20", "24"}},
                                        {"id_bits", {"8", "16", "24"}},
                                        {"polygon_id_bits", {"8", "14", "20"}},
                                        {"position_bits", {"8", "12", "16", "0"}},
                                        {"lines_per_entry", {"1", "2", "3", "4"}},
                                        {"lanes", {"1", "2", "4"}},
                                        {"fragment_slots", {"16", "32", "64"}},
                                        {"visit_fifo_depth", {"16", "32", "64"}},
                                        {"texel_lines", {"16", "64", "256"}},
                                        {"record_lines", {"16", "64", "256"}}};
  static const std::vector<Sweep> winding{{"fraction_bits", {"4", "6", "8"}},
                                          {"end_guard_bits", {"2", "3", "4"}},
                                          {"gradient_bits", {"7", "8", "10"}},
                                          {"plane_step_bits", {"2", "4", "6"}},
                                          {"corner_bits", {"4", "8"}},
                                          {"segments_per_record", {"1", "2", "3"}},
                                          {"semantics", {"physical", "paper"}},
                                          {"id_bits", {"8", "16", "24"}},
                                          {"lanes", {"1", "2", "4"}},
                                          {"fragment_slots", {"16", "32", "64"}},
                                          {"visit_fifo_depth", {"16", "32", "64"}},
                                          {"texel_lines", {"16", "64", "256"}},
                                          {"record_lines", {"16", "64", "256"}}};
  return profile == Profile::kPaper ? paper : winding;
}

bool is_key(const std::string& key) {
  const auto& fields = config_fields();
  return std::any_of(fields.begin(), fields.end(),
                     [&](const ConfigField& f) { return f.key == key; });
}

std::vector<SweepRow> sweep(const UnitConfig& config, const GateOptions& options,
                            const std::vector<std::string>& keys, Progress& progress) {
  std::vector<SweepRow> rows;
  for (const Sweep& sweep : sweeps(config.profile)) {
    const bool asked = std::find(keys.begin(), keys.end(), sweep.key) != keys.end();
    if (!is_key(sweep.key) || (!keys.empty() && !asked)) continue;
    for (const char* value : sweep.values) {
      SweepRow row{sweep.key, value, get_field(config, sweep.key) == value, {}};
      UnitConfig varied = config;
      set_field(varied, sweep.key, value);
      check_fields(varied);
      row.report = measure_gates(varied, options, [&](const std::string& stage) {
        progress.update(fmt::format("{} = {}: {}", sweep.key, value, stage), 0);
      });
      rows.push_back(row);
    }
  }
  return rows;
}

void write_json(const std::string& path, const nlohmann::ordered_json& json) {
  const std::string text = json.dump(2) + "\n";
  if (path == "-") {
    std::cout << text;
    return;
  }
  Outputs outputs;
  outputs.write(path, text, "--json");
  outputs.commit();
}

/// Both profiles, whatever the configuration says of that.
void write_page(const GatesArguments& arguments, UnitConfig config, Progress& progress) {
  GatesPage page;
  std::string command = "kagesen gates --page " + arguments.page;
  GateOptions other = arguments.gates;
  other.library = other.library == "osu018" ? "osu035" : "osu018";
  for (const char* profile : {"paper", "winding"}) {
    set_field(config, "profile", profile);
    const auto tell = [&](const std::string& stage) {
      progress.update(std::string(profile) + ": " + stage, 0);
    };
    page.profiles.push_back(measure_gates(config, arguments.gates, tell));
    page.other_library.push_back(measure_gates(config, other, tell));
    if (!arguments.sweep) continue;
    for (const SweepRow& row : sweep(config, arguments.gates, arguments.keys, progress)) {
      page.sweep.push_back(row);
    }
  }
  if (arguments.sweep) command += " --sweep";
  if (!arguments.keys.empty()) command += fmt::format(" --keys {}", fmt::join(arguments.keys, ","));
  progress.clear();
  Outputs outputs;
  outputs.write(arguments.page, gates_page(page, command), "--page");
  outputs.commit();
  std::cout << arguments.page << "\n";
  for (const GateReport& report : page.profiles) {
    if (!report.unmapped.empty()) throw CLI::RuntimeError(1);
  }
}

void run_gates(const GatesArguments& arguments) {
  const UnitConfig config = load_settings(arguments.settings).config;
  Progress progress(true);
  if (!arguments.page.empty()) {
    write_page(arguments, config, progress);
    return;
  }
  if (arguments.sweep) {
    const std::vector<SweepRow> rows = sweep(config, arguments.gates, arguments.keys, progress);
    progress.clear();
    if (arguments.json != "-") std::cout << sweep_table(rows);
    if (!arguments.json.empty()) write_json(arguments.json, sweep_json(rows));
    return;
  }
  const GateReport report = measure_gates(
      config, arguments.gates, [&](const std::string& stage) { progress.update(stage, 0); });
  progress.clear();
  if (arguments.json != "-") {
    std::cout << gates_table(report);
    if (arguments.paths > 0) std::cout << paths_table(report, arguments.paths);
  }
  if (!arguments.json.empty()) write_json(arguments.json, gates_json(report));
  if (!report.unmapped.empty()) throw CLI::RuntimeError(1);
}

}  // namespace

void add_gates(CLI::App& app) {
  auto arguments = std::make_shared<GatesArguments>();
  CLI::App& command =
      *app.add_subcommand("gates", "Synthesises the unit: gate equivalents, memory bits, MHz");
  add_settings_options(command, arguments->settings);
  GateOptions& gates = arguments->gates;
  command.add_option("--top", gates.top, "Module to measure")
      ->type_name("NAME")
      ->capture_default_str();
  command.add_option("--library", gates.library, "Cell library: osu018 or osu035")
      ->type_name("NAME")
      ->capture_default_str();
  command
      .add_option("--json", arguments->json, "Writes the figures as JSON; - for standard output")
      ->type_name("FILE");
  command.add_option("--paths", arguments->paths, "Prints the N longest paths, one to each register")
      ->type_name("N");
  command.add_flag("--sweep", arguments->sweep, "What each parameter costs, one varied at a time");
  command.add_option("--keys", arguments->keys, "Of --sweep: only these")
      ->type_name("KEY,...")
      ->delimiter(',');
  command.add_option("--page", arguments->page, "Writes both profiles' tables, docs/gates.md")
      ->type_name("FILE");
  command.add_flag("--flatten", gates.flatten,
                   "Dissolves the blocks first: smaller, but no figure per block");
  command.add_option("--abc", gates.abc, "Another script for ABC")
      ->type_name("FILE")
      ->group("Flow");
  command
      .add_option("--package-set", gates.package_sets,
                  "Sets a constant of the package that no key sets")
      ->type_name("NAME=VALUE")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
      ->group("Flow");
  command.footer(
      "Exit status 1 if a cell stayed unmapped or a latch was inferred. Results are kept in\n"
      "$KAGESEN_CACHE, or in the build folder; a sweep that was stopped goes on from there.");
  command.callback([arguments] { run_gates(*arguments); });
}

}  // namespace kagesen

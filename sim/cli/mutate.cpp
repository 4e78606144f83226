/// kagesen mutate: faults put into the RTL, and whether the tests' stimulus finds them.
#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "sim/cli/commands.h"
#include "sim/cli/nearest.h"
#include "sim/cli/parse.h"
#include "sim/cli/progress.h"
#include "sim/report/outputs.h"
#include "testbench/mutation/mutation.h"
#include "traces/format/error.h"

namespace kagesen {
namespace {

struct MutateArguments {
  std::vector<std::string> blocks;
  std::string count, json, page, seconds = "30";
};

std::vector<MutationBlock> chosen(const std::vector<std::string>& names) {
  if (names.empty()) return mutation_blocks();
  std::vector<std::string> all;
  for (const MutationBlock& block : mutation_blocks()) all.push_back(block.name);
  std::vector<MutationBlock> blocks;
  for (const std::string& name : names) {
    const auto found = std::find(all.begin(), all.end(), name);
    if (found == all.end()) {
      throw UserError("--block", "there is no '" + name + "'", suggestion(name, all));
    }
    blocks.push_back(mutation_blocks()[static_cast<std::size_t>(found - all.begin())]);
  }
  return blocks;
}

nlohmann::ordered_json json_of(const std::vector<MutationResult>& results) {
  nlohmann::ordered_json json;
  std::size_t all = 0, killed = 0, equivalent = 0;
  json["blocks"] = nlohmann::ordered_json::array();
  for (const MutationResult& result : results) {
    nlohmann::ordered_json block{{"name", result.block},
                                 {"mutants", result.mutants.size()},
                                 {"killed", result.killed()},
                                 {"equivalent", result.equivalent()},
                                 {"survivors", result.survivors()},
                                 {"beats", result.beats},
                                 {"replay_differs", result.unlike}};
    block["alive"] = nlohmann::ordered_json::array();
    for (const Mutant& mutant : result.mutants) {
      if (mutant.killed_at >= 0 || mutant.equivalent) continue;
      block["alive"].push_back(
          {{"number", mutant.number}, {"what", mutant.what}, {"place", mutant.place}});
    }
    json["blocks"].push_back(block);
    all += result.mutants.size();
    killed += result.killed();
    equivalent += result.equivalent();
  }
  json["mutants"] = all;
  json["killed"] = killed;
  json["equivalent"] = equivalent;
  json["survivors"] = all - killed - equivalent;
  return json;
}

void run_mutate(const MutateArguments& arguments) {
  const double limit_s = parse_number("--seconds", arguments.seconds, 1, 1e6);
  std::vector<MutationResult> results;
  Progress progress(true);
  const std::vector<MutationBlock> blocks = chosen(arguments.blocks);
  for (const MutationBlock& block : blocks) {
    const unsigned count =
        arguments.count.empty()
            ? block.mutants
            : static_cast<unsigned>(parse_number("--count", arguments.count, 1, 60000));
    results.push_back(mutate(block, count, limit_s, [&](const std::string& stage) {
      progress.update(stage, double(results.size()) / double(blocks.size()));
    }));
    progress.clear();
    const MutationResult& result = results.back();
    if (arguments.json != "-") {
      std::cout << fmt::format(
                       "{:<26}{:>5} mutants{:>6} killed{:>5} proven equivalent{:>5} survive\n",
                       result.block, result.mutants.size(), result.killed(), result.equivalent(),
                       result.survivors())
                << std::flush;
    }
  }
  const nlohmann::ordered_json json = json_of(results);
  if (arguments.json == "-") std::cout << json.dump(2) << "\n";
  Outputs outputs;
  if (!arguments.json.empty() && arguments.json != "-") {
    outputs.write(arguments.json, json.dump(2) + "\n", "--json");
  }
  if (!arguments.page.empty()) {
    outputs.write(arguments.page, mutation_page(results, "kagesen mutate --page " + arguments.page),
                  "--page");
  }
  outputs.commit();
  if (json["survivors"] != 0) throw CLI::RuntimeError(1);
}

}  // namespace

void add_mutate(CLI::App& app) {
  auto arguments = std::make_shared<MutateArguments>();
  CLI::App& command = *app.add_subcommand(
      "mutate", "Puts faults into the RTL: does its tests' stimulus find them?");
  command.add_option("--block", arguments->blocks, "Only this block; may be repeated")
      ->type_name("NAME")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  command
      .add_option("--count", arguments->count,
                  "Mutants of each block; a number of its own if not given")
      ->type_name("N");
  command
      .add_option("--seconds", arguments->seconds,
                  "Limit of the proof that a survivor is equivalent")
      ->type_name("N")
      ->capture_default_str();
  command.add_option("--page", arguments->page, "Writes the table, docs/mutation.md")
      ->type_name("FILE");
  command.add_option("--json", arguments->json, "Writes the figures; - for standard output")
      ->type_name("FILE");
  command.footer(
      "Builds the tests with recorders in a folder of the cache (the first time takes minutes).\n"
      "Blocks whose RTL and stimulus have not changed since are not run again.\n"
      "Exit status 1 if a mutant survives.");
  command.callback([arguments] { run_mutate(*arguments); });
}

}  // namespace kagesen

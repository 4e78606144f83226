/// kagesen prove: unbounded proofs of the RTL's small blocks, and that each can fail.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "sim/cli/commands.h"
#include "sim/cli/nearest.h"
#include "sim/cli/parse.h"
#include "sim/cli/progress.h"
#include "sim/report/outputs.h"
#include "testbench/formal/proofs.h"
#include "traces/format/error.h"

namespace kagesen {
namespace {

struct ProveArguments {
  std::vector<std::string> names;
  std::string json, page, seconds = "120";
  bool list = false;
};

std::vector<Proof> chosen(const std::vector<std::string>& names) {
  std::vector<Proof> proofs = find_proofs();
  if (names.empty()) return proofs;
  std::vector<std::string> all;
  for (const Proof& proof : proofs) all.push_back(proof.name);
  for (const std::string& name : names) {
    if (std::find(all.begin(), all.end(), name) == all.end()) {
      throw UserError("prove", "there is no proof '" + name + "'", suggestion(name, all));
    }
  }
  proofs.erase(std::remove_if(proofs.begin(), proofs.end(),
                              [&](const Proof& proof) {
                                return std::find(names.begin(), names.end(), proof.name) ==
                                       names.end();
                              }),
               proofs.end());
  return proofs;
}

/// The page's part of a proof.
std::string section(const Proof& proof, const nlohmann::ordered_json& outcome) {
  std::string widths;
  for (const std::vector<std::string>& package : proof.packages) {
    std::vector<std::string> all = proof.parameters;
    all.insert(all.end(), package.begin(), package.end());
    if (!all.empty())
      widths += fmt::format("{}`{}`", widths.empty() ? "" : "; ", fmt::join(all, " "));
  }
  return fmt::format("## {}\n\n{}\n\n{}: {}, {} of {} broken copies refuted.{}\n\n", proof.name,
                     proof.statement,
                     proof.pipeline ? fmt::format("All runs of {} cycles", proof.pipeline + 1)
                                    : "Runs of any length",
                     outcome["outcome"].get<std::string>(), outcome["refuted"].get<std::size_t>(),
                     outcome["broken"].get<std::size_t>(),
                     widths.empty() ? "" : fmt::format(" Widths: {}.", widths));
}

const char* word(Outcome outcome) {
  return outcome == Outcome::kProved    ? "proved"
         : outcome == Outcome::kRefuted ? "REFUTED"
                                        : "UNDECIDED";
}

void run_prove(const ProveArguments& arguments) {
  const std::vector<Proof> proofs = chosen(arguments.names);
  if (arguments.list) {
    for (const Proof& proof : proofs) std::cout << proof.name << "\n";
    return;
  }
  const double limit_s = parse_number("--seconds", arguments.seconds, 1, 1e6);
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  std::string page =
      "# Proofs\n\nWritten by `kagesen prove --page docs/proofs.md`. "
      "`testbench/formal/NAME_proof.sv` "
      "holds the properties\nof a block and what its neighbours keep; Yosys makes a graph of both, "
      "and ABC's `pdr` proves or refutes\n"
      "it from reset on, `bmc3` where a run has an end. Each proof has to refute copies of the RTL "
      "with a fault in\nthem.\n\n";
  Progress progress(true);
  bool good = true;
  for (const Proof& proof : proofs) {
    progress.update("proving " + proof.name, double(json.size()) / double(proofs.size()));
    const Verdict verdict = run_proof(proof, nullptr, limit_s);
    good = good && verdict.outcome == Outcome::kProved;
    std::size_t refuted = 0;
    std::string left;
    for (const BrokenCopy& broken : proof.broken) {
      if (run_proof(proof, &broken, limit_s).outcome == Outcome::kRefuted)
        ++refuted;
      else
        left += fmt::format("  broken copy not refuted: {}: `{}`\n", broken.file, broken.new_text);
    }
    good = good && refuted == proof.broken.size() && refuted > 0;
    progress.clear();
    if (arguments.json != "-") {
      std::cout << fmt::format("{:<24} {:<10} {:7.1f} s   broken copies refuted: {} of {}\n{}",
                               proof.name, word(verdict.outcome), verdict.seconds, refuted,
                               proof.broken.size(), left)
                << std::flush;
      if (verdict.outcome != Outcome::kProved) std::cout << "  see " << verdict.log << "\n";
    }
    json.push_back({{"name", proof.name},
                    {"profile", proof.profile},
                    {"outcome", word(verdict.outcome)},
                    {"seconds", verdict.seconds},
                    {"broken", proof.broken.size()},
                    {"refuted", refuted}});
    page += section(proof, json.back());
  }
  Outputs outputs;
  if (arguments.json == "-") {
    std::cout << json.dump(2) << "\n";
  } else if (!arguments.json.empty()) {
    outputs.write(arguments.json, json.dump(2) + "\n", "--json");
  }
  if (!arguments.page.empty())
    outputs.write(arguments.page, page.substr(0, page.size() - 1), "--page");
  outputs.commit();
  if (!good) throw CLI::RuntimeError(1);
}

}  // namespace

void add_prove(CLI::App& app) {
  auto arguments = std::make_shared<ProveArguments>();
  CLI::App& command =
      *app.add_subcommand("prove", "Proves the RTL's small blocks for runs of any length");
  command.add_option("NAME", arguments->names, "Proofs to run; all if none is named");
  command.add_flag("--list", arguments->list, "Only prints the names");
  command.add_option("--seconds", arguments->seconds, "Limit of each search")
      ->type_name("N")
      ->capture_default_str();
  command.add_option("--json", arguments->json, "Writes the outcomes; - for standard output")
      ->type_name("FILE");
  command.add_option("--page", arguments->page, "Writes docs/proofs.md")->type_name("FILE");
  command.footer(
      "Each proof also has to refuse broken copies of the RTL. Exit status 1 if a proof does not\n"
      "hold or a broken copy is not refused.");
  command.callback([arguments] { run_prove(*arguments); });
}

}  // namespace kagesen

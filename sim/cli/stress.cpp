#include <fmt/format.h>

#include <filesystem>
#include <iostream>
#include <memory>

#include "sim/cli/check_options.h"
#include "sim/cli/commands.h"
#include "sim/cli/lock_step_check.h"
#include "sim/cli/nearest.h"
#include "sim/cli/parse.h"
#include "sim/cli/progress.h"
#include "sim/cli/settings.h"
#include "sim/report/outputs.h"
#include "tests/stress/state_file.h"
#include "traces/format/error.h"
#include "traces/format/trace_file.h"
#include "traces/format/words.h"

namespace kagesen {
namespace {

using stress::Failure;
using stress::State;
using stress::Totals;

struct StressArguments {
  std::string minutes, seed, cases, only_case, family, profile = "both", engine = "golden",
                                                       folder = "out/stress", json;
  SettingsOptions settings;
  bool resume = false;
};

void check_family(const std::string& name) {
  std::vector<std::string> names;
  for (const stress::Family& family : stress::families()) {
    if (family.name == name) return;
    names.push_back(family.name);
  }
  throw UserError("--family", fmt::format("there is no family '{}'", name),
                  suggestion(name, names));
}

stress::CaseOptions case_options(const StressArguments& arguments) {
  stress::CaseOptions options;
  const Settings settings = load_settings(arguments.settings);
  options.config = settings.config;
  options.given = settings.given;
  for (const char* key : {"map_width", "map_height", "profile", "semantics"}) {
    if (options.given.count(key) == 0) continue;
    throw UserError(std::string("--set ") + key, "every case has its own",
                    std::string(key) == "profile" ? "use --profile" : "leave it out");
  }
  if (arguments.profile == "paper") options.profile = Profile::kPaper;
  if (arguments.profile == "winding") options.profile = Profile::kWinding;
  if (!options.profile && arguments.profile != "both") {
    throw UserError("--profile", fmt::format("there is no '{}'", arguments.profile),
                    suggestion(arguments.profile, {"paper", "winding", "both"}));
  }
  return options;
}

std::string write_trace(const std::string& folder, const Trace& trace, const std::string& name) {
  const std::string path = folder + "/" + name + ".trace";
  PartGuard guard(path + ".part");
  TraceWriter writer(path);
  writer.begin(trace.header);
  writer.casters(trace.all_casters.data(), trace.all_casters.size());
  writer.fragments(trace.all_fragments.data(), trace.all_fragments.size());
  writer.end();
  return path;
}

std::string row(const std::string& name, const Totals& t) {
  return fmt::format("{:<18}{:>10}{:>14}{:>15}{:>15}{:>12}\n", name, grouped(t.cases),
                     grouped(t.fragments), grouped(t.judged), grouped(t.compared),
                     grouped(t.violations));
}

/// The options that a case depends on, as they were given.
std::string given(const StressArguments& arguments) {
  std::string text;
  if (arguments.profile != "both") text += " --profile " + arguments.profile;
  if (arguments.engine != "golden") text += " --engine " + arguments.engine;
  if (!arguments.family.empty()) text += " --family " + arguments.family;
  if (!arguments.settings.file.empty()) text += " --config " + arguments.settings.file;
  for (const std::string& set : arguments.settings.sets) text += " --set " + set;
  return text;
}

std::string what_fails(const std::string& check) {
  const stress::Check* known = stress::find_check(check);
  return (known ? *known : lock_step_check()).what;
}

std::string table(const State& state, const StressArguments& arguments) {
  std::string text =
      fmt::format("Stress, seed {}: {} in {:.0f} s; the next is {}\n\n", state.seed,
                  counted(state.total().cases, "case"), state.seconds, state.next_case);
  text += fmt::format("{:<18}{:>10}{:>14}{:>15}{:>15}{:>12}\n", "family", "cases", "fragments",
                      "judged", "compared", "violations");
  for (const stress::Family& family : stress::families()) {
    const auto totals = state.families.find(family.name);
    if (totals != state.families.end()) text += row(family.name, totals->second);
  }
  text += row("all", state.total());
  for (const Failure& f : state.failures) {
    text += fmt::format("\n{}, {}: {} in {}\n", f.family, what_fails(f.check),
                        counted(f.violations, "verdict"), counted(f.cases, "case"));
    text += fmt::format("  smallest: case {}, {} and {}\n", f.case_number,
                        counted(f.casters, "caster"), counted(f.fragments, "fragment"));
    for (const std::string& line : f.replay) text += "  " + line + "\n";
  }
  if (const Failure* least = stress::smallest(state)) {
    text +=
        fmt::format("\nThe smallest failing case is {}\n  kagesen stress --seed {} --case {}{}\n",
                    least->file, state.seed, least->case_number, given(arguments));
  }
  return text;
}

State starting_state(const StressArguments& arguments, const std::string& path) {
  State state;
  if (arguments.resume) state = stress::read_state(path);
  if (!arguments.seed.empty()) {
    const std::uint64_t seed = parse_count("--seed", arguments.seed, 0, 0x1p53);
    if (arguments.resume && seed != state.seed) {
      throw UserError("--seed", fmt::format("the run to go on with has seed {}", state.seed),
                      "leave --seed or --resume out");
    }
    state.seed = seed;
  } else if (!arguments.resume) {
    state.seed = 1;
  }
  return state;
}

void run_stress(const StressArguments& arguments) {
  stress::SuiteOptions options;
  options.cases = case_options(arguments);
  options.family = arguments.family;
  if (!arguments.family.empty()) check_family(arguments.family);
  if (!arguments.cases.empty())
    options.case_limit = parse_count("--cases", arguments.cases, 1, 1e15);
  if (!arguments.minutes.empty()) {
    options.seconds = 60 * parse_number("--minutes", arguments.minutes, 0.001, 1e6);
  } else if (options.case_limit == 0) {
    options.seconds = 60;
  }
  options.make_engine = make_golden_engine;
  if (arguments.engine == "rtl") {
    for (const std::string& key : width_keys()) options.cases.given.insert(key);
    options.prepare = plan_lock_step;
  } else if (arguments.engine != "golden") {
    throw UserError("--engine", "there is no '" + arguments.engine + "'",
                    suggestion(arguments.engine, {"golden", "rtl"}));
  }

  Outputs outputs;
  outputs.make_folder(arguments.folder);
  const bool json_to_stdout = arguments.json == "-";
  std::ostream* json =
      arguments.json.empty() || json_to_stdout ? nullptr : &outputs.open(arguments.json, "--json");
  // A case that is looked at again leaves the state of the long run alone.
  const std::string state_path = arguments.folder + "/state.json";
  State state = starting_state(arguments, state_path);
  const bool one_case = !arguments.only_case.empty();
  if (one_case) {
    state.next_case = parse_count("--case", arguments.only_case, 0, 0x1p53);
    options.family.clear();
    options.case_limit = 1;
  }
  Progress progress(!json_to_stdout);
  options.write_trace = [&](const Trace& trace, const std::string& name) {
    return write_trace(arguments.folder, trace, name);
  };
  const double before = state.seconds;
  const std::uint64_t first = state.next_case;
  options.after_case = [&](const State& now) {
    if (!one_case) stress::write_state(now, state_path);
    const double by_time = options.seconds > 0 ? (now.seconds - before) / options.seconds : 0;
    const double by_count =
        options.case_limit > 0 ? double(now.next_case - first) / double(options.case_limit) : 0;
    const Totals total = now.total();
    progress.update(
        fmt::format("seed {}, case {}, {} verdicts, {}", now.seed, grouped(now.next_case),
                    grouped(total.judged), counted(total.violations, "violation")),
        std::max(by_time, by_count));
    return true;
  };
  if (!one_case) stress::write_state(state, state_path);
  stress::run_suite(options, state);

  const std::string text = stress::state_json(state).dump(2) + "\n";
  if (json) *json << text;
  outputs.commit();
  progress.clear();
  std::cout << (json_to_stdout ? text : table(state, arguments)) << std::flush;
  if (!state.failures.empty()) throw CLI::RuntimeError(1);
}

}  // namespace

void add_stress(CLI::App& app) {
  auto arguments = std::make_shared<StressArguments>();
  CLI::App& command = *app.add_subcommand(
      "stress", "Holds the unit against the exact reference on adversarial geometry");
  const auto add = [&](const char* name, std::string& value, const char* help, const char* type) {
    return command.add_option(name, value, help)->type_name(type);
  };
  add("--minutes", arguments->minutes, "How long; 1 unless --cases is given", "N");
  add("--cases", arguments->cases, "How many cases", "N");
  add("--seed", arguments->seed, "What the cases are drawn from; 1 if not given", "N");
  add("--case", arguments->only_case, "This case alone", "N");
  add("--family", arguments->family, "Cases of this family alone", "NAME");
  add("--profile", arguments->profile, "paper, winding or both", "NAME")->capture_default_str();
  add("--engine", arguments->engine,
      "golden; or rtl: holds the Verilog against golden, with the widths of one build", "NAME")
      ->capture_default_str();
  command.add_flag("--resume", arguments->resume, "Goes on with the run whose state is in --out");
  add("--out", arguments->folder, "Folder for the state and the failing traces", "DIR")
      ->capture_default_str();
  add("--json", arguments->json, "The totals here; - prints them and nothing else", "FILE|-");
  add_settings_options(command, arguments->settings);
  std::string footer = "Exit status 1 if anything failed. Families:\n";
  for (const stress::Family& f : stress::families()) {
    footer += fmt::format("  {:<18}{}\n", f.name, f.what);
  }
  command.footer(footer);
  command.callback([arguments] { run_stress(*arguments); });
}

}  // namespace kagesen

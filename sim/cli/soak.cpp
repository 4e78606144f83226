#include <fmt/format.h>

#include <fstream>
#include <iostream>
#include <memory>
#include <tuple>

#include "sim/cli/check_options.h"
#include "sim/cli/commands.h"
#include "sim/cli/parse.h"
#include "sim/cli/progress.h"
#include "sim/cli/settings.h"
#include "sim/cli/soak/rounds.h"
#include "sim/cli/stopwatch.h"
#include "sim/report/outputs.h"
#include "tests/stress/state_file.h"
#include "traces/format/error.h"
#include "traces/format/words.h"

namespace kagesen {
namespace {

using stress::State;
using stress::Totals;

struct SoakArguments {
  std::string hours, fragments, seed, only_case, profile = "both", image = "1920x1080",
                                                  folder = "out/soak", json, build = "check";
  SettingsOptions settings;
  bool resume = false;
};

RoundPlan plan_of(const SoakArguments& arguments) {
  RoundPlan plan;
  plan.config = load_settings(arguments.settings).config;
  std::tie(plan.image_width, plan.image_height) = parse_size("--image", arguments.image, 4096);
  if (arguments.profile == "both") return plan;
  if (arguments.profile != "paper" && arguments.profile != "winding") {
    throw UserError("--profile", "there is no '" + arguments.profile + "'",
                    "choose one of paper, winding, both");
  }
  plan.profile = arguments.profile == "paper" ? Profile::kPaper : Profile::kWinding;
  return plan;
}

BuildKind build_of(const SoakArguments& arguments) {
  BenchOptions build;
  build.build = arguments.build;
  return build_kind(build);
}

/// A line a frame, so that a figure of the totals can be taken apart.
class RoundLog {
 public:
  RoundLog(const std::string& path, bool resume)
      : out_(path, resume ? std::ios::app : std::ios::trunc) {
    if (!resume) {
      out_ << "seed,case,family,profile,triangles,fragments,times,cut,cycles,differences,seconds\n";
    }
  }
  void add(const State& state, const Round& round, const LockStepResult& result, double seconds) {
    const std::uint64_t cycles = result.cycles ? result.cycles->total() : 0;
    out_ << fmt::format("{},{},{},{},{},{},{},{},{},{},{:.1f}", state.seed, state.next_case,
                        round.family, get_field(round.config, "profile"),
                        round.trace.all_casters.size(), result.fragments, 1 + round.again.size(),
                        round.cuts, cycles, differences(result), seconds)
         << std::endl;
  }

 private:
  std::ofstream out_;
};

stress::Failure& failure_of(State& state, const std::string& family, const std::string& kind) {
  for (stress::Failure& f : state.failures) {
    if (f.family == family && f.check == kind) return f;
  }
  stress::Failure failure;
  failure.family = family;
  failure.check = kind;
  state.failures.push_back(failure);
  return state.failures.back();
}

std::string replay_line(const SoakArguments& arguments, const State& state, std::uint64_t number) {
  std::string text = fmt::format("kagesen soak --seed {} --case {}", state.seed, number);
  if (arguments.profile != "both") text += " --profile " + arguments.profile;
  if (arguments.image != "1920x1080") text += " --image " + arguments.image;
  if (!arguments.settings.file.empty()) text += " --config " + arguments.settings.file;
  for (const std::string& set : arguments.settings.sets) text += " --set " + set;
  return text;
}

void add_round(const SoakArguments& arguments, const Round& round, const LockStepResult& result,
               State& state) {
  Totals& totals = state.families[round.family];
  ++totals.cases;
  totals.fragments += result.fragments;
  totals.compared += result.fragments;
  totals.violations += differences(result);
  if (result.equal()) return;
  stress::Failure& failure =
      failure_of(state, round.family, result.first ? result.first->kind : "failure");
  failure.violations += differences(result);
  const std::uint64_t size = round.trace.all_casters.size() + result.fragments;
  if (failure.cases++ > 0 && size >= failure.size()) return;
  failure.case_number = state.next_case;
  failure.casters = round.trace.all_casters.size();
  failure.fragments = result.fragments;
  failure.replay = {replay_line(arguments, state, state.next_case)};
  if (!result.first) return;
  const std::vector<std::string>& lines = result.first->lines;
  for (std::size_t i = 0; i < lines.size() && i < 20; ++i) failure.replay.push_back(lines[i]);
}

std::string table(const State& state) {
  std::string text =
      fmt::format("Soak, seed {}: {} in {:.0f} s; the next is {}\n\n", state.seed,
                  counted(state.total().cases, "frame"), state.seconds, state.next_case);
  text += fmt::format("{:<20}{:>10}{:>16}{:>13}\n", "family", "frames", "fragments", "differences");
  const auto row = [&](const std::string& name, const Totals& t) {
    text += fmt::format("{:<20}{:>10}{:>16}{:>13}\n", name, grouped(t.cases), grouped(t.compared),
                        grouped(t.violations));
  };
  for (const auto& [name, totals] : state.families) row(name, totals);
  row("all", state.total());
  for (const stress::Failure& f : state.failures) {
    text += fmt::format("\n{}, {}: {} in {}\n", f.family, f.check,
                        counted(f.violations, "difference"), counted(f.cases, "frame"));
    for (const std::string& line : f.replay) text += "  " + line + "\n";
  }
  return text;
}

void soak_once(const SoakArguments& arguments, std::uint64_t seed) {
  const std::uint64_t number = parse_count("--case", arguments.only_case, 0, 0x1p53);
  const Round round = draw_round(plan_of(arguments), seed, number);
  std::cout << fmt::format("{}: {}, {}\n", round.family,
                           counted(round.trace.all_casters.size(), "triangle"),
                           counted(round.trace.all_fragments.size(), "fragment"));
  for (const ConfigField& field : config_fields()) {
    const std::string value = get_field(round.config, field.key);
    if (value != get_field(UnitConfig{}, field.key)) {
      std::cout << fmt::format("  {} = {}\n", field.key, value);
    }
  }
  RoundRunner runner(build_of(arguments));
  const LockStepResult result = runner.run(round);
  std::cout << fmt::format("{} verdicts, {} texels, {} counters, {} failures differ\n",
                           result.verdict_differences, result.buffer_differences,
                           result.counter_differences, result.failures);
  if (result.first) {
    const std::string& kind = result.first->kind;
    for (const std::string& line : result.first->lines) std::cout << "  " << line << "\n";
    if (kind != "counter" && kind != "repeat" && kind != "cycles") {
      const std::string path = fmt::format("{}/case-{}.fst", arguments.folder, number);
      for (const std::string& line : runner.wave(round, *result.first, path)) {
        std::cout << "  " << line << "\n";
      }
    }
  }
  if (!result.equal()) throw CLI::RuntimeError(1);
}

State first_state(const SoakArguments& arguments) {
  State state;
  state.seed = 1;
  if (arguments.resume) state = stress::read_state(arguments.folder + "/state.json");
  if (arguments.seed.empty()) return state;
  const std::uint64_t seed = parse_count("--seed", arguments.seed, 0, 0x1p53);
  if (arguments.resume && seed != state.seed) {
    throw UserError("--seed", fmt::format("the run to go on with has seed {}", state.seed),
                    "leave --seed or --resume out");
  }
  state.seed = seed;
  return state;
}

void run_soak(const SoakArguments& arguments) {
  Outputs outputs;
  outputs.make_folder(arguments.folder);
  const bool to_stdout = arguments.json == "-";
  std::ostream* json =
      arguments.json.empty() || to_stdout ? nullptr : &outputs.open(arguments.json, "--json");
  State state = first_state(arguments);
  if (!arguments.only_case.empty()) {
    outputs.commit();
    return soak_once(arguments, state.seed);
  }
  const double seconds =
      3600 *
      (arguments.hours.empty() ? 0.05 : parse_number("--hours", arguments.hours, 0.0001, 1e5));
  const std::uint64_t enough =
      arguments.fragments.empty() ? 0 : parse_count("--fragments", arguments.fragments, 1, 1e15);
  const RoundPlan plan = plan_of(arguments);
  RoundRunner runner(build_of(arguments));
  for (const Profile profile : {Profile::kPaper, Profile::kWinding}) {
    UnitConfig config = plan.config;
    config.profile = profile;
    if (plan.profile.value_or(profile) == profile) runner.prepare(config);
  }
  Progress progress(!to_stdout);
  RoundLog log(arguments.folder + "/rounds.csv", arguments.resume);
  Stopwatch watch;
  for (double spent = 0; spent < seconds;) {
    const Round round = draw_round(plan, state.seed, state.next_case);
    const LockStepResult result = runner.run(round);
    add_round(arguments, round, result, state);
    const double lap = watch.lap();
    log.add(state, round, result, lap);
    ++state.next_case;
    spent += lap;
    state.seconds += lap;
    stress::write_state(state, arguments.folder + "/state.json");
    const Totals total = state.total();
    progress.update(
        fmt::format("frame {}, {}, {}", grouped(state.next_case),
                    counted(total.compared, "fragment"), counted(total.violations, "difference")),
        spent / seconds);
    if (enough != 0 && total.compared >= enough) break;
  }
  const std::string text = stress::state_json(state).dump(2) + "\n";
  if (json) *json << text;
  outputs.commit();
  progress.clear();
  std::cout << (to_stdout ? text : table(state)) << std::flush;
  if (!state.failures.empty()) throw CLI::RuntimeError(1);
}

}  // namespace

void add_soak(CLI::App& app) {
  auto arguments = std::make_shared<SoakArguments>();
  CLI::App& command = *app.add_subcommand(
      "soak",
      "Holds the Verilog against golden on scenes and stress cases, with random settings, "
      "latencies, stalls and aborts, as long as wanted");
  const auto add = [&](const char* name, std::string& value, const char* help, const char* type) {
    return command.add_option(name, value, help)->type_name(type);
  };
  add("--hours", arguments->hours, "How long (0.05)", "H");
  add("--fragments", arguments->fragments, "Ends, too, when so many in all were compared", "N");
  add("--seed", arguments->seed, "What the frames are drawn from (1)", "N");
  add("--case", arguments->only_case, "This frame alone, with the waves of a difference", "N");
  add("--profile", arguments->profile, "paper, winding or both", "NAME")->capture_default_str();
  add("--image", arguments->image, "Pixels of the scenes that come in turn", "WxH")
      ->capture_default_str();
  add("--build", arguments->build, "fast, or check (assertions)", "KIND")->capture_default_str();
  command.add_flag("--resume", arguments->resume, "Goes on with the run whose state is in --out");
  add("--out", arguments->folder, "Folder for the state and the waves", "DIR")
      ->capture_default_str();
  add("--json", arguments->json, "The totals here; - prints them and nothing else", "FILE|-");
  add_settings_options(command, arguments->settings);
  command.footer("Exit status 1 if anything differed.");
  command.callback([arguments] { run_soak(*arguments); });
}

}  // namespace kagesen

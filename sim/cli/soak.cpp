#include <fmt/format.h>

#include <iostream>
#include <memory>

#include "model/frame_setup.h"
#include "sim/cli/check_options.h"
#include "sim/cli/commands.h"
#include "sim/cli/lock_step_check.h"
#include "sim/cli/parse.h"
#include "sim/cli/progress.h"
#include "sim/cli/settings.h"
#include "sim/cli/stopwatch.h"
#include "sim/report/outputs.h"
#include "tests/stress/state_file.h"
#include "traces/format/error.h"
#include "traces/format/words.h"
#include "traces/raster/capture.h"
#include "traces/scene/scene.h"

namespace kagesen {
namespace {

using stress::Dice;
using stress::State;
using stress::Totals;

struct SoakArguments {
  std::string hours, seed, only_case, profile = "both", folder = "out/soak", json, build = "check";
  SettingsOptions settings;
  bool resume = false;
};

/// A frame to run, and how.
struct Round {
  std::string family;  ///< of the totals
  Trace trace;
  UnitConfig config;
  FrameSetup setup;
  std::size_t portions = 0;
  Timing timing;
  std::uint64_t cuts = 0, cut_seed = 0;
};

class Soak {
 public:
  explicit Soak(const SoakArguments& arguments)
      : arguments_(arguments), config_(load_settings(arguments.settings).config) {
    BenchOptions build;
    build.build = arguments.build;
    RtlOptions options;
    options.kind = build_kind(build);
    engine_ = std::make_unique<RtlEngine>(options);
    if (arguments.profile != "both" && arguments.profile != "paper" &&
        arguments.profile != "winding") {
      throw UserError("--profile", "there is no '" + arguments.profile + "'",
                      "choose one of paper, winding, both");
    }
  }

  /// Builds what is wanted, so that it is not counted as time spent.
  void prepare() {
    for (const Profile profile : {Profile::kPaper, Profile::kWinding}) {
      const bool paper = profile == Profile::kPaper;
      if (arguments_.profile == (paper ? "winding" : "paper")) continue;
      UnitConfig config = config_;
      config.profile = profile;
      engine_->prepare(config);
    }
  }

  /// Everything about a round follows from seed and number.
  Round draw(std::uint64_t seed, std::uint64_t number) const {
    Dice dice = Dice::of_case(seed, number);
    Round round;
    const Profile profile = arguments_.profile == "paper"     ? Profile::kPaper
                            : arguments_.profile == "winding" ? Profile::kWinding
                            : dice.one_in(2)                  ? Profile::kPaper
                                                              : Profile::kWinding;
    const bool hints = !dice.one_in(4);
    round.config = config_;
    if (dice.one_in(2)) {
      draw_stress(seed, number, profile, round);
    } else {
      draw_scene(dice, round);
    }
    round.config.profile = profile;
    if (!dice.one_in(4)) draw_registers(dice, round.config);
    round.config.map_width = round.trace.header.map_width;
    round.config.map_height = round.trace.header.map_height;
    round.setup = stress::frame_setup(round.trace, {round.config, hints});
    round.timing = draw_timing(dice);
    if (dice.one_in(8)) round.portions = static_cast<std::size_t>(dice.in(1, 5000));
    round.cuts = dice.one_in(2) ? 0 : static_cast<std::uint64_t>(dice.in(1, 3));
    round.cut_seed = dice.next();
    return round;
  }

  LockStepResult run(const Round& round) {
    const Frame frame{round.trace, round.config, round.setup, round.portions};
    expected_ = expect(frame);
    engine_->set_timing(round.timing);
    try {
      for (std::uint64_t i = 0; i < round.cuts && cycles_; ++i) {
        cut_frame(frame, *engine_,
                  i % 2 == 0 ? bench::Bench::Cut::kAbort : bench::Bench::Cut::kReset,
                  round.cut_seed + i, *cycles_);
      }
    } catch (const bench::Failure& failure) {
      engine_->bench().reset();
      LockStepResult result;
      result.fragments = round.trace.all_fragments.size();
      result.failures = 1;
      result.first.emplace();
      result.first->kind = "failure";
      result.first->lines = {std::string("cut short: ") + failure.what()};
      return result;
    }
    LockStepResult result = lock_step(frame, expected_, *engine_);
    if (result.cycles) cycles_ = result.cycles;
    if (result.failures > 0) engine_->bench().reset();
    return result;
  }

  std::vector<std::string> wave(const Round& round, const FirstDifference& first,
                                const std::string& path) const {
    const Frame frame{round.trace, round.config, round.setup, round.portions};
    return write_wave(frame, expected_, first, round.timing, path);
  }

 private:
  void draw_stress(std::uint64_t seed, std::uint64_t number, Profile profile, Round& round) const {
    stress::CaseOptions options;
    options.profile = profile;
    options.config = config_;
    for (const std::string& key : width_keys()) options.given.insert(key);
    stress::StressCase test = stress::make_case(seed, number, options);
    round.family = test.family->name;
    if (!test.plan.empty()) round.config = test.plan[number % test.plan.size()].setting.config;
    round.trace = std::move(test.trace);
  }

  void draw_scene(Dice& dice, Round& round) const {
    const std::vector<SceneInfo> scenes = builtin_scenes();
    const SceneInfo& info = scenes[dice.index(scenes)];
    round.family = "scene " + info.name;
    CaptureOptions capture;
    capture.map_width = static_cast<std::uint32_t>(dice.pick({64, 100, 256, 512, 1024, 1024}));
    capture.map_height =
        dice.one_in(4) ? static_cast<std::uint32_t>(dice.in(1, 1024)) : capture.map_width;
    capture.scale_x = capture.scale_y = dice.pick({1.0, 1.0, 4.0, 16.0, 64.0, 256.0});
    const int side = dice.small(1, 6);  // of sixths of full HD
    capture.image_width = static_cast<std::uint32_t>(320 * side);
    capture.image_height = static_cast<std::uint32_t>(180 * side);
    kagesen::capture(make_builtin(info.name), capture, round.trace);
  }

  const SoakArguments& arguments_;
  const UnitConfig config_;
  std::unique_ptr<RtlEngine> engine_;
  std::optional<CycleReport> cycles_;  // of the frame before: where cuts may fall
  Expected expected_;
};

std::uint64_t differences(const LockStepResult& r) {
  return r.verdict_differences + r.buffer_differences + r.counter_differences + r.failures;
}

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
  Soak soak(arguments);
  const Round round = soak.draw(seed, number);
  std::cout << fmt::format("{}: {}, {}\n", round.family,
                           counted(round.trace.all_casters.size(), "triangle"),
                           counted(round.trace.all_fragments.size(), "fragment"));
  for (const ConfigField& field : config_fields()) {
    const std::string value = get_field(round.config, field.key);
    if (value != get_field(UnitConfig{}, field.key)) {
      std::cout << fmt::format("  {} = {}\n", field.key, value);
    }
  }
  const LockStepResult result = soak.run(round);
  std::cout << fmt::format("{} verdicts, {} texels, {} counters, {} failures differ\n",
                           result.verdict_differences, result.buffer_differences,
                           result.counter_differences, result.failures);
  if (result.first) {
    for (const std::string& line : result.first->lines) std::cout << "  " << line << "\n";
    if (result.first->kind != "counter") {
      const std::string path = fmt::format("{}/case-{}.fst", arguments.folder, number);
      for (const std::string& line : soak.wave(round, *result.first, path)) {
        std::cout << "  " << line << "\n";
      }
    }
  }
  if (!result.equal()) throw CLI::RuntimeError(1);
}

void run_soak(const SoakArguments& arguments) {
  Outputs outputs;
  outputs.make_folder(arguments.folder);
  const bool to_stdout = arguments.json == "-";
  std::ostream* json =
      arguments.json.empty() || to_stdout ? nullptr : &outputs.open(arguments.json, "--json");
  const std::string path = arguments.folder + "/state.json";
  State state;
  state.seed = 1;
  if (arguments.resume) state = stress::read_state(path);
  if (!arguments.seed.empty()) {
    const std::uint64_t seed = parse_count("--seed", arguments.seed, 0, 0x1p53);
    if (arguments.resume && seed != state.seed) {
      throw UserError("--seed", fmt::format("the run to go on with has seed {}", state.seed),
                      "leave --seed or --resume out");
    }
    state.seed = seed;
  }
  if (!arguments.only_case.empty()) {
    outputs.commit();
    return soak_once(arguments, state.seed);
  }
  const double hours =
      arguments.hours.empty() ? 0.05 : parse_number("--hours", arguments.hours, 0.0001, 1e5);
  Soak soak(arguments);
  soak.prepare();
  Progress progress(!to_stdout);
  Stopwatch watch;
  for (double spent = 0; spent < hours * 3600;) {
    const Round round = soak.draw(state.seed, state.next_case);
    const LockStepResult result = soak.run(round);
    add_round(arguments, round, result, state);
    ++state.next_case;
    const double lap = watch.lap();
    spent += lap;
    state.seconds += lap;
    stress::write_state(state, path);
    const Totals total = state.total();
    progress.update(
        fmt::format("frame {}, {}, {}", grouped(state.next_case),
                    counted(total.compared, "fragment"), counted(total.violations, "difference")),
        spent / (hours * 3600));
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
  add("--seed", arguments->seed, "What the frames are drawn from (1)", "N");
  add("--case", arguments->only_case, "This frame alone, with the waves of a difference", "N");
  add("--profile", arguments->profile, "paper, winding or both", "NAME")->capture_default_str();
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

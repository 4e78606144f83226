#include <fmt/format.h>

#include <filesystem>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <sstream>

#include "model/frame_setup.h"
#include "sim/cli/check_options.h"
#include "sim/cli/commands.h"
#include "sim/cli/cycle_check.h"
#include "sim/cli/input.h"
#include "sim/cli/progress.h"
#include "sim/cli/stopwatch.h"
#include "sim/report/outputs.h"
#include "testbench/verilator/lock_step.h"
#include "traces/format/error.h"
#include "traces/format/words.h"

namespace kagesen {
namespace {

using Json = nlohmann::ordered_json;

struct CheckArguments {
  std::vector<std::string> inputs;
  std::string scales;
  InputOptions capture;
  SettingsOptions settings;
  BenchOptions bench;
  std::string frames = "1", aborts = "0", json, folder = "out/check", coverage;
};

/// Figures of one input at one scale, or of all.
struct Figures {
  std::uint64_t frames = 0, fragments = 0;
  std::uint64_t verdict_differences = 0, buffer_differences = 0, cycle_differences = 0;
  std::uint64_t counter_differences = 0, failures = 0, cut = 0;
  std::uint64_t cycles = 0;
  double seconds = 0;
  bool equal() const {
    return verdict_differences + buffer_differences + cycle_differences + counter_differences +
               failures ==
           0;
  }
  Figures& operator+=(const Figures& o) {
    frames += o.frames;
    fragments += o.fragments;
    verdict_differences += o.verdict_differences;
    buffer_differences += o.buffer_differences;
    cycle_differences += o.cycle_differences;
    counter_differences += o.counter_differences;
    failures += o.failures;
    cut += o.cut;
    cycles += o.cycles;
    seconds += o.seconds;
    return *this;
  }
};

Json json_of(const Figures& f) {
  return {{"frames", f.frames},
          {"cut_frames", f.cut},
          {"fragments", f.fragments},
          {"verdict_differences", f.verdict_differences},
          {"buffer_differences", f.buffer_differences},
          {"cycle_differences", f.cycle_differences},
          {"counter_differences", f.counter_differences},
          {"failures", f.failures},
          {"cycles", f.cycles},
          {"seconds", f.seconds}};
}

/// Stages whose cycles differ between two runs of one frame.
std::uint64_t differing_stages(const CycleReport& a, const CycleReport& b) {
  return (a.clear != b.clear) + (a.announce != b.announce) + (a.pass1->total != b.pass1->total) +
         (a.settle != b.settle) + (a.pass2->total != b.pass2->total);
}

class CheckRun {
 public:
  explicit CheckRun(const CheckArguments& arguments)
      : arguments_(arguments),
        progress_(arguments.json != "-"),
        settings_(load_settings(arguments.settings)),
        frames_(parse_count("--frames", arguments.frames, 1, 1e6)),
        aborts_(parse_count("--abort", arguments.aborts, 0, 1e6)) {}

  bool run() {
    Outputs outputs;
    const bool to_stdout = arguments_.json == "-";
    std::ostream* json =
        arguments_.json.empty() || to_stdout ? nullptr : &outputs.open(arguments_.json, "--json");
    Json inputs = Json::array();
    Figures total;
    for (const std::string& input : arguments_.inputs) {
      for (const std::string& scale : scales()) {
        const Figures figures = check(input, scale);
        total += figures;
        Json one = json_of(figures);
        one["input"] = input;
        one["scale"] = scale;
        inputs.push_back(one);
        if (!to_stdout) print(input + (scale.empty() ? "" : " x" + scale), figures);
      }
    }
    if (!arguments_.coverage.empty()) engine_->bench().write_coverage(arguments_.coverage.c_str());
    Json all = json_of(total);
    all["config"] = get_field(settings_.config, "profile");
    all["inputs"] = inputs;
    if (!first_.is_null()) all["first"] = first_;
    const std::string text = all.dump(2) + "\n";
    if (json) *json << text;
    outputs.commit();
    progress_.clear();
    if (to_stdout) {
      std::cout << text;
    } else {
      if (inputs.size() > 1) print("all", total);
      for (const std::string& line : told_) std::cout << line << "\n";
    }
    return total.equal();
  }

 private:
  /// "1,16" taken apart; one empty text if none was given.
  std::vector<std::string> scales() const {
    std::vector<std::string> out;
    std::istringstream text(arguments_.scales);
    for (std::string scale; std::getline(text, scale, ',');) out.push_back(scale);
    if (out.empty()) out.emplace_back();
    return out;
  }

  void print(const std::string& name, const Figures& f) {
    progress_.clear();
    if (!headed_) {
      std::cout << fmt::format("{:<24}{:>7}{:>13}{:>9}{:>9}{:>9}{:>9}{:>15}{:>9}\n", "input",
                               "frames", "fragments", "verdicts", "buffers", "counters", "cycles",
                               "clock cycles", "seconds");
      headed_ = true;
    }
    std::cout << fmt::format("{:<24}{:>7}{:>13}{:>9}{:>9}{:>9}{:>9}{:>15}{:>9.1f}{}\n", name,
                             f.frames, grouped(f.fragments), grouped(f.verdict_differences),
                             grouped(f.buffer_differences), grouped(f.counter_differences),
                             grouped(f.cycle_differences), grouped(f.cycles), f.seconds,
                             f.failures ? "  FAILED" : "")
              << std::flush;
  }

  Figures check(const std::string& input, const std::string& scale) {
    Stopwatch watch;
    Settings settings = settings_;
    InputOptions capture = arguments_.capture;
    capture.name = input;
    capture.scale = scale;
    const Trace trace = load_trace(resolve_input(capture), capture, settings, progress_.callback());
    const Frame frame{trace, settings.config, make_frame_setup(trace, settings.config)};
    progress_.update(input + ": golden", 0);
    const Expected expected = expect(frame);
    if (!engine_) {
      RtlOptions options;
      options.kind = build_kind(arguments_.bench);
      options.keep_cycles = true;
      engine_ = std::make_unique<RtlEngine>(options);
      model_ = std::make_unique<SystemcEngine>(SystemcOptions{{}, true});
    }

    Figures figures;
    Timing timing = timing_of(arguments_.bench, settings.config);
    // Stalls and latencies at random are others in each frame; without, the cycles must be too.
    const bool varies = timing.spread + timing.memory_stall + timing.stream_stall > 0;
    std::optional<CycleReport> before;
    for (std::uint64_t n = 0; n < frames_; ++n) {
      progress_.update(input + ": rtl", double(n) / double(frames_));
      engine_->set_timing(timing);
      const LockStepResult result = lock_step(frame, expected, *engine_);
      ++figures.frames;
      figures.fragments += result.fragments;
      figures.verdict_differences += result.verdict_differences;
      figures.buffer_differences += result.buffer_differences;
      figures.counter_differences += result.counter_differences;
      figures.failures += result.failures;
      if (result.cycles) figures.cycles += result.cycles->total();
      if (result.cycles && before && !varies) {
        figures.cycle_differences += differing_stages(*before, *result.cycles);
      }
      if (result.cycles) before = result.cycles;
      if (result.first) tell(input, scale, frame, expected, timing, *result.first);
      if (result.failures > 0) {
        engine_->bench().reset();
        break;
      }
      progress_.update(input + ": systemc", double(n) / double(frames_));
      model_->set_timing(timing);
      const CycleCheck cycles = check_cycles(frame, expected, *engine_, *model_);
      figures.verdict_differences += cycles.verdict_differences;
      figures.cycle_differences += cycles.cycle_differences;
      if (!cycles.first.empty()) tell_cycles(input, scale, cycles.first);
      if (before && !cut(input, frame, timing.seed, *before, figures)) break;
      if (varies) ++timing.seed;
    }
    figures.seconds = watch.lap();
    return figures;
  }

  /// Frames that are cut short before the next whole one. False: the unit failed.
  bool cut(const std::string& input, const Frame& frame, std::uint64_t seed,
           const CycleReport& cycles, Figures& figures) {
    try {
      for (std::uint64_t i = 0; i < aborts_; ++i) {
        cut_frame(frame, *engine_,
                  i % 2 == 0 ? bench::Bench::Cut::kAbort : bench::Bench::Cut::kReset,
                  seed * 1000 + i, cycles);
        ++figures.cut;
      }
      return true;
    } catch (const bench::Failure& failure) {
      ++figures.failures;
      if (first_.is_null()) {
        told_.push_back(fmt::format("{}, cut short: {}", input, failure.what()));
        first_ = {{"input", input}, {"kind", "failure"}, {"lines", {failure.what()}}};
      }
      engine_->bench().reset();
      return false;
    }
  }

  void tell_cycles(const std::string& input, const std::string& scale,
                   const std::vector<std::string>& lines) {
    if (!first_.is_null()) return;  // the first of all
    told_.push_back(
        fmt::format("First difference, {}{}:", input, scale.empty() ? "" : " at scale " + scale));
    for (const std::string& line : lines) told_.push_back("  " + line);
    first_ = {{"input", input}, {"scale", scale}, {"kind", "cycles"}, {"lines", lines}};
  }

  void tell(const std::string& input, const std::string& scale, const Frame& frame,
            const Expected& expected, const Timing& timing, const FirstDifference& first) {
    if (!first_.is_null()) return;  // the first of all
    const std::string name = std::filesystem::path(input).stem().string();
    told_.push_back(
        fmt::format("First difference, {}{}:", input, scale.empty() ? "" : " at scale " + scale));
    for (const std::string& line : first.lines) told_.push_back("  " + line);
    first_ = {{"input", input}, {"scale", scale}, {"kind", first.kind}, {"lines", first.lines}};
    if (first.kind == "counter") return;
    progress_.update(input + ": waves", 0);
    Outputs folder;
    folder.make_folder(arguments_.folder);
    folder.commit();
    const std::string wave =
        fmt::format("{}/{}{}.fst", arguments_.folder, name, scale.empty() ? "" : "-x" + scale);
    const std::vector<std::string> lines = write_wave(frame, expected, first, timing, wave);
    for (const std::string& line : lines) told_.push_back("  " + line);
    first_["wave"] = wave;
    first_["where"] = lines;
  }

  const CheckArguments& arguments_;
  Progress progress_;
  const Settings settings_;
  const std::uint64_t frames_, aborts_;
  std::unique_ptr<RtlEngine> engine_;
  std::unique_ptr<SystemcEngine> model_;
  bool headed_ = false;
  Json first_;
  std::vector<std::string> told_;
};

}  // namespace

void add_check(CLI::App& app) {
  auto arguments = std::make_shared<CheckArguments>();
  CLI::App& command = *app.add_subcommand(
      "check",
      "Runs the Verilog, the golden unit and the SystemC model in lock step and compares all they do");
  command
      .add_option("INPUT", arguments->inputs,
                  "Built-in scenes (kagesen scenes), mesh files or traces")
      ->required();
  const auto add = [&](const char* name, std::string& value, const char* type, const char* help,
                       const char* group) {
    return command.add_option(name, value, help)->type_name(type)->group(group);
  };
  add("--scale", arguments->scales, "S,...",
      "Virtual projection space; several, separated by commas: each in turn", "Capture");
  add("--image", arguments->capture.image, "WxH", "Pixels of the camera's image (1920x1080)",
      "Capture");
  add("--map", arguments->capture.map, "N|WxH", "Texels of the shadow map (1024)", "Capture");
  add("--mode", arguments->capture.mode, "MODE",
      "Fragments of pass 2: visible, early-z or all (visible)", "Capture");
  add_settings_options(command, arguments->settings);
  add_bench_options(command, arguments->bench);
  add("--frames", arguments->frames, "N", "Runs each frame N times, back to back", "Bench")
      ->capture_default_str();
  add("--abort", arguments->aborts, "N",
      "Before each further frame, starts it N times and cuts it short by register and by reset in "
      "turn, at random cycles",
      "Bench")
      ->capture_default_str();
  add("--coverage", arguments->coverage, "FILE", "Where --build coverage writes its counts",
      "Bench");
  add("--out", arguments->folder, "DIR", "Folder for the waves of a difference", "Output")
      ->capture_default_str();
  add("--json", arguments->json, "FILE|-", "The figures here; - prints them and nothing else",
      "Output");
  command.footer("Exit status 1 on any difference. Waves: gtkwave out/check/NAME.fst");
  command.callback([arguments] {
    if (!CheckRun(*arguments).run()) throw CLI::RuntimeError(1);
  });
}

}  // namespace kagesen

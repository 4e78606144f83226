/// kagesen cycles: clock cycles of the unit over the built-in scenes, into docs/cycles.md.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>

#include "sim/cli/commands.h"
#include "sim/cli/cycles/rows.h"
#include "sim/cli/nearest.h"
#include "sim/cli/progress.h"
#include "sim/cli/simulate.h"
#include "sim/cli/stopwatch.h"
#include "sim/report/outputs.h"
#include "testbench/verilator/build.h"
#include "traces/format/error.h"
#include "traces/format/words.h"
#include "traces/raster/capture.h"
#include "traces/scene/scene.h"

namespace kagesen {
namespace {

namespace fs = std::filesystem;

struct CyclesArguments {
  std::string page = "docs/cycles.md";
  std::string engine = "systemc";
  std::vector<std::string> scenes, profiles{"paper", "winding"};
  std::vector<std::uint64_t> scales{1, 4, 16};
  bool fresh = false;
};

void check_choice(const std::string& option, const std::string& word,
                  const std::vector<std::string>& choices) {
  if (std::find(choices.begin(), choices.end(), word) != choices.end()) return;
  throw UserError(option, fmt::format("there is no '{}'", word), suggestion(word, choices));
}

void check(CyclesArguments& arguments) {
  std::vector<std::string> names;
  for (const SceneInfo& info : builtin_scenes()) names.push_back(info.name);
  if (arguments.scenes.empty()) arguments.scenes = names;
  check_choice("--engine", arguments.engine, {"systemc", "rtl"});
  for (const std::string& scene : arguments.scenes) check_choice("--scenes", scene, names);
  for (const std::string& p : arguments.profiles) check_choice("--profiles", p, {"paper", "winding"});
}

UnitConfig config_of(const std::string& profile) {
  UnitConfig config;
  set_field(config, "profile", profile);
  return config;
}

/// Frames with a row of today's RTL are done; the others are measured and join the file one by one.
class CyclesRun {
 public:
  explicit CyclesRun(const CyclesArguments& arguments)
      : arguments_(arguments), data_(fs::path(arguments.page).replace_extension(".json").string()) {
    for (const std::string& profile : arguments.profiles) {
      const std::string rtl = hash_of(bench_recipe(config_of(profile), BuildKind::kFast));
      for (const std::string& scene : arguments.scenes) {
        for (const std::uint64_t scale : arguments.scales) {
          CyclesRow row;
          row.profile = profile;
          row.scene = scene;
          row.scale = scale;
          row.rtl = rtl;
          row.engine = arguments.engine;
          wanted_.push_back(row);
        }
      }
    }
    if (arguments.fresh) return;
    for (const CyclesRow& row : read_cycles(data_)) {
      const bool wanted = std::any_of(wanted_.begin(), wanted_.end(),
                                      [&](const CyclesRow& w) { return w.same_frame(row); });
      if (wanted) rows_.push_back(row);
    }
  }

  void run() {
    save();  // a place that cannot be written to is found before any work
    const std::size_t missing = wanted_.size() - rows_.size();
    std::size_t done = 0;
    for (CyclesRow& row : wanted_) {
      const auto known = std::find_if(rows_.begin(), rows_.end(),
                                      [&](const CyclesRow& r) { return r.same_frame(row); });
      if (known != rows_.end()) continue;
      const std::string what = fmt::format("{} of {}: {} at scale {}, {} profile,", ++done, missing,
                                           row.scene, row.scale, row.profile);
      measure(row, what);
      rows_.push_back(row);
      save();
    }
    progress_.clear();
    std::cout << fmt::format("{}: {} measured, {} kept\n", arguments_.page, counted(done, "row"),
                             rows_.size() - done);
  }

 private:
  void measure(CyclesRow& row, const std::string& what) {
    CaptureOptions capturing;
    capturing.scale_x = capturing.scale_y = double(row.scale);
    Trace trace;
    capture(make_builtin(row.scene), capturing, trace);
    SimulateOptions options;
    options.engine = row.engine;
    options.reference = false;
    options.progress = [&](const std::string& stage, double part) {
      progress_.update(what + " " + stage, part);
    };
    Stopwatch watch;
    const RunResult result = simulate(trace, config_of(row.profile), options);
    row.seconds = watch.lap();
    row.fragments = trace.all_fragments.size();
    row.cycles = result.cycles.value();
  }

  /// Both files are whole at every moment, so an interruption loses one frame at most.
  void save() const {
    std::vector<CyclesRow> ordered;
    for (const CyclesRow& wanted : wanted_) {
      for (const CyclesRow& row : rows_) {
        if (row.same_frame(wanted)) ordered.push_back(row);
      }
    }
    Outputs outputs;
    const fs::path folder = fs::path(arguments_.page).parent_path();
    outputs.make_folder(folder.empty() ? "." : folder.string());
    outputs.write(data_, cycles_json(ordered).dump(1) + "\n", "--out");
    outputs.write(arguments_.page, cycles_page(ordered), "--out");
    outputs.commit();
  }

  const CyclesArguments& arguments_;
  const std::string data_;
  std::vector<CyclesRow> wanted_, rows_;
  Progress progress_{true};
};

}  // namespace

void add_cycles(CLI::App& app) {
  auto arguments = std::make_shared<CyclesArguments>();
  CLI::App& command = *app.add_subcommand(
      "cycles", "Measures the unit's clock cycles over the built-in scenes, into docs/cycles.md");
  command.add_option("--out", arguments->page, "The page; its figures stand beside it as .json")
      ->type_name("FILE.md")
      ->capture_default_str();
  command.add_option("--engine", arguments->engine, "systemc, or rtl: the same figures, much later")
      ->type_name("NAME")
      ->capture_default_str();
  command.add_option("--scenes", arguments->scenes, "Built-in scenes; all where not given")
      ->type_name("NAME,...")
      ->delimiter(',');
  command.add_option("--profiles", arguments->profiles, "paper, winding")
      ->type_name("NAME,...")
      ->delimiter(',')
      ->capture_default_str();
  command.add_option("--scales", arguments->scales, "Scales of the virtual projection space")
      ->type_name("N,...")
      ->delimiter(',')
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
  command.add_flag("--fresh", arguments->fresh, "Measures again what the file has");
  command.footer(
      "It may be interrupted: frames that the file has, of the same Verilog, are kept.\n"
      "Examples:\n"
      "  kagesen cycles                                 all of docs/cycles.md, minutes\n"
      "  kagesen cycles --scenes solids --out /tmp/c.md  a look");
  command.callback([arguments] {
    check(*arguments);
    CyclesRun(*arguments).run();
  });
}

}  // namespace kagesen

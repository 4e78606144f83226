#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <iostream>
#include <memory>
#include <optional>
#include <sstream>
#include <utility>

#include "sim/cli/commands.h"
#include "sim/cli/input.h"
#include "sim/cli/parse.h"
#include "sim/cli/progress.h"
#include "sim/cli/simulate.h"
#include "sim/cli/stopwatch.h"
#include "sim/report/json.h"
#include "sim/report/outputs.h"
#include "sim/report/pictures.h"
#include "sim/report/table.h"
#include "sim/report/timeline_json.h"
#include "sim/report/timeline_vcd.h"
#include "sim/report/verdicts.h"
#include "sim/systemc/engine.h"
#include "testbench/synthesis/gates.h"
#include "testbench/verilator/rtl_engine.h"
#include "traces/format/error.h"

namespace kagesen {
namespace {

struct RunOptions {
  InputOptions input;
  SettingsOptions settings;
  SimulateOptions simulate;
  std::string folder = "out", json, verdicts, timeline, waves, window = "0-20000", pass = "2";
  bool no_reference = false, no_images = false, scene_exact = false;
};

SceneExact check_scene(const Scene& scene, const LightSpace& light_space, const Trace& trace,
                       const RunResult& result) {
  const auto dark_in = [&](Semantics semantics) {
    std::vector<std::uint8_t> dark;
    for (const Verdict v : result.verdicts_in(semantics)) dark.push_back(v == Verdict::kDark);
    return dark;
  };
  SceneExact exact;
  exact.unit = scene_exact(scene, light_space, trace, dark_in(Semantics::kPaper),
                           dark_in(Semantics::kPhysical));
  if (result.judgement) {
    exact.trace = scene_exact(scene, light_space, trace, result.judgement->exact_paper,
                              result.judgement->exact_physical);
  }
  return exact;
}

/// Nothing without --timeline and --waves.
std::optional<Timeline> window_of(const RunOptions& options) {
  if (options.timeline.empty() && options.waves.empty()) return std::nullopt;
  if (options.simulate.engine == "golden") {
    throw UserError(options.timeline.empty() ? "--waves" : "--timeline", "golden has no clock",
                    "leave --engine golden out");
  }
  const auto pass = static_cast<unsigned>(parse_number("--window-pass", options.pass, 1, 2));
  const std::size_t dash = options.window.find('-', 1);
  const double first = parse_number("--window", options.window.substr(0, dash), 0, 1e15);
  const double last = dash == std::string::npos
                          ? first
                          : parse_number("--window", options.window.substr(dash + 1), first, 1e15);
  return Timeline(pass, static_cast<Cycle>(first), static_cast<Cycle>(last));
}

/// The engine that fills the timeline. Waves of the Verilog go to a file at once.
std::unique_ptr<Engine> make_traced(const std::string& name, const UnitConfig& config,
                                    Timeline* timeline, const std::string& waves) {
  if (name == "systemc") return make_systemc_engine({{}, true, timeline});
  if (name != "rtl") return make_engine(name);
  const BuildKind kind = waves.empty() ? BuildKind::kFast : BuildKind::kTrace;
  auto engine = std::make_unique<RtlEngine>(RtlOptions{kind, {}, true, timeline, {}});
  if (!waves.empty()) {
    engine->prepare(config).trace_pass(
        waves.c_str(), timeline->pass() == 1 ? bench::Pass::kDraw : bench::Pass::kDecide,
        timeline->first(), timeline->last());
  }
  return engine;
}

std::string text_of_file(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

void add_fragments(const std::vector<FragmentCycles>& cycles, Timeline& timeline) {
  const std::uint32_t track = timeline.track("fragments", Timeline::Kind::kWork);
  timeline.begin(2, 0);
  for (std::size_t i = 0; i < cycles.size(); ++i) {
    timeline.work(track, "fragment", i, cycles[i].accepted, cycles[i].retired);
  }
}

/// If kagesen gates measured this configuration as it now is.
std::optional<SynthesisedClock> clock_of(const UnitConfig& config) {
  const GateOptions options;
  const std::optional<GateReport> gates = kept_gates(config, options);
  if (!gates || gates->fmax_mhz == 0) return std::nullopt;
  return SynthesisedClock{gates->fmax_mhz, options.library};
}

void run(RunOptions& options) {
  const bool json_to_stdout = options.json == "-";
  Progress progress(!json_to_stdout);
  options.simulate.reference = !options.no_reference;
  options.simulate.both_semantics = options.scene_exact;
  options.simulate.progress = progress.callback();
  Settings settings = load_settings(options.settings);
  make_engine(options.simulate.engine);  // refuses an unknown one before any work
  std::optional<Timeline> timeline = window_of(options);
  const bool rtl_waves = !options.waves.empty() && options.simulate.engine == "rtl";
  const std::string fst = rtl_waves ? options.waves + ".part" : "";
  const PartGuard fst_guard(fst);
  const std::shared_ptr<void> fst_removed(nullptr, [fst](void*) {
    std::error_code ignored;
    if (!fst.empty()) std::filesystem::remove(fst, ignored);
  });
  if (timeline) {
    // The first engine's; a second one runs for the judgement alone.
    options.simulate.make = [&, to = &*timeline](const std::string& name) mutable {
      Timeline* const first = std::exchange(to, nullptr);
      return make_traced(name, settings.config, first, first ? fst : "");
    };
  }

  // Every place is opened before the work, so that a bad one costs no time.
  Outputs outputs;
  outputs.make_folder(options.folder);
  outputs.reserve_input(options.input.name, "INPUT");
  outputs.reserve_input(options.input.gbuffer, "--gbuffer");
  if (!options.no_images) {
    for (const char* name : kPictureNames) outputs.reserve(options.folder + "/" + name, "--out");
  }
  std::ostream& report = outputs.open(options.folder + "/report.json", "--out");
  std::ostream* json =
      options.json.empty() || json_to_stdout ? nullptr : &outputs.open(options.json, "--json");
  std::ostream* verdicts =
      options.verdicts.empty() ? nullptr : &outputs.open(options.verdicts, "--verdicts");

  std::ostream* timeline_file =
      options.timeline.empty() ? nullptr : &outputs.open(options.timeline, "--timeline");
  std::ostream* waves = options.waves.empty() ? nullptr : &outputs.open(options.waves, "--waves");

  Stopwatch watch;
  const Source source = resolve_input(options.input);
  const Scene* scene = std::get_if<Scene>(&source);
  if (options.scene_exact && (!scene || !options.input.gbuffer.empty())) {
    throw UserError("--scene-exact", "rays need the meshes and the camera of a scene",
                    scene ? "leave --gbuffer out" : "run the scene, not its trace");
  }
  const Trace trace = load_trace(source, options.input, settings, options.simulate.progress);
  const double load_s = watch.lap();
  RunResult result = simulate(trace, settings.config, options.simulate);
  result.stages_s.insert(result.stages_s.begin(), {"input", load_s});
  if (result.cycles) result.clock = clock_of(settings.config);

  watch.lap();
  if (options.scene_exact) {
    progress.update("sending rays", 0);
    const LightSpace light_space =
        fit_light_space(*scene, capture_options(options.input, settings));
    result.scene_exact = check_scene(*scene, light_space, trace, result);
    result.stages_s.emplace_back("scene_exact", watch.lap());
  }
  if (!options.no_images) {
    progress.update("writing pictures", 0);
    write_pictures(trace, result, options.folder, outputs);
    result.stages_s.emplace_back("pictures", watch.lap());
  }
  if (verdicts) {
    write_verdicts(trace, result, *verdicts);
    result.stages_s.emplace_back("verdicts", watch.lap());
  }
  if (timeline) {
    add_fragments(result.fragment_cycles, *timeline);
    timeline->finish();
    if (timeline_file) *timeline_file << timeline_json(*timeline);
    if (waves) *waves << (rtl_waves ? text_of_file(fst) : timeline_vcd(*timeline));
  }
  const std::string text = report_json(trace, result).dump(2) + "\n";
  report << text;
  if (json) *json << text;
  outputs.commit();
  progress.clear();
  std::cout << (json_to_stdout ? text : report_table(trace, result, outputs.names()));
}

}  // namespace

void add_run(CLI::App& app) {
  auto options = std::make_shared<RunOptions>();
  options->simulate.engine = "systemc";
  CLI::App& command = *app.add_subcommand(
      "run", "Decides the shadows of a frame as the unit would, and judges every verdict");
  add_input_options(command, options->input, InputUse::kRun);
  add_settings_options(command, options->settings);
  command.add_option("--engine", options->simulate.engine, 
                   "What decides: systemc, which also tells the cycles; golden, which does not; or rtl (the Verilog, simulated)")
      ->type_name("NAME")
      ->capture_default_str()
      ->group("Unit");
  command.add_option("--out", options->folder, "Folder for the pictures and report.json")
      ->type_name("DIR")
      ->capture_default_str()
      ->group("Output");
  command.add_option("--json", options->json, "The report here too; - prints it and nothing else")
      ->type_name("FILE|-")
      ->group("Output");
  command.add_option("--verdicts", options->verdicts, "A line for every fragment, as text")
      ->type_name("FILE")
      ->group("Output");
  command.add_option("--timeline", options->timeline, "What the unit did when, for Perfetto")
      ->type_name("FILE")
      ->group("Output");
  command.add_option("--waves", options->waves,
                     "Waves: VCD of blocks and queues; with --engine rtl FST of every signal")
      ->type_name("FILE")
      ->group("Output");
  command.add_option("--window", options->window, "Cycles of --timeline and --waves")
      ->type_name("A-B")
      ->capture_default_str()
      ->group("Output");
  command.add_option("--window-pass", options->pass, "The pass whose cycles these are")
      ->type_name("1|2")
      ->capture_default_str()
      ->group("Output");
  command.add_flag("--no-images", options->no_images, "No pictures")->group("Output");
  command
      .add_flag("--no-reference", options->no_reference,
                "Does not hold the verdicts against the exact ones")
      ->group("Output");
  command
      .add_flag("--scene-exact", options->scene_exact,
                "Also sends rays to the meshes as they were before snapping")
      ->group("Output");
  command.footer(
      "Examples:\n"
      "  kagesen run                                    the default scene\n"
      "  kagesen run model.glb --scale 16 --set slope_bits=4 --set fraction_bits=4\n"
      "  kagesen run frame.trace --json - --no-images   only the figures, for a script");
  command.callback([options] { run(*options); });
}

}  // namespace kagesen

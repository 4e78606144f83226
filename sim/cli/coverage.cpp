/// kagesen coverage: runs frames on the build with coverage and tells what they reached.
#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <iostream>
#include <memory>

#include "model/frame_setup.h"
#include "sim/cli/commands.h"
#include "sim/cli/lock_step_check.h"
#include "sim/cli/nearest.h"
#include "sim/cli/parse.h"
#include "sim/cli/progress.h"
#include "sim/cli/stopwatch.h"
#include "sim/report/outputs.h"
#include "testbench/coverage/page.h"
#include "testbench/tools/cache.h"
#include "testbench/tools/rtl_sources.h"
#include "testbench/verilator/sources.h"
#include "traces/format/error.h"
#include "traces/format/words.h"
#include "traces/raster/capture.h"
#include "traces/scene/scene.h"

namespace kagesen {
namespace {

using stress::Dice;

struct CoverageArguments {
  std::string profile = "both", minutes = "6", seed = "1", json, page, exclusions;
  bool report_only = false;
};

/// A frame, and how it is run.
struct Round {
  Trace trace;
  UnitConfig config;
  FrameSetup setup;
  std::size_t portions = 0;
  Timing timing;
  bool cuts = false;
  std::uint64_t cut_seed = 0;
};

/// The scenes come first, each at a scale; what follows is drawn.
struct SceneFrame {
  const char* scene;
  double scale;
  std::uint32_t map, width, height;
};
constexpr SceneFrame kSceneFrames[] = {
    {"solids", 1, 64, 96, 54},   {"torus", 16, 64, 64, 36},  {"glyphs", 256, 32, 64, 36},
    {"avenue", 1, 100, 64, 36},  {"slivers", 1, 64, 96, 54}, {"boxes", 16, 64, 64, 36},
    {"solids", 1024, 4, 64, 36}, {"solids", 512, 8, 64, 36}, {"solids", 256, 16, 64, 36},
    {"solids", 128, 32, 32, 18}, {"solids", 64, 32, 32, 18}, {"solids", 32, 32, 32, 18},
    {"solids", 8, 32, 32, 18},   {"solids", 4, 32, 32, 18},  {"solids", 2, 32, 32, 18},
    {"boxes", 256, 8, 64, 36}};
constexpr std::uint64_t kMostWork = 60000;  ///< larger cases are the soak's
constexpr std::size_t kScenes = std::size(kSceneFrames);

class CoverageRun {
 public:
  CoverageRun(Profile profile, std::uint64_t seed)
      : profile_(profile), seed_(seed), bins_(profile), engine_(options()) {
    base_.profile = profile;
    out_.profile = profile == Profile::kPaper ? "paper" : "winding";
  }

  ProfileCoverage run(double seconds, Progress& progress, std::vector<Exclusion>& exclusions) {
    Stopwatch watch;
    engine_.prepare(base_);
    watch.lap();  // building is not running
    sweep_registers();
    for (std::uint64_t number = 0; out_.seconds < seconds; ++number) {
      const Round round = draw(number);
      run(round, number);
      out_.seconds += watch.lap();
      progress.update(fmt::format("{}: frame {}, {}", out_.profile, number + 1,
                                  counted(out_.fragments, "fragment")),
                      out_.seconds / seconds);
    }
    sweep_registers();
    evaluate(exclusions);
    return out_;
  }

 private:
  static RtlOptions options() {
    RtlOptions options;
    options.kind = BuildKind::kCoverage;
    return options;
  }

  /// Every bit of every register, both ways, and addresses that hold none.
  void sweep_registers() {
    bench::Bench& bench = engine_.bench();
    const auto is_readonly = [](unsigned at) { return at == 0; };  // CONTROL starts passes
    for (const std::uint32_t value : {0xffffffffu, 0u, 0xaaaaaaaau, 0x55555555u, 0u}) {
      for (unsigned at = 0; at < 0x100; at += 4) {
        if (!is_readonly(at)) bench.write(static_cast<bench::Register>(at), value);
        bench.read(static_cast<bench::Register>(at));
      }
    }
    bench.write(bench::Register::kControl, 0xffffff00u);
  }

  Round draw(std::uint64_t number) const {
    Dice dice = Dice::of_case(seed_, number);
    Round round;
    round.config = base_;
    const bool hints = !dice.one_in(4);
    if (number < 2 * kScenes && number % 2 == 0) {
      draw_scene(kSceneFrames[number / 2], round);
    } else {
      draw_stress(number, round);
    }
    round.config.profile = profile_;
    if (!dice.one_in(4)) draw_registers(dice, round.config);
    round.config.map_width = round.trace.header.map_width;
    round.config.map_height = round.trace.header.map_height;
    round.setup = stress::frame_setup(round.trace, {round.config, hints});
    round.timing = draw_timing(dice);
    if (dice.one_in(4)) round.portions = static_cast<std::size_t>(dice.in(1, 500));
    round.cuts = dice.one_in(3);
    round.cut_seed = dice.next();
    return round;
  }

  void draw_stress(std::uint64_t number, Round& round) const {
    stress::CaseOptions options;
    options.profile = profile_;
    options.config = base_;
    for (const std::string& key : width_keys()) options.given.insert(key);
    stress::StressCase test = stress::make_case(seed_, number, options);
    if (!test.plan.empty()) round.config = test.plan[number % test.plan.size()].setting.config;
    round.trace = std::move(test.trace);
  }

  static void draw_scene(const SceneFrame& frame, Round& round) {
    CaptureOptions capture;
    capture.map_width = capture.map_height = frame.map;
    capture.scale_x = capture.scale_y = frame.scale;
    capture.image_width = frame.width;
    capture.image_height = frame.height;
    kagesen::capture(make_builtin(frame.scene), capture, round.trace);
  }

  void run(const Round& round, std::uint64_t number) {
    const Frame frame{round.trace, round.config, round.setup, round.portions};
    const Expected expected = expect(frame);
    if (work_of(frame, expected.counters) > kMostWork) return;
    engine_.set_timing(round.timing);
    if (round.cuts && cycles_ && !cut(frame, round)) return;
    engine_.bench().write(bench::Register::kCounterSelect, static_cast<std::uint32_t>(number % 64));
    const LockStepResult result = lock_step(frame, expected, engine_);
    engine_.bench().read(bench::Register::kCounter);
    engine_.bench().read(bench::Register::kCycles);
    engine_.bench().read(bench::Register::kRecords);
    ++out_.frames;
    out_.fragments += result.fragments;
    out_.differences += result.verdict_differences + result.buffer_differences +
                        result.counter_differences + result.failures;
    if (result.failures > 0) engine_.bench().reset();
    if (!result.cycles) return;
    cycles_ = result.cycles;
    const CycleReport& c = *cycles_;
    out_.cycles += c.total();
    bins_.add(frame, expected, c, engine_.bench().events());
  }

  /// About how many cycles it takes without stalls.
  static std::uint64_t work_of(const Frame& frame, const UnitCounters& c) {
    const auto map = static_cast<std::uint64_t>(frame.config.map_width * frame.config.map_height);
    return map / 4 + c.edge_texels + c.span_texels / 4 + c.fragments + c.entries_read;
  }

  /// Cuts the frame short by register and by reset. False: the unit failed.
  bool cut(const Frame& frame, const Round& round) {
    try {
      std::uint64_t seed = round.cut_seed;
      for (const auto how : {bench::Bench::Cut::kAbort, bench::Bench::Cut::kReset}) {
        cut_frame(frame, engine_, how, seed++, *cycles_);
        bins_.add_cut(how);
        ++out_.cut;
      }
      return true;
    } catch (const bench::Failure&) {
      ++out_.differences;
      engine_.bench().reset();
      return false;
    }
  }

  void evaluate(std::vector<Exclusion>& exclusions) {
    const std::string path =
        (std::filesystem::path(build_cache_folder()) / fmt::format("{}.dat.part", out_.profile))
            .string();
    const PartGuard guard(path);
    engine_.bench().write_coverage(path.c_str());
    const std::string counts = read_file(path);
    std::filesystem::remove(path);
    std::map<std::string, std::string> sources;
    for (const SourceText& source : bench_recipe(base_, BuildKind::kCoverage).sources) {
      sources[source.path] = source.text;
    }
    out_.code = summarise(read_coverage(counts, path), out_.profile, sources, exclusions);
    out_.bins = bins_.all();
    for (const Bin& bin : out_.bins) {
      if (bin.count > 0) continue;
      if (Exclusion* e = find_bin_exclusion(exclusions, out_.profile, bin.full_name())) {
        ++e->used;
        out_.excluded_bins.push_back(bin.full_name());
      }
    }
  }

  const Profile profile_;
  const std::uint64_t seed_;
  UnitConfig base_;
  Bins bins_;
  RtlEngine engine_;
  std::optional<CycleReport> cycles_;  // of the frame before: where cuts may fall
  ProfileCoverage out_;
};

std::vector<Profile> profiles_of(const std::string& name) {
  if (name == "both") return {Profile::kPaper, Profile::kWinding};
  if (name == "paper") return {Profile::kPaper};
  if (name == "winding") return {Profile::kWinding};
  throw UserError("--profile", "there is no '" + name + "'",
                  suggestion(name, {"paper", "winding", "both"}));
}

void run_coverage(const CoverageArguments& arguments) {
  const double minutes = parse_number("--minutes", arguments.minutes, 0.01, 1e5);
  const auto seed = static_cast<std::uint64_t>(parse_number("--seed", arguments.seed, 0, 0x1p53));
  const std::vector<Profile> profiles = profiles_of(arguments.profile);
  const std::string file = arguments.exclusions.empty()
                               ? source_folder() + "/testbench/coverage/exclusions.txt"
                               : arguments.exclusions;
  std::vector<Exclusion> exclusions = read_exclusions(read_file(file), file);
  const bool to_stdout = arguments.json == "-";
  std::vector<ProfileCoverage> runs;
  Progress progress(!to_stdout);
  for (const Profile profile : profiles) {
    CoverageRun run(profile, seed);
    runs.push_back(run.run(60 * minutes / double(profiles.size()), progress, exclusions));
  }
  progress.clear();
  const std::string json = coverage_json(runs, exclusions).dump(2) + "\n";
  Outputs outputs;
  if (!to_stdout && !arguments.json.empty()) outputs.write(arguments.json, json, "--json");
  if (!arguments.page.empty()) {
    const std::string command =
        fmt::format("kagesen coverage --profile {} --minutes {} --seed {} --out {}",
                    arguments.profile, arguments.minutes, arguments.seed, arguments.page);
    outputs.write(arguments.page, coverage_page(runs, exclusions, command), "--out");
  }
  outputs.commit();
  std::cout << (to_stdout ? json : coverage_table(runs)) << std::flush;
  if (arguments.report_only) return;
  for (const ProfileCoverage& run : runs) {
    if (!run.reached()) throw CLI::RuntimeError(1);
  }
}

}  // namespace

void add_coverage(CLI::App& app) {
  auto arguments = std::make_shared<CoverageArguments>();
  CLI::App& command = *app.add_subcommand(
      "coverage", "Which lines, branches, bits and situations of the Verilog a run meets");
  const auto add = [&](const char* name, std::string& value, const char* help, const char* type) {
    return command.add_option(name, value, help)->type_name(type);
  };
  add("--profile", arguments->profile, "paper, winding or both", "NAME")->capture_default_str();
  add("--minutes", arguments->minutes, "How long the frames run in all", "N")
      ->capture_default_str();
  add("--seed", arguments->seed, "What the frames are drawn from", "N")->capture_default_str();
  add("--exclusions", arguments->exclusions,
      "What is left out and why (testbench/coverage/exclusions.txt)", "FILE");
  add("--json", arguments->json, "The figures here; - prints them and nothing else", "FILE|-");
  add("--out", arguments->page, "Writes the page, docs/coverage.md", "FILE");
  command.add_flag("--report-only", arguments->report_only,
                   "Exit status 0 also if a goal is missed");
  command.footer("Exit status 1 if a goal is missed, or anything differs from golden.");
  command.callback([arguments] { run_coverage(*arguments); });
}

}  // namespace kagesen

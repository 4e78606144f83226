#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>

#include "sim/cli/commands.h"
#include "sim/cli/curve/measure.h"
#include "sim/cli/curve/plot.h"
#include "sim/cli/curve/table.h"
#include "sim/cli/nearest.h"
#include "sim/cli/progress.h"
#include "sim/report/encode.h"
#include "sim/report/outputs.h"
#include "traces/format/error.h"
#include "traces/format/words.h"
#include "traces/raster/capture.h"
#include "traces/scene/scene.h"

namespace kagesen {
namespace {

namespace fs = std::filesystem;

struct CurveArguments {
  std::string table = "docs/curve.csv", semantics = "paper";
  std::vector<std::string> scenes{"solids"};
  bool quick = false, fresh = false;
};

/// What is varied.
struct Grid {
  std::vector<std::uint64_t> bits{4, 6, 8, 10, 12}, maps{256, 512, 1024, 2048, 4096};
  std::vector<std::uint64_t> scales{1, 4, 16, 64};
  std::uint32_t image_width = 1920, image_height = 1080;
};

Grid grid_of(const CurveArguments& arguments) {
  Grid grid;
  if (arguments.quick) {
    grid.bits = {4, 8};
    grid.maps = {128, 512};
    grid.scales = {1, 16};
    grid.image_width = 320;
    grid.image_height = 180;
  }
  return grid;
}

void check_choice(const std::string& option, const std::string& word,
                  const std::vector<std::string>& choices) {
  if (std::find(choices.begin(), choices.end(), word) != choices.end()) return;
  throw UserError(option, fmt::format("there is no '{}'", word), suggestion(word, choices));
}

void check(const CurveArguments& arguments) {
  std::vector<std::string> names;
  for (const SceneInfo& info : builtin_scenes()) names.push_back(info.name);
  for (const std::string& scene : arguments.scenes) check_choice("--scenes", scene, names);
  check_choice("--semantics", arguments.semantics, {"paper", "physical"});
}

/// The settings of one frame.
std::vector<CurveRow> settings_of(const CurveArguments& arguments, const Grid& grid,
                                  const std::string& scene, std::uint64_t map,
                                  std::uint64_t scale) {
  std::vector<CurveRow> settings;
  for (const char* profile : {"paper", "winding"}) {
    for (const std::uint64_t bits : grid.bits) {
      CurveRow row;
      row.scene = scene;
      row.profile = profile;
      // The published unit has no other.
      row.semantics = profile == std::string("paper") ? "paper" : arguments.semantics;
      row.fraction_bits = row.slope_bits = bits;
      row.map = map;
      row.scale = scale;
      row.image = fmt::format("{}x{}", grid.image_width, grid.image_height);
      settings.push_back(row);
    }
  }
  return settings;
}

/// Every setting with a row is done; the others are measured and join the file one by one.
class CurveRun {
 public:
  explicit CurveRun(const CurveArguments& arguments)
      : arguments_(arguments), grid_(grid_of(arguments)), progress_(true) {
    rows_ = read_curve_csv(arguments.table);
    if (!arguments.fresh) return;
    each_frame([&](const std::string&, std::uint64_t, std::uint64_t,
                   const std::vector<CurveRow>& settings) {
      for (const CurveRow& s : settings) {
        if (const CurveRow* row = find(s)) rows_.erase(rows_.begin() + (row - rows_.data()));
      }
    });
  }

  void run() {
    save();  // a place that cannot be written to is found before any work
    each_frame([&](const std::string&, std::uint64_t, std::uint64_t,
                   const std::vector<CurveRow>& settings) {
      for (const CurveRow& s : settings) (find(s) ? kept_ : missing_) += 1;
    });
    each_frame([&](const std::string& scene, std::uint64_t map, std::uint64_t scale,
                   const std::vector<CurveRow>& settings) {
      if (std::all_of(settings.begin(), settings.end(),
                      [&](const CurveRow& s) { return find(s) != nullptr; })) {
        return;
      }
      const Trace trace = frame(scene, map, scale);
      for (const CurveRow& setting : settings) {
        if (find(setting)) continue;
        show(setting);
        rows_.push_back(measure_point(trace, setting));
        ++done_;
        save();
      }
    });
    finish();
  }

 private:
  fs::path folder() const {
    const fs::path path(arguments_.table);
    return path.has_parent_path() ? path.parent_path() : ".";
  }

  template <class Visit>
  void each_frame(Visit visit) const {
    for (const std::string& scene : arguments_.scenes) {
      for (const std::uint64_t map : grid_.maps) {
        for (const std::uint64_t scale : grid_.scales) {
          visit(scene, map, scale, settings_of(arguments_, grid_, scene, map, scale));
        }
      }
    }
  }

  const CurveRow* find(const CurveRow& setting) const {
    const auto at = std::find_if(rows_.begin(), rows_.end(),
                                 [&](const CurveRow& r) { return r.same_setting(setting); });
    return at == rows_.end() ? nullptr : &*at;
  }

  Trace frame(const std::string& scene, std::uint64_t map, std::uint64_t scale) const {
    CaptureOptions options;
    options.image_width = grid_.image_width;
    options.image_height = grid_.image_height;
    options.map_width = options.map_height = std::uint32_t(map);
    options.scale_x = options.scale_y = double(scale);
    Trace trace;
    capture(make_builtin(scene), options, trace);
    return trace;
  }

  void show(const CurveRow& s) {
    progress_.update(fmt::format("{}, map {}, scale {}, {}, {} bits: {} of {},", s.scene, s.map,
                                 s.scale, s.profile, s.fraction_bits, done_ + 1, missing_),
                     double(done_) / double(missing_));
  }

  /// The file is whole at every moment, so an interruption loses one row at most.
  void save() const {
    Outputs outputs;
    outputs.make_folder(folder().string());
    outputs.write(arguments_.table, curve_csv(rows_), "--out");
    outputs.commit();
  }

  /// "curve.png", or "curve-NAME.png" where there are several scenes.
  std::string picture_of(const std::string& scene) const {
    const fs::path table(arguments_.table);
    const std::string suffix = arguments_.scenes.size() > 1 ? "-" + scene : "";
    return (table.parent_path() / "images" / (table.stem().string() + suffix + ".png")).string();
  }

  void finish() {
    Outputs outputs;
    outputs.make_folder((folder() / "images").string());
    for (const std::string& scene : arguments_.scenes) {
      std::vector<CurveRow> wanted;
      each_frame([&](const std::string& name, std::uint64_t, std::uint64_t,
                     const std::vector<CurveRow>& settings) {
        if (name != scene) return;
        for (const CurveRow& s : settings) wanted.push_back(*find(s));
      });
      outputs.write(picture_of(scene), encode_png(curve_plot(wanted)));
    }
    outputs.commit();
    progress_.clear();
    std::cout << fmt::format("{}: {} measured, {} kept\n", arguments_.table, counted(done_, "row"),
                             kept_);
    for (const std::string& name : outputs.names()) std::cout << name << "\n";
  }

  const CurveArguments& arguments_;
  const Grid grid_;
  Progress progress_;
  std::vector<CurveRow> rows_;
  std::size_t kept_ = 0, missing_ = 0, done_ = 0;
};

}  // namespace

void add_curve(CLI::App& app) {
  auto arguments = std::make_shared<CurveArguments>();
  CLI::App& command = *app.add_subcommand(
      "curve", "Measures run time against error over widths, map sizes, scales and profiles");
  command
      .add_option("--out", arguments->table,
                  "The table, as CSV; rows that it has are kept. Its plot goes into images/ beside "
                  "it")
      ->type_name("FILE")
      ->capture_default_str();
  command.add_option("--scenes", arguments->scenes, "Built-in scenes, with commas between them")
      ->type_name("NAME,...")
      ->delimiter(',')
      ->capture_default_str();
  command
      .add_option("--semantics", arguments->semantics,
                  "Of the winding profile: paper, as the other profile, or physical")
      ->type_name("NAME")
      ->capture_default_str();
  command.add_flag("--quick", arguments->quick, "Small frames and few settings, for a look");
  command.add_flag("--fresh", arguments->fresh, "Measures rows again that the table has");
  command.footer("Interrupt it at will: called again, it goes on where it was.");
  command.callback([arguments] {
    check(*arguments);
    CurveRun(*arguments).run();
  });
}

}  // namespace kagesen

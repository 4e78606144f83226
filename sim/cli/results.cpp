#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>

#include "sim/cli/commands.h"
#include "sim/cli/nearest.h"
#include "sim/cli/progress.h"
#include "sim/cli/results/gather.h"
#include "sim/cli/results/page.h"
#include "sim/cli/results/winding_page.h"
#include "sim/report/encode.h"
#include "sim/report/outputs.h"
#include "traces/format/error.h"
#include "traces/scene/scene.h"

namespace kagesen {
namespace {

struct ResultsArguments {
  std::string page = "docs/results.md";
  std::vector<std::string> scenes;
  bool quick = false;
};

void check_scenes(std::vector<std::string>& scenes) {
  std::vector<std::string> names;
  for (const SceneInfo& info : builtin_scenes()) names.push_back(info.name);
  if (scenes.empty()) scenes = names;
  for (const std::string& scene : scenes) {
    if (std::find(names.begin(), names.end(), scene) != names.end()) continue;
    throw UserError("--scenes", fmt::format("there is no built-in scene '{}'", scene),
                    suggestion(scene, names));
  }
}

void write_results(const ResultsArguments& arguments) {
  Progress progress(true);
  ResultsOptions options;
  options.scenes = arguments.scenes;
  check_scenes(options.scenes);
  options.progress = progress.callback();
  if (arguments.quick) {
    options.scales = {1, 16};
    options.image_width = 480;
    options.image_height = 270;
  }
  Outputs outputs;
  const std::filesystem::path page(arguments.page);
  const std::filesystem::path folder = page.has_parent_path() ? page.parent_path() : ".";
  outputs.make_folder((folder / "images").string());
  std::ostream& text = outputs.open(arguments.page);
  // A file that is of no use is found before the work, not after it.
  const std::string stress = stress_section((folder / "stress.json").string());

  const std::vector<SceneResults> results = gather_results(options);
  text << results_page(results, options, "images", stress);
  for (const SceneResults& scene : results) {
    outputs.write((folder / "images" / (scene.name + ".png")).string(), encode_png(scene.sheet));
  }
  outputs.commit();
  progress.clear();
  for (const std::string& name : outputs.names()) std::cout << name << "\n";
}

}  // namespace

void add_results(CLI::App& app) {
  auto arguments = std::make_shared<ResultsArguments>();
  CLI::App& command = *app.add_subcommand(
      "results", "Measures the built-in scenes in both profiles and writes docs/results.md");
  command.add_option("--out", arguments->page, "The page; its pictures go into images/ beside it")
      ->type_name("FILE")
      ->capture_default_str();
  command.add_option("--scenes", arguments->scenes, "Only these, with commas between them")
      ->type_name("NAME,...")
      ->delimiter(',');
  command.add_flag("--quick", arguments->quick, "Small frames and two scales, for a look");
  command.callback([arguments] { write_results(*arguments); });
}

}  // namespace kagesen

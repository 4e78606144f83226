#include <fmt/format.h>

#include <algorithm>
#include <iostream>

#include "sim/cli/commands.h"
#include "traces/scene/scene.h"

namespace kagesen {

void add_scenes(CLI::App& app) {
  CLI::App& command = *app.add_subcommand("scenes", "Lists the built-in scenes");
  command.callback([] {
    const std::vector<SceneInfo> scenes = builtin_scenes();
    std::size_t width = 0;
    for (const SceneInfo& scene : scenes) width = std::max(width, scene.name.size());
    for (const SceneInfo& scene : scenes) {
      std::cout << fmt::format("{:<{}}  {}\n", scene.name, width, scene.description);
    }
  });
}

}  // namespace kagesen

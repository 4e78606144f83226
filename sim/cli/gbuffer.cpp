#include "traces/raster/gbuffer.h"

#include <memory>

#include "sim/cli/commands.h"
#include "sim/cli/input.h"
#include "sim/cli/progress.h"
#include "sim/report/outputs.h"
#include "traces/format/error.h"

namespace kagesen {
namespace {

struct GBufferArguments {
  InputOptions input;
  std::string output;
};

void write(const GBufferArguments& arguments) {
  Progress progress(true);
  Settings settings;
  Outputs names;
  names.reserve_input(arguments.input.name, "INPUT");
  names.reserve(arguments.output, "OUTPUT");
  const Source source = resolve_input(arguments.input);
  const Scene* scene = std::get_if<Scene>(&source);
  if (!scene) {
    throw UserError(arguments.input.name, "is a trace, which has no positions in the world",
                    "name a mesh or a built-in scene");
  }
  CaptureOptions capture = capture_options(arguments.input, settings);
  capture.progress = progress.callback();
  PartGuard guard(arguments.output + ".part");
  write_gbuffer(*scene, capture, arguments.output);
}

}  // namespace

void add_gbuffer(CLI::App& app) {
  auto arguments = std::make_shared<GBufferArguments>();
  CLI::App& command = *app.add_subcommand(
      "gbuffer", "Writes what the camera sees as an EXR of positions, normals and object IDs");
  add_input_options(command, arguments->input, InputUse::kGBuffer);
  command.add_option("OUTPUT", arguments->output, "The EXR to write")->required();
  command.footer("kagesen run SCENE --gbuffer FILE reads it back, as it reads any renderer's.");
  command.callback([arguments] { write(*arguments); });
}

}  // namespace kagesen

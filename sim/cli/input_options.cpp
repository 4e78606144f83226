#include "sim/cli/input.h"

namespace kagesen {

void add_input_options(CLI::App& command, InputOptions& options, InputUse use) {
  const bool run = use == InputUse::kRun, gbuffer = use == InputUse::kGBuffer;
  command
      .add_option("INPUT", options.name,
                  run ? "A built-in scene (kagesen scenes), a mesh file (OBJ, PLY, glTF, GLB) "
                        "or a trace; default: the first built-in scene"
                      : "A built-in scene (kagesen scenes) or a mesh file (OBJ, PLY, glTF, GLB)")
      ->required(!run);
  const auto add = [&](const char* name, std::string& value, const char* type, const char* help,
                       const char* group) {
    return command.add_option(name, value, help)->type_name(type)->group(group);
  };
  add("--image", options.image, "WxH", "Pixels of the camera's image (1920x1080)", "Capture");
  if (!gbuffer) {
    add("--map", options.map, "N|WxH", "Texels of the shadow map (1024)", "Capture");
    add("--scale", options.scale, "N|NxM",
        run ? "Virtual projection space: the map covers N times more an axis, 1 to 1024 (1); of a "
              "trace, a power of two"
            : "Virtual projection space: the map covers N times more an axis, 1 to 1024 (1)",
        "Capture");
    add("--mode", options.mode, "MODE", "Fragments of pass 2: visible, early-z or all (visible)",
        "Capture");
    add("--gbuffer", options.gbuffer, "EXR",
        "Takes pass 2 from a rendered frame with position and object-ID channels", "Capture");
  }

  add("--ids", options.ids, "WHO",
      "Objects of a mesh file: auto, file (its own) or components (connected) (auto)", "Scene");
  add("--ground", options.ground, "WHEN",
      "A receiving plane below the meshes of a file: auto, on or off (auto)", "Scene");
  add("--light-kind", options.light_kind, "KIND",
      "directional, spot, or point (within one frustum)", "Scene");
  add("--light-direction", options.light_direction, "X,Y,Z", "The way the light travels", "Scene");
  add("--light-position", options.light_position, "X,Y,Z", "Of a spot or point light", "Scene");
  add("--spread", options.spread, "DEGREES", "Full angle of a spot or point light's frustum",
      "Scene");
  add("--camera-eye", options.camera_eye, "X,Y,Z", "Where the camera stands", "Scene");
  add("--camera-target", options.camera_target, "X,Y,Z", "What it looks at", "Scene");
  add("--fov", options.fov, "DEGREES", "Its vertical field of view", "Scene");
}

}  // namespace kagesen

#include "sim/cli/input.h"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <limits>
#include <vector>

#include "sim/cli/nearest.h"
#include "sim/cli/parse.h"
#include "traces/format/error.h"
#include "traces/format/trace_file.h"
#include "traces/format/words.h"

namespace kagesen {
namespace {

namespace fs = std::filesystem;

constexpr std::uint32_t kMaxImageSide = 16384;

/// The value whose name was typed. Throws UserError with the nearest name.
template <class Value>
Value choose(const std::string& option, const std::string& word,
             const std::vector<std::pair<std::string, Value>>& choices) {
  std::vector<std::string> names;
  for (const auto& [name, value] : choices) {
    if (name == word) return value;
    names.push_back(name);
  }
  throw UserError(option, fmt::format("there is no '{}'", word), suggestion(word, names));
}

ImportOptions import_options(const InputOptions& options) {
  using Ids = ImportOptions::Ids;
  using Ground = ImportOptions::Ground;
  ImportOptions import;
  if (!options.ids.empty()) {
    import.ids = choose<Ids>("--ids", options.ids, {{"auto", Ids::kAuto}, {"file", Ids::kFile}, {
                                                      "components",
                                                      Ids::kComponents
                                                    }});
  }
  if (!options.ground.empty()) {
    import.ground = choose<Ground>("--ground", options.ground,
                                   {{"auto", Ground::kAuto},
                                    {"on", Ground::kOn},
                                    { "off",
                                      Ground::kOff }});
  }
  return import;
}

/// The middle of what casts shadows, or of everything where nothing does.
glm::dvec3 middle(const Scene& scene) {
  for (const bool casters_only : {true, false}) {
    glm::dvec3 low(std::numeric_limits<double>::infinity()), high(-low);
    for (const Object& object : scene.objects) {
      if (casters_only && !object.caster) continue;
      for (const glm::dvec3& position : object.positions) {
        low = glm::min(low, position);
        high = glm::max(high, position);
      }
    }
    if (low.x <= high.x) return (low + high) / 2.0;
  }
  return glm::dvec3(0);
}

void apply_camera(const InputOptions& options, Camera& camera) {
  if (!options.camera_eye.empty()) camera.eye = parse_vector("--camera-eye", options.camera_eye);
  if (!options.camera_target.empty()) {
    camera.target = parse_vector("--camera-target", options.camera_target);
  }
  if (!options.fov.empty()) {
    camera.vertical_fov_degrees = parse_number("--fov", options.fov, 0.1, 179);
  }
  if (camera.eye == camera.target) {
    throw UserError("--camera-eye", "the camera stands where it looks",
                    "move --camera-eye or --camera-target");
  }
}

void apply_light(const InputOptions& options, Scene& scene) {
  using Kind = Light::Kind;
  Light& light = scene.light;
  const Kind before = light.kind;
  if (!options.light_kind.empty()) {
    light.kind = choose<Kind>(
        "--light-kind", options.light_kind,
        {{"directional", Kind::kDirectional}, {"spot", Kind::kSpot}, {"point", Kind::kPoint}});
  }
  const bool directional = light.kind == Kind::kDirectional;
  if (directional && (!options.light_position.empty() || !options.spread.empty())) {
    throw UserError(options.spread.empty() ? "--light-position" : "--spread",
                    "a directional light has none", "add --light-kind spot or point");
  }
  if (!directional && before != light.kind && options.light_position.empty()) {
    throw UserError("--light-kind", "a spot or point light stands somewhere",
                    "add --light-position X,Y,Z");
  }
  if (!options.light_position.empty()) {
    light.position = parse_vector("--light-position", options.light_position);
    // A light that was moved still looks at the scene unless told otherwise.
    light.direction = middle(scene) - light.position;
  }
  if (!options.light_direction.empty()) {
    light.direction = parse_vector("--light-direction", options.light_direction);
  }
  if (!options.spread.empty()) {
    light.spread_degrees = parse_number("--spread", options.spread, 0.1, 175);
  }
  if (glm::dot(light.direction, light.direction) == 0) {
    throw UserError("--light-direction", "has no length", "give a direction such as 0,-1,0");
  }
}

/// The first option given that has no meaning for this kind of input; empty if none was.
std::string first_given(const std::vector<std::pair<const char*, const std::string*>>& options) {
  for (const auto& [name, value] : options) {
    if (!value->empty()) return name;
  }
  return {};
}

void refuse_scene_options(const InputOptions& o, const std::string& path) {
  const std::string given = first_given({{"--image", &o.image},
                                         {"--map", &o.map},
                                         {"--mode", &o.mode},
                                         {"--gbuffer", &o.gbuffer},
                                         {"--ids", &o.ids},
                                         {"--ground", &o.ground},
                                         {"--light-kind", &o.light_kind},
                                         {"--light-direction", &o.light_direction},
                                         {"--light-position", &o.light_position},
                                         {"--spread", &o.spread},
                                         {"--camera-eye", &o.camera_eye},
                                         {"--camera-target", &o.camera_target},
                                         {"--fov", &o.fov}});
  if (given.empty()) return;
  throw UserError(given, fmt::format("{} is a trace, which is captured already", path),
                  "leave the option out, or capture the scene again");
}

}  // namespace

Source resolve_input(const InputOptions& options) {
  const std::vector<SceneInfo> builtin = builtin_scenes();
  const std::string name = options.name.empty() ? builtin.front().name : options.name;
  std::error_code error;
  const fs::file_status status = fs::status(name, error);
  const bool is_file = fs::exists(status) && !fs::is_directory(status);
  if (is_file && is_trace_file(name)) {
    refuse_scene_options(options, name);
    return TracePath{name};
  }
  if (!options.gbuffer.empty()) {
    const std::string given = first_given({{"--image", &options.image}, {"--mode", &options.mode}});
    if (!given.empty()) {
      throw UserError(given, "the pixels of --gbuffer are taken as they are", "leave it out");
    }
  }
  Scene scene;
  if (is_file) {
    scene = import_mesh(name, import_options(options));
  } else {
    bool known = false;
    for (const SceneInfo& info : builtin) known = known || info.name == name;
    if (!known && fs::is_directory(status)) {
      throw UserError(name, "is a folder", "name a mesh file, a trace or a built-in scene");
    }
    if (!known && name.find_first_of("./") != std::string::npos) {
      throw UserError(name, "there is no such file",
                      "check the name; built-in scenes are listed by kagesen scenes");
    }
    const std::string given = first_given({{"--ids", &options.ids}, {"--ground", &options.ground}});
    if (known && !given.empty()) {
      throw UserError(given, "is for mesh files only", "leave it out");
    }
    scene = make_builtin(name);
  }
  apply_camera(options, scene.camera);
  apply_light(options, scene);
  return scene;
}

CaptureOptions capture_options(const InputOptions& options, Settings& settings) {
  CaptureOptions capture;
  if (!options.image.empty()) {
    std::tie(capture.image_width, capture.image_height) =
        parse_size("--image", options.image, kMaxImageSide);
  }
  if (!options.map.empty()) {
    const auto [width, height] = parse_size("--map", options.map, kMaxMapSide);
    settings.config.map_width = width;
    settings.config.map_height = height;
  }
  capture.map_width = static_cast<std::uint32_t>(settings.config.map_width);
  capture.map_height = static_cast<std::uint32_t>(settings.config.map_height);
  if (!options.scale.empty()) {
    std::tie(capture.scale_x, capture.scale_y) = parse_scale("--scale", options.scale);
  }
  if (!options.mode.empty()) {
    capture.mode = choose<FragmentMode>("--mode", options.mode,
                                        {{"visible", FragmentMode::kVisible},
                                         {"early-z", FragmentMode::kEarlyZ},
                                         {"all", FragmentMode::kAll}});
  }
  return capture;
}

void capture_into(const Scene& scene, const InputOptions& options, const CaptureOptions& capture,
                  TraceSink& sink) {
  if (options.gbuffer.empty()) {
    kagesen::capture(scene, capture, sink);
  } else {
    capture_gbuffer(scene, options.gbuffer, capture, sink);
  }
}

Trace load_trace(const Source& source, const InputOptions& options, Settings& settings,
                 const ProgressCallback& progress) {
  Trace trace;
  if (const auto* file = std::get_if<TracePath>(&source)) {
    if (progress) progress("reading " + file->path, 0);
    read_trace(file->path, trace);
    if (!options.scale.empty()) rescale(trace, options.scale);
    const TraceHeader& header = trace.header;
    const auto agree = [&](const char* key, std::int64_t& value, std::uint32_t captured) {
      if (settings.given.count(key) && value != captured) {
        throw UserError(key,
                        fmt::format("{} was captured for a map of {} x {} texels", file->path,
                                    header.map_width, header.map_height),
                        "leave the key out, or capture the scene again");
      }
      value = captured;
    };
    agree("map_width", settings.config.map_width, header.map_width);
    agree("map_height", settings.config.map_height, header.map_height);
  } else {
    CaptureOptions capture = capture_options(options, settings);
    capture.progress = progress;
    capture_into(std::get<Scene>(source), options, capture, trace);
  }
  return trace;
}

void rescale(Trace& trace, const std::string& scale) {
  const auto [x, y] = parse_scale("--scale", scale);
  int exponent = 0;
  if (x != y || std::frexp(x, &exponent) != 0.5) {
    throw UserError("--scale " + scale, "a trace is re-read at one power of two for both axes",
                    "use 1, 2, 4, ... or capture the scene again");
  }
  TraceHeader& header = trace.header;
  const std::uint32_t more = static_cast<std::uint32_t>(exponent - 1);
  if (header.fraction_bits + more > kMaxFractionBits || header.scale_x * x > 1024 ||
      header.scale_y * y > 1024) {
    throw UserError(
        "--scale " + scale,
        fmt::format("the trace has scale {:g} x {:g} and {} already", header.scale_x,
                    header.scale_y, counted(header.fraction_bits, "fraction bit")),
        fmt::format("at most scale {}",
                    1u << (kMaxFractionBits -
                           std::min<std::uint32_t>(header.fraction_bits, kMaxFractionBits))));
  }
  header.fraction_bits += more;
  header.scale_x *= x;
  header.scale_y *= y;
}

}  // namespace kagesen

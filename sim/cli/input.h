#pragma once
/// The input of a run: a trace file, a mesh file or a built-in scene, and how it is captured.
#include <CLI/CLI.hpp>
#include <functional>
#include <optional>
#include <string>
#include <variant>

#include "sim/cli/settings.h"
#include "traces/format/records.h"
#include "traces/raster/capture.h"
#include "traces/scene/scene.h"

namespace kagesen {

/// As typed; empty where the option was not given.
struct InputOptions {
  std::string name;
  std::string scale, map, image, mode, ids, ground, gbuffer;
  std::string light_kind, light_direction, light_position, spread;
  std::string camera_eye, camera_target, fov;
};
/// What a command makes of its input.
enum class InputUse {
  kRun,      ///< decides its shadows; a trace will do, and without INPUT the first built-in scene
  kTrace,    ///< captures it; INPUT is required
  kGBuffer,  ///< renders it, which takes no light space; INPUT is required
};
/// Adds the positional INPUT and the options of the scene, the camera, the light and the capture
/// that `use` has a meaning for.
void add_input_options(CLI::App& command, InputOptions& options, InputUse use);

struct TracePath {
  std::string path;
};
using Source = std::variant<TracePath, Scene>;

/// Finds the input and, for a scene, applies the camera and light options. Throws UserError.
Source resolve_input(const InputOptions& options);

/// How to capture a scene. `settings` gives the map's size, and takes it from --map.
CaptureOptions capture_options(const InputOptions& options, Settings& settings);

/// Captures the scene into the sink, by the camera or from a G-buffer.
void capture_into(const Scene& scene, const InputOptions& options, const CaptureOptions& capture,
                  TraceSink& sink);

using ProgressCallback = std::function<void(const std::string&, double)>;

/// The whole input in memory; the map's size in `settings` agrees with it afterwards.
Trace load_trace(const Source& source, const InputOptions& options, Settings& settings,
                 const ProgressCallback& progress);

/// Reads the same integers as a map that covers `scale` times more an axis. Throws UserError unless
/// scale is one power of two that leaves the trace at most kMaxFractionBits.
void rescale(Trace& trace, const std::string& scale);

}  // namespace kagesen

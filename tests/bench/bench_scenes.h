#pragma once
/// Frames that the benchmarks share, captured once each.
#include <map>
#include <string>

#include "traces/raster/capture.h"
#include "traces/scene/scene.h"

namespace kagesen {

inline const Trace& scene_trace(const std::string& name) {
  static std::map<std::string, Trace> traces;
  const auto [found, fresh] = traces.try_emplace(name);
  if (fresh) capture(make_builtin(name), CaptureOptions{}, found->second);
  return found->second;
}

inline const Trace& default_trace() { return scene_trace(builtin_scenes().front().name); }

}  // namespace kagesen

#pragma once
/// What the tests of scenes and captures share.
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <tuple>
#include <vector>

#include "traces/format/error.h"
#include "traces/raster/capture.h"
#include "traces/scene/scene.h"
#include "traces/scene/topology.h"

namespace kagesen {

inline auto key(const LightPoint& p) { return std::make_tuple(p.x, p.y, p.z); }
inline auto key(const Caster& c) {
  return std::make_tuple(key(c.vertex[0]), key(c.vertex[1]), key(c.vertex[2]), c.object, c.polygon);
}
inline auto key(const Fragment& f) {
  return std::make_tuple(f.pixel_y, f.pixel_x, f.object, key(f.position), f.shade, f.flags);
}

template <typename Records>
auto keys(const Records& records) {
  std::vector<decltype(key(records.front()))> all;
  for (const auto& r : records) all.push_back(key(r));
  return all;
}

/// what() of the UserError that `act` throws, or "" where it throws none.
template <typename Act>
std::string user_error(Act&& act) {
  try {
    act();
  } catch (const UserError& error) {
    return error.what();
  }
  return "";
}

/// A directory that goes when the test does.
class TemporaryDirectory {
 public:
  TemporaryDirectory() {
    std::string pattern = (std::filesystem::temp_directory_path() / "kagesen-XXXXXX").string();
    path_ = mkdtemp(pattern.data());
  }
  ~TemporaryDirectory() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  std::string file(const std::string& name) const { return path_ + "/" + name; }
  std::string write(const std::string& name, const std::string& content) const {
    std::ofstream(file(name), std::ios::binary) << content;
    return file(name);
  }

 private:
  std::string path_;
};

/// One object of loose triangles, seen from above (+y), lit straight down.
inline Scene flat_scene(const std::vector<std::array<glm::dvec3, 3>>& triangles) {
  Scene scene;
  scene.name = "test";
  Object object;
  object.name = "loose";
  for (const auto& t : triangles) {
    const auto base = static_cast<std::uint32_t>(object.positions.size());
    object.positions.insert(object.positions.end(), t.begin(), t.end());
    object.triangles.push_back({base, base + 1, base + 2});
  }
  scene.objects.push_back(std::move(object));
  scene.camera.eye = {0, 10, 0};
  scene.camera.target = {0, 0, 0};
  scene.camera.up = {0, 0, -1};
  scene.light.direction = {0, -1, 0};
  return scene;
}

inline CaptureOptions small_options(std::uint32_t width = 320, std::uint32_t height = 180) {
  CaptureOptions options;
  options.image_width = width;
  options.image_height = height;
  return options;
}

inline Trace captured(const Scene& scene, const CaptureOptions& options) {
  Trace trace;
  capture(scene, options, trace);
  return trace;
}

}  // namespace kagesen

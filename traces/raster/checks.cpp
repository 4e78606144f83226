#include "traces/raster/checks.h"

#include <fmt/format.h>

#include <cmath>

#include "traces/format/error.h"

namespace kagesen {
namespace {

bool finite(const glm::dvec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

void check_options(const CaptureOptions& o) {
  if (o.image_width < 1 || o.image_height < 1 || o.image_width > kMaxImageSide ||
      o.image_height > kMaxImageSide) {
    throw UserError("image size", fmt::format("{} x {} pixels", o.image_width, o.image_height),
                    fmt::format("give 1 to {} a side", kMaxImageSide));
  }
  if (o.map_width < 1 || o.map_height < 1 || o.map_width > kMaxMapSide ||
      o.map_height > kMaxMapSide) {
    throw UserError("map size", fmt::format("{} x {} texels", o.map_width, o.map_height),
                    fmt::format("give 1 to {} a side", kMaxMapSide));
  }
  for (const double scale : {o.scale_x, o.scale_y}) {
    if (!(scale >= 1 && scale <= 1024)) {
      throw UserError("scale", fmt::format("{} x {}", o.scale_x, o.scale_y),
                      "give 1 to 1024 an axis");
    }
  }
}

void check_camera(const Camera& camera) {
  if (!finite(camera.eye) || !finite(camera.target) || !finite(camera.up)) {
    throw UserError("camera", "a coordinate is not a finite number", "give finite coordinates");
  }
  if (!(glm::length(camera.target - camera.eye) > 0)) {
    throw UserError("camera", "it stands on its own target", "move the eye or the target");
  }
  if (!(camera.vertical_fov_degrees > 0 && camera.vertical_fov_degrees < 180)) {
    throw UserError("camera",
                    fmt::format("a field of view of {} degrees", camera.vertical_fov_degrees),
                    "give more than 0 and less than 180");
  }
  if (!(camera.near_plane >= 0) || !std::isfinite(camera.near_plane)) {
    throw UserError("camera", fmt::format("a near plane at {}", camera.near_plane),
                    "give a distance above 0, or 0 to have it fitted");
  }
}

void check_light(const Light& light) {
  if (!finite(light.position) || !finite(light.direction) || !finite(light.target) ||
      !(light.half_extent >= 0) || !std::isfinite(light.half_extent)) {
    throw UserError("light", "a value is negative or not a finite number", "give finite values");
  }
  if (!(glm::length(light.direction) > 0)) {
    throw UserError("light", "its direction is zero", "give the way the light travels");
  }
  if (light.kind != Light::Kind::kDirectional &&
      !(light.spread_degrees > 0 && light.spread_degrees < 170)) {
    throw UserError("light", fmt::format("a spread of {} degrees", light.spread_degrees),
                    "give more than 0 and less than 170");
  }
}

}  // namespace

void check_capture(const Scene& scene, const CaptureOptions& options) {
  check_options(options);
  if (scene.triangle_count() == 0) {
    throw UserError(scene.name.empty() ? "scene" : scene.name, "it has no triangles",
                    "give a mesh with faces");
  }
  check_camera(scene.camera);
  check_light(scene.light);
}

std::string describe_light(const Light& light) {
  switch (light.kind) {
    case Light::Kind::kDirectional:
      return "directional";
    case Light::Kind::kSpot:
      return fmt::format("spot, {:g} degrees", light.spread_degrees);
    case Light::Kind::kPoint:
      return fmt::format("point, {:g} degrees", light.spread_degrees);
  }
  return "unknown";
}

}  // namespace kagesen

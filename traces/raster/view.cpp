#include "traces/raster/view.h"

#include <cmath>

#include "traces/scene/fit.h"

namespace kagesen {

View::View(const Scene& scene, int width, int height)
    : eye_(scene.camera.eye), width_(width), height_(height) {
  const Camera& camera = scene.camera;
  forward_ = glm::normalize(camera.target - camera.eye);
  glm::dvec3 right = glm::cross(forward_, camera.up);
  // Looking along `up`: any other hint will do.
  if (!(glm::length(right) > 1e-9 * glm::length(camera.up))) {
    right = glm::cross(forward_,
                       std::abs(forward_.z) < 0.9 ? glm::dvec3(0, 0, -1) : glm::dvec3(1, 0, 0));
  }
  right = glm::normalize(right);
  const glm::dvec3 up = glm::cross(right, forward_);
  const double pixel =
      2 * std::tan(glm::radians(camera.vertical_fov_degrees) / 2) / height;  // at distance 1
  step_x_ = right * pixel;
  step_y_ = -up * pixel;
  corner_ = forward_ - step_x_ * (0.5 * width) - step_y_ * (0.5 * height);
  row_x_ = right / pixel + forward_ * (0.5 * width);
  row_y_ = -up / pixel + forward_ * (0.5 * height);
  near_ = camera.near_plane;
  if (!(near_ > 0)) {
    const double size = caster_bounds(scene).diagonal();
    near_ = 1e-5 * (size > 0 ? size : glm::length(camera.target - camera.eye));
  }
}

glm::dvec4 View::project(const glm::dvec3& world) const {
  const glm::dvec3 q = world - eye_;
  return {glm::dot(row_x_, q), glm::dot(row_y_, q), 1, glm::dot(forward_, q)};
}

int View::to_screen(const std::array<glm::dvec4, 3>& projected,
                    std::array<ScreenPoint, 16>& corners) const {
  ClipPolygon polygon;
  bool near_cut = false, guard_cut = false;
  constexpr double kGuard = static_cast<double>(kGuardPixels);
  for (const glm::dvec4& v : projected) {
    polygon.push(v);
    near_cut = near_cut || !(v.w >= near_);
    guard_cut = guard_cut || !(std::abs(v.x) <= kGuard * v.w && std::abs(v.y) <= kGuard * v.w);
  }
  if (near_cut) polygon = clip(polygon, glm::dvec4(0, 0, -near_, 1));
  if (near_cut || guard_cut) {
    for (const glm::dvec4& side : {glm::dvec4(1, 0, 0, kGuard), glm::dvec4(-1, 0, 0, kGuard),
                                   glm::dvec4(0, 1, 0, kGuard), glm::dvec4(0, -1, 0, kGuard)}) {
      polygon = clip(polygon, side);
    }
  }
  if (polygon.count < 3) return 0;
  for (int i = 0; i < polygon.count; ++i) {
    const glm::dvec4& v = polygon.vertex[static_cast<std::size_t>(i)];
    const auto snap = [&](double p) {
      return static_cast<std::int64_t>(std::floor(p / v.w * kSubpixels + 0.5));
    };
    corners[static_cast<std::size_t>(i)] = {snap(v.x), snap(v.y)};
  }
  return polygon.count;
}

}  // namespace kagesen

#include "traces/scene/fit.h"

#include <algorithm>
#include <cmath>

namespace kagesen {
namespace {

template <typename Visit>
void visit_vertices(const Scene& scene, bool casters_only, Visit visit) {
  for (const Object& object : scene.objects) {
    if (casters_only && !object.caster) continue;
    for (const auto& t : object.triangles) {
      for (const std::uint32_t v : t) visit(object.positions[v]);
    }
  }
}

Bounds bounds_of(const Scene& scene, bool casters_only) {
  Bounds bounds;
  visit_vertices(scene, casters_only, [&](const glm::dvec3& p) {
    bounds.low = glm::min(bounds.low, p);
    bounds.high = glm::max(bounds.high, p);
  });
  return bounds;
}

/// Where a ray of light through the top of the scene lands, at most, away from its foot.
double shadow_length(const Scene& scene, const Bounds& bounds) {
  constexpr double kTan60 = 1.7320508075688772;
  const double height = bounds.high.y - bounds.low.y;
  const Light& light = scene.light;
  if (light.kind != Light::Kind::kDirectional) return height * kTan60;
  const double down = -light.direction.y;
  const double along = std::hypot(light.direction.x, light.direction.z);
  return height * (down * kTan60 > along ? along / down : kTan60);
}

}  // namespace

std::size_t Scene::triangle_count() const {
  std::size_t count = 0;
  for (const Object& object : objects) count += object.triangles.size();
  return count;
}

Bounds caster_bounds(const Scene& scene) {
  const Bounds bounds = bounds_of(scene, true);
  return bounds.empty() ? bounds_of(scene, false) : bounds;
}

bool has_floor(const Scene& scene) {
  const Bounds bounds = caster_bounds(scene);
  if (bounds.empty()) return false;
  const glm::dvec3 size = bounds.high - bounds.low;
  const double limit = bounds.low.y + 0.1 * size.y;
  double covered = 0;
  for (const Object& object : scene.objects) {
    for (const auto& t : object.triangles) {
      const glm::dvec3 a = object.positions[t[0]], b = object.positions[t[1]],
                       c = object.positions[t[2]];
      if (std::max({a.y, b.y, c.y}) > limit) continue;
      const glm::dvec3 normal = glm::cross(b - a, c - a);
      if (normal.y > 0.9 * glm::length(normal)) covered += 0.5 * normal.y;
    }
  }
  return covered >= 0.5 * size.x * size.z && covered > 0;
}

void add_ground(Scene& scene) {
  const Bounds bounds = caster_bounds(scene);
  if (bounds.empty()) return;
  const glm::dvec3 centre = bounds.centre();
  const double half_side =
      1.15 * (0.5 * std::max(bounds.high.x - bounds.low.x, bounds.high.z - bounds.low.z) +
              shadow_length(scene, bounds)) +
      0.01 * bounds.diagonal();
  const double y = bounds.low.y - 1e-3 * bounds.diagonal();
  Object ground;
  ground.name = "ground";
  ground.caster = false;
  ground.colour = glm::vec3(0.55f, 0.55f, 0.52f);
  ground.positions = {{centre.x - half_side, y, centre.z - half_side},
                      {centre.x - half_side, y, centre.z + half_side},
                      {centre.x + half_side, y, centre.z + half_side},
                      {centre.x + half_side, y, centre.z - half_side}};
  ground.triangles = {{0, 1, 2}, {0, 2, 3}};
  scene.objects.push_back(std::move(ground));
}

void fit_camera(Scene& scene) { fit_camera(scene, 1); }

void fit_camera(Scene& scene, double aspect) {
  const Bounds bounds = caster_bounds(scene);
  if (bounds.empty()) return;
  Camera camera;
  camera.vertical_fov_degrees = 40;
  camera.target = bounds.centre();
  // Three-quarter view: 35 degrees round from the front, 28 above the horizon.
  const glm::dvec3 back = glm::normalize(glm::dvec3(0.506, 0.469, 0.723));
  const glm::dvec3 right = glm::normalize(glm::cross(camera.up, back));
  const glm::dvec3 up = glm::cross(back, right);
  const double slope = 0.92 * std::tan(glm::radians(camera.vertical_fov_degrees) / 2);
  double distance = 0;  // the least from which every vertex stands within the view
  visit_vertices(scene, true, [&](const glm::dvec3& p) {
    const glm::dvec3 q = p - camera.target;
    const double aside = std::max(std::abs(glm::dot(q, right)) / aspect, std::abs(glm::dot(q, up)));
    distance = std::max(distance, glm::dot(q, back) + aside / slope);
  });
  if (!(distance > 0)) distance = std::max(1.0, 2 * bounds.diagonal());
  camera.eye = camera.target + back * distance;
  scene.camera = camera;
}

void fit_light(Scene& scene) {
  Light light;
  light.kind = Light::Kind::kDirectional;
  // From the upper left behind the camera of fit_camera, 39 degrees from vertical.
  light.direction = glm::normalize(glm::dvec3(0.75, -1.0, -0.32));
  light.target = caster_bounds(scene).centre();
  light.half_extent = 0;
  scene.light = light;
}

}  // namespace kagesen

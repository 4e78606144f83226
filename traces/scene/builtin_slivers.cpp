#include <cmath>

#include "traces/scene/builtin.h"
#include "traces/scene/fit.h"
#include "traces/scene/random.h"
#include "traces/scene/solids.h"

namespace kagesen {
namespace {

constexpr double kPi = 3.14159265358979323846;

/// Two fans of `sides` slivers from poles that are `thickness` apart, over a rim that steps in and
/// out: closed, nearly flat, full of needle-sharp corners.
Object make_fan_disc(double radius, double thickness, int sides) {
  Object o;
  const auto n = static_cast<std::uint32_t>(sides);
  o.positions = {{0, -thickness / 2, 0}, {0, thickness / 2, 0}};
  for (std::uint32_t i = 0; i < n; ++i) {
    const double angle = 2 * kPi * i / n, r = radius * (i % 2 ? 1.0 : 0.93);
    o.positions.push_back({r * std::cos(angle), 0, r * std::sin(angle)});
  }
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t a = 2 + i, b = 2 + (i + 1) % n;
    o.triangles.push_back({0, a, b});
    o.triangles.push_back({1, b, a});
  }
  return o;
}

/// A tetrahedron along `direction`, `width` wide at its root.
Object make_needle(double length, double width) {
  Object o;
  o.positions = {{0, width, 0}, {0, -width / 2, width}, {0, -width / 2, -width}, {length, 0, 0}};
  o.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  return o;
}

}  // namespace

void build_slivers(Scene& scene) {
  scene.seed = 11;
  Random random(scene.seed);
  Object disc = make_fan_disc(1.7, 0.06, 360);
  place(disc, {14, 0, 22}, {-1.6, 2.0, -0.4});
  add(scene, std::move(disc), "disc", {0.80f, 0.50f, 0.32f});
  Object small_disc = make_fan_disc(0.9, 0.02, 97);
  place(small_disc, {-25, 0, 12}, {1.7, 1.1, 1.4});
  add(scene, std::move(small_disc), "small_disc", {0.36f, 0.56f, 0.72f});
  for (int i = 0; i < 64; ++i) {
    Object needle = make_needle(random.uniform(1.1, 2.0), random.uniform(0.004, 0.02));
    const double turn = 360.0 * i / 64;
    place(needle, {random.uniform(0, 90), turn, random.uniform(-20, 25)},
          {1.6 + 0.15 * std::cos(turn * kPi / 180), 2.3, -1.2 - 0.15 * std::sin(turn * kPi / 180)});
    add(scene, std::move(needle), "needle", {0.60f, 0.62f, 0.44f});
  }
  add_level_ground(scene, 0, 0, 9, 9);
  fit_camera(scene, 1.5);
  fit_light(scene);
}

}  // namespace kagesen

#include <cmath>

#include "traces/scene/builtin.h"
#include "traces/scene/fit.h"
#include "traces/scene/random.h"
#include "traces/scene/solids.h"

namespace kagesen {
namespace {

/// A bent three-sided blade of `segments` pieces that narrows to a tenth of its width, closed at
/// both ends.
Object make_blade(double height, double width, double bend, int segments) {
  Object o;
  const auto n = static_cast<std::uint32_t>(segments);
  for (std::uint32_t j = 0; j <= n; ++j) {
    const double t = static_cast<double>(j) / n, w = width * (1 - 0.9 * t);
    const double x = bend * t * t, y = height * t;
    o.positions.push_back({x, y, w});
    o.positions.push_back({x + 0.3 * w, y, 0});
    o.positions.push_back({x, y, -w});
  }
  for (std::uint32_t j = 0; j < n; ++j) {
    for (std::uint32_t i = 0; i < 3; ++i) {
      const std::uint32_t a = 3 * j + i, b = 3 * j + (i + 1) % 3;
      o.triangles.push_back({a, b, b + 3});
      o.triangles.push_back({a, b + 3, a + 3});
    }
  }
  o.triangles.push_back({0, 2, 1});
  o.triangles.push_back({3 * n, 3 * n + 1, 3 * n + 2});
  return o;
}

}  // namespace

void build_hair(Scene& scene) {
  constexpr int kBlades = 600;
  scene.seed = 5;
  Random random(scene.seed);
  for (int i = 0; i < kBlades; ++i) {
    // Square root: even cover of the disc.
    const double r = 3.2 * std::sqrt(random.uniform(0, 1)), angle = random.uniform(0, 6.28318);
    Object blade = make_blade(random.uniform(0.6, 1.8), random.uniform(0.008, 0.03),
                              random.uniform(0.1, 0.8), 5);
    place(blade, {random.uniform(-8, 8), random.uniform(0, 360), random.uniform(-8, 8)},
          {r * std::cos(angle), 0, r * std::sin(angle)});
    rest_on_ground(blade, 0.01);
    add(scene, std::move(blade), "blade",
        {0.36f, 0.50f + 0.2f * static_cast<float>(random.uniform(0, 1)), 0.28f});
  }
  Object ball = make_sphere(0.7, 48, 24);
  place(ball, {0, 0, 10}, {0.2, 1.9, 0});
  add(scene, std::move(ball), "ball", {0.80f, 0.42f, 0.34f});
  add_level_ground(scene, 0, 0, 9, 9);
  fit_camera(scene, 1.5);
  fit_light(scene);
}

}  // namespace kagesen

#include "traces/scene/builtin.h"
#include "traces/scene/fit.h"
#include "traces/scene/solids.h"

namespace kagesen {

void build_torus(Scene& scene) {
  Object flat = make_torus(1.6, 0.42, 96, 32);  // faces the light: its hole shows on the ground
  place(flat, {18, 0, 36}, {-0.6, 2.4, 0});
  add(scene, std::move(flat), "torus", {0.80f, 0.45f, 0.26f});
  Object standing = make_torus(1.0, 0.3, 64, 24);
  place(standing, {90, 20, 0}, {2.6, 0, -1.0});
  rest_on_ground(standing, 0.04);
  add(scene, std::move(standing), "hoop", {0.34f, 0.52f, 0.74f});
  Object lying = make_torus(0.9, 0.16, 48, 16);
  place(lying, {12, 0, 8}, {1.2, 0, 2.4});
  rest_on_ground(lying, 0.04);
  add(scene, std::move(lying), "ring", {0.45f, 0.66f, 0.40f});
  Object pearl = make_sphere(0.35, 32, 16);  // seen, and lit, through the hole
  place(pearl, {0, 0, 0}, {0.55, 0.8, -0.5});
  add(scene, std::move(pearl), "pearl", {0.88f, 0.86f, 0.80f});
  add_level_ground(scene, 0, 0, 8, 8);
  fit_camera(scene, 1.5);
  fit_light(scene);
}

}  // namespace kagesen

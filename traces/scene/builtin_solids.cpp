#include "traces/scene/builtin.h"
#include "traces/scene/fit.h"
#include "traces/scene/solids.h"

namespace kagesen {

void build_solids(Scene& scene) {
  struct Placed {
    const char* name;
    Object object;
    glm::dvec3 degrees;
    double x, z, gap;
    glm::vec3 colour;
  };
  const Placed placed[] = {
      {"cube", make_box({0.8, 0.8, 0.8}), {31, 17, 8}, -2.4, 0.9, 0.04, {0.80f, 0.36f, 0.28f}},
      {"icosahedron", make_icosahedron(1.0), {12, 40, 5}, 0.1, 1.5, 0.04, {0.93f, 0.73f, 0.30f}},
      {"tetrahedron", make_tetrahedron(1.2), {23, 64, 11}, 2.5, 1.1, 0.04, {0.35f, 0.58f, 0.36f}},
      {"cylinder",
       make_cylinder(0.6, 0.6, 1.3, 32),
       {7, 0, 16},
       -1.4,
       -1.7,
       0.04,
       {0.32f, 0.50f, 0.72f}},
      {"sphere", make_sphere(0.9, 48, 24), {15, 0, 25}, 1.3, -1.5, 0.5, {0.66f, 0.45f, 0.66f}},
      {"slab", make_box({1.1, 0.12, 0.7}), {24, 52, 14}, -0.5, -0.2, 2.5, {0.85f, 0.85f, 0.80f}},
      {"cone",
       make_cylinder(0.7, 0.05, 0.9, 24),
       {160, 0, 12},
       3.3,
       -1.2,
       0.04,
       {0.30f, 0.64f, 0.66f}},
      {"ball", make_sphere(0.42, 24, 12), {0, 30, 0}, 0.9, 3.2, 0.04, {0.75f, 0.75f, 0.78f}},
  };
  for (const Placed& p : placed) {
    Object object = p.object;
    place(object, p.degrees, {p.x, 0, p.z});
    rest_on_ground(object, p.gap);
    add(scene, std::move(object), p.name, p.colour);
  }
  add_level_ground(scene, 0.8, 0.2, 6, 6);
  fit_camera(scene, 1.5);
  fit_light(scene);
}

}  // namespace kagesen

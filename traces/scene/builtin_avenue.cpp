#include "traces/scene/builtin.h"
#include "traces/scene/random.h"
#include "traces/scene/solids.h"

namespace kagesen {
namespace {

void add_tree(Scene& scene, Random& random, double x, double z) {
  const double height = random.uniform(2.2, 3.6);
  Object trunk = make_cylinder(0.16, 0.11, height / 2, 10);
  place(trunk, {random.uniform(-3, 3), 0, random.uniform(-3, 3)}, {x, 0, z});
  rest_on_ground(trunk, 0.02);
  add(scene, std::move(trunk), "trunk", {0.42f, 0.30f, 0.22f});
  Object crown = make_sphere(random.uniform(0.8, 1.3), 20, 10);
  place(crown, {random.uniform(0, 90), random.uniform(0, 90), 0}, {x, height + 0.9, z});
  add(scene, std::move(crown), "crown", {0.30f, 0.52f, 0.28f});
}

void add_lamp(Scene& scene, double x, double z) {
  Object post = make_cylinder(0.06, 0.04, 1.9, 8);
  place(post, {1, 0, 2}, {x, 0, z});
  rest_on_ground(post, 0.02);
  add(scene, std::move(post), "post", {0.3f, 0.3f, 0.32f});
  Object globe = make_icosahedron(0.26);
  place(globe, {10, 20, 30}, {x, 4.2, z});
  add(scene, std::move(globe), "globe", {0.9f, 0.88f, 0.75f});
}

void add_house(Scene& scene, Random& random, double x, double z) {
  Object house = make_box({random.uniform(1.5, 2.2), random.uniform(1.2, 3.5), 2.3});
  place(house, {0, random.uniform(-6, 6), 0}, {x, 0, z});
  rest_on_ground(house, 0.02);
  add(scene, std::move(house), "house", {0.72f, 0.62f, 0.52f});
}

}  // namespace

void build_avenue(Scene& scene) {
  scene.seed = 7;
  Random random(scene.seed);
  for (int i = 0; i < 24; ++i) {
    const double z = 2.0 - 5.0 * i - random.uniform(0, 1);
    for (const double side : {-1.0, 1.0}) {
      add_tree(scene, random, side * 4.2 + random.uniform(-0.3, 0.3), z);
      if (i % 2 == 0) add_lamp(scene, side * 2.9, z - 2.5);
      if (i % 2 == 1) add_house(scene, random, side * 8.5, z);
    }
  }
  add_level_ground(scene, 0, -56, 16, 70);
  scene.camera.eye = {0.6, 1.7, 8};
  scene.camera.target = {0.1, 1.5, -20};
  scene.camera.vertical_fov_degrees = 50;
  // Light across the street while the view goes along it; at scale 1 the map reaches the first
  // trees only, and 16 times more holds everything.
  scene.light.direction = glm::normalize(glm::dvec3(0.8, -0.75, 0.05));
  scene.light.target = {0, 1.5, 0};
  scene.light.half_extent = 8;
}

}  // namespace kagesen

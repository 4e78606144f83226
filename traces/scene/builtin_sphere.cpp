#include "traces/scene/builtin.h"
#include "traces/scene/fit.h"
#include "traces/scene/solids.h"

namespace kagesen {

void build_sphere1m(Scene& scene) {
  Object sphere = make_sphere(2.0, 1000, 501);  // 2 * 1000 * (501 - 1) triangles
  place(sphere, {20, 0, 15}, {0, 2.1, 0});
  add(scene, std::move(sphere), "sphere", {0.72f, 0.72f, 0.76f});
  add_level_ground(scene, 0, 0, 7, 7);
  fit_camera(scene, 1.5);
  fit_light(scene);
}

}  // namespace kagesen

#include "traces/scene/builtin.h"
#include "traces/scene/fit.h"
#include "traces/scene/random.h"
#include "traces/scene/solids.h"

namespace kagesen {

void build_boxes(Scene& scene) {
  constexpr int kBoxes = 200, kColumns = 20;
  scene.seed = 3;
  Random random(scene.seed);
  for (int i = 0; i < kBoxes; ++i) {
    const double x = (i % kColumns - 9.5) * 1.0 + random.uniform(-0.3, 0.3);
    const double z = (static_cast<double>(i / kColumns) - 4.5) * 1.4 + random.uniform(-0.4, 0.4);
    Object box =
        make_box({random.uniform(0.12, 0.4), random.uniform(0.12, 0.8), random.uniform(0.12, 0.4)});
    place(box, {random.uniform(-25, 25), random.uniform(0, 90), random.uniform(-25, 25)},
          {x, 0, z});
    rest_on_ground(box, 0.02 + random.uniform(0, 0.6));
    add(scene, std::move(box), "box",
        {0.4f + 0.45f * static_cast<float>(random.uniform(0, 1)), 0.55f,
         0.4f + 0.4f * static_cast<float>(random.uniform(0, 1))});
  }
  add_level_ground(scene, 0, 0, 14, 14);
  fit_camera(scene, 1.5);
  fit_light(scene);
}

}  // namespace kagesen

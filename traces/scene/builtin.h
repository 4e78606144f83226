#pragma once
/// The generators behind the built-in scenes, one file a family. Each fills objects, camera and
/// light; make_builtin does the rest (snapping of positions, closedness, name, digest).
#include "traces/scene/scene.h"

namespace kagesen {

void build_solids(Scene& scene);
void build_torus(Scene& scene);
void build_glyphs(Scene& scene);
void build_avenue(Scene& scene);
void build_slivers(Scene& scene);
void build_boxes(Scene& scene);
void build_hair(Scene& scene);
void build_sphere1m(Scene& scene);

}  // namespace kagesen

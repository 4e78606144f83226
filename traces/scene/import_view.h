#pragma once
/// The camera and the light that a mesh file brings.
#include <map>
#include <string>

#include "traces/scene/scene.h"

struct aiScene;

namespace kagesen {

/// World from node, by node name.
using NodeTransforms = std::map<std::string, glm::dmat4>;

/// Takes the file's first perspective camera; false where it has none. Needs the scene's objects.
bool import_camera(const aiScene& file, const NodeTransforms& nodes, Scene& scene);
/// Takes the file's first directional, spot or point light; false where it has none. What had to be
/// passed over goes to scene.warnings. A point light's one frustum looks at the casters.
bool import_light(const aiScene& file, const NodeTransforms& nodes, Scene& scene);

}  // namespace kagesen

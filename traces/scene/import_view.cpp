#include "traces/scene/import_view.h"

#include <assimp/scene.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "traces/scene/fit.h"

namespace kagesen {
namespace {

glm::dvec3 vector_of(const aiVector3D& v) { return {v.x, v.y, v.z}; }

glm::dmat4 transform_of(const NodeTransforms& nodes, const aiString& name) {
  const auto found = nodes.find(name.C_Str());
  return found == nodes.end() ? glm::dmat4(1) : found->second;
}

bool usable(const glm::dvec3& v) { return std::isfinite(glm::dot(v, v)) && glm::length(v) > 0; }

}  // namespace

bool import_camera(const aiScene& file, const NodeTransforms& nodes, Scene& scene) {
  for (unsigned int i = 0; i < file.mNumCameras; ++i) {
    const aiCamera& from = *file.mCameras[i];
    const glm::dmat4 world = transform_of(nodes, from.mName);
    // The node alone places it: Assimp 5.2 repeats the node's translation in mPosition.
    const glm::dvec3 eye(world[3]);
    const glm::dvec3 ahead = glm::dmat3(world) * vector_of(from.mLookAt);
    const glm::dvec3 up = glm::dmat3(world) * vector_of(from.mUp);
    // Of the formats read here only glTF has cameras, and Assimp 5.2 gives their vertical angle
    // times the aspect ratio for the horizontal one.
    const double aspect = from.mAspect > 0 ? from.mAspect : 1;
    const double fov = glm::degrees(from.mHorizontalFOV / aspect);
    if (from.mOrthographicWidth > 0 || !usable(ahead) || !usable(up) || !(fov > 0 && fov < 180) ||
        !std::isfinite(glm::dot(eye, eye))) {
      scene.warnings.push_back(
          fmt::format("camera '{}' is not a usable perspective camera", from.mName.C_Str()));
      continue;
    }
    const Bounds bounds = caster_bounds(scene);
    const glm::dvec3 direction = glm::normalize(ahead);
    const double reach = glm::dot(bounds.centre() - eye, direction);
    scene.camera = Camera{};
    scene.camera.eye = eye;
    scene.camera.target = eye + direction * (reach > 0 ? reach : std::max(1.0, bounds.diagonal()));
    scene.camera.up = glm::normalize(up);
    scene.camera.vertical_fov_degrees = fov;
    if (file.mNumCameras > 1) {
      scene.warnings.push_back(
          fmt::format("took camera '{}' of {}", from.mName.C_Str(), file.mNumCameras));
    }
    return true;
  }
  return false;
}

bool import_light(const aiScene& file, const NodeTransforms& nodes, Scene& scene) {
  for (unsigned int i = 0; i < file.mNumLights; ++i) {
    const aiLight& from = *file.mLights[i];
    const glm::dmat4 world = transform_of(nodes, from.mName);
    const Bounds bounds = caster_bounds(scene);
    Light light;
    light.position = glm::dvec3(world * glm::dvec4(vector_of(from.mPosition), 1));
    light.direction = glm::dmat3(world) * vector_of(from.mDirection);
    light.target = bounds.centre();
    bool known = std::isfinite(glm::dot(light.position, light.position));
    if (from.mType == aiLightSource_DIRECTIONAL) {
      light.kind = Light::Kind::kDirectional;
    } else if (from.mType == aiLightSource_SPOT) {
      light.kind = Light::Kind::kSpot;
      // glTF's cone angle runs from the axis to the rim.
      light.spread_degrees = std::clamp(glm::degrees(2.0 * from.mAngleOuterCone), 1.0, 160.0);
    } else if (from.mType == aiLightSource_POINT) {
      light.kind = Light::Kind::kPoint;
      light.direction = bounds.centre() - light.position;
      const double distance = glm::length(light.direction), radius = bounds.diagonal() / 2;
      const bool within = !(distance > radius);
      if (!usable(light.direction)) light.direction = glm::dvec3(0, -1, 0);
      light.spread_degrees =
          within ? 150
                 : std::clamp(glm::degrees(2 * std::asin(radius / distance)) * 1.02, 1.0, 150.0);
    } else {
      known = false;
    }
    if (!known || !usable(light.direction)) {
      scene.warnings.push_back(
          fmt::format("light '{}' is of no kind that casts here", from.mName.C_Str()));
      continue;
    }
    light.direction = glm::normalize(light.direction);
    scene.light = light;
    if (file.mNumLights > 1) {
      scene.warnings.push_back(
          fmt::format("took light '{}' of {}", from.mName.C_Str(), file.mNumLights));
    }
    return true;
  }
  return false;
}

}  // namespace kagesen

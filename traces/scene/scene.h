#pragma once
/// Scenes in world space: meshes, a camera, a light. Doubles; right-handed, +y up.
#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

namespace kagesen {

struct Object {
  std::string name;
  std::vector<glm::dvec3> positions;
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< indices into positions
  bool closed = false;  ///< closed 2-manifold of consistent winding, outward normals
  bool caster = true;   ///< false: a pure receiver (the ground)
  glm::vec3 colour{0.7f};  ///< for pictures only
};

/// A pinhole camera.
struct Camera {
  glm::dvec3 eye{0, 1, 5}, target{0}, up{0, 1, 0};
  double vertical_fov_degrees = 45;
  double near_plane = 0;  ///< 0: fitted to the scene
};

struct Light {
  enum class Kind { kDirectional, kSpot, kPoint };
  Kind kind = Kind::kDirectional;
  glm::dvec3 position{0, 10, 0};    ///< spot and point
  glm::dvec3 direction{0, -1, 0};   ///< the way the light travels; a point light's one frustum looks this way
  double spread_degrees = 90;       ///< full angle of the frustum of a spot or point light
  /// Half extent in world units of a directional light's square map at scale 1, centred on `target`;
  /// 0: fitted to the casters.
  double half_extent = 0;
  glm::dvec3 target{0};
};

struct Scene {
  std::string name;
  std::string sha256;      ///< of the file, or of the generated geometry
  std::uint64_t seed = 0;  ///< of the generator, 0 where none is used
  std::vector<Object> objects;
  Camera camera;
  Light light;
  std::vector<std::string> warnings;  ///< one line each: what the import dropped or changed, with counts
  std::size_t triangle_count() const;
};

struct SceneInfo {
  std::string name, description;
};
/// The built-in scenes; the first is the default of the main job.
std::vector<SceneInfo> builtin_scenes();
/// Throws UserError with the nearest names when there is no such scene.
Scene make_builtin(const std::string& name);

struct ImportOptions {
  enum class Ids { kAuto, kFile, kComponents };
  Ids ids = Ids::kAuto;  ///< auto: the file's objects where it has more than one, else connected components
  enum class Ground { kAuto, kOn, kOff };
  Ground ground = Ground::kAuto;  ///< a receiver plane under the scene
};
/// Imports OBJ, PLY, glTF or GLB. Throws UserError naming the file, the place and the mend.
Scene import_mesh(const std::string& path, const ImportOptions& options = {});

/// Sets `closed` of every object from its triangles: each edge used exactly twice, in opposite directions.
void classify_objects(Scene& scene);
/// Fits a camera and a light to the scene's casters (used where a file has none).
void fit_camera(Scene& scene);
void fit_light(Scene& scene);

}  // namespace kagesen

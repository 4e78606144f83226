#pragma once
/// Scene -> trace: pass 1 casters in light space, pass 2 fragments as the camera sees them.
#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <string>

#include "traces/format/records.h"
#include "traces/scene/scene.h"

namespace kagesen {

struct CaptureOptions {
  std::uint32_t image_width = 1920, image_height = 1080;
  std::uint32_t map_width = 1024, map_height = 1024;
  double scale_x = 1, scale_y = 1;  ///< 1 to 1024: the map covers scale times more world an axis
  FragmentMode mode = FragmentMode::kVisible;
  std::function<void(const std::string& stage, double done)> progress;  ///< done in [0, 1]; may be empty
};

struct CaptureSummary {
  std::uint64_t casters = 0;     ///< written, after culling and clipping
  std::uint64_t culled = 0;      ///< averted triangles of closed objects
  std::uint64_t degenerate = 0;  ///< of zero area after snapping: they cast no shadow
  std::uint64_t clipped = 0;     ///< triangles cut by the light's frustum
  std::uint64_t fragments = 0, averted = 0, outside = 0;
};

/// World to light space, before snapping: x, y in texels from the map's origin (see records.h), z in [0, 1].
struct LightSpace {
  glm::dmat4 clip_from_world;  ///< -w..w in x and y over the map, 0..w in depth
  bool perspective = false;
  std::uint32_t fraction_bits = kMinFractionBits;
  std::uint32_t map_width = 1024, map_height = 1024;
  /// Snaps to the nearest unit; sets `outside` when the point is not in the frustum (then clamped).
  LightPoint snap(const glm::dvec3& world, bool& outside) const;
};
/// The light's frustum at the options' scale. Throws UserError for a light or a camera of no size.
LightSpace fit_light_space(const Scene& scene, const CaptureOptions& options);

/// Throws UserError for a scene that cannot be captured (no triangles, a degenerate camera, ...).
CaptureSummary capture(const Scene& scene, const CaptureOptions& options, TraceSink& sink);

/// As `capture`, with pass 2 from a rendered EXR: channels position.x/y/z (or P.X/Y/Z) in world space and
/// an object-ID channel (`id`, numbers as in the scene); pixels whose ID is negative or NaN are background.
CaptureSummary capture_gbuffer(const Scene& scene, const std::string& exr_path, const CaptureOptions& options,
                               TraceSink& sink);

}  // namespace kagesen

#pragma once
/// The end-to-end check: verdicts against shadow rays on the scene's own, unsnapped meshes.
///
/// Single-precision rays (Embree, robust), so it is exact but for fragments within about 2^-20 of
/// the scene's size of an edge. What it tells beyond ExactReference is the error of making the
/// trace.
#include <cstdint>
#include <vector>

#include "model/reference/reference.h"
#include "traces/format/records.h"
#include "traces/raster/capture.h"
#include "traces/scene/scene.h"

namespace kagesen {

struct SceneExactFigures {
  std::uint64_t agree = 0;
  std::uint64_t false_lit = 0,
                false_dark = 0;  ///< the verdict says lit, dark; the rays the opposite
  std::uint64_t wrong() const { return false_lit + false_dark; }
};

struct SceneExactReport {
  std::uint64_t judged = 0;   ///< fragments compared
  std::uint64_t skipped = 0;  ///< the ray through the pixel did not meet the fragment's object
  std::uint64_t ignored = 0;  ///< not visible, averted or outside the light's frustum: not compared
  SceneExactFigures paper, physical;
};

/// Camera rays through pixel centres; pixel (0, 0) is the image's upper left one.
class PixelRays {
 public:
  PixelRays(const Camera& camera, std::uint32_t image_width, std::uint32_t image_height);
  const glm::dvec3& origin() const { return origin_; }
  /// Of length 1.
  glm::dvec3 direction(std::uint32_t pixel_x, std::uint32_t pixel_y) const;

 private:
  glm::dvec3 origin_, forward_, right_, up_;  ///< right_, up_: half the image at distance 1
  double width_, height_;
};

/// Compares verdicts (1 = dark, one a fragment of the trace) with shadow rays against the scene's
/// casters. Only kVisible fragments that are neither averted nor outside count. `threads` 0: one a
/// core. Throws std::invalid_argument when the sizes or object numbers of the arguments do not fit
/// together.
SceneExactReport scene_exact(const Scene& scene, const LightSpace& light_space, const Trace& trace,
                             const std::vector<std::uint8_t>& paper,
                             const std::vector<std::uint8_t>& physical, unsigned threads = 0);

}  // namespace kagesen

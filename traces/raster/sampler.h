#pragma once
/// A world position on a surface -> a fragment's place in light space, its flags and its shade.
#include "traces/raster/surface.h"

namespace kagesen {

class Sampler {
 public:
  Sampler(const Scene& scene, const LightSpace& space, const CasterSet& casters);

  /// Chooses the surface of the samples that follow.
  /// @param normal  towards the camera, of any length
  /// @param on_surface  any world point of the surface's plane
  void select(std::uint32_t polygon, const glm::dvec3& normal, const glm::dvec3& on_surface);
  /// The same where the triangle is not known.
  void select(const glm::dvec3& normal, const glm::dvec3& on_surface);
  /// Where not even the normal is known: never averted, full shade.
  void select_unknown();

  /// Sets position and shade, and adds kAverted and kOutside to the flags. Depth is rounded down,
  /// and lowered to the surface's own snapped plane: a surface is not beyond itself.
  void place(const glm::dvec3& world, Fragment& fragment) const;

 private:
  const Light& light_;
  const glm::dmat4 clip_from_world_;
  const bool perspective_;
  const UnitGrid grid_;
  OwnSurface surface_;
  bool surface_known_ = false, normal_known_ = false, averted_ = false;
  glm::dvec3 normal_{0};           ///< of length 1
  std::uint8_t flat_shade_ = 255;  ///< of a directional light
};

}  // namespace kagesen

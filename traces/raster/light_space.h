#pragma once
/// The integer grid of light space, and its frustum as planes.
#include <array>
#include <glm/glm.hpp>

#include "traces/raster/capture.h"

namespace kagesen {

/// From clip coordinates to units, and the range of units that lie in a texel of the map.
///
/// Scaling by a power of two changes only exponents here, so that the same world point has the same
/// units at every such scale, bit for bit.
struct UnitGrid {
  explicit UnitGrid(const LightSpace& space);

  /// Units before rounding. @pre clip.w > 0
  double x(const glm::dvec4& clip) const { return clip.x / clip.w * scale_x + offset_x; }
  double y(const glm::dvec4& clip) const { return clip.y / clip.w * scale_y + offset_y; }
  /// Depth before rounding, 0 to kDepthMax inside the frustum. @pre clip.w > 0
  static double z(const glm::dvec4& clip) { return clip.z / clip.w * kDepthMax; }

  /// Nearest unit, clamped into the map and the depth range. @pre clip.w > 0
  LightPoint snap(const glm::dvec4& clip) const;

  double scale_x, scale_y, offset_x, offset_y;
  std::int32_t min_x, max_x, min_y, max_y;  ///< inclusive
  /// dot(plane, clip) >= 0 on all four: snap() is in the map without clamping.
  std::array<glm::dvec4, 4> sides;
};

}  // namespace kagesen

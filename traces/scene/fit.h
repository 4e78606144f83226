#pragma once
/// Where a scene is, and what it lacks: bounds, floor, ground.
#include "traces/scene/scene.h"

namespace kagesen {

/// An axis-aligned box in world space; empty while low > high.
struct Bounds {
  glm::dvec3 low{1e300}, high{-1e300};
  bool empty() const { return low.x > high.x; }
  glm::dvec3 centre() const { return (low + high) * 0.5; }
  double diagonal() const { return empty() ? 0 : glm::length(high - low); }
};

/// Bounds of the vertices that triangles use: of the casters, or of the whole scene where there is
/// no caster.
Bounds caster_bounds(const Scene& scene);

/// True where the scene brings its own floor: level triangles that face up, within the lowest tenth
/// of its height, cover at least half of its footprint.
bool has_floor(const Scene& scene);

/// Adds a square receiver "ground" 1/1000 of the scene's diagonal under its lowest point, large
/// enough for the shadows of its light (up to 60 degrees from vertical).
void add_ground(Scene& scene);

/// fit_camera for images at least `aspect` times as wide as high; the plain one takes 1.
void fit_camera(Scene& scene, double aspect);

}  // namespace kagesen

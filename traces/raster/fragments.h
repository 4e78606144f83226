#pragma once
/// Pass 2: the samples that the camera's rasteriser hands to the unit.
#include <functional>

#include "traces/raster/casters.h"

namespace kagesen {

/// A sample with what a G-buffer needs besides: world position and the triangle it lies on.
struct Sample {
  Fragment fragment;
  glm::dvec3 world{0};
  std::uint32_t polygon = 0;
};

/// Draws both sides of every triangle and hands out the samples of options.mode: triangles in scene
/// order; in a triangle 8x8 tiles, 2x2 quads and pixels, each row-major. The one that the camera
/// finally sees at its pixel is flagged kVisible in every mode. Memory: 12 bytes a pixel.
void draw_samples(const Scene& scene, const CaptureOptions& options, const LightSpace& space,
                  const CasterSet& casters, const std::function<void(const Sample&)>& emit);

/// Collects fragments, counts them, and passes them on in portions.
class FragmentStream {
 public:
  FragmentStream(TraceSink& sink, CaptureSummary& summary);
  void push(const Fragment& fragment);
  void flush();

 private:
  TraceSink& sink_;
  CaptureSummary& summary_;
  std::vector<Fragment> portion_;
};

}  // namespace kagesen

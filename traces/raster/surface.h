#pragma once
/// Depth of fragments on the grid of light space, free of shadows that snapping alone would make.
#include <cstdint>

#include "traces/raster/casters.h"

namespace kagesen {

/// The casters that came of one polygon, as planes.
class OwnSurface {
 public:
  OwnSurface(const CasterSet& set) : set_(set) {}

  /// Chooses the polygon whose fragments come next.
  void select(std::uint32_t polygon);

  /// Lowers a fragment's depth to the floor of its own snapped triangle at (x, y), where that
  /// covers (x, y) and lies nearer only by what snapping explains: 4 depth units and twice the
  /// change of depth over one unit in x and in y.
  void settle(LightPoint& p) const;

 private:
  struct Plane {
    const Caster* caster;
    std::int64_t area;               ///< doubled, above 0 after ordering
    double slope_x, slope_y, slack;  ///< depth a unit; largest correction
  };
  const CasterSet& set_;
  std::uint32_t polygon_ = 0xffffffffu;
  Plane planes_[16];
  int count_ = 0;
};

}  // namespace kagesen

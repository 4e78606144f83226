#pragma once
/// Edge setup: direction, major axis, slope and L/R of an outline edge (3.3.1), and the exact ramps
/// that the walker advances.
#include "model/unit/fixed.h"
#include "model/unit/line.h"
#include "traces/format/records.h"

namespace kagesen::unit {

/// What the walker needs of one edge. "u" is x, mirrored (-x) when the edge travels towards -x, so
/// that both coordinates of the walk grow. Texel indices count from the map's origin.
struct EdgeSetup {
  bool x_major = false, x_positive = true;
  bool left = false;
  std::int32_t first_major = 0,
               last_major = 0;  ///< texel index along the major axis, mirrored if u
  std::int32_t first_minor = 0, last_minor = 0;
  std::uint32_t slope = 0;  ///< stored Slope, UQ0.slope_bits, nearest, saturated
  ExactRamp
      minor;  ///< minor coordinate at the texel's near major side, units from its near minor side
  ExactRamp major_depth;  ///< depth at the next border along the major axis
  ExactRamp minor_depth;  ///< depth at the next border along the minor axis; only if minor_moves
  bool minor_moves = false;
  std::int64_t first_depth = 0, last_depth = 0;
};

/// Sets up the edge a-b of a triangle whose third vertex is `opposite`.
///
/// The direction is canonical: towards +y, exactly horizontal edges towards +x; both triangles of a
/// shared edge get the same setup but for L/R. Exact but for `slope`: at most 2^-(slope_bits + 1)
/// off, 2^-slope_bits where 1.0 saturates. @pre a and b differ in x or y.
EdgeSetup setup_edge(const LightPoint& a, const LightPoint& b, const LightPoint& opposite,
                     int fraction_bits_of_texel, int slope_bits);

}  // namespace kagesen::unit

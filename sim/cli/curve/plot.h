#pragma once
/// Run time against error, as a picture.
#include <vector>

#include "sim/cli/curve/table.h"
#include "sim/report/canvas.h"

namespace kagesen {

/// A column a scale. Above, a line a profile through the widths at one map side: wrong fragments of
/// the band against run time in units of a plain map of that side. Below, a line a profile, and one
/// for the plain map, through the map sides at one width: wrong fragments against run time in units
/// of one plain map's.
/// @param rows  of one scene, not empty
Canvas curve_plot(const std::vector<CurveRow>& rows);

}  // namespace kagesen

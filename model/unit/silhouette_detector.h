#pragma once
/// Silhouette detector (SLD, 3.3.2): is an outline shared with a polygon already drawn?
#include "model/unit/line.h"

namespace kagesen::unit {

/// True if `a` and `b`, of one object in one texel, are the two sides of one edge: opposite L/R,
/// every other stored field equal. Two lines of one polygon never are, where `match_polygon_id`
/// says so. Start-here is not part of the published record and is left out of the match.
inline bool cancels(const Line& a, const Line& b, bool match_polygon_id) {
  const unsigned differ = (a.flags ^ b.flags) & ~unsigned{Line::kStartHere};
  return differ == Line::kLeft && a.fraction == b.fraction && a.slope == b.slope &&
         !(match_polygon_id && a.polygon == b.polygon);
}

}  // namespace kagesen::unit

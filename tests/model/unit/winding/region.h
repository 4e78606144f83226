#pragma once
/// What the winding profile stores of triangles in one texel, without the unit around it.
#include <vector>

#include "model/unit/span_filler.h"
#include "model/unit/winding/edge_walker.h"
#include "model/unit/winding/segment.h"

namespace kagesen::unit::winding {

/// The pieces of all triangles in a texel and how many cover its corner.
struct Region {
  int corner = 0;
  std::vector<Segment> segments;
  bool left_out = false;  ///< some edge lies within the left or the lower border

  /// With `cancels`, pieces that oppose each other go, as those of inner edges do.
  void store(const Segment& s, bool cancels) {
    for (std::size_t i = 0; cancels && i < segments.size(); ++i) {
      if (!segments[i].opposes(s)) continue;
      segments.erase(segments.begin() + static_cast<std::ptrdiff_t>(i));
      return;
    }
    segments.push_back(s);
  }

  void add(const Caster& c, int texel_x, int texel_y, int texel_bits, int end_bits, bool cancels) {
    const Polygon polygon(c, texel_bits);
    if (polygon.degenerate()) return;
    corner += polygon.covers_corner(texel_x, texel_y);
    for (int i = 0; i < 3; ++i) {
      EdgeWalker w(c.vertex[i], c.vertex[(i + 1) % 3], c.vertex[(i + 2) % 3], texel_bits, end_bits);
      for (;; w.step()) {
        if (w.x() == texel_x && w.y() == texel_y) {
          Segment s;
          if (w.segment(s)) {
            if (cancels && !s.dot()) s.flags |= Segment::kInner;
            store(s, cancels);
          } else {
            left_out = true;
          }
        }
        if (w.last()) break;
      }
    }
  }

  Crossing at(const Place& p, int shift) const {
    Crossing out{corner, false};
    for (const Segment& s : segments) {
      const Crossing met = crossing(s, p, shift);
      out.winding += met.winding;
      out.near = out.near || met.near;
    }
    return out;
  }
  bool inside(const Place& p, int shift) const {
    const Crossing c = at(p, shift);
    return c.near || c.winding > 0;
  }
};

}  // namespace kagesen::unit::winding

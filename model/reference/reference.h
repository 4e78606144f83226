#pragma once
/// The exact verdict for a fragment: integer-exact on the trace's own numbers.
#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

#include "model/unit/config.h"
#include "traces/format/records.h"

namespace kagesen {

/// A nearest-depth sample, as a plain shadow map would store.
struct DepthSample {
  std::uint32_t depth = kDepthMax;     ///< floor of the surface's depth
  std::uint32_t object = 0xffffffffu;  ///< none
  bool hit() const { return object != 0xffffffffu; }
};

/// Exact point queries against a trace's casters.
///
/// A caster covers a point if the point lies inside or on its snapped outline; it shadows depth z
/// if its plane there is strictly nearer than z, compared without rounding. Triangles of zero area
/// cover nothing. Thread-safe after construction. Memory: O(casters), 85 to 140 MB
/// for 1 M of them; the first call of boundary_distance or in_band, and the first of
/// casters_in, add a table each.
class ExactReference {
 public:
  /// Keeps a reference to the casters.
  explicit ExactReference(const std::vector<Caster>& casters);
  ~ExactReference();

  /// Is a fragment of `object` at p in shadow?
  bool dark(const LightPoint& p, std::uint32_t object, Semantics semantics) const;
  bool dark(const Fragment& f, Semantics semantics) const {
    if (f.flags & Fragment::kAverted) return true;
    if (f.flags & Fragment::kOutside) return false;
    return dark(f.position, f.object, semantics);
  }
  /// Does any caster of `object` cover (x, y)? `nearer_than`: only surfaces strictly nearer than
  /// this.
  bool covered_by(std::int32_t x, std::int32_t y, std::uint32_t object,
                  std::uint32_t nearer_than = std::numeric_limits<std::uint32_t>::max()) const;
  /// The surface nearest the light at (x, y); of surfaces of equal depth (rounded down) the one
  /// whose caster comes first, as a map would keep that is drawn in order.
  DepthSample nearest(std::int32_t x, std::int32_t y) const;

  /// Distance in light-space units from p, at p's depth, to the nearest point where the verdict
  /// changes; searched up to `limit` units and `limit` where none is nearer. Accurate to 1 unit;
  /// gaps narrower than 1/16 unit count as closed.
  double boundary_distance(const LightPoint& p, std::uint32_t object, Semantics semantics,
                           double limit) const;
  /// Is p within `radius` units of an edge of the shadow at its depth? Lines at which a surface
  /// passes that depth do not count: on a tilted surface its own passes through every point. A lit
  /// point is answered exactly; a dark one by whether any of 32 points, in eight directions at a
  /// quarter to the whole of the radius, is lit.
  bool in_band(const LightPoint& p, std::uint32_t object, Semantics semantics, double radius) const;
  /// Distance in depth units to the nearest surface of another depth test outcome at p: how close
  /// to contact. It is how far p would have to move in depth for its verdict to change: the
  /// distance to the surface nearest the light among those that may shadow it; infinite where none
  /// covers p.
  double contact_distance(const LightPoint& p, std::uint32_t object, Semantics semantics) const;

  /// Indices of the casters whose bounding box meets the rectangle (units, inclusive), appended
  /// once each.
  void casters_in(std::int32_t x0, std::int32_t y0, std::int32_t x1, std::int32_t y1,
                  std::vector<std::uint32_t>& out) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace kagesen

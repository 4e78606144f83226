#include "traces/raster/surface.h"

#include <cmath>

namespace kagesen {
namespace {

__extension__ typedef __int128 Wide;  // sums of products of two 29-bit edges and a 25-bit depth

Wide floor_div(Wide n, Wide d) { return n >= 0 ? n / d : -((-n + d - 1) / d); }

bool covers(const Caster& c, const LightPoint& p, std::int64_t area) {
  for (int i = 0; i < 3; ++i) {
    const std::int64_t side = doubled_area(c.vertex[i], c.vertex[(i + 1) % 3], p);
    if (area > 0 ? side < 0 : side > 0) return false;
  }
  return true;
}

/// Exact floor of the triangle's plane at p.
std::int64_t plane_floor(const Caster& c, const LightPoint& p, std::int64_t area) {
  Wide sum = 0;
  for (int i = 0; i < 3; ++i) {
    sum += Wide{doubled_area(c.vertex[(i + 1) % 3], c.vertex[(i + 2) % 3], p)} * c.vertex[i].z;
  }
  return static_cast<std::int64_t>(area > 0 ? floor_div(sum, area) : floor_div(-sum, -Wide{area}));
}

}  // namespace

void OwnSurface::select(std::uint32_t polygon) {
  if (polygon == polygon_) return;
  polygon_ = polygon;
  count_ = 0;
  for (std::uint32_t i = set_.first[polygon]; i < set_.first[polygon + 1] && count_ < 16; ++i) {
    const Caster& c = set_.casters[i];
    const LightPoint &a = c.vertex[0], &b = c.vertex[1], &d = c.vertex[2];
    const double area = static_cast<double>(doubled_area(a, b, d));
    const double bz = double(b.z) - a.z, dz = double(d.z) - a.z;
    const double bx = double(b.x) - a.x, by = double(b.y) - a.y;
    const double dx = double(d.x) - a.x, dy = double(d.y) - a.y;
    Plane& plane = planes_[count_++];
    plane.caster = &c;
    plane.area = doubled_area(a, b, d);
    plane.slope_x = (bz * dy - dz * by) / area;
    plane.slope_y = (dz * bx - bz * dx) / area;
    plane.slack = 4 + 2 * (std::abs(plane.slope_x) + std::abs(plane.slope_y));
  }
}

void OwnSurface::settle(LightPoint& p) const {
  for (int i = 0; i < count_; ++i) {
    const Plane& plane = planes_[i];
    const LightPoint& a = plane.caster->vertex[0];
    // A double tells all but the near ties; its error here is far below a quarter.
    const double about =
        a.z + plane.slope_x * (double(p.x) - a.x) + plane.slope_y * (double(p.y) - a.y);
    if (about > p.z + 0.5 + plane.slack * 1e-6 || about < p.z - plane.slack - 2) continue;
    if (!covers(*plane.caster, p, plane.area)) continue;
    const std::int64_t limit = plane_floor(*plane.caster, p, plane.area);
    if (limit < p.z && static_cast<double>(p.z - limit) <= plane.slack) {
      p.z = static_cast<std::uint32_t>(limit < 0 ? 0 : limit);
    }
  }
}

}  // namespace kagesen

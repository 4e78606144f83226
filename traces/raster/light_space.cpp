#include "traces/raster/light_space.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "traces/raster/checks.h"
#include "traces/raster/clip.h"
#include "traces/scene/fit.h"

namespace kagesen {
namespace {

constexpr double kMargin = 1.015;       // room around the casters of a fitted map
constexpr double kNearestShare = 1e-3;  // least near plane, as a share of the far plane

/// r x u = -f: a triangle wound counter-clockwise as the light sees it has positive area in (r, u).
struct LightBasis {
  explicit LightBasis(const glm::dvec3& direction) : f(glm::normalize(direction)) {
    const glm::dvec3 hint = std::abs(f.y) < 0.99 ? glm::dvec3(0, 1, 0) : glm::dvec3(0, 0, -1);
    r = glm::normalize(glm::cross(f, hint));
    u = glm::cross(r, f);
  }
  /// Right, up and forward of a world point or vector.
  glm::dvec3 turned(const glm::dvec3& p) const {
    return {glm::dot(r, p), glm::dot(u, p), glm::dot(f, p)};
  }
  glm::dvec3 f, r, u;
};

struct Range {
  double low = 1e300, high = -1e300;
  void add(double v) {
    low = std::min(low, v);
    high = std::max(high, v);
  }
  double size() const { return high - low; }
  double centre() const { return (low + high) / 2; }
};

template <typename Visit>
void visit_triangles(const Scene& scene, Visit visit) {
  for (const Object& object : scene.objects) {
    for (const auto& t : object.triangles) {
      visit(object, object.positions[t[0]], object.positions[t[1]], object.positions[t[2]]);
    }
  }
}

glm::dmat4 from_rows(const std::array<glm::dvec4, 4>& rows) {
  glm::dmat4 m;
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 4; ++row) m[column][row] = rows[static_cast<std::size_t>(row)][column];
  }
  return m;
}

glm::dmat4 fit_directional(const Scene& scene, const CaptureOptions& options) {
  const LightBasis basis(scene.light.direction);
  const bool any_caster =
      std::any_of(scene.objects.begin(), scene.objects.end(),
                  [](const Object& o) { return o.caster && !o.triangles.empty(); });
  Range x, y, depth;
  visit_triangles(scene, [&](const Object& object, const auto&... vertex) {
    for (const glm::dvec3& p : {vertex...}) {
      const glm::dvec3 q = basis.turned(p);
      depth.add(q.z);
      if (object.caster || !any_caster) {
        x.add(q.x);
        y.add(q.y);
      }
    }
  });
  const double w = options.map_width, h = options.map_height;
  double texel, centre_x, centre_y;
  if (scene.light.half_extent > 0) {
    texel = 2 * scene.light.half_extent / std::min(w, h);
    const glm::dvec3 target = basis.turned(scene.light.target);
    centre_x = target.x;
    centre_y = target.y;
  } else {
    texel = kMargin * std::max(x.size() / w, y.size() / h);
    centre_x = x.centre();
    centre_y = y.centre();
  }
  const double reach = std::max({std::abs(x.low), std::abs(x.high), std::abs(y.low),
                                 std::abs(y.high), std::abs(depth.low), std::abs(depth.high)});
  if (!(texel > 0)) texel = std::max(reach, 1.0) / std::max(w, h);  // a single point or line
  // Padded, so that rounding puts nothing outside; a flat scene gets a depth of a texel or so.
  const double pad = std::max({depth.size() / 2048, texel / 2, 1e-12 * reach});
  const double near = depth.low - pad, far = depth.high + pad;
  const glm::dvec3 row_x = basis.r / (texel * w / 2), row_y = basis.u / (texel * h / 2);
  const glm::dvec3 row_z = basis.f / (far - near);
  return from_rows({glm::dvec4(row_x, -centre_x / (texel * w / 2)),
                    glm::dvec4(row_y, -centre_y / (texel * h / 2)),
                    glm::dvec4(row_z, -near / (far - near)), glm::dvec4(0, 0, 0, 1)});
}

/// The near plane stands just before the nearest caster in the frustum of scale 1, at whatever
/// scale the map is: depths do not depend on the scale. Casters nearer than it, which only a larger
/// scale can show, are flattened onto it (see casters.cpp).
glm::dmat4 fit_perspective(const Scene& scene, const CaptureOptions& options) {
  const Light& light = scene.light;
  const LightBasis basis(light.direction);
  const double slope = std::tan(glm::radians(light.spread_degrees) / 2);
  const double w = options.map_width, h = options.map_height;
  const double slope_x = slope * w / std::min(w, h), slope_y = slope * h / std::min(w, h);
  const auto turned = [&](const glm::dvec3& p) {
    const glm::dvec3 q = basis.turned(p - light.position);
    return glm::dvec4(q.x / slope_x, q.y / slope_y, 0, q.z);
  };
  double far = 0, reach = 0;
  visit_triangles(scene, [&](const Object&, const auto&... vertex) {
    for (const glm::dvec3& p : {vertex...}) {
      far = std::max(far, turned(p).w);
      reach = std::max(reach, glm::length(p - light.position));
    }
  });
  far = far > 0 ? far * (1 + 1e-6) : std::max(reach, 1.0);
  double nearest = far;
  const glm::dvec4 sides[] = {
      {1, 0, 0, 1}, {-1, 0, 0, 1}, {0, 1, 0, 1}, {0, -1, 0, 1}, {0, 0, 0, 1}};
  visit_triangles(scene, [&](const Object& object, const auto&... vertex) {
    if (!object.caster) return;
    ClipPolygon polygon;
    for (const glm::dvec3& p : {vertex...}) polygon.push(turned(p));
    for (const glm::dvec4& side : sides) polygon = clip(polygon, side);
    for (int i = 0; i < polygon.count; ++i) {
      nearest = std::min(nearest, polygon.vertex[static_cast<std::size_t>(i)].w);
    }
  });
  const double near = std::clamp(0.99 * nearest, kNearestShare * far, 0.99 * far);
  const double depth_scale = far / (far - near);
  const glm::dvec3 row_x = basis.r / slope_x, row_y = basis.u / slope_y;
  const auto row = [&](const glm::dvec3& r, double offset) {
    return glm::dvec4(r, offset - glm::dot(r, light.position));
  };
  return from_rows({row(row_x, 0), row(row_y, 0), row(basis.f * depth_scale, -near * depth_scale),
                    row(basis.f, 0)});
}

/// The largest |x| or |y| in texels, less whatever the map cuts off.
double reach_in_texels(const Scene& scene, const LightSpace& space) {
  const double limit_x = (space.map_width + 1) / 2, limit_y = (space.map_height + 1) / 2;
  double reach = 0;
  for (const Object& object : scene.objects) {
    for (const glm::dvec3& p : object.positions) {
      const glm::dvec4 c = space.clip_from_world * glm::dvec4(p, 1);
      const bool before = c.w > 0;
      const double x = before ? std::abs(c.x / c.w) * space.map_width / 2 : limit_x;
      const double y = before ? std::abs(c.y / c.w) * space.map_height / 2 : limit_y;
      reach = std::max({reach, std::min(x, limit_x), std::min(y, limit_y)});
    }
  }
  return reach;
}

}  // namespace

UnitGrid::UnitGrid(const LightSpace& space) {
  const double unit = std::ldexp(1.0, static_cast<int>(space.fraction_bits));
  const auto axis = [&](std::uint32_t texels, double& scale, double& offset, std::int32_t& low,
                        std::int32_t& high) {
    const double below = texels / 2, above = texels - texels / 2;
    scale = texels * 0.5 * unit;
    offset = (texels * 0.5 - below) * unit;
    low = static_cast<std::int32_t>(std::max<double>(-below * unit, kCoordinateMin));
    high = static_cast<std::int32_t>(std::min<double>(above * unit - 1, kCoordinateMax));
  };
  axis(space.map_width, scale_x, offset_x, min_x, max_x);
  axis(space.map_height, scale_y, offset_y, min_y, max_y);
  sides = {glm::dvec4(scale_x, 0, 0, offset_x - min_x + 0.5),
           glm::dvec4(-scale_x, 0, 0, max_x + 0.5 - offset_x),
           glm::dvec4(0, scale_y, 0, offset_y - min_y + 0.5),
           glm::dvec4(0, -scale_y, 0, max_y + 0.5 - offset_y)};
}

LightPoint UnitGrid::snap(const glm::dvec4& clip) const {
  const auto nearest = [](double v, double low, double high) {
    return std::clamp(std::floor(v + 0.5), low, high);
  };
  return {static_cast<std::int32_t>(nearest(x(clip), min_x, max_x)),
          static_cast<std::int32_t>(nearest(y(clip), min_y, max_y)),
          static_cast<std::uint32_t>(nearest(z(clip), 0, kDepthMax))};
}

LightPoint LightSpace::snap(const glm::dvec3& world, bool& outside) const {
  const UnitGrid grid(*this);
  const glm::dvec4 clip = clip_from_world * glm::dvec4(world, 1);
  outside = !(clip.w > 0) || (perspective && clip.z < 0);
  if (!(clip.w > 0)) return {};
  for (const glm::dvec4& side : grid.sides) outside = outside || !(glm::dot(side, clip) >= 0);
  return grid.snap(clip);
}

LightSpace fit_light_space(const Scene& scene, const CaptureOptions& options) {
  check_capture(scene, options);
  LightSpace space;
  space.map_width = options.map_width;
  space.map_height = options.map_height;
  space.perspective = scene.light.kind != Light::Kind::kDirectional;
  space.clip_from_world =
      space.perspective ? fit_perspective(scene, options) : fit_directional(scene, options);
  for (int column = 0; column < 4; ++column) {
    space.clip_from_world[column][0] /= options.scale_x;
    space.clip_from_world[column][1] /= options.scale_y;
  }
  // A coarser texel gets more fraction bits, so that a unit stays as fine as at scale 1 where the
  // coordinates have room for it.
  const double scale = std::max(options.scale_x, options.scale_y);
  const double reach = reach_in_texels(scene, space);
  int bits = static_cast<int>(kMinFractionBits) + static_cast<int>(std::floor(std::log2(scale)));
  while (bits > static_cast<int>(kMinFractionBits) &&
         std::ldexp(reach, bits) > kCoordinateMax + 1.0) {
    --bits;
  }
  space.fraction_bits = static_cast<std::uint32_t>(bits);
  return space;
}

}  // namespace kagesen

// Pass 1: do casters land where they should on the light's grid, watertight and at every scale?
#include "traces/raster/light_space.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

#include "tests/traces/raster_support.h"
#include "traces/raster/casters.h"
#include "traces/scene/random.h"
#include "traces/scene/solids.h"

namespace kagesen {
namespace {

CasterSet casters_of(const Scene& scene, const CaptureOptions& options) {
  return make_casters(scene, fit_light_space(scene, options));
}

CaptureOptions scaled(double scale) {
  CaptureOptions options = small_options();
  options.scale_x = options.scale_y = scale;
  return options;
}

/// A jittered, gently waved sheet of cells x cells quads over [-half, half] squared.
Scene sheet(int cells, double half, std::uint64_t seed) {
  Random random(seed);
  Scene scene = flat_scene({});
  Object& o = scene.objects[0];
  for (int j = 0; j <= cells; ++j) {
    for (int i = 0; i <= cells; ++i) {
      const bool rim = i == 0 || j == 0 || i == cells || j == cells;
      const double jitter = rim ? 0 : 0.3;
      o.positions.push_back({half * (2 * (i + random.uniform(-jitter, jitter)) / cells - 1),
                             random.uniform(0, 0.1),
                             half * (2 * (j + random.uniform(-jitter, jitter)) / cells - 1)});
    }
  }
  const auto n = static_cast<std::uint32_t>(cells);
  for (std::uint32_t j = 0; j < n; ++j) {
    for (std::uint32_t i = 0; i < n; ++i) {
      const std::uint32_t a = j * (n + 1) + i, b = a + 1, c = a + n + 1;
      o.triangles.push_back({a, c, c + 1});
      o.triangles.push_back({a, c + 1, b});
    }
  }
  return scene;
}

TEST(LightSpace, FitsTheCastersSquareAndCentred) {
  Scene scene = flat_scene({{glm::dvec3(-4, 0, -1), {4, 1, -1}, {0, 0, 1}}});
  for (const auto& size : {std::pair{1024u, 1024u}, {512u, 2048u}, {7u, 5u}, {1u, 1u}}) {
    CaptureOptions options = small_options();
    options.map_width = size.first;
    options.map_height = size.second;
    const LightSpace space = fit_light_space(scene, options);
    bool outside = true;
    const LightPoint left = space.snap({-4, 0, 0}, outside);
    EXPECT_FALSE(outside);
    const LightPoint right = space.snap({4, 0, 0}, outside);
    EXPECT_FALSE(outside);
    const double texels = std::abs(double(right.x) - left.x) / 65536;
    EXPECT_NEAR(texels, size.first / 1.015, 0.01);
    const LightPoint up = space.snap({0, 0, -1}, outside), down = space.snap({0, 0, 1}, outside);
    EXPECT_NEAR(std::abs(double(up.y) - down.y) / 65536, texels / 4, 0.01);  // square texels
    space.snap({4.2, 0, 0}, outside);
    EXPECT_TRUE(outside);
  }
}

TEST(LightSpace, HalfExtentAndDepthRange) {
  Scene scene = sheet(2, 1, 1);
  scene.light.half_extent = 2;
  scene.light.target = {0.5, 0, 0};
  const LightSpace space = fit_light_space(scene, small_options());
  bool outside = false;
  EXPECT_EQ(space.snap({0.5, 0, 0}, outside).x, 0);
  EXPECT_EQ(std::abs(space.snap({1.5, 0, 0}, outside).x), 256 * 65536);
  const LightPoint high = space.snap({0, 0.1, 0}, outside), low = space.snap({0, 0, 0}, outside);
  EXPECT_LT(high.z, low.z);  // depth grows away from the light
  EXPECT_GT(low.z - high.z, kDepthMax / 2);
}

TEST(LightSpace, ScalingByPowersOfTwoKeepsEveryInteger) {
  Scene scene = make_builtin("solids");
  for (const bool spot : {false, true}) {
    if (spot) {
      scene.light.kind = Light::Kind::kSpot;
      scene.light.position = scene.light.target - scene.light.direction * 12.0;
      scene.light.spread_degrees = 60;
    } else {
      scene.light.half_extent = 10;  // the ground too fits the map of scale 1
    }
    const Trace at_1 = captured(scene, scaled(1));
    for (const double scale : {4.0, 16.0}) {
      const Trace at_s = captured(scene, scaled(scale));
      EXPECT_GT(at_s.header.fraction_bits, at_1.header.fraction_bits);
      EXPECT_EQ(keys(at_1.all_casters), keys(at_s.all_casters)) << scale;
      if (spot) continue;  // more of the ground comes into the map
      EXPECT_EQ(keys(at_1.all_fragments), keys(at_s.all_fragments)) << scale;
    }
  }
}

TEST(LightSpace, FractionBitsGiveWayWhereCoordinatesWouldNotFit) {
  const Scene scene = make_builtin("avenue");
  for (const double scale : {1.0, 1.5, 4.0, 16.0, 100.0, 1024.0}) {
    const Trace trace = captured(scene, scaled(scale));
    EXPECT_GE(trace.header.fraction_bits, 16u);
    EXPECT_LE(trace.header.fraction_bits, 26u);
    const double limit = std::ldexp(512.0, static_cast<int>(trace.header.fraction_bits));
    for (const Caster& c : trace.all_casters) {
      for (const LightPoint& p : c.vertex) {
        ASSERT_TRUE(p.x >= kCoordinateMin && p.x <= kCoordinateMax && p.x >= -limit &&
                    p.x < limit && p.y >= -limit && p.y < limit && p.z <= kDepthMax);
      }
    }
    for (const Fragment& f : trace.all_fragments) {
      ASSERT_TRUE(f.position.x >= kCoordinateMin && f.position.x <= kCoordinateMax &&
                  f.position.z <= kDepthMax);
    }
  }
}

/// Doubled area that the casters cover.
double covered_area(const CasterSet& set) {
  double sum = 0;
  for (const Caster& c : set.casters) {
    sum += static_cast<double>(std::abs(doubled_area(c.vertex[0], c.vertex[1], c.vertex[2])));
  }
  return sum;
}

TEST(Casters, ClippingKeepsTheAreaAndTheSharedCorners) {
  for (const std::uint64_t seed : {1u, 2u, 3u}) {
    Scene scene = sheet(17, 3, seed);
    scene.light.half_extent = 1;
    for (const bool spot : {false, true}) {
      if (spot) {
        scene.light.kind = Light::Kind::kSpot;
        scene.light.position = {0.1, 1.2, 0};
        scene.light.direction = {0.05, -1, 0};
        scene.light.spread_degrees = 80;
      }
      const CasterSet set = casters_of(scene, small_options());
      EXPECT_GT(set.clipped, 20u);
      EXPECT_GT(set.outside, 20u);
      const double side = 1024.0 * 65536 - 1;
      EXPECT_NEAR(covered_area(set) / (2 * side * side), 1, 1e-9);

      // Inside the map every edge has its opposite: no cracks, no T-junctions.
      std::map<std::pair<std::pair<int, int>, std::pair<int, int>>, int> balance;
      const auto point = [](const LightPoint& p) { return std::pair{p.x, p.y}; };
      for (const Caster& c : set.casters) {
        for (int i = 0; i < 3; ++i) {
          const auto a = point(c.vertex[i]), b = point(c.vertex[(i + 1) % 3]);
          ++balance[{a, b}];
          --balance[{b, a}];
        }
      }
      const int low = -(512 << 16), high = (512 << 16) - 1;
      const auto on_border = [&](const std::pair<int, int>& p, const std::pair<int, int>& q) {
        return (p.first == q.first && (p.first == low || p.first == high)) ||
               (p.second == q.second && (p.second == low || p.second == high));
      };
      for (const auto& [edge, count] : balance) {
        ASSERT_TRUE(count == 0 || on_border(edge.first, edge.second));
      }
    }
  }
}

TEST(Casters, TrianglesInsideAreNotTouched) {
  const Scene scene = make_builtin("boxes");
  const CaptureOptions options = small_options();
  const LightSpace space = fit_light_space(scene, options);
  const CasterSet set = make_casters(scene, space);
  EXPECT_EQ(set.clipped, 0u);
  EXPECT_EQ(set.casters.size() + set.culled + set.degenerate, 2400u);
  std::uint32_t polygon = 0;
  for (const Object& o : scene.objects) {
    for (const auto& t : o.triangles) {
      for (std::uint32_t i = set.first[polygon]; i < set.first[polygon + 1]; ++i) {
        const Caster& c = set.casters[i];
        EXPECT_EQ(c.polygon, polygon);
        for (std::size_t v = 0; v < 3; ++v) {
          bool outside = false;
          EXPECT_EQ(key(c.vertex[v]), key(space.snap(o.positions[t[v]], outside)));
        }
      }
      ++polygon;
    }
  }
}

TEST(Casters, ClosedObjectsDrawLightFacingTrianglesOnlyOpenOnesAll) {
  Scene scene = flat_scene({});
  scene.objects[0] = make_box({1, 1, 1});
  scene.light.direction = {0.3, -1, 0.2};
  classify_objects(scene);
  CasterSet set = casters_of(scene, small_options());
  EXPECT_EQ(set.casters.size(), 6u);
  EXPECT_EQ(set.culled, 6u);
  for (const Caster& c : set.casters) {
    EXPECT_GT(doubled_area(c.vertex[0], c.vertex[1], c.vertex[2]), 0);
  }
  scene.objects[0].triangles.pop_back();
  classify_objects(scene);
  set = casters_of(scene, small_options());
  EXPECT_EQ(set.casters.size(), 11u);
  EXPECT_EQ(set.culled, 0u);
  scene.light.direction = {0, -1, 0};  // four sides on edge
  scene.objects[0] = make_box({1, 1, 1});
  classify_objects(scene);
  set = casters_of(scene, small_options());
  EXPECT_EQ(set.casters.size(), 2u);
  EXPECT_EQ(set.culled, 2u);
  EXPECT_EQ(set.degenerate, 8u);
}

TEST(Casters, ReceiversStayOutAndKeepTheirPolygonNumbers) {
  Scene scene = flat_scene({{glm::dvec3(0, 0, 0), {1, 0, 0}, {0, 0, 1}}});
  scene.objects.push_back(scene.objects[0]);
  scene.objects[0].caster = false;
  const CasterSet set = casters_of(scene, small_options());
  ASSERT_EQ(set.casters.size(), 1u);
  EXPECT_EQ(set.casters[0].polygon, 1u);
  EXPECT_EQ(set.casters[0].object, 1u);
}

TEST(PointLight, WhatLiesBeforeTheNearPlaneIsFlattenedNotLost) {
  // Beside the light, outside the frustum of scale 1 but inside that of scale 8.
  Scene scene = sheet(6, 3, 4);
  scene.light.kind = Light::Kind::kPoint;
  scene.light.position = {0, 4, 0};
  scene.light.spread_degrees = 60;
  Object flag = flat_scene({{glm::dvec3(2, 3.7, 0), {2.5, 3.9, 0.4}, {2.2, -0.5, 0.9}}}).objects[0];
  scene.objects.push_back(flag);
  const LightSpace space_1 = fit_light_space(scene, scaled(1));
  const LightSpace space_8 = fit_light_space(scene, scaled(8));
  for (int column = 0; column < 4; ++column) {
    EXPECT_EQ(space_1.clip_from_world[column][2], space_8.clip_from_world[column][2]);
  }
  const CasterSet set = make_casters(scene, space_8);
  std::set<std::uint32_t> depths;
  double area = 0;
  for (const Caster& c : set.casters) {
    if (c.object != 1) continue;
    for (const LightPoint& p : c.vertex) depths.insert(p.z);
    area += static_cast<double>(std::abs(doubled_area(c.vertex[0], c.vertex[1], c.vertex[2])));
  }
  EXPECT_EQ(*depths.begin(), 0u);
  EXPECT_GT(*depths.rbegin(), 0u);
  EXPECT_GT(area, 0);
}

TEST(PointLight, CastersBehindAndAroundTheLight) {
  Scene scene = flat_scene({});
  scene.objects[0] = make_sphere(3, 40, 20);  // the light stands inside
  classify_objects(scene);
  scene.light.kind = Light::Kind::kPoint;
  scene.light.position = {0.2, 0.1, 0};
  for (const double spread : {1.0, 90.0, 169.0}) {
    scene.light.spread_degrees = spread;
    for (Object& o : scene.objects) o.closed = false;
    const CasterSet set = casters_of(scene, small_options());
    const double side = 1024.0 * 65536 - 1;
    EXPECT_NEAR(covered_area(set) / (2 * side * side), 1, 1e-6) << spread;
  }
}

}  // namespace
}  // namespace kagesen

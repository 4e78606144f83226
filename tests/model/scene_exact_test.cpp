#include "model/reference/scene_exact.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace kagesen {
namespace {

constexpr std::uint32_t kSide = 100;  ///< of the image, pixels

Object rectangle(double x0, double x1, double z0, double z1, double y) {
  Object o;
  o.positions = {{x0, y, z0}, {x1, y, z0}, {x1, y, z1}, {x0, y, z1}};
  o.triangles = {{0, 2, 1}, {0, 3, 2}};
  return o;
}

/// A plate [-1, 1]^2 at height 1 over a ground at height 0, light straight from above, and a camera
/// that looks straight down from far away through a narrow lens: pixel (px, py) is nearly x = ...,
/// z = ...
struct PlateScene {
  Scene scene;
  LightSpace light;
  Trace trace;
  std::vector<std::uint8_t> verdicts;

  explicit PlateScene(bool spot = false) {
    scene.objects = {rectangle(-4, 4, -4, 4, 0), rectangle(-1, 1, -1, 1, 1)};
    scene.objects[0].caster = false;
    scene.camera.eye = {9, 6, 0};
    scene.camera.target = {0, 0, 0};
    scene.camera.vertical_fov_degrees = 30;
    if (spot) {
      scene.light.kind = Light::Kind::kSpot;
      scene.light.position = {0, 2, 0};
      light.perspective = true;
    }
    trace.header.image_width = trace.header.image_height = kSide;
    const PixelRays rays(scene.camera, kSide, kSide);
    for (std::uint16_t y = 0; y < kSide; ++y) {
      for (std::uint16_t x = 0; x < kSide; ++x) add_pixel(rays, x, y, spot ? 2 : 1);
    }
  }
  /// What analytic geometry says: the shadow is the square [-reach, reach]^2 on the ground.
  void add_pixel(const PixelRays& rays, std::uint16_t px, std::uint16_t py, double reach) {
    const glm::dvec3 o = rays.origin(), d = rays.direction(px, py);
    Fragment f;
    f.pixel_x = px;
    f.pixel_y = py;
    f.flags = Fragment::kVisible;
    glm::dvec3 p = o + d * ((1 - o.y) / d.y);
    f.object = 1;
    if (std::abs(p.x) > 1 || std::abs(p.z) > 1) {
      f.object = 0;
      p = o - d * (o.y / d.y);
      if (d.y >= 0 || std::abs(p.x) > 4 || std::abs(p.z) > 4) return;
    }
    trace.all_fragments.push_back(f);
    verdicts.push_back(f.object == 0 && std::abs(p.x) <= reach && std::abs(p.z) <= reach);
  }
};

TEST(SceneExact, AgreesWithAnalyticShadows) {
  for (bool spot : {false, true}) {
    const PlateScene s(spot);
    const auto report = scene_exact(s.scene, s.light, s.trace, s.verdicts, s.verdicts);
    const std::size_t count = s.trace.all_fragments.size();
    ASSERT_GT(count, 2000u);
    EXPECT_GT(std::count(s.verdicts.begin(), s.verdicts.end(), 1), 100);
    EXPECT_EQ(report.judged, count);
    EXPECT_EQ(report.skipped, 0u);
    EXPECT_EQ(report.paper.agree, count);
    EXPECT_EQ(report.physical.agree, count);
    EXPECT_EQ(report.paper.wrong() + report.physical.wrong(), 0u);
  }
}

TEST(SceneExact, CountsWrongVerdictsByDirection) {
  const PlateScene s;
  auto paper = s.verdicts, physical = s.verdicts;
  std::size_t lit = 0, dark = 0;
  for (std::size_t i = 0; i < paper.size(); i += 7) {
    ++(paper[i] ? dark : lit);
    paper[i] ^= 1;
  }
  for (unsigned threads : {1u, 3u}) {
    const auto report = scene_exact(s.scene, s.light, s.trace, paper, physical, threads);
    EXPECT_EQ(report.paper.false_lit, dark);
    EXPECT_EQ(report.paper.false_dark, lit);
    EXPECT_EQ(report.physical.wrong(), 0u);
  }
}

TEST(SceneExact, OwnObjectShadowsOnlyPhysically) {
  PlateScene s;
  Object& plate = s.scene.objects[1];  // plate and ground become one object
  s.scene.objects[0].caster = true;
  for (const glm::dvec3& p : plate.positions) s.scene.objects[0].positions.push_back(p);
  for (const auto& t : plate.triangles) {
    s.scene.objects[0].triangles.push_back({t[0] + 4, t[1] + 4, t[2] + 4});
  }
  plate.triangles.clear();
  for (Fragment& f : s.trace.all_fragments) f.object = 0;
  const std::vector<std::uint8_t> lit(s.verdicts.size(), 0);
  const auto report = scene_exact(s.scene, s.light, s.trace, lit, s.verdicts);
  EXPECT_EQ(report.paper.agree, s.verdicts.size());
  EXPECT_EQ(report.physical.agree, s.verdicts.size());
}

TEST(SceneExact, ReceiversCastNoShadow) {
  PlateScene s;
  s.scene.objects[1].caster = false;
  const std::vector<std::uint8_t> lit(s.verdicts.size(), 0);
  const auto report = scene_exact(s.scene, s.light, s.trace, lit, lit);
  EXPECT_EQ(report.physical.agree, s.verdicts.size());
}

TEST(SceneExact, SkipsAndIgnores) {
  PlateScene s;
  s.trace.all_fragments[0].object ^= 1;
  s.trace.all_fragments[1].flags = 0;
  s.trace.all_fragments[2].flags |= Fragment::kAverted;
  s.trace.all_fragments[3].flags |= Fragment::kOutside;
  const auto report = scene_exact(s.scene, s.light, s.trace, s.verdicts, s.verdicts);
  EXPECT_EQ(report.skipped, 1u);
  EXPECT_EQ(report.ignored, 3u);
  EXPECT_EQ(report.judged + 4, s.trace.all_fragments.size());
}

TEST(SceneExact, RejectsWhatDoesNotFitTogether) {
  PlateScene s;
  auto short_by_one = s.verdicts;
  short_by_one.pop_back();
  EXPECT_THROW(scene_exact(s.scene, s.light, s.trace, short_by_one, s.verdicts),
               std::invalid_argument);
  s.light.perspective = true;
  EXPECT_THROW(scene_exact(s.scene, s.light, s.trace, s.verdicts, s.verdicts),
               std::invalid_argument);
  s.light.perspective = false;
  s.scene.objects[0].triangles[0][1] = 4;
  EXPECT_THROW(scene_exact(s.scene, s.light, s.trace, s.verdicts, s.verdicts),
               std::invalid_argument);
}

}  // namespace
}  // namespace kagesen

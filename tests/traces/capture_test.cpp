// Pass 2: are the fragments those that the camera sees, in every mode, and free of false shadow?
#include "traces/raster/capture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "tests/traces/raster_support.h"
#include "traces/raster/casters.h"
#include "traces/scene/solids.h"

namespace kagesen {
namespace {

Trace in_mode(const Scene& scene, FragmentMode mode) {
  CaptureOptions options = small_options();
  options.mode = mode;
  return captured(scene, options);
}

TEST(Capture, HeaderAndSummaryAgreeWithTheRecords) {
  const Scene scene = make_builtin("solids");
  Trace trace;
  const CaptureSummary summary = capture(scene, small_options(), trace);
  EXPECT_EQ(trace.header.source, "solids");
  EXPECT_EQ(trace.header.source_sha256, scene.sha256);
  EXPECT_EQ(trace.header.light, "directional");
  EXPECT_EQ(trace.header.image_width, 320u);
  ASSERT_EQ(trace.header.objects.size(), scene.objects.size());
  EXPECT_TRUE(trace.header.objects[0].closed);
  EXPECT_FALSE(trace.header.objects.back().caster);
  EXPECT_EQ(summary.casters, trace.all_casters.size());
  EXPECT_EQ(summary.fragments, trace.all_fragments.size());
  const auto flagged = [&](int flag) {
    return static_cast<std::uint64_t>(
        std::count_if(trace.all_fragments.begin(), trace.all_fragments.end(),
                      [&](const Fragment& f) { return (f.flags & flag) != 0; }));
  };
  EXPECT_EQ(summary.averted, flagged(Fragment::kAverted));
  EXPECT_EQ(summary.outside, flagged(Fragment::kOutside));
  EXPECT_GT(summary.averted, 0u);
}

TEST(Capture, SameEveryTime) {
  const Scene scene = make_builtin("hair");
  const Trace a = captured(scene, small_options()), b = captured(scene, small_options());
  EXPECT_EQ(keys(a.all_casters), keys(b.all_casters));
  EXPECT_EQ(keys(a.all_fragments), keys(b.all_fragments));
}

TEST(Modes, VisibleIsPartOfEarlyZIsPartOfAll) {
  for (const char* name : {"solids", "boxes", "hair"}) {
    const Scene scene = make_builtin(name);
    const auto visible = keys(in_mode(scene, FragmentMode::kVisible).all_fragments);
    const Trace early = in_mode(scene, FragmentMode::kEarlyZ);
    const Trace all = in_mode(scene, FragmentMode::kAll);
    EXPECT_LT(visible.size(), early.all_fragments.size());
    EXPECT_LT(early.all_fragments.size(), all.all_fragments.size());
    for (const Trace* trace : {&early, &all}) {
      std::vector<Fragment> seen;
      std::copy_if(trace->all_fragments.begin(), trace->all_fragments.end(),
                   std::back_inserter(seen),
                   [](const Fragment& f) { return (f.flags & Fragment::kVisible) != 0; });
      EXPECT_EQ(keys(seen), visible) << name;  // order included
    }
    auto sorted_early = keys(early.all_fragments), sorted_all = keys(all.all_fragments);
    std::sort(sorted_early.begin(), sorted_early.end());
    std::sort(sorted_all.begin(), sorted_all.end());
    EXPECT_TRUE(std::includes(sorted_all.begin(), sorted_all.end(), sorted_early.begin(),
                              sorted_early.end()));
    std::set<std::pair<int, int>> pixels;
    for (const auto& f : visible) {
      EXPECT_TRUE(pixels.emplace(std::get<0>(f), std::get<1>(f)).second) << "pixel seen twice";
    }
  }
}

TEST(Fragments, StreamInTriangleOrder) {
  for (const FragmentMode mode : {FragmentMode::kVisible, FragmentMode::kAll}) {
    const Trace trace = in_mode(make_builtin("boxes"), mode);
    EXPECT_TRUE(
        std::is_sorted(trace.all_fragments.begin(), trace.all_fragments.end(),
                       [](const Fragment& a, const Fragment& b) { return a.object < b.object; }));
  }
}

__extension__ typedef __int128 Wide;

/// Is p inside or on the caster's outline and strictly beyond its plane? Exact.
bool shadows(const Caster& c, const LightPoint& p) {
  std::int64_t side[3];
  const std::int64_t area = doubled_area(c.vertex[0], c.vertex[1], c.vertex[2]);
  Wide depth = 0;
  for (int i = 0; i < 3; ++i) {
    side[i] = doubled_area(c.vertex[(i + 1) % 3], c.vertex[(i + 2) % 3], p);
    if (area > 0 ? side[i] < 0 : side[i] > 0) return false;
    depth += Wide{side[i]} * c.vertex[i].z;
  }
  return area > 0 ? depth < Wide{area} * p.z : depth > Wide{area} * p.z;
}

TEST(Fragments, ConvexSolidsDoNotShadowThemselves) {
  for (const bool spot : {false, true}) {
    Scene scene = make_builtin("solids");
    if (spot) {
      scene.light.kind = Light::Kind::kSpot;
      scene.light.position = scene.light.target - scene.light.direction * 12.0;
      scene.light.spread_degrees = 50;
    }
    const Trace trace = captured(scene, small_options());
    std::map<std::uint32_t, std::vector<const Caster*>> by_object;
    for (const Caster& c : trace.all_casters) by_object[c.object].push_back(&c);
    std::size_t tested = 0, shadowed = 0;
    for (const Fragment& f : trace.all_fragments) {
      if (f.flags & (Fragment::kAverted | Fragment::kOutside)) continue;
      for (const Caster* c : by_object[f.object]) {
        ++tested;
        shadowed += shadows(*c, f.position) ? 1 : 0;
      }
    }
    EXPECT_GT(tested, 100000u);
    EXPECT_EQ(shadowed, 0u);
  }
}

TEST(Fragments, LieOnTheirSurface) {
  const Scene scene = make_builtin("solids");
  const CaptureOptions options = small_options();
  const LightSpace space = fit_light_space(scene, options);
  // On the ground light space is an affine map of (x, z): three corners foretell every depth.
  const Object& ground = scene.objects.back();
  const auto at = [&](const glm::dvec3& p) {
    const glm::dvec4 c = space.clip_from_world * glm::dvec4(p, 1);
    return glm::dvec3(c.x * 512 * 65536, c.y * 512 * 65536, c.z * kDepthMax);
  };
  const glm::dvec3 a = at(ground.positions[0]), b = at(ground.positions[1]) - a,
                   c = at(ground.positions[2]) - a;
  const double det = b.x * c.y - b.y * c.x;
  std::size_t count = 0;
  for (const Fragment& f : captured(scene, options).all_fragments) {
    if (f.object + 1 != scene.objects.size() || (f.flags & Fragment::kOutside)) continue;
    const double x = f.position.x - a.x, y = f.position.y - a.y;
    const double u = (x * c.y - y * c.x) / det, v = (b.x * y - b.y * x) / det;
    const double depth = a.z + u * b.z + v * c.z;
    ASSERT_LE(f.position.z, depth + 1);  // floor, half a unit of snapping away
    ASSERT_GE(f.position.z, depth - 2);
    ++count;
  }
  EXPECT_GT(count, 1000u);
}

TEST(Fragments, AvertedIsTheSideTheCameraSees) {
  // A sheet lit from above, seen from above and from below.
  Scene scene = flat_scene({{glm::dvec3(-5, 0, -5), {-5, 0, 5}, {5, 0, 0}}});
  for (const bool above : {true, false}) {
    scene.camera.eye = {0, above ? 10.0 : -10.0, 0};
    for (const bool turned : {true, false}) {
      if (turned) std::swap(scene.objects[0].triangles[0][0], scene.objects[0].triangles[0][1]);
      const Trace trace = captured(scene, small_options());
      ASSERT_FALSE(trace.all_fragments.empty());
      for (const Fragment& f : trace.all_fragments) {
        ASSERT_EQ((f.flags & Fragment::kAverted) != 0, !above);
        ASSERT_EQ(f.shade, above ? 255 : 0);
      }
    }
  }
}

TEST(Fragments, OutsideTheMapAreFlaggedAndClamped) {
  Scene scene = make_builtin("avenue");
  const Trace trace = captured(scene, small_options());
  std::size_t outside = 0;
  for (const Fragment& f : trace.all_fragments) {
    ASSERT_TRUE(f.position.x >= -(512 << 16) && f.position.x < 512 << 16);
    ASSERT_TRUE(f.position.y >= -(512 << 16) && f.position.y < 512 << 16);
    outside += f.flags & Fragment::kOutside ? 1 : 0;
  }
  EXPECT_GT(outside, 1000u);
}

TEST(Fragments, DuplicateFacesAreSeenOnceAndTheFirstWins) {
  Scene scene = flat_scene({{glm::dvec3(-5, 0.1, -5), {-5, 0.3, 5}, {5, 0.7, 0}},
                            {glm::dvec3(5, 0.7, 0), {-5, 0.3, 5}, {-5, 0.1, -5}}});
  scene.objects.push_back(scene.objects[0]);
  for (const Fragment& f : captured(scene, small_options()).all_fragments) {
    ASSERT_EQ(f.object, 0u);
  }
}

TEST(Capture, CameraInsideASolid) {
  Scene scene = flat_scene({});
  scene.objects[0] = make_box({2, 2, 2});
  classify_objects(scene);
  scene.camera.eye = {0.3, 0.1, 0.2};
  scene.camera.target = {1, 0.2, 0.1};
  scene.camera.up = {0, 1, 0};
  scene.light.direction = {0.2, -1, 0.1};
  EXPECT_EQ(captured(scene, small_options()).all_fragments.size(), 320u * 180u);
}

TEST(Capture, OddMapsAndLooksAlongUp) {
  Scene scene = make_builtin("solids");
  scene.camera.eye = {0, 12, 0};
  scene.camera.target = {0, 0, 0};
  scene.camera.up = {0, 1, 0};
  CaptureOptions options = small_options();
  options.map_width = 37;
  options.map_height = 4095;
  const Trace trace = captured(scene, options);
  EXPECT_GT(trace.all_fragments.size(), 10000u);
  for (const Caster& c : trace.all_casters) {
    for (const LightPoint& p : c.vertex) {
      ASSERT_TRUE(p.x >= -(18 << 16) && p.x < 19 << 16);
      ASSERT_TRUE(p.y >= -(2047 << 16) && p.y < 2048 << 16);
    }
  }
}

TEST(Capture, RefusesWhatCannotBeCaptured) {
  const Scene good = make_builtin("solids");
  const auto refuses = [&](const char* where, auto&& spoil) {
    Scene scene = good;
    CaptureOptions options = small_options();
    spoil(scene, options);
    Trace trace;
    const std::string what = user_error([&] { capture(scene, options, trace); });
    EXPECT_EQ(what.compare(0, std::string(where).size(), where), 0) << where << ": " << what;
  };
  using S = Scene;
  using O = CaptureOptions;
  refuses("camera", [](S& s, O&) { s.camera.eye = s.camera.target; });
  refuses("camera", [](S& s, O&) { s.camera.vertical_fov_degrees = 0; });
  refuses("camera", [](S& s, O&) { s.camera.vertical_fov_degrees = 180; });
  refuses("camera", [](S& s, O&) { s.camera.eye.x = std::nan(""); });
  refuses("camera", [](S& s, O&) { s.camera.near_plane = -1; });
  refuses("image size", [](S&, O& o) { o.image_width = 0; });
  refuses("image size", [](S&, O& o) { o.image_height = 16385; });
  refuses("map size", [](S&, O& o) { o.map_width = 0; });
  refuses("map size", [](S&, O& o) { o.map_height = 4097; });
  refuses("scale", [](S&, O& o) { o.scale_x = 0.5; });
  refuses("scale", [](S&, O& o) { o.scale_y = std::numeric_limits<double>::infinity(); });
  refuses("light", [](S& s, O&) { s.light.direction = {0, 0, 0}; });
  refuses("light", [](S& s, O&) { s.light.half_extent = -1; });
  for (const double spread : {0.0, 170.0, std::nan("")}) {
    refuses("light", [&](S& s, O&) {
      s.light.kind = Light::Kind::kSpot;
      s.light.spread_degrees = spread;
    });
  }
  refuses("solids", [](S& s, O&) { s.objects.clear(); });
}

}  // namespace
}  // namespace kagesen

// Are the built-in scenes what their names promise, and is `closed` told rightly?
#include "traces/scene/scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "tests/traces/raster_support.h"
#include "traces/scene/fit.h"
#include "traces/scene/random.h"
#include "traces/scene/solids.h"

namespace kagesen {
namespace {

Object classified(Object object) {
  classify_object(object);
  return object;
}

double signed_volume(const Object& o) {
  double sum = 0;
  for (const auto& t : o.triangles) {
    sum += glm::dot(o.positions[t[0]], glm::cross(o.positions[t[1]], o.positions[t[2]]));
  }
  return sum / 6;
}

/// Each scene is made once: the largest takes a second.
const Scene& builtin(const std::string& name) {
  static std::map<std::string, Scene> made;
  const auto found = made.find(name);
  return found != made.end() ? found->second : made.emplace(name, make_builtin(name)).first->second;
}

class Builtin : public testing::TestWithParam<std::string> {};

TEST_P(Builtin, ClosedCastersOverAReceiver) {
  const Scene& scene = builtin(GetParam());
  ASSERT_GE(scene.objects.size(), 2u);
  std::size_t receivers = 0;
  for (const Object& object : scene.objects) {
    if (object.caster) {
      EXPECT_TRUE(object.closed) << object.name;
      EXPECT_GT(signed_volume(object), 0) << object.name;
    } else {
      ++receivers;
    }
    for (const auto& t : object.triangles) {
      for (const std::uint32_t v : t) ASSERT_LT(v, object.positions.size());
    }
  }
  EXPECT_EQ(receivers, 1u);
  EXPECT_EQ(scene.name, GetParam());
}

TEST_P(Builtin, NothingReachesBelowTheGround) {
  const Scene& scene = builtin(GetParam());
  EXPECT_GT(caster_bounds(scene).low.y, 0);
}

TEST_P(Builtin, SameEveryTime) {
  const Scene &a = builtin(GetParam()), b = make_builtin(GetParam());
  EXPECT_EQ(a.sha256, b.sha256);
  EXPECT_EQ(a.sha256.size(), 64u);
}

std::vector<std::string> builtin_names() {
  std::vector<std::string> names;
  for (const SceneInfo& info : builtin_scenes()) names.push_back(info.name);
  return names;
}
INSTANTIATE_TEST_SUITE_P(All, Builtin, testing::ValuesIn(builtin_names()),
                         [](const auto& info) { return info.param; });

TEST(BuiltinScenes, DigestsDoNotDrift) {
  // Results name scenes by these; a changed generator must be a decision.
  EXPECT_EQ(builtin("solids").sha256.substr(0, 16), "3c9bd04ef1a85305");
  EXPECT_EQ(builtin("boxes").sha256.substr(0, 16), "0709b5268283e847");
  EXPECT_EQ(builtin("hair").sha256.substr(0, 16), "a7881f8c0e3183be");
}

TEST(BuiltinScenes, DefaultIsSolidsAndAMillionIsAMillion) {
  EXPECT_EQ(builtin_scenes().front().name, "solids");
  EXPECT_EQ(builtin("sphere1m").objects[0].triangles.size(), 1000000u);
  EXPECT_EQ(builtin("boxes").objects.size(), 201u);
}

TEST(BuiltinScenes, SolidsAreConvex) {
  const Scene& scene = builtin("solids");
  for (const Object& o : scene.objects) {
    if (!o.caster) continue;
    for (const auto& t : o.triangles) {
      const glm::dvec3 a = o.positions[t[0]];
      const glm::dvec3 n = glm::normalize(glm::cross(o.positions[t[1]] - a, o.positions[t[2]] - a));
      for (const glm::dvec3& p : o.positions) {
        // The grid of 2^-20 bends flat faces by a little more than its step.
        ASSERT_LT(glm::dot(n, p - a), 2e-5) << o.name;
      }
    }
  }
}

TEST(BuiltinScenes, UnknownNameOffersTheNearest) {
  const std::string what = user_error([] { make_builtin("solid"); });
  EXPECT_NE(what.find("'solid'"), std::string::npos);
  EXPECT_NE(what.find("did you mean solids,"), std::string::npos) << what;
}

TEST(Closedness, EachSolidOfTheKit) {
  for (const Object& o :
       {make_box({1, 2, 3}), make_tetrahedron(1), make_icosahedron(1), make_cylinder(1, 0.5, 1, 7),
        make_sphere(1, 9, 5), make_torus(2, 0.5, 11, 6),
        make_cells({"###", "#.#", "###"}, {0, 1, 2, 3}, {0, 1, 2, 3}, 0.5)}) {
    EXPECT_GT(signed_volume(o), 0) << o.positions.size();
    EXPECT_TRUE(classified(o).closed) << o.positions.size();
  }
}

TEST(Closedness, AHoleOpens) {
  Object box = make_box({1, 1, 1});
  box.triangles.pop_back();
  EXPECT_FALSE(classified(box).closed);
}

TEST(Closedness, OneFaceTurnedRoundOpens) {
  Object box = make_box({1, 1, 1});
  std::swap(box.triangles[3][0], box.triangles[3][1]);
  EXPECT_FALSE(classified(box).closed);
}

TEST(Closedness, InwardSolidsAreTurnedOutward) {
  Object box = make_box({1, 1, 1});
  for (auto& t : box.triangles) std::swap(t[0], t[1]);
  const Object turned = classified(box);
  EXPECT_TRUE(turned.closed);
  EXPECT_NEAR(signed_volume(turned), 8, 1e-12);
}

TEST(Closedness, BackToBackDuplicatesAreOpen) {
  Object sheet;
  sheet.positions = {{0.1, 0.2, 0.3}, {1.7, 0.4, 0.1}, {0.3, 1.9, 0.7}};
  sheet.triangles = {{0, 1, 2}, {0, 2, 1}};
  EXPECT_FALSE(classified(sheet).closed);
}

TEST(Closedness, ASheetBesideASolidOpensTheObject) {
  Object both = make_box({1, 1, 1});
  both.positions.insert(both.positions.end(), {{5, 0, 0}, {6, 0, 0}, {5, 1, 0}});
  both.triangles.push_back({8, 9, 10});
  both.triangles.push_back({8, 10, 9});
  EXPECT_FALSE(classified(both).closed);
}

TEST(Closedness, UnweldedCornersCountAsOne) {
  const Object box = make_box({1, 1, 1});
  Object loose;
  for (const auto& t : box.triangles) {
    for (const std::uint32_t v : t) {
      loose.triangles.resize(loose.positions.size() / 3 + 1);
      loose.triangles.back()[loose.positions.size() % 3] =
          static_cast<std::uint32_t>(loose.positions.size());
      loose.positions.push_back(box.positions[v] + glm::dvec3(v % 2 ? 0.0 : -0.0));
    }
  }
  EXPECT_TRUE(classified(loose).closed);
}

TEST(Closedness, AnEdgeOfFourFacesIsOpen) {
  Object two = make_box({1, 1, 1});
  const Object other = make_box({1, 1, 1});
  for (const glm::dvec3& p : other.positions) two.positions.push_back(p + glm::dvec3(2, 2, 0));
  for (const auto& t : other.triangles) two.triangles.push_back({t[0] + 8, t[1] + 8, t[2] + 8});
  EXPECT_FALSE(classified(two).closed);
}

TEST(Components, AreNumberedByFirstAppearance) {
  Object two = make_box({1, 1, 1});
  for (const glm::dvec3& p : make_tetrahedron(1).positions) {
    two.positions.push_back(p + glm::dvec3(9, 0, 0));
  }
  two.triangles.insert(two.triangles.begin(), {{8, 9, 10}, {8, 11, 9}, {8, 10, 11}, {9, 11, 10}});
  two.name = "two";
  const std::vector<Object> parts = split_components(two);
  ASSERT_EQ(parts.size(), 2u);
  EXPECT_EQ(parts[0].triangles.size(), 4u);
  EXPECT_EQ(parts[1].triangles.size(), 12u);
  EXPECT_EQ(parts[1].positions.size(), 8u);
  EXPECT_EQ(parts[1].name, "two.1");
}

TEST(Fit, CameraSeesEveryCasterAndLightComesFromAbove) {
  Scene scene = flat_scene({{glm::dvec3(-30, 2, 7), {5, 90, 1}, {3, 4, -60}}});
  fit_camera(scene);
  fit_light(scene);
  const Trace trace = captured(scene, small_options(100, 100));
  EXPECT_FALSE(trace.all_fragments.empty());
  for (const Fragment& f : trace.all_fragments) {
    EXPECT_TRUE(f.pixel_x > 0 && f.pixel_x < 99 && f.pixel_y > 0 && f.pixel_y < 99);
  }
  const double angle = glm::degrees(std::acos(-scene.light.direction.y));
  EXPECT_TRUE(angle > 35 && angle < 50) << angle;
}

TEST(Random, IsSplitMix64) {
  Random random(0);
  EXPECT_EQ(random.next(), 0xe220a8397b1dcdafu);
  EXPECT_EQ(random.next(), 0x6e789e6aa1b965f4u);
}

}  // namespace
}  // namespace kagesen

#include "traces/scene/builtin.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "traces/format/error.h"
#include "traces/scene/sha256.h"
#include "traces/scene/topology.h"

namespace kagesen {
namespace {

struct Family {
  const char* name;
  const char* description;
  void (*build)(Scene&);
};

constexpr Family kFamilies[] = {
    {"solids", "closed convex solids over a ground plane: the default", build_solids},
    {"torus", "tori that the light sees through", build_torus},
    {"glyphs", "extruded letters with notches and holes", build_glyphs},
    {"avenue", "objects near and far, light across the view, 16 times wider than the scale-1 map",
     build_avenue},
    {"slivers", "fans of sliver triangles: thin closed discs and needles", build_slivers},
    {"boxes", "a field of 200 turned boxes", build_boxes},
    {"hair", "600 thin closed blades", build_hair},
    {"sphere1m", "one sphere of a million triangles", build_sphere1m},
};

/// Sines and cosines may differ in their last bit between C libraries; a grid of 2^-20 world units
/// makes the geometry, and so its digest, the same everywhere.
void snap_to_grid(Scene& scene) {
  constexpr double kGrid = 0x1p20;
  for (Object& object : scene.objects) {
    for (glm::dvec3& p : object.positions) {
      for (int i = 0; i < 3; ++i) p[i] = std::floor(p[i] * kGrid + 0.5) / kGrid;
    }
  }
}

std::size_t edit_distance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t changed = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({changed, row[j] + 1, row[j - 1] + 1});
    }
  }
  return row[b.size()];
}

/// Up to three names, nearest first.
std::string nearest_names(const std::string& name) {
  std::vector<std::pair<std::size_t, std::string>> ranked;
  for (const Family& family : kFamilies) {
    ranked.emplace_back(edit_distance(name, family.name), family.name);
  }
  std::stable_sort(ranked.begin(), ranked.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  return ranked[0].second + ", " + ranked[1].second + " or " + ranked[2].second;
}

}  // namespace

std::vector<SceneInfo> builtin_scenes() {
  std::vector<SceneInfo> list;
  for (const Family& family : kFamilies) list.push_back({family.name, family.description});
  return list;
}

Scene make_builtin(const std::string& name) {
  for (const Family& family : kFamilies) {
    if (name != family.name) continue;
    Scene scene;
    scene.name = name;
    family.build(scene);
    snap_to_grid(scene);
    classify_objects(scene);
    scene.sha256 = geometry_sha256(scene);
    return scene;
  }
  throw UserError("scene '" + name + "'", "no built-in scene has this name",
                  "did you mean " + nearest_names(name) + "?");
}

}  // namespace kagesen

// Does each kind of mesh come in whole, and each bad one with one line that says what to mend?
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "tests/traces/raster_support.h"
#include "traces/scene/fit.h"

namespace kagesen {
namespace {

constexpr const char* kTetrahedron =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n"
    "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
constexpr const char* kPlyHeader =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
    "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n";

class Import : public testing::Test {
 protected:
  Scene import(const std::string& name, const std::string& content,
               const ImportOptions& options = {}) {
    return import_mesh(directory_.write(name, content), options);
  }
  /// The error's text after the directory.
  std::string error(const std::string& name, const std::string& content) {
    const std::string path = directory_.write(name, content);
    const std::string what = user_error([&] { import_mesh(path); });
    EXPECT_EQ(what.compare(0, path.size(), path), 0) << what;
    EXPECT_EQ(what.find('\n'), std::string::npos) << what;
    EXPECT_NE(what.find("; "), std::string::npos) << what;
    return what.substr(std::min(path.size() - name.size(), what.size()));
  }
  static bool starts(const std::string& text, const std::string& start) {
    return text.compare(0, start.size(), start) == 0;
  }
  TemporaryDirectory directory_;
};

TEST_F(Import, ObjSolidIsClosedAndGetsAGround) {
  const Scene scene = import("tetra.obj", kTetrahedron);
  ASSERT_EQ(scene.objects.size(), 2u);
  EXPECT_TRUE(scene.objects[0].closed);
  EXPECT_EQ(scene.objects[0].triangles.size(), 4u);
  EXPECT_FALSE(scene.objects[1].caster);
  EXPECT_LT(scene.objects[1].positions[0].y, 0);
  EXPECT_EQ(scene.name, "tetra.obj");
  EXPECT_EQ(scene.sha256.size(), 64u);
  EXPECT_TRUE(scene.warnings.empty());
}

TEST_F(Import, GroundOnAndOff) {
  ImportOptions options;
  options.ground = ImportOptions::Ground::kOff;
  EXPECT_EQ(import("a.obj", kTetrahedron, options).objects.size(), 1u);
  const std::string with_floor =
      std::string(kTetrahedron) + "v -3 0 -3\nv -3 0 3\nv 3 0 3\nv 3 0 -3\nf 5 6 7 8\n";
  options.ground = ImportOptions::Ground::kAuto;
  for (const Object& o : import("b.obj", with_floor, options).objects) EXPECT_TRUE(o.caster);
  options.ground = ImportOptions::Ground::kOn;
  EXPECT_FALSE(import("c.obj", with_floor, options).objects.back().caster);
}

TEST_F(Import, GroupsAreObjectsAndOneGroupSplitsIntoComponents) {
  const std::string two =
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 5 0 0\nv 6 0 0\nv 5 1 0\nv 9 0 0\nv 9 1 0\nv 8 0 1\n";
  const Scene grouped = import("g.obj", two + "o left\nf 1 2 3\no right\nf 4 5 6\nf 7 8 9\n");
  ASSERT_EQ(grouped.objects.size(), 3u);
  EXPECT_EQ(grouped.objects[0].name, "left");
  EXPECT_EQ(grouped.objects[1].triangles.size(), 2u);
  EXPECT_EQ(import("one.obj", two + "f 1 2 3\nf 4 5 6\nf 7 8 9\n").objects.size(), 4u);
  ImportOptions options;
  options.ids = ImportOptions::Ids::kComponents;
  EXPECT_EQ(
      import("c.obj", two + "o left\nf 1 2 3\no right\nf 4 5 6\nf 7 8 9\n", options).objects.size(),
      4u);
  options.ids = ImportOptions::Ids::kFile;
  EXPECT_EQ(import("f.obj", two + "f 1 2 3\nf 4 5 6\nf 7 8 9\n", options).objects.size(), 2u);
}

TEST_F(Import, MaterialsDoNotSplitAnObject) {
  const std::string text = std::string("o solid\n") + kTetrahedron;
  std::string with_materials = text;
  with_materials.insert(with_materials.find("f 1 2 4"), "usemtl red\n");
  const Scene scene = import("m.obj", with_materials);
  ASSERT_EQ(scene.objects.size(), 2u);
  EXPECT_TRUE(scene.objects[0].closed);
}

TEST_F(Import, PolygonsAreTriangulatedLinesAndDegeneratesLeftOutWithACount) {
  const Scene scene = import("p.obj",
                             "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nv 1 0 0\nv 9 9 9\n"
                             "f 1 2 3 4\nf 1 5 2\nf 1 1 3\nl 1 2\np 6\n");
  EXPECT_EQ(scene.objects[0].triangles.size(), 2u);
  ASSERT_EQ(scene.warnings.size(), 2u);
  EXPECT_EQ(scene.warnings[0], "left out 1 point and 1 line");
  EXPECT_EQ(scene.warnings[1], "left out 2 triangles of no area");
}

TEST_F(Import, NegativeAndContinuedObjIndices) {
  EXPECT_EQ(import("n.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 \\\n -1\n").objects.size(), 2u);
}

TEST_F(Import, BadObj) {
  const std::string v = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  EXPECT_TRUE(starts(error("a.obj", v + "f 1 2 9\n"), "a.obj:4: face index 9 of 3 vertices;"));
  EXPECT_TRUE(starts(error("b.obj", v + "f 0 1 2\n"), "b.obj:4: face index 0, "));
  EXPECT_TRUE(starts(error("c.obj", v + "f -1 -2 -9\n"), "c.obj:4: face index -9 "));
  EXPECT_TRUE(starts(error("d.obj", v + "f 1 two 3\n"), "d.obj:4: a face index that is no"));
  EXPECT_TRUE(starts(error("e.obj", "v 0 0 0\nv nan 0 0\nv 0 1 0\nf 1 2 3\n"), "e.obj:2: "));
  EXPECT_TRUE(starts(error("f.obj", "v 0 0 0\nv inf 0 0\nv 0 1 0\nf 1 2 3\n"), "f.obj:2: "));
  EXPECT_TRUE(starts(error("g.obj", "v 0 0 0\nv 1 0\nv 0 1 0\nf 1 2 3\n"), "g.obj:2: "));
  EXPECT_TRUE(starts(error("h.obj", "v 0 0 0\nv 1 x 0\nv 0 1 0\nf 1 2 3\n"), "h.obj:2: "));
  EXPECT_TRUE(starts(error("i.obj", v + v + v), "i.obj: "));
  EXPECT_TRUE(starts(error("j.obj", v + "f 1 1 1\n"), "j.obj: no triangles"));
}

TEST_F(Import, BadFiles) {
  EXPECT_TRUE(starts(error("empty.obj", ""), "empty.obj: it is empty;"));
  EXPECT_TRUE(starts(error("words.obj", "hello, world\n"), "words.obj: "));
  EXPECT_TRUE(starts(error("a.stl", "solid\n"), "a.stl: not a kind of mesh"));
  EXPECT_TRUE(starts(error("none", "v 0 0 0\n"), "none: not a kind of mesh"));
  EXPECT_NE(user_error([&] { import_mesh(directory_.file("gone.obj")); }).find("no such file"),
            std::string::npos);
  EXPECT_NE(user_error([&] { import_mesh(directory_.file("")); }).find("it is a directory"),
            std::string::npos);
  for (const char* name : {"r.obj", "r.ply", "r.gltf", "r.glb"}) {
    std::string noise;
    for (int i = 0; i < 4000; ++i) noise += static_cast<char>(i * 7919 >> 3);
    EXPECT_TRUE(starts(error(name, noise), name));
  }
}

TEST_F(Import, PlyGoodAndBad) {
  const std::string h = kPlyHeader, v = "0 0 0\n1 0 0\n0 1 0\n";
  EXPECT_EQ(import("ok.ply", h + v + "3 0 1 2\n").objects[0].triangles.size(), 1u);
  EXPECT_NE(error("range.ply", h + v + "3 0 1 9\n").find("vertex 9 of 3"), std::string::npos);
  EXPECT_TRUE(starts(error("minus.ply", h + v + "3 0 1 -1\n"), "minus.ply: "));
  EXPECT_NE(error("nan.ply", h + "0 0 0\nnan 0 0\n0 1 0\n3 0 1 2\n").find("vertex 1 is not finite"),
            std::string::npos);
  EXPECT_NE(error("short.ply", h + v).find("3 of 4 data lines"), std::string::npos);
  EXPECT_TRUE(starts(error("cut.ply", h.substr(0, 80)), "cut.ply: "));
  std::string binary = h;
  binary.replace(binary.find("ascii"), 5, "binary_little_endian");
  const float points[9] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
  const std::int32_t corners[3] = {0, 1, 2};
  binary.append(reinterpret_cast<const char*>(points), sizeof points);
  binary += '\3';
  binary.append(reinterpret_cast<const char*>(corners), sizeof corners);
  EXPECT_EQ(import("bin.ply", binary).objects[0].triangles.size(), 1u);
  EXPECT_NE(error("cutbin.ply", binary.substr(0, binary.size() - 1)).find("it ends early"),
            std::string::npos);
}

/// A glTF triangle whose buffer lies in `name`.bin; `extra` is inserted into the file.
std::string gltf(const TemporaryDirectory& directory, std::array<std::uint16_t, 6> indices,
                 const std::string& nodes, const std::string& extra = "") {
  const float points[9] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
  std::string bytes(reinterpret_cast<const char*>(points), sizeof points);
  bytes.append(reinterpret_cast<const char*>(indices.data()), sizeof indices);
  directory.write("data.bin", bytes);
  return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0,1,2]}],)" + extra +
         R"("nodes":[)" + nodes + R"(],
    "meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],
    "buffers":[{"byteLength":48,"uri":"data.bin"}],
    "bufferViews":[{"buffer":0,"byteLength":36},{"buffer":0,"byteOffset":36,"byteLength":12}],
    "accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3",
                  "min":[0,0,0],"max":[1,1,0]},
                 {"bufferView":1,"componentType":5123,"count":6,"type":"SCALAR"}]})";
}

TEST_F(Import, GltfTransformsKeepObjectsApartAndMirrorsKeepNormals) {
  const Scene scene = import("t.gltf", gltf(directory_, {0, 1, 2, 0, 1, 2},
                                            R"({"mesh":0,"name":"a","translation":[10,0,0]},
                        {"mesh":0,"name":"b","scale":[-1,1,1]},{"name":"empty"})"));
  ASSERT_EQ(scene.objects.size(), 3u);
  const Object& a = scene.objects[0];
  EXPECT_EQ(a.name, "a");
  EXPECT_EQ(a.positions[0].x, 10);
  const Object& b = scene.objects[1];
  const auto& t = b.triangles[0];
  EXPECT_GT(
      glm::cross(b.positions[t[1]] - b.positions[t[0]], b.positions[t[2]] - b.positions[t[0]]).z,
      0);
}

TEST_F(Import, GltfBringsCameraAndLight) {
  const Scene scene =
      import("v.gltf", gltf(directory_, {0, 1, 2, 0, 1, 2},
                            R"({"mesh":0},{"name":"Eye","camera":0,"translation":[0,0,5]},
              {"name":"Lamp","translation":[0,3,0],"rotation":[-0.70710678,0,0,0.70710678],
               "extensions":{"KHR_lights_punctual":{"light":0}}})",
                            R"("cameras":[{"type":"perspective",
                "perspective":{"yfov":0.7,"aspectRatio":1.6,"znear":0.1}}],
              "extensionsUsed":["KHR_lights_punctual"],
              "extensions":{"KHR_lights_punctual":{"lights":[
                {"type":"spot","spot":{"innerConeAngle":0.2,"outerConeAngle":0.5}}]}},)"));
  EXPECT_EQ(scene.camera.eye, glm::dvec3(0, 0, 5));
  EXPECT_LT(scene.camera.target.z, 5);
  EXPECT_NEAR(scene.camera.vertical_fov_degrees, glm::degrees(0.7), 1e-4);
  EXPECT_EQ(scene.light.kind, Light::Kind::kSpot);
  EXPECT_NEAR(scene.light.spread_degrees, glm::degrees(1.0), 1e-4);
  EXPECT_NEAR(scene.light.position.y, 3, 1e-6);
  EXPECT_NEAR(scene.light.direction.y, -1, 1e-6);
}

TEST_F(Import, BadGltf) {
  const std::string nodes = R"({"mesh":0},{},{})";
  const std::string good = gltf(directory_, {0, 1, 2, 0, 1, 2}, nodes);
  EXPECT_EQ(import("good.gltf", good).objects[0].triangles.size(), 2u);
  const std::string range = gltf(directory_, {0, 1, 2, 0, 1, 7}, nodes);
  EXPECT_NE(error("range.gltf", range).find("index 7 of 3 vertices"), std::string::npos);
  directory_.write("data.bin", "short");
  EXPECT_NE(error("b.gltf", good).find("beyond their buffer"), std::string::npos);
  std::filesystem::remove(directory_.file("data.bin"));
  EXPECT_NE(error("c.gltf", good).find("'data.bin' cannot be read"), std::string::npos);
  EXPECT_TRUE(starts(error("d.gltf", good.substr(0, 200)), "d.gltf: its JSON is damaged"));
  EXPECT_TRUE(starts(error("e.gltf", R"({"asset":{"version":"2.0"}})"), "e.gltf: "));
  EXPECT_TRUE(starts(error("f.gltf", R"({"asset":{"version":"2.0"},"scenes":[{"nodes":[0]}],
      "nodes":[{"children":[1]},{"children":[0]}]})"),
                     "f.gltf: "));
  EXPECT_TRUE(starts(error("g.gltf", R"({"meshes":[{"primitives":[{"indices":5}]}]})"), "g.gltf"));
  EXPECT_TRUE(starts(error("h.glb", "glTF\2"), "h.glb: not a GLB"));
}

}  // namespace
}  // namespace kagesen

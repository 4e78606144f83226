#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <fmt/format.h>

#include <assimp/Importer.hpp>
#include <cmath>
#include <filesystem>
#include <set>

#include "traces/format/error.h"
#include "traces/format/words.h"
#include "traces/scene/fit.h"
#include "traces/scene/import_view.h"
#include "traces/scene/mesh_file_check.h"
#include "traces/scene/sha256.h"
#include "traces/scene/topology.h"

namespace kagesen {
namespace {

constexpr const char* kRepair = "repair the mesh, or export it again";

/// The first line, without its full stop.
std::string one_line(std::string text) {
  text = text.substr(0, text.find_first_of("\r\n"));
  while (!text.empty() && text.back() == '.') text.pop_back();
  return text;
}

/// Before any of Assimp's own steps runs: they trust what this checks.
void check_mesh(const std::string& path, const aiMesh& mesh) {
  const auto where = [&] { return fmt::format("{}: mesh '{}'", path, mesh.mName.C_Str()); };
  for (unsigned int v = 0; v < mesh.mNumVertices; ++v) {
    const aiVector3D& p = mesh.mVertices[v];
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) {
      throw UserError(where(), fmt::format("vertex {} is not finite", v), kRepair);
    }
  }
  for (unsigned int f = 0; f < mesh.mNumFaces; ++f) {
    const aiFace& face = mesh.mFaces[f];
    if (face.mNumIndices == 0) {
      throw UserError(where(), fmt::format("face {} has no vertices", f), kRepair);
    }
    for (unsigned int i = 0; i < face.mNumIndices; ++i) {
      if (face.mIndices[i] >= mesh.mNumVertices) {
        throw UserError(where(),
                        fmt::format("face {} refers to vertex {} of {}", f, face.mIndices[i],
                                    mesh.mNumVertices),
                        kRepair);
      }
    }
  }
}

struct Dropped {
  std::size_t points = 0, lines = 0, degenerate = 0;
};

class Converter {
 public:
  Converter(const std::string& path, const aiScene& file, bool node_is_object, Scene& scene)
      : path_(path), file_(file), node_is_object_(node_is_object), scene_(scene) {}

  void add_node(const aiNode& node, const glm::dmat4& parent, int depth) {
    if (depth > 1000) throw UserError(path_, "nodes nested over 1000 deep", "flatten its tree");
    glm::dmat4 local;
    for (int row = 0; row < 4; ++row) {
      for (int column = 0; column < 4; ++column) {
        local[column][row] = node.mTransformation[static_cast<unsigned>(row)][column];
      }
    }
    const glm::dmat4 world = parent * local;
    nodes_.emplace(node.mName.C_Str(), world);
    Object whole;
    for (unsigned int i = 0; i < node.mNumMeshes; ++i) {
      const aiMesh& mesh = *file_.mMeshes[node.mMeshes[i]];
      Object part;
      add_mesh(mesh, world, node_is_object_ ? whole : part);
      if (!node_is_object_) {
        keep(std::move(part),
             node.mNumMeshes == 1 && node.mName.length > 0 ? node.mName : mesh.mName);
      }
    }
    if (node_is_object_) keep(std::move(whole), node.mName);
    for (unsigned int i = 0; i < node.mNumChildren; ++i) {
      add_node(*node.mChildren[i], world, depth + 1);
    }
  }

  const Dropped& dropped() const { return dropped_; }
  const NodeTransforms& nodes() const { return nodes_; }

 private:
  void add_mesh(const aiMesh& mesh, const glm::dmat4& world, Object& object) {
    const auto base = static_cast<std::uint32_t>(object.positions.size());
    for (unsigned int v = 0; v < mesh.mNumVertices; ++v) {
      const aiVector3D& p = mesh.mVertices[v];
      const glm::dvec3 q(world * glm::dvec4(p.x, p.y, p.z, 1));
      if (!std::isfinite(glm::dot(q, q))) {
        throw UserError(fmt::format("{}: mesh '{}'", path_, mesh.mName.C_Str()),
                        fmt::format("its node's transform takes vertex {} to infinity", v),
                        kRepair);
      }
      object.positions.push_back(q);
    }
    const bool mirrored = glm::determinant(glm::dmat3(world)) < 0;
    for (unsigned int f = 0; f < mesh.mNumFaces; ++f) {
      const aiFace& face = mesh.mFaces[f];
      if (face.mNumIndices < 3) {
        ++(face.mNumIndices == 1 ? dropped_.points : dropped_.lines);
        continue;
      }
      const unsigned int* i = face.mIndices;
      if (degenerate(mesh.mVertices[i[0]], mesh.mVertices[i[1]], mesh.mVertices[i[2]])) {
        ++dropped_.degenerate;
        continue;
      }
      // A mirror turns windings round; outward normals stay outward.
      object.triangles.push_back(
          {base + i[0], base + i[mirrored ? 2 : 1], base + i[mirrored ? 1 : 2]});
    }
  }

  /// No area in the file's own numbers: once transformed, rounding may give it some.
  static bool degenerate(const aiVector3D& a, const aiVector3D& b, const aiVector3D& c) {
    const glm::dvec3 p(a.x, a.y, a.z);
    return glm::cross(glm::dvec3(b.x, b.y, b.z) - p, glm::dvec3(c.x, c.y, c.z) - p) ==
           glm::dvec3(0);
  }

  void keep(Object object, const aiString& name) {
    if (object.triangles.empty()) return;
    object.name = name.length > 0 ? name.C_Str() : "object";
    if (!names_.insert(object.name).second) {
      int copy = 2;
      while (!names_.insert(fmt::format("{}#{}", object.name, copy)).second) ++copy;
      object.name = fmt::format("{}#{}", object.name, copy);
    }
    scene_.objects.push_back(std::move(object));
  }

  const std::string& path_;
  const aiScene& file_;
  const bool node_is_object_;
  Scene& scene_;
  Dropped dropped_;
  NodeTransforms nodes_;
  std::set<std::string> names_;
};

/// All objects as one, for components that span the file's objects.
Object merged(const Scene& scene, const std::string& name) {
  Object all;
  all.name = name;
  for (const Object& object : scene.objects) {
    const auto base = static_cast<std::uint32_t>(all.positions.size());
    all.positions.insert(all.positions.end(), object.positions.begin(), object.positions.end());
    for (const auto& t : object.triangles) {
      all.triangles.push_back({t[0] + base, t[1] + base, t[2] + base});
    }
  }
  return all;
}

void choose_objects(Scene& scene, ImportOptions::Ids ids) {
  switch (ids) {
    case ImportOptions::Ids::kFile:
      return;
    case ImportOptions::Ids::kAuto:
      if (scene.objects.size() > 1) return;
      break;
    case ImportOptions::Ids::kComponents:
      break;
  }
  std::vector<Object> parts = split_components(merged(scene, scene.name));
  if (parts.size() > 1) scene.objects = std::move(parts);
}

/// A colour for each object, so that pictures tell them apart: steps of the golden angle.
void tint(Scene& scene) {
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const double hue = 2.39996323 * static_cast<double>(i);
    scene.objects[i].colour = glm::vec3(0.66 + 0.18 * std::cos(hue), 0.64 + 0.14 * std::sin(hue),
                                        0.62 - 0.18 * std::cos(hue));
  }
}

void read(const std::string& path, Assimp::Importer& importer) {
  const auto refuse = [&](const std::string& why) {
    throw UserError(path, "cannot be imported: " + one_line(why), kRepair);
  };
  try {
    if (importer.ReadFile(path, 0) == nullptr) refuse(importer.GetErrorString());
    const aiScene& file = *importer.GetScene();
    if (file.mRootNode == nullptr || file.mNumMeshes == 0) {
      throw UserError(path, "no triangles in it", "give a mesh with faces");
    }
    for (unsigned int i = 0; i < file.mNumMeshes; ++i) check_mesh(path, *file.mMeshes[i]);
    // Neither FindDegenerates (makes lines of them) nor OptimizeMeshes (merges objects).
    if (importer.ApplyPostProcessing(aiProcess_Triangulate) == nullptr) {
      refuse(importer.GetErrorString());
    }
  } catch (const UserError&) {
    throw;
  } catch (const std::exception& error) {
    refuse(error.what());
  }
}

}  // namespace

Scene import_mesh(const std::string& path, const ImportOptions& options) {
  const std::string extension = check_mesh_file(path);
  Assimp::Importer importer;
  read(path, importer);
  const aiScene& file = *importer.GetScene();

  Scene scene;
  scene.name = std::filesystem::path(path).filename().string();
  scene.sha256 = file_sha256(path);
  // An OBJ group may use several materials, each a mesh of its own; a glTF primitive is an object.
  Converter converter(path, file, extension == "obj", scene);
  converter.add_node(*file.mRootNode, glm::dmat4(1), 0);
  const Dropped& dropped = converter.dropped();
  if (dropped.points + dropped.lines > 0) {
    scene.warnings.push_back(fmt::format("left out {} and {}", counted(dropped.points, "point"),
                                         counted(dropped.lines, "line")));
  }
  if (dropped.degenerate > 0) {
    scene.warnings.push_back(
        fmt::format("left out {} of no area", counted(dropped.degenerate, "triangle")));
  }
  if (scene.triangle_count() == 0) {
    throw UserError(path, "no triangles in it", "give a mesh with faces");
  }
  choose_objects(scene, options.ids);
  classify_objects(scene);
  tint(scene);
  if (!import_camera(file, converter.nodes(), scene)) fit_camera(scene);
  if (!import_light(file, converter.nodes(), scene)) fit_light(scene);
  if (options.ground == ImportOptions::Ground::kOn ||
      (options.ground == ImportOptions::Ground::kAuto && !has_floor(scene))) {
    add_ground(scene);
  }
  return scene;
}

}  // namespace kagesen

#include "traces/raster/gbuffer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "traces/format/error.h"
#include "traces/format/words.h"
#include "traces/raster/capture_frame.h"
#include "traces/raster/gbuffer_file.h"
#include "traces/raster/pixel_raster.h"
#include "traces/raster/sampler.h"

namespace kagesen {
namespace {

constexpr std::uint32_t kUnknown = 0xffffffffu;

/// Finds a polygon's plane by its number in the scene.
class Polygons {
 public:
  explicit Polygons(const Scene& scene) : scene_(scene) {
    first_.push_back(0);
    for (const Object& o : scene.objects) first_.push_back(first_.back() + o.triangles.size());
  }
  bool belongs(std::uint32_t polygon, std::uint32_t object) const {
    return polygon >= first_[object] && polygon < first_[object + 1];
  }
  /// Is the polygon of this object, and does the 32-bit position lie on its plane?
  bool holds(std::uint32_t polygon, std::uint32_t object, const glm::dvec3& world) const {
    if (!belongs(polygon, object)) return false;
    glm::dvec3 corner, normal;
    plane(polygon, object, corner, normal);
    const double size = std::max({std::abs(world.x), std::abs(world.y), std::abs(world.z)});
    return std::abs(glm::dot(normal, world - corner)) <= 8 * 0x1p-24 * size * glm::length(normal);
  }
  /// Corner and normal, towards the camera.
  void plane(std::uint32_t polygon, std::uint32_t object, glm::dvec3& corner,
             glm::dvec3& normal) const {
    const Object& o = scene_.objects[object];
    const auto& t = o.triangles[polygon - first_[object]];
    corner = o.positions[t[0]];
    normal = glm::cross(o.positions[t[1]] - corner, o.positions[t[2]] - corner);
    if (glm::dot(normal, scene_.camera.eye - corner) < 0) normal = -normal;
  }

 private:
  const Scene& scene_;
  std::vector<std::size_t> first_;
};

/// Depth units towards the light that cover the rounding of a 32-bit position at `world`, on
/// surfaces up to about 75 degrees from the light.
std::uint32_t rounding_bias(const CaptureFrame& frame, const glm::dvec3& world) {
  const double error =
      4 * 0x1p-24 * std::max({std::abs(world.x), std::abs(world.y), std::abs(world.z)});
  const Light& light = frame.scene.light;
  const glm::dvec3 away = frame.space.perspective ? world - light.position : light.direction;
  if (!(glm::length(away) > 0)) return 1;
  const glm::dvec3 moved = world + glm::normalize(away) * error;
  const glm::dvec4 a = frame.space.clip_from_world * glm::dvec4(world, 1);
  const glm::dvec4 b = frame.space.clip_from_world * glm::dvec4(moved, 1);
  if (!(a.w > 0 && b.w > 0)) return 1;
  const double bias = std::abs(UnitGrid::z(b) - UnitGrid::z(a));
  return 1 + static_cast<std::uint32_t>(std::min<double>(bias, kDepthMax / 2));
}

struct Checked {
  std::uint64_t pixels = 0, not_finite = 0, not_whole = 0;
};

/// Background pixels get ID -1. Throws UserError for an ID that the scene does not have.
Checked check_pixels(GBufferFile& file, const Scene& scene, const std::string& path) {
  Checked checked;
  for (std::size_t i = 0; i < file.id.size(); ++i) {
    float& id = file.id[i];
    if (!(id >= 0)) {
      id = -1;
      continue;
    }
    const std::size_t x = i % file.width, y = i / file.width;
    if (id >= static_cast<float>(scene.objects.size())) {
      throw UserError(fmt::format("{}: pixel {}, {}", path, x, y),
                      fmt::format("object ID {:g}, but scene '{}' has {} objects", id, scene.name,
                                  scene.objects.size()),
                      "give the scene that was rendered");
    }
    bool finite = true;
    for (const auto& axis : file.position) finite = finite && std::isfinite(axis[i]);
    if (id != std::floor(id)) {
      ++checked.not_whole;
      id = -1;
    } else if (!finite) {
      ++checked.not_finite;
      id = -1;
    } else {
      ++checked.pixels;
    }
  }
  return checked;
}

}  // namespace

CaptureSummary capture_gbuffer(const Scene& scene, const std::string& exr_path,
                               const CaptureOptions& options, TraceSink& sink) {
  GBufferFile file = read_gbuffer_file(exr_path);
  const Checked checked = check_pixels(file, scene, exr_path);
  CaptureOptions actual = options;
  actual.image_width = file.width;
  actual.image_height = file.height;
  actual.mode = FragmentMode::kVisible;
  CaptureFrame frame(scene, actual);
  const auto warn = [&](std::uint64_t count, const char* what) {
    if (count > 0)
      frame.header.warnings.push_back(fmt::format("left out {} {}", counted(count, "pixel"), what));
  };
  warn(checked.not_finite, "whose position is not finite");
  warn(checked.not_whole, "whose ID is no whole number");
  if (checked.pixels == 0) frame.header.warnings.push_back("the G-buffer shows no object");
  frame.send_casters(sink);

  const Polygons polygons(scene);
  Sampler sampler(scene, frame.space, frame.casters);
  FragmentStream stream(sink, frame.summary);
  const auto at = [](const std::vector<float>(&axes)[3], std::size_t i) {
    return glm::dvec3(axes[0][i], axes[1][i], axes[2][i]);
  };
  visit_pixels(file.width, file.height, [&](int x, int y) {
    const std::size_t i = static_cast<std::size_t>(y) * file.width + static_cast<std::size_t>(x);
    if (file.id[i] < 0) return;
    Fragment fragment;
    fragment.object = static_cast<std::uint32_t>(file.id[i]);
    fragment.pixel_x = static_cast<std::uint16_t>(x);
    fragment.pixel_y = static_cast<std::uint16_t>(y);
    fragment.flags = Fragment::kVisible;
    glm::dvec3 world = at(file.position, i);
    std::uint32_t polygon = kUnknown;
    if (!file.polygon.empty() && file.polygon[i] >= 0 && file.polygon[i] < 4e9f) {
      polygon = static_cast<std::uint32_t>(file.polygon[i]);
    }
    if (polygon != kUnknown && polygons.holds(polygon, fragment.object, world)) {
      glm::dvec3 corner, normal;
      polygons.plane(polygon, fragment.object, corner, normal);
      sampler.select(polygon, normal, corner);
      // Back onto the plane, which a 32-bit position misses.
      const double square = glm::dot(normal, normal);
      if (square > 0) world -= normal * (glm::dot(normal, world - corner) / square);
      sampler.place(world, fragment);
    } else {
      glm::dvec3 normal = file.normal[0].empty() ? glm::dvec3(0) : at(file.normal, i);
      if (glm::dot(normal, scene.camera.eye - world) < 0) normal = -normal;
      if (std::isfinite(glm::dot(normal, normal))) {
        sampler.select(normal, world);
      } else {
        sampler.select_unknown();
      }
      sampler.place(world, fragment);
      std::uint32_t& z = fragment.position.z;
      z -= std::min(z, rounding_bias(frame, world));
    }
    stream.push(fragment);
  });
  stream.flush();
  sink.end();
  return frame.summary;
}

void write_gbuffer(const Scene& scene, const CaptureOptions& options, const std::string& exr_path) {
  CaptureOptions actual = options;
  actual.mode = FragmentMode::kVisible;
  const CaptureFrame frame(scene, actual);
  GBufferFile file;
  file.width = actual.image_width;
  file.height = actual.image_height;
  const std::size_t pixels = static_cast<std::size_t>(file.width) * file.height;
  // Whole numbers are exact in a float up to 2^24 only.
  if (scene.triangle_count() <= std::size_t{1} << 24) file.polygon.assign(pixels, -1);
  file.id.assign(pixels, -1);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    file.position[axis].assign(pixels, 0);
    file.normal[axis].assign(pixels, 0);
  }
  const Polygons polygons(scene);
  draw_samples(scene, actual, frame.space, frame.casters, [&](const Sample& sample) {
    const std::size_t i =
        static_cast<std::size_t>(sample.fragment.pixel_y) * file.width + sample.fragment.pixel_x;
    glm::dvec3 corner, normal;
    polygons.plane(sample.polygon, sample.fragment.object, corner, normal);
    const double length = glm::length(normal);
    for (int axis = 0; axis < 3; ++axis) {
      const auto a = static_cast<std::size_t>(axis);
      file.position[a][i] = static_cast<float>(sample.world[axis]);
      file.normal[a][i] = length > 0 ? static_cast<float>(normal[axis] / length) : 0.0f;
    }
    file.id[i] = static_cast<float>(sample.fragment.object);
    if (!file.polygon.empty()) file.polygon[i] = static_cast<float>(sample.polygon);
  });
  write_gbuffer_file(exr_path, file);
}

}  // namespace kagesen

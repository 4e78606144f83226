#include "traces/raster/fragments.h"

#include <algorithm>
#include <cmath>

#include "traces/raster/sampler.h"
#include "traces/raster/view.h"

namespace kagesen {
namespace {

constexpr std::uint32_t kNobody = 0xffffffffu;
constexpr std::size_t kPortion = 1 << 16;  // fragments

/// A triangle's plane as the camera sees it: one over the distance along the view direction.
struct PlaneInView {
  /// Vertices are put in order first: two triangles on the same three points get the same bits.
  PlaneInView(const View& view, std::array<glm::dvec3, 3> p,
              const std::array<glm::dvec4, 3>& projected) {
    std::sort(p.begin(), p.end(), [](const glm::dvec3& a, const glm::dvec3& b) {
      return a.x != b.x ? a.x < b.x : a.y != b.y ? a.y < b.y : a.z < b.z;
    });
    normal = glm::cross(p[1] - p[0], p[2] - p[0]);
    const double d = glm::dot(normal, p[0] - view.eye());
    if (d > 0) normal = -normal;  // towards the camera
    const double scale = -1 / std::abs(d);
    origin = glm::dot(normal, view.corner()) * scale;
    step_x = glm::dot(normal, view.step_x()) * scale;
    step_y = glm::dot(normal, view.step_y()) * scale;
    const auto range = std::minmax({projected[0].w, projected[1].w, projected[2].w});
    most = 1 / std::max(range.first, view.near_plane());
    least = 1 / std::max(range.second, view.near_plane());
    if (!std::isfinite(origin + step_x + step_y)) {  // seen edge-on
      origin = most;
      step_x = step_y = 0;
    }
  }
  /// Kept between the corners' values: snapping may show a plane a little beyond its triangle.
  double at(int x, int y) const {
    return std::clamp(origin + step_x * (x + 0.5) + step_y * (y + 0.5), least, most);
  }
  glm::dvec3 normal;
  double origin, step_x, step_y, least, most;
};

/// Walks the pixels of every triangle in scene order.
class Walker {
 public:
  Walker(const Scene& scene, const CaptureOptions& options)
      : scene_(scene),
        view_(scene, static_cast<int>(options.image_width),
              static_cast<int>(options.image_height)) {}

  const View& view() const { return view_; }
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(view_.width()) +
           static_cast<std::size_t>(x);
  }

  /// start(object, polygon, plane) before a triangle's pixels, then pixel(x, y, 1 / distance).
  template <typename Start, typename Pixel>
  void walk(Start&& start, Pixel&& pixel) {
    std::uint32_t polygon = 0;
    for (std::uint32_t number = 0; number < scene_.objects.size(); ++number) {
      const Object& object = scene_.objects[number];
      projected_.clear();
      for (const glm::dvec3& p : object.positions) projected_.push_back(view_.project(p));
      for (const auto& t : object.triangles) {
        const std::array<glm::dvec4, 3> projected{projected_[t[0]], projected_[t[1]],
                                                  projected_[t[2]]};
        std::array<ScreenPoint, 16> corners;
        const int count = view_.to_screen(projected, corners);
        if (count >= 3) {
          const PlaneInView plane(
              view_, {object.positions[t[0]], object.positions[t[1]], object.positions[t[2]]},
              projected);
          start(number, polygon, plane, object.positions[t[0]]);
          for (int i = 2; i < count; ++i) {
            raster_triangle({corners[0], corners[static_cast<std::size_t>(i - 1)],
                             corners[static_cast<std::size_t>(i)]},
                            view_.width(), view_.height(),
                            [&](int x, int y) { pixel(x, y, plane.at(x, y)); });
          }
        }
        ++polygon;
      }
    }
  }

 private:
  const Scene& scene_;
  const View view_;
  std::vector<glm::dvec4> projected_;
};

}  // namespace

void draw_samples(const Scene& scene, const CaptureOptions& options, const LightSpace& space,
                  const CasterSet& casters, const std::function<void(const Sample&)>& emit) {
  Walker walker(scene, options);
  const std::size_t pixels = walker.index(0, walker.view().height());
  const auto progress = [&](const char* stage, double done) {
    if (options.progress) options.progress(stage, done);
  };

  // Who is seen at each pixel must be known before the first sample leaves.
  progress("visibility", 0);
  std::vector<double> nearest(pixels, 0);  // 1 / distance
  std::vector<std::uint32_t> seen(pixels, kNobody);
  std::uint32_t current = 0;
  walker.walk([&](std::uint32_t, std::uint32_t polygon, const PlaneInView&,
                  const glm::dvec3&) { current = polygon; },
              [&](int x, int y, double inverse) {
                const std::size_t i = walker.index(x, y);
                if (inverse > nearest[i]) {
                  nearest[i] = inverse;
                  seen[i] = current;
                }
              });

  progress("fragments", 0);
  const FragmentMode mode = options.mode;
  if (mode == FragmentMode::kEarlyZ) std::fill(nearest.begin(), nearest.end(), 0.0);
  Sampler sampler(scene, space, casters);
  const double total = static_cast<double>(std::max<std::size_t>(scene.triangle_count(), 1));
  Sample sample;
  bool surface_ready = false;
  const PlaneInView* plane = nullptr;
  glm::dvec3 corner{0};
  walker.walk(
      [&](std::uint32_t object, std::uint32_t polygon, const PlaneInView& p, const glm::dvec3& c) {
        if (polygon % 65536 == 65535) progress("fragments", polygon / total);
        sample.fragment.object = object;
        sample.polygon = polygon;
        plane = &p;
        corner = c;
        surface_ready = false;
      },
      [&](int x, int y, double inverse) {
        const std::size_t i = walker.index(x, y);
        const bool visible = seen[i] == sample.polygon;
        if (mode == FragmentMode::kVisible && !visible) return;
        if (mode == FragmentMode::kEarlyZ) {
          if (!(inverse > nearest[i])) return;
          nearest[i] = inverse;
        }
        if (!surface_ready) sampler.select(sample.polygon, plane->normal, corner);
        surface_ready = true;
        if (visible) seen[i] = kNobody;  // flagged once
        sample.fragment.pixel_x = static_cast<std::uint16_t>(x);
        sample.fragment.pixel_y = static_cast<std::uint16_t>(y);
        sample.fragment.flags = visible ? Fragment::kVisible : 0;
        sample.world = walker.view().eye() + walker.view().ray(x, y) / inverse;
        sampler.place(sample.world, sample.fragment);
        emit(sample);
      });
  progress("fragments", 1);
}

FragmentStream::FragmentStream(TraceSink& sink, CaptureSummary& summary)
    : sink_(sink), summary_(summary) {
  portion_.reserve(kPortion);
}

void FragmentStream::push(const Fragment& fragment) {
  ++summary_.fragments;
  if (fragment.flags & Fragment::kAverted) ++summary_.averted;
  if (fragment.flags & Fragment::kOutside) ++summary_.outside;
  portion_.push_back(fragment);
  if (portion_.size() == kPortion) flush();
}

void FragmentStream::flush() {
  if (!portion_.empty()) sink_.fragments(portion_.data(), portion_.size());
  portion_.clear();
}

}  // namespace kagesen

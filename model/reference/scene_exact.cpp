#include "model/reference/scene_exact.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>
#include <thread>

namespace kagesen {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr unsigned kCasterMask = 1, kReceiverMask = 2;
/// Offset of a shadow ray along the surface's normal, as a part of the scene's size: some float
/// ulps.
constexpr double kOffset = 1.0 / (1 << 20);

/// A ray query that can pass over one object.
struct Context {
  RTCIntersectContext embree;  // first, so that Embree's pointer to it is one to this
  unsigned passed_over;
};

void pass_over_object(const RTCFilterFunctionNArguments* arguments) {
  const auto* context = reinterpret_cast<const Context*>(arguments->context);
  for (unsigned i = 0; i < arguments->N; ++i) {
    if (RTCHitN_geomID(arguments->hit, arguments->N, i) == context->passed_over)
      arguments->valid[i] = 0;
  }
}

struct DeviceDeleter {
  void operator()(RTCDevice d) const { rtcReleaseDevice(d); }
};
struct SceneDeleter {
  void operator()(RTCScene s) const { rtcReleaseScene(s); }
};

/// The meshes, relative to their middle so that single precision goes as far as it can.
class RayScene {
 public:
  explicit RayScene(const Scene& scene) : device_(rtcNewDevice("threads=1")) {
    if (!device_) throw std::runtime_error("Embree cannot start");
    glm::dvec3 low(std::numeric_limits<double>::infinity()), high = -low;
    for (const Object& o : scene.objects) {
      for (const glm::dvec3& p : o.positions) {
        low = glm::min(low, p);
        high = glm::max(high, p);
      }
    }
    if (low.x <= high.x) {
      middle_ = (low + high) / 2.0;
      size_ = glm::length(high - low);
    }
    scene_.reset(rtcNewScene(device_.get()));
    rtcSetSceneFlags(scene_.get(), RTC_SCENE_FLAG_ROBUST);
    rtcSetSceneBuildQuality(scene_.get(), RTC_BUILD_QUALITY_HIGH);
    for (std::size_t i = 0; i < scene.objects.size(); ++i) add(scene.objects[i], unsigned(i));
    rtcCommitScene(scene_.get());
    if (rtcGetDeviceError(device_.get()) != RTC_ERROR_NONE) {
      throw std::runtime_error("Embree cannot take the scene");
    }
  }

  double size() const { return size_; }

  struct Hit {
    bool found = false;
    unsigned object = 0;
    glm::dvec3 position, normal;  ///< normal: of length 1, towards where the ray came from
  };
  Hit first_hit(const glm::dvec3& origin, const glm::dvec3& direction) const {
    Context context = make_context(RTC_INVALID_GEOMETRY_ID);
    RTCRayHit query{};
    query.ray = make_ray(origin, direction, 0, kInfinity, kCasterMask | kReceiverMask);
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(scene_.get(), &context.embree, &query);
    Hit hit;
    if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return hit;
    glm::dvec3 n(query.hit.Ng_x, query.hit.Ng_y, query.hit.Ng_z);
    n = glm::normalize(n);
    if (glm::dot(n, direction) > 0) n = -n;
    hit = {true, query.hit.geomID, origin + direction * double(query.ray.tfar), n};
    return hit;
  }

  bool occluded(const glm::dvec3& origin, const glm::dvec3& direction, double length,
                unsigned passed_over) const {
    Context context = make_context(passed_over);
    RTCRay ray = make_ray(origin, direction, 0, float(length), kCasterMask);
    rtcOccluded1(scene_.get(), &context.embree, &ray);
    return ray.tfar < 0;
  }

 private:
  void add(const Object& object, unsigned number) {
    RTCGeometry g = rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* vertices = static_cast<float*>(
        rtcSetNewGeometryBuffer(g, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float),
                                std::max<std::size_t>(object.positions.size(), 1)));
    auto* indices = static_cast<unsigned*>(
        rtcSetNewGeometryBuffer(g, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(unsigned),
                                object.triangles.size()));
    if (vertices == nullptr || (indices == nullptr && !object.triangles.empty())) {
      rtcReleaseGeometry(g);
      throw std::runtime_error("Embree cannot take object " + object.name);
    }
    for (std::size_t i = 0; i < object.positions.size(); ++i) {
      const glm::dvec3 p = object.positions[i] - middle_;
      for (int k = 0; k < 3; ++k) vertices[3 * i + std::size_t(k)] = float(p[k]);
    }
    for (std::size_t i = 0; i < object.triangles.size(); ++i) {
      for (std::size_t k = 0; k < 3; ++k) indices[3 * i + k] = object.triangles[i][k];
    }
    rtcSetGeometryMask(g, object.caster ? kCasterMask : kReceiverMask);
    rtcSetGeometryOccludedFilterFunction(g, pass_over_object);
    rtcCommitGeometry(g);
    rtcAttachGeometryByID(scene_.get(), g, number);
    rtcReleaseGeometry(g);
  }

  static Context make_context(unsigned passed_over) {
    Context context;
    rtcInitIntersectContext(&context.embree);
    context.passed_over = passed_over;
    return context;
  }

  RTCRay make_ray(const glm::dvec3& origin, const glm::dvec3& direction, float near, float far,
                  unsigned mask) const {
    const glm::dvec3 o = origin - middle_;
    RTCRay ray{};
    ray.org_x = float(o.x), ray.org_y = float(o.y), ray.org_z = float(o.z);
    ray.dir_x = float(direction.x), ray.dir_y = float(direction.y), ray.dir_z = float(direction.z);
    ray.tnear = near;
    ray.tfar = far;
    ray.mask = mask;
    return ray;
  }

  std::unique_ptr<RTCDeviceTy, DeviceDeleter> device_;
  std::unique_ptr<RTCSceneTy, SceneDeleter> scene_;
  glm::dvec3 middle_{0};
  double size_ = 1;
};

void check_arguments(const Scene& scene, const Trace& trace, const std::vector<std::uint8_t>& paper,
                     const std::vector<std::uint8_t>& physical) {
  const std::size_t count = trace.all_fragments.size();
  if (paper.size() != count || physical.size() != count) {
    throw std::invalid_argument("scene_exact: one verdict a fragment is needed");
  }
  if (count > 0 && (trace.header.image_width == 0 || trace.header.image_height == 0)) {
    throw std::invalid_argument("scene_exact: the trace has no image size");
  }
  for (const Object& o : scene.objects) {
    for (const auto& t : o.triangles) {
      if (std::max({t[0], t[1], t[2]}) >= o.positions.size()) {
        throw std::invalid_argument("scene_exact: a triangle of " + o.name + " has no such vertex");
      }
    }
  }
}

/// Judges one fragment after the other; one a thread.
class FragmentJudge {
 public:
  FragmentJudge(const RayScene& rays, const PixelRays& pixels, const Scene& scene)
      : rays_(rays), pixels_(pixels), light_(scene.light) {}

  void judge(const Fragment& f, bool paper, bool physical) {
    if (!(f.flags & Fragment::kVisible) || f.flags & (Fragment::kAverted | Fragment::kOutside)) {
      ++report.ignored;
      return;
    }
    const RayScene::Hit hit =
        rays_.first_hit(pixels_.origin(), pixels_.direction(f.pixel_x, f.pixel_y));
    if (!hit.found || hit.object != f.object) {
      ++report.skipped;
      return;
    }
    ++report.judged;
    const double offset = rays_.size() * kOffset;
    glm::dvec3 to_light = -glm::normalize(light_.direction);
    double length = std::numeric_limits<double>::infinity();
    if (light_.kind != Light::Kind::kDirectional) {
      const glm::dvec3 way = light_.position - hit.position;
      length = std::max(glm::length(way) - offset, 0.0);
      to_light = glm::normalize(way);
    }
    // The side of the surface that the light sees, whichever the camera does.
    const glm::dvec3 normal = glm::dot(hit.normal, to_light) < 0 ? -hit.normal : hit.normal;
    const glm::dvec3 origin = hit.position + normal * offset;
    const bool shadowed = rays_.occluded(origin, to_light, length, RTC_INVALID_GEOMETRY_ID);
    count(report.physical, physical, shadowed);
    count(report.paper, paper, shadowed && rays_.occluded(origin, to_light, length, f.object));
  }

  SceneExactReport report;

 private:
  static void count(SceneExactFigures& figures, bool verdict, bool dark) {
    if (verdict == dark) {
      ++figures.agree;
    } else {
      ++(dark ? figures.false_lit : figures.false_dark);
    }
  }

  const RayScene& rays_;
  const PixelRays& pixels_;
  const Light& light_;
};

void add(SceneExactFigures& sum, const SceneExactFigures& part) {
  sum.agree += part.agree;
  sum.false_lit += part.false_lit;
  sum.false_dark += part.false_dark;
}

}  // namespace

PixelRays::PixelRays(const Camera& camera, std::uint32_t image_width, std::uint32_t image_height)
    : origin_(camera.eye), width_(image_width), height_(image_height) {
  const double half_height = std::tan(glm::radians(camera.vertical_fov_degrees) / 2);
  forward_ = glm::normalize(camera.target - camera.eye);
  const glm::dvec3 side = glm::normalize(glm::cross(forward_, camera.up));
  right_ = side * (half_height * width_ / height_);
  up_ = glm::cross(side, forward_) * half_height;
}

glm::dvec3 PixelRays::direction(std::uint32_t pixel_x, std::uint32_t pixel_y) const {
  const double x = (2 * pixel_x + 1) / width_ - 1, y = 1 - (2 * pixel_y + 1) / height_;
  return glm::normalize(forward_ + right_ * x + up_ * y);
}

SceneExactReport scene_exact(const Scene& scene, const LightSpace& light_space, const Trace& trace,
                             const std::vector<std::uint8_t>& paper,
                             const std::vector<std::uint8_t>& physical, unsigned threads) {
  check_arguments(scene, trace, paper, physical);
  if (light_space.perspective != (scene.light.kind != Light::Kind::kDirectional)) {
    throw std::invalid_argument("scene_exact: the light space is another light's");
  }
  const RayScene rays(scene);
  const PixelRays pixels(scene.camera, trace.header.image_width, trace.header.image_height);
  if (threads == 0) threads = std::max(1u, std::thread::hardware_concurrency());
  std::vector<FragmentJudge> judges(threads, FragmentJudge(rays, pixels, scene));
  std::atomic<std::size_t> next{0};
  auto work = [&](FragmentJudge& judge) {
    constexpr std::size_t kPortion = 4096;
    const std::size_t count = trace.all_fragments.size();
    for (std::size_t begin; (begin = next.fetch_add(kPortion)) < count;) {
      for (std::size_t i = begin; i < std::min(begin + kPortion, count); ++i) {
        judge.judge(trace.all_fragments[i], paper[i] != 0, physical[i] != 0);
      }
    }
  };
  std::vector<std::thread> workers;
  for (unsigned i = 1; i < threads; ++i) workers.emplace_back(work, std::ref(judges[i]));
  work(judges[0]);
  for (std::thread& w : workers) w.join();
  SceneExactReport sum;
  for (const FragmentJudge& j : judges) {
    sum.judged += j.report.judged;
    sum.skipped += j.report.skipped;
    sum.ignored += j.report.ignored;
    add(sum.paper, j.report.paper);
    add(sum.physical, j.report.physical);
  }
  return sum;
}

}  // namespace kagesen

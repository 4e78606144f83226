#include "traces/raster/sampler.h"

#include <algorithm>
#include <cmath>

namespace kagesen {
namespace {

std::uint8_t shade_of(double cosine) {
  return static_cast<std::uint8_t>(std::clamp(cosine, 0.0, 1.0) * 255 + 0.5);
}

}  // namespace

Sampler::Sampler(const Scene& scene, const LightSpace& space, const CasterSet& casters)
    : light_(scene.light),
      clip_from_world_(space.clip_from_world),
      perspective_(space.perspective),
      grid_(space),
      surface_(casters) {}

void Sampler::select(std::uint32_t polygon, const glm::dvec3& normal,
                     const glm::dvec3& on_surface) {
  select(normal, on_surface);
  surface_known_ = !averted_;
  if (surface_known_) surface_.select(polygon);
}

void Sampler::select(const glm::dvec3& normal, const glm::dvec3& on_surface) {
  surface_known_ = false;
  const double length = glm::length(normal);
  normal_known_ = length > 0;
  if (!normal_known_) return select_unknown();
  normal_ = normal / length;
  // The sign is the same all over the plane, for a light at a place too.
  const glm::dvec3 to_light = perspective_ ? light_.position - on_surface : -light_.direction;
  const double cosine = glm::dot(normal, to_light);
  averted_ = !(cosine > 0);
  flat_shade_ = shade_of(glm::dot(normal_, to_light) / glm::length(to_light));
}

void Sampler::select_unknown() {
  surface_known_ = normal_known_ = averted_ = false;
  flat_shade_ = 255;
}

void Sampler::place(const glm::dvec3& world, Fragment& fragment) const {
  if (averted_) fragment.flags |= Fragment::kAverted;
  fragment.shade = flat_shade_;
  if (perspective_ && normal_known_) {
    const glm::dvec3 to_light = light_.position - world;
    fragment.shade = averted_ ? 0 : shade_of(glm::dot(normal_, to_light) / glm::length(to_light));
  }
  const glm::dvec4 clip = clip_from_world_ * glm::dvec4(world, 1);
  if (!(clip.w > 0)) {
    fragment.flags |= Fragment::kOutside;
    fragment.position = {};
    return;
  }
  bool outside = perspective_ && clip.z < 0;
  for (const glm::dvec4& side : grid_.sides) outside = outside || !(glm::dot(side, clip) >= 0);
  fragment.position = grid_.snap(clip);
  if (outside) {
    fragment.flags |= Fragment::kOutside;
    return;
  }
  fragment.position.z =
      static_cast<std::uint32_t>(std::clamp<double>(std::floor(UnitGrid::z(clip)), 0, kDepthMax));
  if (surface_known_) surface_.settle(fragment.position);
}

}  // namespace kagesen

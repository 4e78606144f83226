#include "sim/report/palette.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace kagesen {
namespace {

constexpr Light3 kSun{1.02f, 0.98f, 0.90f};
constexpr Light3 kAmbient{0.13f, 0.16f, 0.21f};  // sky light: what is in shadow looks bluish
constexpr Light3 kSkyTop{0.25f, 0.45f, 0.72f};
constexpr Light3 kSkyHorizon{0.78f, 0.86f, 0.92f};
constexpr Light3 kGround{0.62f, 0.59f, 0.53f};

constexpr std::array<Light3, 9> kSurfaces{{{0.72f, 0.26f, 0.16f},
                                           {0.17f, 0.40f, 0.58f},
                                           {0.80f, 0.58f, 0.18f},
                                           {0.25f, 0.48f, 0.26f},
                                           {0.48f, 0.28f, 0.52f},
                                           {0.78f, 0.44f, 0.38f},
                                           {0.20f, 0.52f, 0.52f},
                                           {0.70f, 0.68f, 0.62f},
                                           {0.42f, 0.32f, 0.24f}}};

Light3 blend(const Light3& a, const Light3& b, float t) {
  return {a.r + (b.r - a.r) * t, a.g + (b.g - a.g) * t, a.b + (b.b - a.b) * t};
}

/// Linear to screen, tabulated: pow() for every pixel would cost more than the run.
const std::array<std::uint8_t, 4097>& screen_table() {
  static const auto table = [] {
    std::array<std::uint8_t, 4097> values{};
    for (std::size_t i = 0; i < values.size(); ++i) {
      values[i] = static_cast<std::uint8_t>(std::lround(255 * std::pow(double(i) / 4096, 1 / 2.2)));
    }
    return values;
  }();
  return table;
}

}  // namespace

Rgb encoded(const Light3& light) {
  const auto& table = screen_table();
  const auto value = [&](float v) {
    return table[static_cast<std::size_t>(std::clamp(v, 0.0f, 1.0f) * 4096 + 0.5f)];
  };
  return {value(light.r), value(light.g), value(light.b)};
}

Light3 shaded(const ObjectInfo& object, std::size_t index, std::uint8_t shade, bool dark) {
  const Light3& surface = object.caster ? kSurfaces[index % kSurfaces.size()] : kGround;
  const float sun = dark ? 0.0f : float(shade) / 255;
  return {surface.r * (kAmbient.r + kSun.r * sun), surface.g * (kAmbient.g + kSun.g * sun),
          surface.b * (kAmbient.b + kSun.b * sun)};
}

Light3 sky(double height) {
  return blend(kSkyTop, kSkyHorizon, float(std::sqrt(std::clamp(height, 0.0, 1.0))));
}

Rgb cause_colour(Cause cause) {
  switch (cause) {
    case Cause::kNone:
      return {120, 120, 120};
    case Cause::kQuantisation:
      return {255, 176, 0};
    case Cause::kIdRule:
      return {220, 38, 127};
    case Cause::kDepth:
      return {100, 143, 255};
    case Cause::kCombination:
      return {254, 97, 0};
    case Cause::kCancelling:
      return {150, 110, 255};
    case Cause::kHiddenRemoval:
      return {0, 200, 150};
    case Cause::kCapacity:
      return {255, 255, 255};
    case Cause::kOther:
      return {255, 0, 0};
  }
  return {};
}

Rgb heat_colour(double t) {
  static constexpr std::array<Rgb, 6> kStops{{{58, 28, 110},
                                              {120, 28, 109},
                                              {188, 55, 84},
                                              {237, 105, 37},
                                              {251, 180, 26},
                                              {252, 255, 190}}};
  const double at = std::clamp(t, 0.0, 1.0) * (kStops.size() - 1);
  const std::size_t stop = std::min<std::size_t>(static_cast<std::size_t>(at), kStops.size() - 2);
  return mix(kStops[stop], kStops[stop + 1], at - double(stop));
}

}  // namespace kagesen

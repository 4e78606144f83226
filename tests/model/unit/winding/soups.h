#pragma once
/// Random frames of the winding profile at any scale, run through the Engine interface.
#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "model/frame_setup.h"
#include "model/reference/triangle.h"
#include "tests/model/random_meshes.h"
#include "tests/model/unit/frame.h"

namespace kagesen {

inline UnitConfig winding_config(Semantics semantics, int fraction_bits = 8) {
  UnitConfig c;
  c.profile = Profile::kWinding;
  c.semantics = semantics;
  c.fraction_bits = fraction_bits;
  return c;
}

enum class Scene { kSoup, kMesh, kStack, kSheets };
inline constexpr Scene kScenes[] = {Scene::kSoup, Scene::kMesh, Scene::kStack, Scene::kSheets};

/// Triangles from an eighth of the radius to the whole map, with shared vertices, on and off the
/// borders of texels; meshes; stacks that hide each other; sheets that pass through one another.
/// Fragments on, near and between them, at and about their depths.
class RandomTrace {
 public:
  RandomTrace(Scene scene, int texel_bits, int fraction_bits, std::uint64_t seed,
              int fragments = 1500)
      : g_(seed), texel_(std::int64_t{1} << texel_bits) {
    trace.header.fraction_bits = std::uint32_t(texel_bits);
    trace.header.objects.resize(4);
    side_ = std::min<std::int64_t>(24, (std::int64_t{1} << 28) / texel_);
    trace.header.map_width = trace.header.map_height = std::uint32_t(side_);
    radius_ = std::max<std::int64_t>(1, texel_ >> fraction_bits);
    reach_ = std::min<std::int64_t>(side_ * texel_ * 5 / 8, kCoordinateMax);
    switch (scene) {
      case Scene::kSoup:
        for (int i = 0; i < 60; ++i) add_any(std::int64_t{1} << g_.in(0, 24));
        break;
      case Scene::kStack:
        for (int i = 0; i < 40; ++i) add_large();
        for (int i = 0; i < 30; ++i) add_any(1 << 22);
        break;
      default:
        for (int i = 0; i < (scene == Scene::kMesh ? 1 : 3); ++i) add_mesh();
    }
    for (std::size_t i = 0; i < trace.all_casters.size(); ++i) {
      trace.all_casters[i].polygon = std::uint32_t(i);
    }
    for (int i = 0; i < fragments; ++i) add_fragment();
  }

  UnitConfig fit(UnitConfig c) const {
    c.map_width = c.map_height = side_;
    return c;
  }

  Trace trace;

 private:
  std::int32_t clip(std::int64_t v) const {
    return std::int32_t(std::clamp<std::int64_t>(v, kCoordinateMin, kCoordinateMax));
  }
  LightPoint about(const LightPoint& p, std::int64_t spread, std::int64_t depth_spread) {
    LightPoint out{clip(p.x + g_.in(-spread, spread)), clip(p.y + g_.in(-spread, spread)), 0};
    if (g_.in(0, 7) == 0) out.x = clip(out.x / texel_ * texel_);
    if (g_.in(0, 7) == 0) out.y = clip(out.y / texel_ * texel_);
    out.z = std::uint32_t(
        std::clamp<std::int64_t>(p.z + g_.in(-depth_spread, depth_spread), 0, kDepthMax));
    return out;
  }
  void add_any(std::int64_t depth_spread) {
    const std::int64_t size =
        std::max<std::int64_t>(1, std::int64_t(double(radius_) / 8 *
                                               std::pow(8.0 * double(reach_) / double(radius_),
                                                        double(g_.in(0, 100)) / 100)));
    Caster c;
    c.object = std::uint32_t(g_.in(0, 3));
    const LightPoint centre = about({0, 0, 1 << 23}, reach_, 1 << 22);
    for (LightPoint& p : c.vertex) {
      p = about(centre, size, depth_spread / 4);
      if (!trace.all_casters.empty() && g_.in(0, 4) == 0) {
        p = trace.all_casters[std::size_t(g_.in(0, std::int64_t(trace.all_casters.size()) - 1))]
                .vertex[g_.in(0, 2)];
      }
    }
    trace.all_casters.push_back(c);
  }
  void add_large() {
    const std::uint32_t z = std::uint32_t(g_.in(1, 15)) << 20;
    Caster c;
    c.object = std::uint32_t(g_.in(0, 3));
    for (LightPoint& p : c.vertex) p = about({0, 0, z}, kCoordinateMax, 1 << g_.in(0, 20));
    trace.all_casters.push_back(c);
  }
  void add_mesh() {
    const int pitch = int(std::log2(double(texel_))) - int(g_.in(0, 3));
    const std::int64_t shift = g_.in(0, reach_);
    for (Caster c : random_mesh(int(g_.in(3, 7)), std::min(pitch, 22), g_.engine())) {
      for (LightPoint& p : c.vertex) {
        p.x = clip(p.x - shift / 2);
        p.y = clip(p.y - shift / 2);
      }
      trace.all_casters.push_back(c);
    }
  }
  void add_fragment() {
    const Caster& c =
        trace.all_casters[std::size_t(g_.in(0, std::int64_t(trace.all_casters.size()) - 1))];
    double u = double(g_.in(0, 100)) / 100, v = double(g_.in(0, 100)) / 100;
    if (g_.in(0, 2) == 0) v = 0;
    if (u + v > 1) u = 1 - u, v = 1 - v;
    const auto mix = [&](double a, double b, double d) { return a + u * (b - a) + v * (d - a); };
    const LightPoint* p = c.vertex;
    const std::int64_t away = std::int64_t(double(radius_) * std::pow(2.0, double(g_.in(-3, 6))));
    const std::int64_t limit = side_ * texel_ / 2 - 1;
    Fragment f;
    f.position.x = clip(std::clamp<std::int64_t>(
        std::llround(mix(p[0].x, p[1].x, p[2].x)) + g_.in(-away, away), -limit, limit));
    f.position.y = clip(std::clamp<std::int64_t>(
        std::llround(mix(p[0].y, p[1].y, p[2].y)) + g_.in(-away, away), -limit, limit));
    const std::int64_t off = std::int64_t{1} << g_.in(0, 23);
    f.position.z = std::uint32_t(std::clamp<std::int64_t>(
        std::llround(mix(p[0].z, p[1].z, p[2].z)) + g_.in(-off, 2 * off), 0, kDepthMax));
    f.object = std::uint32_t(g_.in(0, 3));
    if (g_.in(0, 40) == 0) f.flags = std::uint8_t(g_.in(0, 7));
    trace.all_fragments.push_back(f);
  }

  Generator g_;
  std::int64_t texel_, side_, radius_, reach_;
};

inline Outcome outcome(Engine& engine, const std::vector<Fragment>& fragments) {
  Outcome out;
  out.verdicts.resize(fragments.size());
  engine.decide(fragments.data(), fragments.size(), out.verdicts.data());
  out.contents = engine.contents();
  out.counters = engine.counters();
  return out;
}

inline Outcome run_winding(Engine& engine, const Trace& trace, const UnitConfig& config) {
  engine.begin(config, make_frame_setup(trace, config));
  engine.announce(trace.all_fragments.data(), trace.all_fragments.size());
  engine.draw(trace.all_casters.data(), trace.all_casters.size());
  return outcome(engine, trace.all_fragments);
}
inline Outcome run_winding(const Trace& trace, const UnitConfig& config) {
  return run_winding(*make_golden_engine(), trace, config);
}

inline auto as_tuple(const SegmentRecord& s) {
  return std::tie(s.x0, s.y0, s.x1, s.y1, s.positive, s.crosses_left);
}
inline bool operator==(const SegmentRecord& a, const SegmentRecord& b) {
  return as_tuple(a) == as_tuple(b);
}
inline bool operator==(const TexelCluster& a, const TexelCluster& b) {
  return std::tie(a.texel_x, a.texel_y, a.object, a.base, a.gradient_x, a.gradient_y, a.corner,
                  a.full, a.segments) == std::tie(b.texel_x, b.texel_y, b.object, b.base,
                                                  b.gradient_x, b.gradient_y, b.corner, b.full,
                                                  b.segments);
}

}  // namespace kagesen

#pragma once
/// Random meshes with what adjacency stumbles over, and other ways to write the same casters.
#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

#include "tests/model/random_casters.h"

namespace kagesen {

/// A sheet of side x side quads, each of two triangles, curved, folded, jittered and noisy by
/// chance; a few triangles are missing, duplicated, split at an edge or of another object.
///
/// @param log2_pitch  of a quad's side in units, 0 to 22
inline std::vector<Caster> random_mesh(int side, int log2_pitch, std::uint64_t seed) {
  Generator g(seed);
  const std::int64_t pitch = std::int64_t{1} << log2_pitch;
  const std::int64_t jitter = g.in(0, 1) ? pitch / 3 : 0;
  const std::int64_t noise = g.in(0, 1) ? g.in(0, 40) : 0;
  const std::int64_t slope_x = g.in(-300, 300), slope_y = g.in(-300, 300);
  const std::int64_t bend = g.in(0, 2) ? g.in(-20, 20) : 0;
  const bool faulty = g.in(0, 1);
  std::vector<LightPoint> points;
  for (int j = 0; j <= side; ++j) {
    for (int i = 0; i <= side; ++i) {
      const std::int64_t z = 8'000'000 + slope_x * i + slope_y * j + bend * (i * i + j * j);
      points.push_back(g.near({std::int32_t(i * pitch), std::int32_t(j * pitch), std::uint32_t(z)},
                              jitter, noise));
    }
  }
  std::vector<Caster> out;
  const auto add = [&](const LightPoint& a, const LightPoint& b, const LightPoint& c) {
    const std::uint32_t object = faulty && g.in(0, 19) == 0;
    const int fault = faulty ? int(g.in(0, 29)) : 29;
    if (fault == 0) return;
    if (fault == 1) {
      const LightPoint middle{(a.x + b.x) / 2, (a.y + b.y) / 2, (a.z + b.z) / 2};
      out.push_back({{a, middle, c}, object, 0});
      out.push_back({{middle, b, c}, object, 0});
      return;
    }
    if (fault == 2) out.push_back({{a, b, c}, object, 0});
    if (fault == 3) out.push_back({{a, b, g.near(c, pitch, 50)}, object, 0});
    out.push_back({{a, b, c}, object, 0});
  };
  for (int j = 0; j < side; ++j) {
    for (int i = 0; i < side; ++i) {
      const LightPoint* p = &points[std::size_t(j * (side + 1) + i)];
      const LightPoint &a = p[0], &b = p[1], &c = p[side + 2], &d = p[side + 1];
      if (g.in(0, 1)) {
        add(a, b, c);
        add(a, c, d);
      } else {
        add(a, b, d);
        add(d, b, c);
      }
    }
  }
  for (std::size_t i = 0; i < out.size(); ++i) out[i].polygon = std::uint32_t(i);
  return out;
}

/// A caster written otherwise: which old caster it is, and which of its vertices each one was.
struct Rewritten {
  std::size_t caster;
  std::array<std::size_t, 3> vertex;
  /// The old number of its edge k.
  std::size_t old_edge(std::size_t k) const { return (vertex[(k + 2) % 3] + 1) % 3; }
};

/// The same casters in another order, each with its vertices in another one.
inline std::vector<Caster> rewrite(const std::vector<Caster>& casters, std::uint64_t seed,
                                   std::vector<Rewritten>& how) {
  std::mt19937_64 random(seed);
  how.assign(casters.size(), {0, {0, 1, 2}});
  for (std::size_t i = 0; i < how.size(); ++i) {
    how[i].caster = i;
    std::shuffle(how[i].vertex.begin(), how[i].vertex.end(), random);
  }
  std::shuffle(how.begin(), how.end(), random);
  std::vector<Caster> out;
  for (const Rewritten& r : how) {
    const Caster& old = casters[r.caster];
    out.push_back(old);
    for (std::size_t k = 0; k < 3; ++k) out.back().vertex[k] = old.vertex[r.vertex[k]];
  }
  return out;
}

}  // namespace kagesen

#include "traces/scene/topology.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>
#include <string>
#include <unordered_map>

namespace kagesen {
namespace {

struct PositionHash {
  std::size_t operator()(const glm::dvec3& p) const {
    std::uint64_t h = 0x9e3779b97f4a7c15u;
    for (int i = 0; i < 3; ++i) {
      const double v = p[i] + 0.0;  // -0 + 0 is 0
      std::uint64_t bits;
      std::memcpy(&bits, &v, sizeof bits);
      h = (h ^ bits) * 0xbf58476d1ce4e5b9u;
      h ^= h >> 29;
    }
    return h;
  }
};

class UnionFind {
 public:
  explicit UnionFind(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), 0u);
  }
  std::uint32_t find(std::uint32_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(std::uint32_t a, std::uint32_t b) {
    a = find(a);
    b = find(b);
    if (a != b) parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::uint32_t> parent_;
};

constexpr std::uint32_t kNone = 0xffffffffu;

std::uint32_t number_components(const Object& object, const std::vector<std::uint32_t>& welded,
                                std::vector<std::uint32_t>& component) {
  UnionFind sets(welded.size());
  for (const auto& t : object.triangles) {
    sets.join(welded[t[0]], welded[t[1]]);
    sets.join(welded[t[0]], welded[t[2]]);
  }
  std::vector<std::uint32_t> number(welded.size(), kNone);
  std::uint32_t count = 0;
  component.resize(object.triangles.size());
  for (std::size_t i = 0; i < object.triangles.size(); ++i) {
    std::uint32_t& n = number[sets.find(welded[object.triangles[i][0]])];
    if (n == kNone) n = count++;
    component[i] = n;
  }
  return count;
}

/// Every edge exactly once each way. One sort: the direction is the key's lowest bit.
bool edges_pair_up(const Object& object, const std::vector<std::uint32_t>& welded) {
  std::vector<std::uint64_t> keys;
  keys.reserve(object.triangles.size() * 3);
  for (const auto& t : object.triangles) {
    const std::uint64_t v[3] = {welded[t[0]], welded[t[1]], welded[t[2]]};
    if (v[0] == v[1] || v[1] == v[2] || v[2] == v[0]) continue;
    for (int e = 0; e < 3; ++e) {
      const std::uint64_t a = v[e], b = v[(e + 1) % 3];
      keys.push_back(a < b ? a << 33 | b << 1 : b << 33 | a << 1 | 1);
    }
  }
  std::sort(keys.begin(), keys.end());
  if (keys.empty() || keys.size() % 2 != 0) return false;
  for (std::size_t i = 0; i < keys.size(); i += 2) {
    if ((keys[i] & 1) != 0 || keys[i + 1] != (keys[i] | 1)) return false;
    if (i + 2 < keys.size() && keys[i + 2] <= keys[i + 1]) return false;
  }
  return true;
}

/// Signed volume of each component, and the sum of the absolute terms as a measure of its noise.
struct Volume {
  double sum = 0, absolute = 0;
  glm::dvec3 origin{0};
  bool started = false;
};

}  // namespace

std::vector<std::uint32_t> weld(const std::vector<glm::dvec3>& positions) {
  std::unordered_map<glm::dvec3, std::uint32_t, PositionHash> first;
  first.reserve(positions.size());
  std::vector<std::uint32_t> welded(positions.size());
  for (std::size_t i = 0; i < positions.size(); ++i) {
    welded[i] = first.emplace(positions[i], static_cast<std::uint32_t>(first.size())).first->second;
  }
  return welded;
}

std::uint32_t components(const Object& object, std::vector<std::uint32_t>& component) {
  return number_components(object, weld(object.positions), component);
}

std::vector<Object> split_components(const Object& object) {
  std::vector<std::uint32_t> component;
  std::vector<Object> parts(components(object, component));
  std::vector<std::uint32_t> index(object.positions.size(), kNone);
  for (std::size_t k = 0; k < parts.size(); ++k) {
    parts[k].name = object.name + "." + std::to_string(k);
    parts[k].caster = object.caster;
    parts[k].colour = object.colour;
  }
  for (std::size_t i = 0; i < object.triangles.size(); ++i) {
    Object& part = parts[component[i]];
    std::array<std::uint32_t, 3> t = object.triangles[i];
    for (std::uint32_t& v : t) {
      if (index[v] == kNone) {
        index[v] = static_cast<std::uint32_t>(part.positions.size());
        part.positions.push_back(object.positions[v]);
      }
      v = index[v];
    }
    part.triangles.push_back(t);
  }
  return parts;
}

void classify_object(Object& object) {
  object.closed = false;
  const std::vector<std::uint32_t> welded = weld(object.positions);
  if (!edges_pair_up(object, welded)) return;

  std::vector<std::uint32_t> component;
  std::vector<Volume> volumes(number_components(object, welded, component));
  for (std::size_t i = 0; i < object.triangles.size(); ++i) {
    const auto& t = object.triangles[i];
    Volume& volume = volumes[component[i]];
    if (!volume.started) volume.origin = object.positions[t[0]];
    volume.started = true;
    const glm::dvec3 a = object.positions[t[0]] - volume.origin;
    const glm::dvec3 b = object.positions[t[1]] - volume.origin;
    const glm::dvec3 c = object.positions[t[2]] - volume.origin;
    const double term = glm::dot(a, glm::cross(b, c));
    volume.sum += term;
    volume.absolute += glm::length(a) * glm::length(b) * glm::length(c);
  }
  constexpr double kNoise = 1e-12;  // of sums of doubles; a real solid is far above
  for (const Volume& volume : volumes) {
    if (std::abs(volume.sum) <= kNoise * volume.absolute) return;
  }
  for (std::size_t i = 0; i < object.triangles.size(); ++i) {
    if (volumes[component[i]].sum < 0) std::swap(object.triangles[i][1], object.triangles[i][2]);
  }
  object.closed = true;
}

void classify_objects(Scene& scene) {
  for (Object& object : scene.objects) classify_object(object);
}

}  // namespace kagesen

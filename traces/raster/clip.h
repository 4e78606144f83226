#pragma once
/// Clipping of convex polygons in homogeneous coordinates, so that neighbours stay watertight.
#include <array>
#include <glm/glm.hpp>

namespace kagesen {

/// A triangle grows by at most one vertex a plane.
struct ClipPolygon {
  std::array<glm::dvec4, 16> vertex;
  int count = 0;
  void push(const glm::dvec4& v) { vertex[static_cast<std::size_t>(count++)] = v; }
};

/// The point where the edge a-b meets the plane dot(plane, v) = 0; the ends lie on different sides.
///
/// Computed from the smaller end to the larger (in lexicographic order) whichever way round it is
/// asked: two triangles that share the edge get the same bits, and snap to the same vertex.
inline glm::dvec4 cut_edge(glm::dvec4 a, glm::dvec4 b, const glm::dvec4& plane) {
  for (int i = 0; i < 4; ++i) {
    if (a[i] == b[i]) continue;
    if (a[i] > b[i]) std::swap(a, b);
    break;
  }
  const double da = glm::dot(plane, a), db = glm::dot(plane, b);
  return a + (b - a) * (da / (da - db));
}

/// Keeps what lies on the side dot(plane, v) >= 0.
inline ClipPolygon clip(const ClipPolygon& in, const glm::dvec4& plane) {
  ClipPolygon out;
  for (int i = 0; i < in.count; ++i) {
    const glm::dvec4& a = in.vertex[static_cast<std::size_t>(i)];
    const glm::dvec4& b = in.vertex[static_cast<std::size_t>((i + 1) % in.count)];
    const bool a_inside = glm::dot(plane, a) >= 0, b_inside = glm::dot(plane, b) >= 0;
    if (a_inside) out.push(a);
    if (a_inside != b_inside) out.push(cut_edge(a, b, plane));
  }
  return out;
}

}  // namespace kagesen

#include "traces/scene/solids.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace kagesen {
namespace {

constexpr double kPi = 3.14159265358979323846;

glm::dvec3 turned(glm::dvec3 p, const glm::dvec3& degrees) {
  for (int axis = 0; axis < 3; ++axis) {
    const double angle = degrees[axis] * (kPi / 180), c = std::cos(angle), s = std::sin(angle);
    const int i = (axis + 1) % 3, j = (axis + 2) % 3;
    const double u = p[i], v = p[j];
    p[i] = c * u - s * v;
    p[j] = s * u + c * v;
  }
  return p;
}

}  // namespace

Object make_box(const glm::dvec3& half) {
  Object o;
  for (int i = 0; i < 8; ++i) {
    o.positions.push_back(half * glm::dvec3(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1));
  }
  o.triangles = {{0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}, {0, 1, 5}, {0, 5, 4},
                 {2, 6, 7}, {2, 7, 3}, {0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}};
  return o;
}

Object make_tetrahedron(double radius) {
  const double s = radius / std::sqrt(3.0);
  Object o;
  o.positions = {{s, s, s}, {s, -s, -s}, {-s, s, -s}, {-s, -s, s}};
  o.triangles = {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}};
  return o;
}

Object make_icosahedron(double radius) {
  const double a = radius / std::sqrt((5 + std::sqrt(5.0)) / 2), b = a * (1 + std::sqrt(5.0)) / 2;
  Object o;
  o.positions = {{-a, b, 0},  {a, b, 0},  {-a, -b, 0}, {a, -b, 0}, {0, -a, b},  {0, a, b},
                 {0, -a, -b}, {0, a, -b}, {b, 0, -a},  {b, 0, a},  {-b, 0, -a}, {-b, 0, a}};
  o.triangles = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                 {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                 {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                 {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
  return o;
}

Object make_cylinder(double bottom_radius, double top_radius, double half_height, int sides) {
  Object o;
  o.positions = {{0, -half_height, 0}, {0, half_height, 0}};
  const auto n = static_cast<std::uint32_t>(sides);
  for (std::uint32_t i = 0; i < n; ++i) {
    const double angle = 2 * kPi * i / n, c = std::cos(angle), s = std::sin(angle);
    o.positions.push_back({bottom_radius * c, -half_height, bottom_radius * s});
    o.positions.push_back({top_radius * c, half_height, top_radius * s});
  }
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t a = 2 + 2 * i, b = 2 + 2 * ((i + 1) % n);
    o.triangles.push_back({0, a, b});
    o.triangles.push_back({1, b + 1, a + 1});
    o.triangles.push_back({a, a + 1, b + 1});
    o.triangles.push_back({a, b + 1, b});
  }
  return o;
}

Object make_sphere(double radius, int around, int rings) {
  const auto n = static_cast<std::uint32_t>(around), m = static_cast<std::uint32_t>(rings);
  Object o;
  o.positions = {{0, -radius, 0}, {0, radius, 0}};
  for (std::uint32_t j = 1; j < m; ++j) {
    const double latitude = kPi * j / m, r = radius * std::sin(latitude);
    for (std::uint32_t i = 0; i < n; ++i) {
      const double angle = 2 * kPi * i / n;
      o.positions.push_back(
          {r * std::cos(angle), -radius * std::cos(latitude), r * std::sin(angle)});
    }
  }
  const auto at = [&](std::uint32_t i, std::uint32_t j) { return 2 + (j - 1) * n + i % n; };
  for (std::uint32_t i = 0; i < n; ++i) o.triangles.push_back({0, at(i, 1), at(i + 1, 1)});
  for (std::uint32_t j = 1; j + 1 < m; ++j) {
    for (std::uint32_t i = 0; i < n; ++i) {
      o.triangles.push_back({at(i, j), at(i, j + 1), at(i + 1, j + 1)});
      o.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i + 1, j)});
    }
  }
  for (std::uint32_t i = 0; i < n; ++i) o.triangles.push_back({1, at(i + 1, m - 1), at(i, m - 1)});
  return o;
}

Object make_torus(double radius, double tube, int around, int sides) {
  const auto n = static_cast<std::uint32_t>(around), m = static_cast<std::uint32_t>(sides);
  Object o;
  for (std::uint32_t i = 0; i < n; ++i) {
    const double u = 2 * kPi * i / n;
    for (std::uint32_t j = 0; j < m; ++j) {
      const double v = 2 * kPi * j / m, r = radius + tube * std::cos(v);
      o.positions.push_back({r * std::cos(u), tube * std::sin(v), r * std::sin(u)});
    }
  }
  const auto at = [&](std::uint32_t i, std::uint32_t j) { return (i % n) * m + j % m; };
  for (std::uint32_t i = 0; i < n; ++i) {
    for (std::uint32_t j = 0; j < m; ++j) {
      o.triangles.push_back({at(i, j), at(i, j + 1), at(i + 1, j + 1)});
      o.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i + 1, j)});
    }
  }
  return o;
}

Object make_cells(const std::vector<std::string>& rows, const std::vector<double>& x,
                  const std::vector<double>& y, double half_depth) {
  const int height = static_cast<int>(rows.size());
  const auto filled = [&](int column, int row) {
    if (row < 0 || row >= height || column < 0) return false;
    const std::string& text = rows[static_cast<std::size_t>(height - 1 - row)];
    return column < static_cast<int>(text.size()) && text[static_cast<std::size_t>(column)] == '#';
  };
  Object o;
  std::map<std::array<int, 3>, std::uint32_t> numbers;
  const auto vertex = [&](int column, int row, int side) {
    const auto found = numbers.emplace(std::array<int, 3>{column, row, side},
                                       static_cast<std::uint32_t>(o.positions.size()));
    if (found.second) {
      o.positions.push_back({x[static_cast<std::size_t>(column)], y[static_cast<std::size_t>(row)],
                             side ? half_depth : -half_depth});
    }
    return found.first->second;
  };
  const auto quad = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    o.triangles.push_back({a, b, c});
    o.triangles.push_back({a, c, d});
  };
  for (int row = 0; row < height; ++row) {
    for (int column = 0; column + 1 < static_cast<int>(x.size()); ++column) {
      if (!filled(column, row)) continue;
      const int right = column + 1, top = row + 1;
      quad(vertex(column, row, 1), vertex(right, row, 1), vertex(right, top, 1),
           vertex(column, top, 1));
      quad(vertex(column, row, 0), vertex(column, top, 0), vertex(right, top, 0),
           vertex(right, row, 0));
      const auto wall = [&](int c0, int r0, int c1, int r1) {
        quad(vertex(c0, r0, 0), vertex(c1, r1, 0), vertex(c1, r1, 1), vertex(c0, r0, 1));
      };
      if (!filled(column, row - 1)) wall(column, row, right, row);
      if (!filled(column + 1, row)) wall(right, row, right, top);
      if (!filled(column, row + 1)) wall(right, top, column, top);
      if (!filled(column - 1, row)) wall(column, top, column, row);
    }
  }
  return o;
}

void place(Object& object, const glm::dvec3& degrees, const glm::dvec3& move) {
  for (glm::dvec3& p : object.positions) p = turned(p, degrees) + move;
}

void rest_on_ground(Object& object, double gap) {
  double low = 1e300;
  for (const glm::dvec3& p : object.positions) low = std::min(low, p.y);
  for (glm::dvec3& p : object.positions) p.y += gap - low;
}

void add(Scene& scene, Object object, const std::string& name, const glm::vec3& colour) {
  object.name = name;
  object.colour = colour;
  scene.objects.push_back(std::move(object));
}

void add_level_ground(Scene& scene, double x, double z, double half_x, double half_z) {
  Object ground;
  ground.caster = false;
  ground.positions = {{x - half_x, 0, z - half_z},
                      {x - half_x, 0, z + half_z},
                      {x + half_x, 0, z + half_z},
                      {x + half_x, 0, z - half_z}};
  ground.triangles = {{0, 1, 2}, {0, 2, 3}};
  add(scene, std::move(ground), "ground", glm::vec3(0.55f, 0.55f, 0.52f));
}

}  // namespace kagesen

// Solids and surfaces in any position, snapped to the lattice as a capture does.
#include <cmath>
#include <vector>

#include "tests/stress/families.h"
#include "traces/scene/solids.h"

namespace kagesen::stress {
namespace {

constexpr double kTurn = 6.283185307179586;

/// Where a solid of about unit size goes: centre, units and depth units a length of 1.
struct Place {
  Point centre;
  double across, deep;
};

Place some_place(Builder& b) {
  Place place;
  place.centre = b.anywhere();
  place.across = static_cast<double>(b.span()) / b.dice.real(4, 20);
  place.deep = static_cast<double>(b.dice.magnitude(20));
  place.centre.z = b.dice.in(1 << 21, kDepthMax - (1 << 21));
  return place;
}

void turn(Builder& b, Object& solid) {
  const auto degrees = [&] {
    return b.dice.one_in(3) ? static_cast<double>(b.dice.in(0, 3)) * 90 : b.dice.real(0, 360);
  };
  const glm::dvec3 angles{degrees(), degrees(), degrees()};
  kagesen::place(solid, angles, {0, 0, 0});
}

/// Draws the light-facing side of a closed object, every triangle of another one.
void draw(Builder& b, const Object& solid, const Place& place, const char* name, bool closed) {
  const std::uint32_t object = b.object(name, closed);
  std::vector<Point> points;
  for (const glm::dvec3& p : solid.positions) {
    points.push_back(place.centre + Point{std::llround(p.x * place.across),
                                          std::llround(p.y * place.across),
                                          std::llround(p.z * place.deep)});
  }
  for (const auto& t : solid.triangles) {
    const Point &p = points[t[0]], &q = points[t[1]], &r = points[t[2]];
    const std::int64_t facing = (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
    if (!closed || facing < 0) b.triangle(p, q, r, object);
  }
}

Object some_solid(Builder& b) {
  switch (b.dice.in(0, 4)) {
    case 0:
      return make_box({b.dice.real(0.2, 1), b.dice.real(0.2, 1), b.dice.real(0.2, 1)});
    case 1:
      return make_tetrahedron(1);
    case 2:
      return make_icosahedron(1);
    case 3: {
      const double bottom = b.dice.real(0.1, 1), top = b.dice.real(0.1, 1);
      return make_cylinder(bottom, top, 1, b.dice.small(3, 12));
    }
    default: {
      const int around = b.dice.small(4, 12), rings = b.dice.small(3, 8);
      return make_sphere(1, around, rings);
    }
  }
}

/// A tube along a trefoil, closed.
Object make_knot(int around, int sides, double tube) {
  Object knot;
  const auto centre = [](double s) {
    return glm::dvec3{std::sin(s) + 2 * std::sin(2 * s), std::cos(s) - 2 * std::cos(2 * s),
                      -std::sin(3 * s)} /
           3.0;
  };
  for (int i = 0; i < around; ++i) {
    const double s = kTurn * i / around;
    const glm::dvec3 along = glm::normalize(centre(s + 1e-3) - centre(s - 1e-3));
    const glm::dvec3 side = glm::normalize(glm::cross(along, glm::dvec3{0, 0, 1}));
    const glm::dvec3 up = glm::cross(side, along);
    for (int j = 0; j < sides; ++j) {
      const double angle = kTurn * j / sides;
      knot.positions.push_back(centre(s) + tube * (std::cos(angle) * side + std::sin(angle) * up));
    }
  }
  const auto index = [&](int i, int j) {
    return static_cast<std::uint32_t>((i % around) * sides + j % sides);
  };
  for (int i = 0; i < around; ++i) {
    for (int j = 0; j < sides; ++j) {
      knot.triangles.push_back({index(i, j), index(i, j + 1), index(i + 1, j + 1)});
      knot.triangles.push_back({index(i, j), index(i + 1, j + 1), index(i + 1, j)});
    }
  }
  return knot;
}

}  // namespace

void build_interpenetrating(Builder& b) {
  b.small_map();
  Place place = some_place(b);
  const auto count = b.dice.in(2, 6);
  for (std::int64_t i = 0; i < count; ++i) {
    Object solid = some_solid(b);
    turn(b, solid);
    draw(b, solid, place, "solid", !b.dice.one_in(4));
    const auto across = static_cast<std::int64_t>(place.across);
    const auto deep = static_cast<std::int64_t>(place.deep);
    place.centre = place.centre + Point{b.dice.in(-across, across), b.dice.in(-across, across),
                                        b.dice.in(-deep, deep)};
  }
}

void build_torus(Builder& b) {
  b.small_map();
  const auto count = b.dice.in(1, 2);
  for (std::int64_t i = 0; i < count; ++i) {
    const double tube = b.dice.real(0.05, 0.6);
    const int around = b.dice.small(6, 24), sides = b.dice.small(3, 10);
    Object torus = make_torus(1, tube, around, sides);
    turn(b, torus);
    const Place place = some_place(b);
    draw(b, torus, place, "torus", !b.dice.one_in(4));
  }
}

void build_knot(Builder& b) {
  b.small_map();
  const int around = b.dice.small(16, 48), sides = b.dice.small(3, 8);
  Object knot = make_knot(around, sides, b.dice.real(0.05, 0.3));
  turn(b, knot);
  const Place place = some_place(b);
  draw(b, knot, place, "knot", !b.dice.one_in(4));
}

void build_shells(Builder& b) {
  b.small_map();
  const int around = b.dice.small(5, 12), rings = b.dice.small(3, 8);
  Object shell = make_sphere(1, around, rings);
  turn(b, shell);
  Place place = some_place(b);
  const auto count = b.dice.in(2, 5);
  const bool closed = b.dice.one_in(2);
  for (std::int64_t i = 0; i < count; ++i) {
    draw(b, shell, place, "shell", closed);
    // The next shell is inside, a few units in depth or in width.
    place.centre.z += b.dice.in(0, 40);
    place.across -= static_cast<double>(b.dice.pick<std::int64_t>({0, 1, 2, b.texel() / 16}));
    place.deep -= static_cast<double>(b.dice.in(0, 40));
  }
}

void build_boxes(Builder& b) {
  b.small_map();
  const int nx = b.dice.small(1, 4), ny = b.dice.small(1, 4);
  const double degrees = b.dice.pick({0.0, 45.0, b.dice.real(0, 90)});
  const double lean = b.dice.one_in(2) ? 0 : b.dice.real(-30, 30);
  const Place place = some_place(b);
  const bool closed = !b.dice.one_in(3);
  for (int i = 0; i < nx; ++i) {
    for (int j = 0; j < ny; ++j) {
      Object box = make_box({0.5, 0.5, 0.5});
      for (glm::dvec3& p : box.positions) p += glm::dvec3{i, j, b.dice.one_in(4) ? 0.5 : 0.0};
      kagesen::place(box, {lean, 0, degrees}, {0, 0, 0});
      draw(b, box, place, "box", closed);
    }
  }
}

void build_terrain(Builder& b) {
  b.small_map();
  const int n = b.dice.small(2, 12);
  Object field;
  const double rough = b.dice.one_in(3) ? 0 : b.dice.real(0, 1);
  const double jitter = b.dice.one_in(2) ? 0 : b.dice.real(0, 0.6);
  for (int i = 0; i <= n; ++i) {
    for (int j = 0; j <= n; ++j) {
      field.positions.push_back(glm::dvec3{(i + b.dice.real(-jitter, jitter)) / n - 0.5,
                                           (j + b.dice.real(-jitter, jitter)) / n - 0.5,
                                           b.dice.real(-rough, rough)});
    }
  }
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      const auto at = [&](int x, int y) { return static_cast<std::uint32_t>(x * (n + 1) + y); };
      field.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      field.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  Place place = some_place(b);
  place.across *= b.dice.real(1, 20);
  if (b.dice.one_in(2)) turn(b, field);
  draw(b, field, place, "terrain", false);
}

}  // namespace kagesen::stress

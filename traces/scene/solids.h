#pragma once
/// Building blocks of the built-in scenes: closed solids about the origin, outward winding, +y up.
#include <string>
#include <vector>

#include "traces/scene/scene.h"

namespace kagesen {

Object make_box(const glm::dvec3& half);
Object make_tetrahedron(double radius);
Object make_icosahedron(double radius);
/// A frustum of a cone with `sides` sides, from y = -half_height to half_height.
Object make_cylinder(double bottom_radius, double top_radius, double half_height, int sides);
/// 2 * around * (rings - 1) triangles; rings counts the bands between the poles.
Object make_sphere(double radius, int around, int rings);
/// Its axis is y.
Object make_torus(double radius, double tube, int around, int sides);
/// Closed bodies from filled cells of a letter drawn in rows of '#' and other characters.
/// Cell (column, row) spans x[column..column + 1] and y[row..row + 1], from the lowest row up;
/// z from -half_depth to half_depth. Cells may not touch at a corner alone.
Object make_cells(const std::vector<std::string>& rows, const std::vector<double>& x,
                  const std::vector<double>& y, double half_depth);

/// Turns by degrees about x, then y, then z, then moves.
void place(Object& object, const glm::dvec3& degrees, const glm::dvec3& move);
/// Lifts or lowers so that the lowest point stands `gap` over y = 0.
void rest_on_ground(Object& object, double gap);

/// Appends under a name and a colour.
void add(Scene& scene, Object object, const std::string& name, const glm::vec3& colour);
/// A ground plane at y = 0 over [-half_x, half_x] x [-half_z, half_z] about (x, z).
void add_level_ground(Scene& scene, double x, double z, double half_x, double half_z);

}  // namespace kagesen

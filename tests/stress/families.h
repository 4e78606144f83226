#pragma once
/// Adversarial geometry, a family a function. Which cases belong to which: case.h.
#include <string>
#include <vector>

#include "tests/stress/builder.h"

namespace kagesen::stress {

struct Family {
  std::string name;
  std::string what;  ///< in words
  void (*build)(Builder&);
};
const std::vector<Family>& families();

// On the lattice of texels.
void build_corners(Builder& b);
void build_borders(Builder& b);
void build_slopes(Builder& b);
void build_long_edges(Builder& b);
// Shapes of single facets and how they join.
void build_slivers(Builder& b);
void build_specks(Builder& b);
void build_fan(Builder& b);
void build_dense(Builder& b);
void build_layers(Builder& b);
void build_exact_junctions(Builder& b);
void build_rounded_junctions(Builder& b);
void build_windings(Builder& b);
void build_degenerate(Builder& b);
// Ends of the ranges.
void build_range_ends(Builder& b);
void build_map_sides(Builder& b);
void build_scale_1024(Builder& b);
void build_grazing(Builder& b);
void build_depth_ends(Builder& b);
void build_soup(Builder& b);
void build_mixture(Builder& b);
// Solids and surfaces, snapped.
void build_interpenetrating(Builder& b);
void build_torus(Builder& b);
void build_knot(Builder& b);
void build_shells(Builder& b);
void build_boxes(Builder& b);
void build_terrain(Builder& b);

}  // namespace kagesen::stress

#include "tests/stress/families.h"

namespace kagesen::stress {

const std::vector<Family>& families() {
  static const std::vector<Family> all = {
      {"corners", "vertices on texel corners, and one unit off them", build_corners},
      {"borders", "edges along texel borders, and one unit off them", build_borders},
      {"slopes", "slopes 0 and 1, and within one unit of them, in every octant", build_slopes},
      {"long_edges", "edges from one texel to all that 28-bit coordinates hold (4,096 texels)",
       build_long_edges},
      {"slivers", "triangles thinner than one unit, or than the radius of the contract",
       build_slivers},
      {"specks", "triangles of a few units, or about the size of the radius", build_specks},
      {"fan", "1,000 triangles round one vertex", build_fan},
      {"dense", "meshes of facets about the size of a snap step, no two in one plane", build_dense},
      {"layers", "coplanar and near-coplanar layers one depth unit apart", build_layers},
      {"exact_junctions", "T-junctions on the lattice", build_exact_junctions},
      {"rounded_junctions", "T-junctions that snapping has pulled apart", build_rounded_junctions},
      {"windings", "meshes in both windings, mixed and doubled", build_windings},
      {"degenerate", "duplicated triangles, points and straight lines", build_degenerate},
      {"range_ends", "coordinates at the ends of their range", build_range_ends},
      {"map_sides", "triangles across every side and corner of the map", build_map_sides},
      {"scale_1024", "26 fraction bits: a whole mesh in a texel or two", build_scale_1024},
      {"grazing", "depth gradients up to the whole range within a unit", build_grazing},
      {"depth_ends", "depths at and near 0 and 2^24 - 1", build_depth_ends},
      {"soup", "triangles of every size", build_soup},
      {"mixture", "two other families in one map", build_mixture},
      {"interpenetrating", "closed solids that cross each other", build_interpenetrating},
      {"torus", "tori, closed or drawn with all their sides", build_torus},
      {"knot", "trefoil knots", build_knot},
      {"shells", "nested shells a few depth units apart", build_shells},
      {"boxes", "boxes that share faces", build_boxes},
      {"terrain", "height fields, every vertex shared by six triangles", build_terrain},
  };
  return all;
}

}  // namespace kagesen::stress

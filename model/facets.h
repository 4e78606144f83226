#pragma once
/// Neighbouring facets that share one plane: what the winding profile keeps as one cluster.
#include <cstdint>
#include <vector>

#include "model/engine.h"

namespace kagesen {

struct FacetGroups {
  std::vector<Facet> facets;   ///< a caster each, in the given order
  std::vector<Caster> planes;  ///< the seeds of groups of two or more, vertices by x, y, z
};

/// Groups casters over the edges that they share. The grouping and the order of its planes depend
/// on the set of casters alone: not on their order, their first vertex or the way they wind.
///
/// Two casters are neighbours if they belong to one object, lie on either side of an edge with the
/// same two ends, depths included, and no third one has that edge. Casters of zero area and
/// narrow ones (see is_narrow) take no part. Seeds are tried by falling area in light space; a seed
/// gathers, from neighbour to neighbour, the casters that are still free and fit its plane:
/// - every vertex lies within plane_tolerance depth units of the plane, exactly;
/// - over r = 2^-fraction_bits texel, depths drift apart by plane_tolerance at most:
///   |g - g_seed|_1 r <= plane_tolerance, with g the gradient, |g|_1 = |dz/dx| + |dz/dy|. Else a
///   facet hardly wider than r could be off by several times the tolerance next to its edges;
/// - the seed is not steeper by more than a quarter of a depth unit over r: |g_seed|_1 r <=
///   |g|_1 r + 1/4, so that a bias made for the seed's gradient keeps within the contact distance
///   of the member. That costs little: what faces the light looks largest and is tried first.
/// Gradients are compared in steps of 2^-8 depth units over r; with a tolerance of 0 only coplanar
/// facets merge. A caster alone keeps its own plane.
///
/// @param trace_fraction_bits  units a texel = 2^this
FacetGroups group_facets(const std::vector<Caster>& casters, std::uint32_t trace_fraction_bits,
                         const UnitConfig& config);

/// Is the height over a caster's longest edge, or that edge itself, at most a quarter of
/// r = 2^-radius_bits texel? Exact. True for zero area.
bool is_narrow(const Caster& caster, std::uint32_t trace_fraction_bits, int radius_bits);

}  // namespace kagesen

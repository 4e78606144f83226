#pragma once
/// What hangs together in a mesh, and what is closed. Vertices count as one where their positions
/// are exactly equal.
#include <cstdint>
#include <vector>

#include "traces/scene/scene.h"

namespace kagesen {

/// For each position the index of the first equal one (-0 equals 0), renumbered without gaps.
std::vector<std::uint32_t> weld(const std::vector<glm::dvec3>& positions);

/// Component number of each triangle, in order of first appearance; triangles that share a welded
/// vertex belong together. Returns the number of components.
std::uint32_t components(const Object& object, std::vector<std::uint32_t>& component);

/// One object a connected component, in order of first appearance, named NAME.0, NAME.1, ...
std::vector<Object> split_components(const Object& object);

/// Sets `closed`, and turns inward components outward.
///
/// Closed: once vertices are welded and triangles with fewer than three different vertices left
/// out, every edge is used exactly once each way, and every component encloses a volume. So a sheet
/// doubled back to back (edges in order, no volume) is open.
void classify_object(Object& object);

}  // namespace kagesen

#pragma once
/// Which edges of the casters can be part of a shadow's outline.
#include <cstdint>
#include <vector>

#include "traces/format/records.h"

namespace kagesen {

/// For every caster a bit an edge (bit i: vertex i to vertex i + 1): set unless casters of the same
/// object lie on both sides of that very edge, depths included. Such a shared edge is covered from
/// both sides wherever it is nearer than a fragment, at any depth, so it never bounds the object's
/// shadow. Casters of zero area cover nothing: they get 0 and close no edge of others.
std::vector<std::uint8_t> find_open_edges(const std::vector<Caster>& casters);

}  // namespace kagesen

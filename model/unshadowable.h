#pragma once
/// Objects that nothing can shadow.
#include <cstdint>
#include <vector>

#include "model/unit/config.h"
#include "traces/format/records.h"

namespace kagesen {

/// A flag for every object of the header: 1 if no caster that may shadow it under config.semantics
/// is nearer than one of its fragments anywhere. Fragments that are averted, outside or off the map
/// are decided without looking and do not count. Never wrong about a flagged object; cautious about
/// the others: compares, in tiles of 8 x 8 texels, the nearest vertex of every caster whose
/// bounding box, widened by a texel, meets the tile. A texel is more than the unit's outlines ever
/// reach beyond the exact ones, so that no verdict of the unit changes either.
///
/// A caster costs at most 64 tiles: large ones are entered in tiles of 16, 32, ... texels.
std::vector<std::uint8_t> find_unshadowable(const Trace& trace, const UnitConfig& config);

}  // namespace kagesen

#pragma once
/// The winding profile's side of contact: how near in depth a caster may lie to a fragment without
/// the contract asking for its shadow (docs/unit.md). Exact integers and doubles on the trace's own
/// numbers; nothing of the unit's arithmetic.
#include <cstdint>

#include "model/reference/reference.h"
#include "model/unit/config.h"
#include "traces/format/records.h"

namespace kagesen {

/// How fast a facet's depth changes as the contract counts it: |dz/dx| + |dz/dy|, depth units a
/// texel of 2^fraction_bits units.
///
/// With r = 2^-config.fraction_bits texel: 0 where the longest edge is at most r / 4, since all of
/// the facet then has its nearest vertex's depth; that along the longest edge where the height over
/// it is at most r / 4 (the steepest, of edges equally long). The facet must have an area.
double contact_gradient(const Caster& facet, const UnitConfig& config, std::uint32_t fraction_bits);

/// The contact distance B of a facet, depth units: what the unit's threshold there may lie behind
/// the facet's exact depth.
///
/// 2 plane_tolerance (shared planes) + 2 2^plane_step_bits (stored planes) + 4 (snapped ends and
/// rounding) + 2 r contact_gradient (the reach of a point that moves by r, twice).
double contact_distance(const Caster& facet, const UnitConfig& config, std::uint32_t fraction_bits);

/// Does some caster that may shadow f cover it and lie more than its contact distance nearer the
/// light? Then no depth excuses the verdict "lit". Exact in the plane; depths in doubles, off by
/// less than 2^-20.
bool clear_of_contact(const ExactReference& reference, const std::vector<Caster>& casters,
                      const Fragment& f, Semantics semantics, const UnitConfig& config,
                      std::uint32_t fraction_bits);

}  // namespace kagesen

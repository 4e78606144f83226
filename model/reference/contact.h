#pragma once
/// The winding profile's side of contact: how near in depth a caster may lie to a fragment without
/// the contract asking for its shadow (docs/unit.md). Exact integers and doubles on the trace's own
/// numbers; nothing of the unit's arithmetic.
#include <cstdint>

#include "model/reference/reference.h"
#include "model/unit/config.h"
#include "traces/format/records.h"

namespace kagesen {

/// The contact distance B of a facet, depth units: what the unit's threshold there may lie behind
/// the facet's exact depth. The facet must have an area.
///
/// 2 plane_tolerance (shared planes) + 2 2^plane_step_bits (stored planes) + 4 (rounding) +
/// (|dz/dx| + |dz/dy|) (r + 2^-(m + 1)) (reach and place; rounding of the gradient, whose mantissa
/// has m = gradient_bits, at least fraction_bits - 1, at most 10), r = 2^-config.fraction_bits
/// texel, a texel =
/// 2^fraction_bits units. A facet no higher than r / 4 over its longest edge has the gradient along
/// that edge, and its third vertex's distance in depth from it counts besides; one no longer
/// than r / 4 has none, and its whole range of depth counts. Of edges equally long the worst.
double contact_distance(const Caster& facet, const UnitConfig& config, std::uint32_t fraction_bits);

/// Does some caster that may shadow f cover it and lie more than its contact distance nearer the
/// light? Then no depth excuses the verdict "lit". What only touches the left or the lower border
/// of f's texel, from beyond, is no part of the texel and does not cover. Exact in the plane;
/// depths in doubles, off by less than 2^-20.
bool clear_of_contact(const ExactReference& reference, const std::vector<Caster>& casters,
                      const Fragment& f, Semantics semantics, const UnitConfig& config,
                      std::uint32_t fraction_bits);

}  // namespace kagesen

#pragma once
/// Puts fragments where a shadow unit is most likely to err.
#include <cstddef>

#include "model/unit/config.h"
#include "tests/stress/dice.h"
#include "traces/format/records.h"

namespace kagesen::stress {

/// Appends `count` fragments to the trace: at and within 3 units and within 2^-F texel of vertices,
/// edges, texel borders and corners; at depths at, one unit and one bias before and behind the
/// surfaces; and some anywhere. The trace must have its casters.
void place_fragments(Trace& trace, const UnitConfig& config, std::size_t count, Dice& dice);

}  // namespace kagesen::stress

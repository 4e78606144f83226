#pragma once
/// Fits a trace's objects into the unit's ID width.
#include <cstdint>
#include <vector>

#include "traces/format/records.h"

namespace kagesen {

struct UnitIds {
  std::vector<std::uint32_t> ids;  ///< a unit ID an object; empty: every object keeps its number
  std::uint64_t sharing = 0;  ///< objects that share an ID with one whose shadow may reach them
};

/// Where a trace has more objects than `id_bits` can tell apart, objects whose boxes of texels do
/// not meet share an ID: neither can shadow the other nor share an SLB entry, so no verdict
/// changes. Where even that needs too many IDs, the rest share with the object whose box is met
/// least; they are counted.
UnitIds assign_unit_ids(const Trace& trace, std::uint32_t fraction_bits, int id_bits);

}  // namespace kagesen

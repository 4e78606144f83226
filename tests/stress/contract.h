#pragma once
/// What the winding profile promises of one fragment.
#include "model/reference/reference.h"
#include "model/unit/config.h"
#include "traces/format/records.h"

namespace kagesen::stress {

/// Does this wrong verdict break the contract: farther than 2^-fraction_bits texel from an exact
/// shadow boundary and, where it says lit, clear of contact? A wrong "dark" is never excused by
/// contact.
bool breaks_contract(const Trace& trace, const UnitConfig& config, const ExactReference& reference,
                     const Fragment& fragment, bool said_dark);

/// Is the fragment on the map?
bool on_map(const Trace& trace, const Fragment& fragment);

}  // namespace kagesen::stress

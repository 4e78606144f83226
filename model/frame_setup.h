#pragma once
/// What the host prepares of a frame before the unit sees it.
#include <cstdint>

#include "model/engine.h"

namespace kagesen {

/// Unit IDs; for the winding profile the groups of facets that share a plane and, if
/// skip_fragments is set, the objects that nothing can shadow.
///
/// @param aliased_objects  if not null: how many objects share a unit ID with one that they may
///                         shadow. 0 where the unit stores no IDs (winding, physical semantics)
FrameSetup make_frame_setup(const Trace& trace, const UnitConfig& config,
                            std::uint64_t* aliased_objects = nullptr);

}  // namespace kagesen

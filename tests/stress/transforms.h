#pragma once
/// The same geometry in another form: what metamorphic checks compare.
#include "model/engine.h"
#include "tests/stress/dice.h"
#include "traces/format/records.h"

namespace kagesen::stress {

/// Another order of casters, of the vertices of each, and of their winding. If `setup` is not null
/// and has facets, they go with their casters.
Trace shuffled(const Trace& trace, Dice& dice, FrameSetup* setup);
/// Moved by whole texels as far as coordinates and map allow; fragments that leave the map or meet
/// its other side stay in the trace. False if nothing can move.
bool translate(Trace& trace, Dice& dice);
/// x, y swapped, mirrored or turned by a multiple of 90 degrees; a map's origin stays where it is.
/// False where a coordinate has no counterpart.
bool turn(Trace& trace, Dice& dice);
/// Cuts triangles into pieces; sets `exact` if every piece lies exactly in its triangle's plane.
Trace refined(const Trace& trace, Dice& dice, bool& exact);
/// Puts geometry of a new object behind every fragment that is nearer than the depth it returns.
std::uint32_t add_hidden(Trace& trace, Dice& dice);

}  // namespace kagesen::stress

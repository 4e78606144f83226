#pragma once
/// A timeline as waves: a string for a block's state, a number for what a queue holds, and of work how
/// many pieces are under way.
#include <string>

#include "sim/common/timeline.h"

namespace kagesen {

/// VCD, a time unit a cycle. Strings are GTKWave's extension. @pre timeline.finish() was called
std::string timeline_vcd(const Timeline& timeline);

}  // namespace kagesen

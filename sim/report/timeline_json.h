#pragma once
/// A timeline in Chrome's trace format, which Perfetto opens. A cycle is shown as a microsecond.
#include <string>

#include "sim/common/timeline.h"

namespace kagesen {

std::string timeline_json(const Timeline& timeline);

}  // namespace kagesen

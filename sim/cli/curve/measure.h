#pragma once
/// One point of the curve.
#include "sim/cli/curve/table.h"
#include "traces/format/records.h"

namespace kagesen {

/// Runs the unit that `setting` names on the trace, beside a plain map of the same side, and judges
/// it. Both are timed three times in turn and the best counts, so that other work on the machine
/// disturbs neither more than the other.
CurveRow measure_point(const Trace& trace, const CurveRow& setting);

}  // namespace kagesen

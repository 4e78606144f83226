#pragma once
/// The verdicts file: a line a fragment, for scripts.
#include <ostream>

#include "sim/report/run_result.h"

namespace kagesen {

/// Header line, then "index px py verdict exact_paper exact_physical cause_paper cause_physical";
/// verdicts are 1 = dark, 0 = lit. Without the reference the last four columns are "-".
void write_verdicts(const Trace& trace, const RunResult& result, std::ostream& out);

}  // namespace kagesen

#pragma once
/// The unit's memories read back as golden's contents.
#include "model/engine.h"
#include "testbench/verilator/bench.h"

namespace kagesen {

/// @pre pass 1 is settled. Throws bench::Failure where a chain is broken.
MapContents rtl_contents(const UnitConfig& config, const bench::MemoryWords& texels,
                         const bench::MemoryWords& records);

}  // namespace kagesen

#pragma once
/// The pins of the whole unit while it draws and decides a short frame.
#include <cstddef>

#include "model/unit/config.h"
#include "testbench/mutation/recording.h"

namespace kagesen {

/// @param beats  clock cycles that are kept, at most
/// Throws UserError when a verdict is not golden's.
Recording record_unit(const UnitConfig& config, std::size_t beats);

}  // namespace kagesen

#pragma once
/// Makes a failing trace as small as it gets while it still fails.
#include <functional>

#include "traces/format/records.h"

namespace kagesen::stress {

struct ShrinkLimits {
  double seconds = 10;
  std::size_t tries = 20000;
};

/// Drops fragments, casters and objects, then makes numbers rounder and the map smaller, as long as
/// `fails` holds. `trace` must fail.
/// @param suspect  a fragment that fails: the others are dropped first
Trace shrink(const Trace& trace, std::uint32_t suspect,
             const std::function<bool(const Trace&)>& fails, const ShrinkLimits& limits = {});

}  // namespace kagesen::stress

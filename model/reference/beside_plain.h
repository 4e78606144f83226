#pragma once
/// A unit's verdicts beside those of plain shadow maps.
#include <cstdint>
#include <vector>

#include "model/engine.h"
#include "model/reference/judge.h"
#include "model/reference/reference.h"

namespace kagesen {

/// The frame, in one semantics, as far as it is judged.
struct PlainComparison {
  const Trace& trace;
  const UnitConfig& config;
  const FrameSetup& setup;
  const ExactReference& reference;
  Semantics semantics;
  const std::vector<Verdict>& verdicts;      ///< the unit's
  const std::vector<std::uint8_t>& exact;    ///< 1 = dark
  const std::vector<std::uint8_t>& judged;   ///< 1 = neither averted nor off the map
  const std::vector<std::uint8_t>& in_band;  ///< 1 = within a texel of a true edge
};

/// A map whose sides are the unit's times `grow`, rounded down, 1 texel at least.
PlainFigures plain_map_figures(const PlainComparison& frame, double grow);
/// By how much the sides of a map as large as the unit's grow until it takes so many bytes.
double grow_to_bytes(const UnitConfig& config, std::uint64_t bytes);

/// The smallest plain map that errs no more in the band than the unit does.
EquivalentResolution equivalent_resolution(const PlainComparison& frame,
                                           const JudgeOptions& options);

}  // namespace kagesen

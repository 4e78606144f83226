#pragma once
/// Why a verdict of the winding profile is wrong, and whether its contract allows it.
#include <cstdint>

#include "model/engine.h"
#include "model/reference/judge.h"
#include "model/reference/reference.h"

namespace kagesen {

/// What is found of one wrong fragment.
struct WindingFault {
  Cause cause = Cause::kOther;
  /// Farther than 2^-fraction_bits texel from an exact shadow boundary, and clear of contact.
  bool breaks_contract = false;
};

/// Holds wrong verdicts, one at a time, against the winding profile's contract.
///
/// kCapacity: its texel overflowed. kQuantisation: within 2^-fraction_bits texel of a boundary.
/// kDepth: lit, and every caster that should shadow it lies within its contact distance. kOther:
/// none of these, so the contract is broken.
class WindingCauseFinder {
 public:
  /// Keeps references to all but the numbers. `contents`: of the unit set to `semantics`.
  WindingCauseFinder(const Trace& trace, const UnitConfig& config, const FrameSetup& setup,
                     const MapContents& contents, const ExactReference& reference,
                     Semantics semantics);

  /// @param fragment  on the map; its verdict differs from `exact_dark`
  WindingFault find(const Fragment& fragment, bool exact_dark) const;

 private:
  bool overflowed(const LightPoint& p) const;
  bool near_boundary(const Fragment& fragment) const;

  const Trace& trace_;
  const UnitConfig& config_;
  const std::uint32_t fraction_bits_;
  const MapContents& contents_;
  const ExactReference& reference_;
  const Semantics semantics_;
};

}  // namespace kagesen

#include "model/reference/winding_cause.h"

#include <cmath>

#include "model/reference/contact.h"

namespace kagesen {

WindingCauseFinder::WindingCauseFinder(const Trace& trace, const UnitConfig& config,
                                       const FrameSetup& setup, const MapContents& contents,
                                       const ExactReference& reference, Semantics semantics)
    : trace_(trace),
      config_(config),
      fraction_bits_(setup.fraction_bits),
      contents_(contents),
      reference_(reference),
      semantics_(semantics) {}

WindingFault WindingCauseFinder::find(const Fragment& f, bool exact_dark) const {
  WindingFault fault;
  if (near_boundary(f)) {
    fault.cause = Cause::kQuantisation;
  } else if (exact_dark && !clear_of_contact(reference_, trace_.all_casters, f, semantics_, config_,
                                             fraction_bits_)) {
    fault.cause = Cause::kDepth;
  } else {  // a threshold is never nearer than what it stands for: no contact excuses "dark"
    fault.breaks_contract = true;
  }
  if (overflowed(f.position)) fault.cause = Cause::kCapacity;
  return fault;
}

bool WindingCauseFinder::overflowed(const LightPoint& p) const {
  const std::int64_t x = (p.x >> fraction_bits_) + std::int64_t{contents_.width / 2};
  const std::int64_t y = (p.y >> fraction_bits_) + std::int64_t{contents_.height / 2};
  return contents_.overflowed[static_cast<std::size_t>(y * contents_.width + x)] != 0;
}

bool WindingCauseFinder::near_boundary(const Fragment& f) const {
  const double radius =
      std::ldexp(1.0, static_cast<int>(fraction_bits_) - static_cast<int>(config_.fraction_bits));
  return reference_.boundary_distance(f.position, f.object, semantics_, radius + 1) <= radius;
}

}  // namespace kagesen

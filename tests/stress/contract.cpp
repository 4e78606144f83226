#include "tests/stress/contract.h"

#include <cmath>

#include "model/reference/contact.h"

namespace kagesen::stress {

bool breaks_contract(const Trace& trace, const UnitConfig& config, const ExactReference& reference,
                     const Fragment& fragment, bool said_dark) {
  const std::uint32_t bits = trace.header.fraction_bits;
  const double radius =
      std::ldexp(1.0, static_cast<int>(bits) - static_cast<int>(config.fraction_bits));
  const double distance =
      reference.boundary_distance(fragment.position, fragment.object, config.semantics, radius + 1);
  if (distance <= radius) return false;
  return said_dark ||
         clear_of_contact(reference, trace.all_casters, fragment, config.semantics, config, bits);
}

bool on_map(const Trace& trace, const Fragment& fragment) {
  const TraceHeader& h = trace.header;
  const std::int64_t x = (fragment.position.x >> h.fraction_bits) + h.map_width / 2;
  const std::int64_t y = (fragment.position.y >> h.fraction_bits) + h.map_height / 2;
  return x >= 0 && y >= 0 && x < h.map_width && y < h.map_height;
}

}  // namespace kagesen::stress

#include "tests/stress/contract.h"

#include <cmath>

#include "model/reference/contact.h"

namespace kagesen::stress {
namespace {

/// A texel owns its left and lower border, but not what only touches them from beyond.
Fragment inside_texel(Fragment f, std::uint32_t fraction_bits) {
  const std::int32_t mask = (1 << fraction_bits) - 1;
  f.position.x += (f.position.x & mask) == 0;
  f.position.y += (f.position.y & mask) == 0;
  return f;
}

}  // namespace

bool breaks_contract(const Trace& trace, const UnitConfig& config, const ExactReference& reference,
                     const Fragment& fragment, bool said_dark) {
  const std::uint32_t bits = trace.header.fraction_bits;
  const double radius =
      std::ldexp(1.0, static_cast<int>(bits) - static_cast<int>(config.fraction_bits));
  const double distance =
      reference.boundary_distance(fragment.position, fragment.object, config.semantics, radius + 1);
  if (distance <= radius) return false;
  const auto clear = [&](const Fragment& f) {
    return clear_of_contact(reference, trace.all_casters, f, config.semantics, config, bits);
  };
  return said_dark || (clear(fragment) && clear(inside_texel(fragment, bits)));
}

bool on_map(const Trace& trace, const Fragment& fragment) {
  const TraceHeader& h = trace.header;
  const std::int64_t x = (fragment.position.x >> h.fraction_bits) + h.map_width / 2;
  const std::int64_t y = (fragment.position.y >> h.fraction_bits) + h.map_height / 2;
  return x >= 0 && y >= 0 && x < h.map_width && y < h.map_height;
}

}  // namespace kagesen::stress

#pragma once
/// The golden engine's two profiles.
#include <cstdint>
#include <memory>

#include "model/engine.h"

namespace kagesen {

std::unique_ptr<Engine> make_golden_paper_engine();
std::unique_ptr<Engine> make_golden_winding_engine();

/// Bits that tell so many values apart.
constexpr int bits_for(std::uint64_t values) {
  int bits = 0;
  while ((std::uint64_t{1} << bits) < values) ++bits;
  return bits;
}

}  // namespace kagesen

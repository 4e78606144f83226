#pragma once
/// How long a division of the setups takes.
/// Twins: rtl/common/divider.sv with SkipBits 8, and rtl/paper/plane_divider.sv.
#include <cstdint>

#include "sim/systemc/common/clock.h"

namespace kagesen::tlm_model {

/// Cycles from the one in which a division is taken to the one in which its result is there: two bits of
/// the quotient a cycle, or eight zeros.
/// @param quotient  rounded down; of a negative one the bits are worked out inverted
/// @param bits      of the quotient that the divider works out, even
inline Cycle division_cycles(__int128 quotient, unsigned bits) {
  constexpr unsigned kSkip = 8;
  const auto size = static_cast<unsigned __int128>(quotient < 0 ? ~quotient : quotient);
  Cycle cycles = 1;
  for (unsigned left = bits; left != 0; ++cycles) {
    const bool skip = left >= kSkip && (size >> (left - kSkip) & ((1u << kSkip) - 1)) == 0;
    left -= skip ? kSkip : 2;
  }
  return cycles;
}

}  // namespace kagesen::tlm_model

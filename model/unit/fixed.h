#pragma once
/// Exact integer arithmetic that the unit's blocks share.
#include <cstdint>

namespace kagesen::unit {

using Int128 = __int128;

/// floor(a / b), b > 0.
constexpr std::int64_t floor_div(std::int64_t a, std::int64_t b) {
  const std::int64_t q = a / b;
  return q - (a % b < 0);
}
constexpr std::int64_t floor_div(Int128 a, std::int64_t b) {
  const auto q = static_cast<std::int64_t>(a / b);
  return q - (a % b < 0);
}

/// A value that grows by the same rational amount each step, without error: whole + rest / base.
///
/// The hardware is two adders and a comparison a step, after one division for the step.
struct ExactRamp {
  std::int64_t whole = 0;  ///< floor of the value
  std::int64_t rest = 0;   ///< [0, base)
  std::int64_t step_whole = 0, step_rest = 0;
  std::int64_t base = 1;  ///< > 0, below 2^60

  /// start + offset_numerator / base, growing by step_numerator / base.
  template <typename Wide>
  static ExactRamp make(std::int64_t start, Wide offset_numerator, Wide step_numerator,
                        std::int64_t base) {
    ExactRamp ramp;
    const std::int64_t offset = floor_div(offset_numerator, base);
    const std::int64_t step = floor_div(step_numerator, base);
    ramp.whole = start + offset;
    ramp.rest = static_cast<std::int64_t>(offset_numerator - static_cast<Wide>(offset) * base);
    ramp.step_whole = step;
    ramp.step_rest = static_cast<std::int64_t>(step_numerator - static_cast<Wide>(step) * base);
    ramp.base = base;
    return ramp;
  }

  void advance() {
    whole += step_whole;
    rest += step_rest;
    const bool carry = rest >= base;
    whole += carry;
    rest -= carry ? base : 0;
  }
};

/// The nearest UQ0.bits to value / 2^from_bits, ties up; 1.0 and above saturate to 2^bits - 1.
/// Exact also when `value` is the floor of a number with further fraction, as from_bits > bits.
constexpr std::uint32_t round_to_field(std::int64_t value, int from_bits, int bits) {
  const int shift = from_bits - bits;
  const std::int64_t rounded = (value + (std::int64_t{1} << (shift - 1))) >> shift;
  const std::int64_t largest = (std::int64_t{1} << bits) - 1;
  return static_cast<std::uint32_t>(rounded > largest ? largest : rounded);
}

}  // namespace kagesen::unit

#pragma once
/// The stretch of a row that half-planes leave: what maps that fill triangles row by row share.
#include <algorithm>
#include <cstdint>

namespace kagesen {

/// Largest integer not above a / b; b > 0.
inline std::int64_t floor_divide(std::int64_t a, std::int64_t b) {
  const std::int64_t q = a / b;
  return q - (a % b != 0 && a < 0);
}

/// Cuts [low, high] to the integers x with slope * x + constant >= 0; none are left where
/// low > high.
inline void cut_span(std::int64_t slope, std::int64_t constant, std::int64_t& low,
                     std::int64_t& high) {
  if (slope > 0) {
    low = std::max(low, -floor_divide(constant, slope));
  } else if (slope < 0) {
    high = std::min(high, floor_divide(constant, -slope));
  } else if (constant < 0) {
    high = low - 1;  // the whole row lies outside
  }
}

}  // namespace kagesen

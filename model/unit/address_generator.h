#pragma once
/// Address generator (ADRG): texel coordinates to a bucket of the SLB.
#include <cstdint>

namespace kagesen::unit {

/// Bucket of texel (x, y), below `buckets`, a power of two: x + 181 y, wrapped. Neighbours along a
/// row never collide; 181 spreads the rows and costs four adders (128 + 32 + 16 + 4 + 1).
constexpr std::uint32_t bucket_of(std::uint32_t x, std::uint32_t y, std::uint32_t buckets) {
  return (x + 181 * y) & (buckets - 1);
}

}  // namespace kagesen::unit

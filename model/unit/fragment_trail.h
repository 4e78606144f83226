#pragma once
/// What pass 2 reads to decide one fragment, in the unit's order: what a model of its time needs.
#include <cstdint>
#include <vector>

namespace kagesen::unit {

struct FragmentTrail {
  bool reads_texel = false;  ///< else its verdict is known by definition
  std::uint32_t x = 0, y = 0;  ///< its texel
  /// Addresses of the SLB records that are read; none where the texel decides. The first
  /// `slb_buckets` are the buckets' own.
  std::vector<std::uint32_t> records;

  void clear() {
    reads_texel = false;
    records.clear();
  }
};

}  // namespace kagesen::unit

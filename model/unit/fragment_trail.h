#pragma once
/// What pass 2 reads to decide one fragment, in the unit's order: what a model of its time needs.
#include <cstdint>
#include <vector>

namespace kagesen::unit {

struct FragmentTrail {
  bool reads_texel = false;  ///< else its verdict is known by definition
  std::uint32_t x = 0, y = 0;  ///< its texel
  /// An SLB record that is read: which entry of the bucket's chain, and which of its records, from 0.
  struct Place {
    std::uint32_t entry, part;
  };
  std::uint32_t bucket = 0;
  std::vector<Place> places;           ///< none where the texel decides
  std::vector<std::uint32_t> records;  ///< their addresses; hardware's to say, golden leaves it empty

  void clear() {
    reads_texel = false;
    places.clear();
    records.clear();
  }
};

}  // namespace kagesen::unit

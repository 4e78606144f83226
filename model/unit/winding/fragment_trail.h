#pragma once
/// What pass 2 reads to decide one fragment, in the unit's order: what a model of its time needs.
#include <cstdint>
#include <vector>

namespace kagesen::unit::winding {

struct FragmentTrail {
  bool reads_tile = false;     ///< else its verdict is known
  bool reads_texel = false;    ///< else its tile decides, or there is no texel
  std::uint32_t x = 0, y = 0;  ///< its texel
  std::uint32_t tile_slot = 0;
  struct Record {
    std::uint32_t address;  ///< golden: its number, as records were given out
    std::uint32_t boxed;  ///< of its segments: how many have the fragment within their box
  };
  std::vector<Record> records;  ///< that are read; none where the texel decides

  void clear() {
    reads_tile = reads_texel = false;
    records.clear();
  }
};

}  // namespace kagesen::unit::winding

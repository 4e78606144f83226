#pragma once
/// What two engines made of one frame, held against each other field by field.
#include <cstdint>
#include <string>
#include <vector>

#include "model/engine.h"

namespace kagesen {

/// Everything that contents hold of one texel, a line each; "nothing" if that is all.
std::vector<std::string> texel_lines(const MapContents& contents, std::uint32_t x, std::uint32_t y);

struct BufferDifferences {
  std::uint64_t texels = 0;                ///< that differ
  std::uint32_t first_x = 0, first_y = 0;  ///< of them, row by row
};
BufferDifferences compare_contents(const MapContents& golden, const MapContents& other);

/// "edge_texels: 12, but 11" for each counter that differs.
std::vector<std::string> compare_counters(const UnitCounters& golden, const UnitCounters& other);

}  // namespace kagesen

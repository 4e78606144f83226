#pragma once
/// The pictures of a run: the frame shaded, its shadow mask, its errors, and the unit's memory.
#include <cstdint>
#include <string>
#include <vector>

#include "sim/report/canvas.h"
#include "sim/report/outputs.h"
#include "sim/report/run_result.h"

namespace kagesen {

/// The frame with the unit's shadows; sky where the camera sees nothing.
Canvas shaded_picture(const Trace& trace, const std::vector<Verdict>& verdicts);
/// 255 lit, 0 dark, 128 where the camera sees nothing.
std::vector<std::uint8_t> mask_values(const Trace& trace, const std::vector<Verdict>& verdicts);
/// The frame in grey, wrong fragments coloured by cause (main_semantics()), and below it a legend.
/// @param legend  false: the frame alone
Canvas error_picture(const Trace& trace, const RunResult& result, bool legend = true);
/// Lines a texel (winding: segments) over the depth buffer, and below it the scale. Small maps are
/// enlarged.
Canvas lines_picture(const RunResult& result);

/// Cycles of pass 2 that each pixel cost, and below it the scale. @pre the engine kept cycles
Canvas cycle_picture(const Trace& trace, const RunResult& result);

/// Beside each other over the map, and with the scale: cycles of pass 1 by tile, and what the fragments
/// of pass 2 cost by the tile that they fall in. @pre the engine has a clock
Canvas map_cycle_picture(const Trace& trace, const RunResult& result);
/// The latter, row by row, in tiles of PassCycles::kTile texels a side.
std::vector<std::uint64_t> fragment_tiles(const Trace& trace, const RunResult& result);

/// Multi-channel EXR of the frame; -1 where the camera sees nothing.
std::string frame_exr(const Trace& trace, const RunResult& result);
/// Multi-channel EXR of the map; -1 where nothing was written. `lines` and `entries` are segments
/// and clusters in the winding profile.
std::string map_exr(const RunResult& result);

inline constexpr const char* kPictureNames[] = {"shaded.png", "mask.png",  "errors.png", "lines.png",
                                                "cycles.png", "map_cycles.png", "frame.exr",
                                                "map.exr"};
/// All of them in `folder`, under kPictureNames; their role among the outputs is "--out".
/// A run without the reference has no errors.png, one without fragments' cycles no cycles.png, one
/// without a clock no map_cycles.png, a trace without an image nothing of the frame.
void write_pictures(const Trace& trace, const RunResult& result, const std::string& folder,
                    Outputs& outputs);

}  // namespace kagesen

#pragma once
/// Trees of buffers for what has many readers, as a chip's placement would put them in. ABC does
/// not: it sees neither what a flip-flop, a memory or a port drives, nor what lies behind a
/// module's ports.
#include <cstddef>
#include <string>

namespace kagesen {

inline constexpr const char* kFanoutBuffer = "BUFX4";
inline constexpr std::size_t kMostReaders = 8;    ///< of anything that is no buffer
inline constexpr std::size_t kMostBuffered = 16;  ///< of a buffer
inline constexpr std::size_t kMostBuffers = 6;    ///< that drive others, or that one net drives

/// Puts buffers between each net and its readers where they are more; clock and reset are left
/// alone. Registers of settings become setting_0, setting_1, ...
/// @param netlist  a flat mapped design that Yosys' write_json wrote; becomes the same with buffers
/// @returns buffers
std::size_t buffer_fanout(const std::string& top, std::string& netlist);

}  // namespace kagesen

#pragma once
/// The texel port in pass 2: where a fragment is placed, its word read, and decided on early.
/// Twin: place, texel read and early decision in rtl/paper/shadow_lane.sv.
///
/// Timing: placed in the cycle after it was taken, or when the read before has gone; its read is
///         offered in the cycle after that; decided on in the cycle after its word.
#include <algorithm>
#include <cstdint>
#include <systemc>

#include "sim/systemc/common/memory_port.h"

namespace kagesen::tlm_model::paper {

class TexelBuffers : public sc_core::sc_module {
 public:
  MemoryPort port;

  explicit TexelBuffers(const sc_core::sc_module_name& name) : sc_module(name), port("port") {}

  void begin_pass(unsigned word_bytes, unsigned pitch_log2) {
    port.begin_pass(word_bytes);
    pitch_log2_ = pitch_log2;
    taken_ = 0;
  }
  /// The cycle in which a fragment that reads no texel is placed.
  static Cycle place(Cycle accepted) { return accepted + 1; }
  /// And one that does.
  Cycle place_to_read(Cycle accepted) const { return std::max(accepted + 1, taken_); }
  /// @return the cycle of its early decision
  Cycle read(Cycle placed, std::uint32_t x, std::uint32_t y) {
    const std::uint64_t word = std::uint64_t{y} << pitch_log2_ | x / 4;
    const MemoryPort::Read read = port.read(placed + 1, word);
    taken_ = read.accepted;
    return read.responded + 1;
  }

 private:
  Cycle taken_ = 0;  // when the last read was
  unsigned pitch_log2_ = 0;
};

}  // namespace kagesen::tlm_model::paper

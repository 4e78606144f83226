#pragma once
/// Words for a stream of fragments, in order: which of them have to be read, and when each moves.
/// Twin: rtl/winding/shared_reads.sv.
///
/// Timing: a fragment is looked up in the cycle after it came, or when the one before it has moved on.
///         A read waits there until the read before has been taken, and while kWords of them are
///         between look-up and departure. A fragment leaves for the output two cycles after it was
///         looked up, or in the cycle after its word's response, one a cycle.
#include <algorithm>
#include <array>
#include <cstdint>
#include <systemc>

#include "sim/systemc/common/clock.h"
#include "sim/systemc/common/queue_meter.h"

namespace kagesen::tlm_model::winding {

class SharedReads : public sc_core::sc_module {
 public:
  QueueMeter meter;  ///< fragments from look-up to departure

  explicit SharedReads(const sc_core::sc_module_name& name) : sc_module(name) {}

  void begin_pass() {
    last_ = kNone;
    kept_.fill(kNone);
    gone_.fill(0);
    reads_ = 0;
    looked_up_ = left_ = taken_ = 0;
    meter.begin_pass();
  }

  /// Is the fragment's word not the last one's, nor kept?
  bool has_to_read(std::uint32_t address) {
    if (address == last_) return false;
    last_ = address;
    std::uint32_t& kept = kept_[line_of(address)];
    const bool read = kept != address;
    kept = address;
    return read;
  }
  /// The cycle from which on the next fragment is let in.
  Cycle open() const { return looked_up_; }
  /// The number of the next read; read_taken() says when it was.
  std::uint64_t reads() const { return reads_; }
  /// A fragment comes. Returns the cycle in which it is looked up; its read is offered in the next.
  /// @pre of a read: the one kWords before has left
  Cycle look_up(Cycle came, bool read) {
    Cycle at = came + 1;
    if (read) at = std::max({at, taken_, gone_[reads_++ % kWords] + 1});
    return looked_up_ = at;
  }
  void read_taken(Cycle at) { taken_ = at; }
  /// A fragment leaves, in order, for the output, which is free from `output` on.
  Cycle leave(Cycle looked_up, Cycle output) {
    left_ = std::max({looked_up + 2, left_ + 1, output});
    meter.word(looked_up, left_);
    return left_;
  }
  /// The same of read number `number`, whose response came in cycle `responded`.
  Cycle leave(Cycle looked_up, Cycle output, std::uint64_t number, Cycle responded) {
    return gone_[number % kWords] = leave(looked_up, std::max(output, responded + 1));
  }

  static constexpr std::uint32_t kWords = 32;

 private:
  static constexpr unsigned kLineBits = 6;
  static constexpr std::uint32_t kNone = ~0u;

  static std::uint32_t line_of(std::uint32_t address) {
    std::uint32_t reversed = 0;  // of the upper bits
    for (unsigned bit = 0; bit < kLineBits; ++bit) {
      reversed = reversed << 1 | (address >> (kLineBits + bit) & 1);
    }
    return (address ^ reversed) & ((1u << kLineBits) - 1);
  }

  std::uint32_t last_ = kNone;                         // address
  std::array<std::uint32_t, 1u << kLineBits> kept_{};  // addresses
  std::array<Cycle, kWords> gone_{};                   // when each of the last reads left
  std::uint64_t reads_ = 0;
  Cycle looked_up_ = 0, left_ = 0;  // the last fragment
  Cycle taken_ = 0;                 // the last read, by the memory
};

}  // namespace kagesen::tlm_model::winding

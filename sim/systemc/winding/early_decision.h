#pragma once
/// The texel port in pass 2: a fragment's tile, then its texel word, and what they decide.
/// Twin: rtl/winding/early_decision.sv.
///
/// Timing: tiles and words each in order (shared_reads.h); words follow tiles in the cycle after they
///         left. Reads of both share the port: words go first, but whose turn it is is settled when
///         one of them has something to offer. A list is known two cycles after its word left, a
///         verdict four.
/// Order:  tiles are looked up as fragments enter; from there on they move as far as they can without
///         another read of a word. That is served once no tile can come before it: whoever enters
///         later reads later.
#include <cstdint>
#include <deque>
#include <systemc>
#include <vector>

#include "model/unit/winding/fragment_trail.h"
#include "sim/systemc/common/lane_slots.h"
#include "sim/systemc/common/memory_port.h"
#include "sim/systemc/winding/list_reader.h"
#include "sim/systemc/winding/shared_reads.h"

namespace kagesen::tlm_model::winding {

class EarlyDecision : public sc_core::sc_module {
 public:
  /// A fragment in one of the two stages.
  struct Stay {
    Cycle looked_up = 0;
    MemoryPort::Read read{0, 0};  ///< zeros: without
  };
  struct Stays {
    Stay tile, word;
  };

  MemoryPort port;
  SharedReads tiles, texel_words;

  EarlyDecision(const sc_core::sc_module_name& name, LaneSlots& slots, ListReader& lists);

  void begin_pass(std::uint32_t slots, unsigned map_bits, unsigned word_bytes);
  /// The cycle from which on a fragment that reads its tile is let in.
  Cycle open() const { return tiles.open(); }
  /// Such a fragment comes.
  void look_up(Cycle entered, std::uint32_t slot, const unit::winding::FragmentTrail& trail);
  /// When the next read of a word is offered; kNever if no fragment here has one to do.
  Cycle next_word() {
    while (move_on()) {
    }
    return offered_ == kNothing ? kNever : stays_[inside(offered_).slot].word.looked_up + 1;
  }
  /// It is read, and its fragment decided on. @pre no tile's read comes before
  void read_word();

  const Stays& stays(std::uint32_t slot) const { return stays_[slot]; }
  /// A slot's fragment reads nothing here.
  void pass_by(std::uint32_t slot) { stays_[slot] = {}; }
  /// Does a read wait for its turn in this cycle? Calls come in the order of time.
  bool port_busy(Cycle at);
  /// Nobody asks for cycles before this one any more.
  void forget(Cycle before) {
    while (!waits_.empty() && waits_.front().end <= before) waits_.pop_front();
  }

 private:
  struct Inside {  // a fragment from its tile's look-up to its verdict
    std::uint32_t slot, word;
    bool needs_word, has_list;
    std::uint64_t tile_number, word_number;  // of its reads
    Cycle left_tile, came;                   // came for its word
  };
  struct Wait {
    Cycle begin, end;
  };

  static constexpr std::uint64_t kNothing = ~std::uint64_t{0};

  Inside& inside(std::uint64_t number) { return inside_[number & (inside_.size() - 1)]; }
  bool move_on();
  bool leave_tile();
  bool come_for_word();
  bool look_up_word();
  bool leave_word();
  MemoryPort::Read read(Cycle offered, std::uint64_t address);

  LaneSlots& slots_;
  ListReader& lists_;
  unsigned map_bits_ = 10;
  std::vector<Stays> stays_;       // a slot each
  std::vector<Inside> inside_;     // a ring, slots being a power of two
  // How many fragments have come so far; none of these is more than the one before.
  std::uint64_t entered_ = 0, left_tile_ = 0, came_ = 0, looked_up_ = 0, left_word_ = 0;
  std::uint64_t tile_reads_left_ = 0, word_reads_left_ = 0;
  Cycle output_ = 0;  // from when on the tiles' output is free
  std::uint64_t offered_ = kNothing;  // the fragment whose word is to be read next
  Cycle free_ = 0;         // the port, for the next read
  std::deque<Wait> waits_;  // of reads for the port
};

}  // namespace kagesen::tlm_model::winding

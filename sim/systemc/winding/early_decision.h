#pragma once
/// The texel port in pass 2: a fragment's tile, then its texel word, and what they decide.
/// Twin: rtl/winding/early_decision.sv.
///
/// Timing: tiles and words each in order (shared_reads.h); words follow tiles in the cycle after they
///         left. Reads of both share the port: words go first, but whose turn it is is settled when
///         one of them has something to offer. A list is known two cycles after its word left, a
///         verdict four.
/// Order:  tiles are looked up as fragments enter; words only as far as somebody asks. A word is
///         served once no tile can come before it: whoever enters later reads later.
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
    while (!word_offered_ && first_ != last_) move_on();
    return word_offered_ ? word_.stay.looked_up + 1 : kNever;
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
  struct Waiting {  // between tile and word
    std::uint32_t slot, word;
    bool reads_word, has_list;
    std::uint64_t tile_number;  // of its read
  };
  struct Word {
    std::uint32_t slot, address;
    bool has_list;
    std::uint64_t number;
    Stay stay;
  };
  struct Wait {
    Cycle begin, end;
  };

  void move_on();
  void finish(std::uint32_t slot, bool has_list, Cycle left);
  MemoryPort::Read read(Cycle offered, std::uint64_t address);

  LaneSlots& slots_;
  ListReader& lists_;
  unsigned map_bits_ = 10;
  std::vector<Stays> stays_;       // a slot each
  std::vector<Waiting> waiting_;   // a ring
  std::uint64_t first_ = 0, last_ = 0;
  std::uint64_t tiles_left_ = 0;   // reads of tiles whose fragment has moved on
  Cycle output_ = 0;               // from when on the tiles' output is free
  bool word_offered_ = false;
  Word word_{};
  Cycle free_ = 0;                 // the port, for the next read
  std::deque<Wait> waits_;         // of reads for the port
};

}  // namespace kagesen::tlm_model::winding

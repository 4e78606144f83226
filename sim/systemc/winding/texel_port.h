#pragma once
/// The texel memory's port in pass 1, which tiles and texel words share.
/// Twin: the three port_merge in rtl/winding/store.sv.
///
/// Reads: texel words go first. Writes: a tile, else an empty word of a tile that gets texels, else a
/// texel word. What is offered stays until it is taken.
#include <algorithm>
#include <systemc>

#include "sim/systemc/common/due_queue.h"
#include "sim/systemc/common/memory_port.h"
#include "sim/systemc/winding/work.h"

namespace kagesen::tlm_model::winding {

class TexelPort : public sc_core::sc_module {
 public:
  struct Wants {
    bool word_read = false, tile_read = false;
    bool tile_write = false, touch = false, word_write = false;
    WordAddress word_address = 0, tile_address = 0;  ///< of reads
    unsigned word_line = 0, tile_line = 0;
  };
  /// What the memory does in a cycle.
  struct Does {
    bool word_fetched = false, tile_fetched = false;
    bool tile_ready = false, touch_ready = false, word_ready = false;  ///< for writes
    bool response = false, of_tile = false;
    unsigned line = 0;
  };

  MemoryPort port;

  explicit TexelPort(const sc_core::sc_module_name& name) : sc_module(name), port("port") {}

  void reset(unsigned map_bits) { tiles_from_ = std::uint64_t{1} << (2 * map_bits - 2); }
  /// @param writes  cycles in which the memory takes none
  void begin_pass(unsigned word_bytes, const Stalls& writes) {
    port.begin_pass(word_bytes);
    writes_ = writes;
    accepted_ = kNever;
    due_.clear();
    tile_read_offered_ = touch_offered_ = word_offered_ = false;
  }
  /// Of this cycle. The same, however often it is asked.
  Does does(Cycle now, const Wants& wants) {
    Does does;
    const bool tile = tile_read_offered_ || !wants.word_read;
    if (tile ? wants.tile_read : wants.word_read) {
      if (accepted_ == kNever) {
        const MemoryPort::Read read =
            port.read(now, tile ? tiles_from_ | wants.tile_address : wants.word_address);
        accepted_ = read.accepted;
        due_.push(read.responded, {tile, tile ? wants.tile_line : wants.word_line});
      }
      (tile ? does.tile_fetched : does.word_fetched) = accepted_ == now;
    }
    const bool touch = touch_offered_ || !wants.tile_write;
    const bool side = touch ? wants.touch : wants.tile_write;
    const bool word = word_offered_ || !side;
    const bool ready = !writes_.at(now);
    does.word_ready = ready && word;
    does.touch_ready = ready && !word && touch;
    does.tile_ready = ready && !word && !touch;
    does.response = due_.next() == now;
    if (does.response) {
      does.of_tile = due_.front().of_tile;
      does.line = due_.front().line;
    }
    return does;
  }
  /// The clock's edge. @return did anything change?
  bool clock(const Wants& wants, const Does& does) {
    const bool before[] = {tile_read_offered_, touch_offered_, word_offered_};
    tile_read_offered_ = (tile_read_offered_ || !wants.word_read) && wants.tile_read && !does.tile_fetched;
    const bool touch = touch_offered_ || !wants.tile_write;
    const bool word = word_offered_ || !(touch ? wants.touch : wants.tile_write);
    touch_offered_ = touch && wants.touch && !does.touch_ready;
    word_offered_ = word && wants.word_write && !does.word_ready;
    if (does.word_fetched || does.tile_fetched) accepted_ = kNever;
    if (does.response) due_.pop();
    writing_ = wants.tile_write || wants.touch || wants.word_write;
    return does.word_fetched || does.tile_fetched || does.response ||
           before[0] != tile_read_offered_ || before[1] != touch_offered_ || before[2] != word_offered_;
  }
  /// The first cycle from `from` on in which the memory does something, if nothing else happens.
  Cycle next(Cycle from) const {
    Cycle at = due_.next();
    if (accepted_ != kNever) at = std::min(at, accepted_);
    if (writing_) at = std::min(at, writes_.next(from));
    return at;
  }

 private:
  struct Response {
    bool of_tile;
    unsigned line;
  };

  std::uint64_t tiles_from_ = 0;  // address
  Stalls writes_;
  Cycle accepted_ = kNever;  // the request that is offered
  DueQueue<Response> due_;
  bool tile_read_offered_ = false, touch_offered_ = false, word_offered_ = false;
  bool writing_ = false;
};

}  // namespace kagesen::tlm_model::winding

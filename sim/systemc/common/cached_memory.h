#pragma once
/// A memory's port in pass 1 with the words of it that are kept on chip.
#include <algorithm>

#include "sim/systemc/common/due_queue.h"
#include "sim/systemc/common/line_cache.h"
#include "sim/systemc/common/memory_port.h"

namespace kagesen::tlm_model {

class CachedMemory : public sc_core::sc_module {
 public:
  LineCache cache;
  MemoryPort port;

  explicit CachedMemory(const sc_core::sc_module_name& name)
      : sc_module(name), cache("cache"), port("port") {}

  /// @param writes  cycles in which the memory takes none
  void begin_pass(unsigned word_bytes, const Stalls& writes) {
    port.begin_pass(word_bytes);
    writes_ = writes;
    accepted_ = kNever;
    due_.clear();
  }
  /// Words from 0 on are written in turn, the first in cycle `from`. Returns the first cycle in which
  /// the memory has them all. @pre nothing is on chip
  Cycle wipe(Cycle from, std::uint32_t words) {
    cache.fill_in_turn(words);
    for (std::uint32_t i = 0; i < words; ++i) from = writes_.next(from + 1);
    return from + 1;
  }
  /// What the memory does in a cycle.
  LineCache::Inputs inputs(Cycle now) {
    LineCache::Inputs in;
    if (cache.reads() && accepted_ == kNever) {
      const MemoryPort::Read read = port.read(now, cache.read_address());
      accepted_ = read.accepted;
      due_.push(read.responded, cache.read_line());
    }
    in.read_ready = accepted_ == now;
    in.write_ready = !writes_.at(now);
    in.response = due_.next() == now;
    if (in.response) in.response_line = due_.front();
    return in;
  }
  void step(const LineCache::Inputs& in) {
    if (in.response) due_.pop();
    if (in.read_ready) accepted_ = kNever;
    cache.step(in);
  }
  /// The first cycle from `from` on in which the memory does something, if nothing else happens.
  Cycle next(Cycle from) const {
    Cycle at = due_.next();
    if (accepted_ != kNever) at = std::min(at, accepted_);
    if (cache.writes()) at = std::min(at, writes_.next(from));
    return at;
  }

 private:
  Stalls writes_;
  Cycle accepted_ = kNever;  // the request that is offered
  DueQueue<unsigned> due_;  // lines
};

}  // namespace kagesen::tlm_model

#pragma once
/// Records of the SLB kept on chip in pass 1, with the memory's port: which are there, cycle by cycle.
/// Twin: `records` in rtl/winding/store.sv, a line_cache of one way that nobody gives hints.
#include <systemc>
#include <vector>

#include "sim/systemc/common/due_queue.h"
#include "sim/systemc/common/memory_port.h"
#include "sim/systemc/winding/work.h"

namespace kagesen::tlm_model::winding {

class RecordCache : public sc_core::sc_module {
 public:
  /// What the owner does in a cycle.
  struct Inputs {
    bool lookup = false, lookup_end = false;
    bool update = false;  ///< only where update_ready()
    WordAddress lookup_address = 0, update_address = 0;
  };

  MemoryPort port;

  explicit RecordCache(const sc_core::sc_module_name& name) : sc_module(name), port("port") {}

  /// As after reset. @param lines  a power of two
  void reset(unsigned lines);
  void clear();
  /// @param writes  cycles in which the memory takes none
  void begin_pass(unsigned word_bytes, const Stalls& writes);

  // Of this cycle:
  bool hit() const { return hit_; }
  /// Words that were looked up in this pass.
  std::uint64_t lookups() const { return lookups_; }
  bool idle() const { return !read_valid_ && !write_valid_ && busy_count_ == 0; }
  bool looks_up() const { return lookup_; }
  bool update_ready(WordAddress address, Cycle now) const {
    return (!write_valid_ || !writes_.at(now)) &&
           ((hit_ && address == looked_up_) || !lines_[line_of(address)].busy);
  }
  /// The clock's edge. @return did anything change?
  bool step(Cycle now, const Inputs& in);
  /// The first cycle from `from` on in which the memory does something, if nothing else happens.
  Cycle next(Cycle from) const;

 private:
  struct Line {
    bool valid = false, busy = false;
    WordAddress address = 0;
  };
  unsigned line_of(WordAddress address) const;
  bool reads() const { return read_valid_ && !(write_valid_ && write_address_ == read_address_); }
  void settle();

  unsigned line_bits_ = 1;
  std::vector<Line> lines_;
  unsigned busy_count_ = 0;
  std::uint64_t lookups_ = 0;
  bool lookup_ = false, forward_ = false, raced_ = false, read_valid_ = false, write_valid_ = false;
  WordAddress looked_up_ = 0, key_ = 0;  // key_: the word in the looked-up one's line
  WordAddress read_address_ = 0, write_address_ = 0;
  unsigned lookup_line_ = 0, read_line_ = 0;
  // What follows from the registers.
  bool present_ = false, hit_ = false;

  Stalls writes_;
  Cycle accepted_ = kNever;  // the request that is offered
  DueQueue<unsigned> due_;  // lines
};

}  // namespace kagesen::tlm_model::winding

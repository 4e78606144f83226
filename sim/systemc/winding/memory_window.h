#pragma once
/// Words of a memory that queued work needs, fetched ahead and kept on chip: which are there. No
/// word's value.
/// Twin: rtl/winding/memory_window.sv, whose rules and registers these are.
#include <systemc>
#include <vector>

#include "sim/systemc/common/fifo.h"
#include "sim/systemc/winding/work.h"

namespace kagesen::tlm_model::winding {

class MemoryWindow : public sc_core::sc_module {
 public:
  struct Size {
    unsigned lines, depth;
    unsigned row_bits;  ///< of the address's lower coordinate
  };
  /// What comes in a cycle.
  struct Inputs {
    const Work* work = nullptr;  ///< only where in_ready()
    bool bare = false;           ///< it needs no word
    WordAddress address = 0;
    bool fetched = false;  ///< the read is taken
    bool response = false;
    unsigned line = 0;
    bool load = false, pop = false, clean = false;  ///< the owner's
  };

  explicit MemoryWindow(const sc_core::sc_module_name& name) : sc_module(name) {}

  /// As after reset.
  void reset(const Size& size);
  void clear();

  // Of this cycle, by registers alone:
  bool valid() const { return ahead_valid_ && payloads_.valid(); }
  bool fresh() const { return ahead_fresh_; }
  const Work& work() const { return payloads_.front(); }
  WordAddress address() const { return ahead_.address; }  ///< of this work's word, if it has one
  bool empty() const {
    return payloads_.empty() && !ahead_valid_ && lines_.empty() && !entry_valid_;
  }
  bool waits() const { return !ahead_valid_ && !payloads_.empty(); }
  bool reads() const { return reads_; }
  // For meters.
  std::size_t payloads() const { return payloads_.words(); }
  std::size_t lines() const { return lines_.words(); }
  bool holds_work() const { return payloads_.valid(); }  ///< work() is the oldest
  WordAddress read_address() const { return entry_.address; }
  unsigned read_line() const { return entry_.line; }
  bool in_ready(bool fetched) const {
    return payloads_.ready() && (!entry_valid_ || pushes(fetched));
  }

  /// The clock's edge. @return did anything change?
  bool step(const Inputs& in);

 private:
  struct Entry {
    WordAddress address = 0;
    unsigned line = 0;
    bool bare = false;
  };
  struct Line {
    bool valid = false, busy = false;
    WordAddress address = 0;
    unsigned piece = 0;  // the last one that needs it
  };

  bool pushes(bool fetched) const {
    return entry_valid_ && lines_.ready() && (entry_.bare || hit_ || fetched);
  }
  unsigned line_of(WordAddress address) const;
  void settle();

  Size size_{};
  unsigned line_bits_ = 1, piece_mask_ = 0;
  std::vector<Line> all_;
  Fifo<Work> payloads_;
  Fifo<Entry> lines_;
  Entry entry_, ahead_;
  bool entry_valid_ = false, ahead_valid_ = false, ahead_fresh_ = false;
  bool newest_valid_ = false, held_valid_ = false;
  unsigned newest_line_ = 0, held_line_ = 0;
  unsigned pushed_ = 0, popped_ = 0;
  // What follows from the registers.
  bool hit_ = false, reads_ = false;
};

}  // namespace kagesen::tlm_model::winding

#pragma once
/// Words of a memory kept on chip in pass 1: which are there, cycle by cycle. No word's value.
/// Twin: rtl/common/line_cache.sv, whose rules and registers these are.
///
/// Which line a word takes hangs on what lookups, hints, updates and responses meet in a cycle; so
/// it is stepped, but for cycles in which nothing changes: see unchanged().
#include <cstdint>
#include <systemc>
#include <vector>

#include "sim/systemc/common/clock.h"

namespace kagesen::tlm_model {

class LineCache : public sc_core::sc_module {
 public:
  using Address = std::uint32_t;
  /// What comes in a cycle.
  struct Inputs {
    bool hint = false, hint_weak = false, lookup = false, lookup_new = false, lookup_end = false;
    bool update = false;  ///< only where update_ready()
    bool read_ready = false, write_ready = false, response = false;
    Address hint_address = 0, lookup_address = 0, update_address = 0;
    unsigned response_line = 0;
  };

  explicit LineCache(const sc_core::sc_module_name& name) : sc_module(name) {}

  /// As after reset. @param lines  of two ways, a power of two  @param fold  see line_cache.sv
  void reset(unsigned lines, bool fold);
  void clear();
  /// Words from 0 on are updated in turn, none being looked up, and written.
  void fill_in_turn(Address words);

  // Of this cycle, by registers alone:
  bool hit() const { return hit_; }
  bool idle() const { return !r_.hint && !r_.read && !r_.write && busy_count_ == 0; }
  bool reads() const { return r_.read && !(r_.write && r_.write_address == r_.read_address); }
  Address read_address() const { return r_.read_address; }
  unsigned read_line() const { return r_.read_line; }
  bool writes() const { return r_.write; }
  Address address_of(unsigned line) const { return keys_[line]; }
  /// Words that were looked up since forget_lookups().
  std::uint64_t lookups() const { return lookups_; }
  void forget_lookups() { lookups_ = 0; }
  bool update_ready(Address address, bool write_ready, bool read_ready) const;
  /// Would a hint be taken? Of `in` only the update and the memory's readiness count.
  bool hint_ready(const Inputs& in) const;

  /// The clock's edge.
  void step(const Inputs& in);
  /// The last step changed nothing: so would the same inputs again.
  bool unchanged() const { return unchanged_; }

 private:
  struct Registers {
    bool lookup, is_new, forward, forward_way, raced, met, hint, hint_weak, hint_raced, hinting, read, write, turn;
    std::uint8_t read_line;
    Address lookup_address, hint_address, read_address, write_address;
    Address lookup_keys[2], hint_keys[2];
  };
  struct Line {
    bool valid, busy, hinted, again;
    bool awaited() const { return valid && hinted; }
  };
  struct Fill {
    bool lookup, hint;
    bool any() const { return lookup || hint; }
  };

  unsigned set_of(Address address) const;
  bool in_place(Address address) const;
  bool wants_fill() const;
  bool wants_hint() const;
  bool can_fill(bool read_ready) const { return !r_.read || (reads() && read_ready); }
  Fill fill(const Inputs& in) const;
  bool takes_hint(const Fill& fill) const;
  void settle();
  void settle_lookup();
  void settle_hint();

  unsigned set_bits_ = 0;
  bool fold_ = false;
  std::vector<Line> lines_;
  std::vector<Address> keys_;
  unsigned busy_count_ = 0;
  std::uint64_t lookups_ = 0;
  Registers r_{};
  // What follows from the registers.
  unsigned lookup_set_ = 0, hint_set_ = 0;
  bool present_ = false, lookup_free_ = false, hit_ = false, hint_done_ = false, hint_free_ = false;
  unsigned lookup_way_ = 0, done_way_ = 0, hint_way_ = 0;
  bool unchanged_ = false;
};

}  // namespace kagesen::tlm_model

#pragma once
/// The SLB's records as hardware stores them, without planes and segments, and which of them are free.
/// Twin: rtl/winding/record_pool.sv; record_t of shadow_pkg.sv.
///
/// Records that were never in use are given out first, in turn; then those of the list of free ones.
/// Which record stands where golden does not know: it numbers them as they are given out.
#include <cstdint>
#include <systemc>
#include <vector>

#include "sim/systemc/winding/work.h"

namespace kagesen::tlm_model::winding {

struct Record {
  bool full = false, goes_on = false, has_next = false;
  std::uint8_t count = 0;  ///< segments
  WordAddress next = 0;
};

class RecordPool : public sc_core::sc_module {
 public:
  explicit RecordPool(const sc_core::sc_module_name& name) : sc_module(name) {}

  /// No record is in use.
  void clear(std::uint32_t limit) {
    limit_ = limit;
    fresh_ = used_ = 0;
    spare_valid_ = free_valid_ = false;
    records_.clear();
    addresses_.clear();
  }
  Record& operator[](WordAddress at) { return records_[at]; }
  const Record& operator[](WordAddress at) const { return records_[at]; }
  /// @param number  of golden, of a record that was given out
  WordAddress address_of(std::uint32_t number) const { return addresses_[number]; }

  bool spare_ready() const { return spare_valid_ || fresh_ < limit_; }
  WordAddress spare() const { return spare_valid_ ? spare_ : fresh_; }
  bool full() const { return used_ >= limit_; }
  std::uint32_t used() const { return used_; }
  WordAddress free() const { return free_; }
  bool free_valid() const { return free_valid_; }
  /// What the last one of records that become free leads to.
  void lead_to_free(Record& last) const {
    last.next = free_;
    last.has_next = free_valid_;
  }

  /// The spare is in use now. Returns its address.
  WordAddress give(const Record& record) {
    const WordAddress at = spare();
    if (!spare_valid_) ++fresh_;
    spare_valid_ = false;
    ++used_;
    if (at >= records_.size()) records_.resize(at + 1);
    records_[at] = record;
    addresses_.push_back(at);
    return at;
  }
  void release() { --used_; }
  /// Records from `first` on become free.
  void put(WordAddress first) {
    free_ = first;
    free_valid_ = true;
  }
  /// The first free one becomes the spare.
  void take() {
    spare_ = free_;
    spare_valid_ = true;
    free_valid_ = records_[spare_].has_next;
    free_ = records_[spare_].next;
  }

 private:
  std::uint32_t limit_ = 0, fresh_ = 0, used_ = 0;
  bool spare_valid_ = false, free_valid_ = false;
  WordAddress spare_ = 0, free_ = 0;
  std::vector<Record> records_;
  std::vector<WordAddress> addresses_;  // by golden's number
};

}  // namespace kagesen::tlm_model::winding

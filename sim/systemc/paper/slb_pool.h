#pragma once
/// The SLB's records behind the buckets' own: which is the next to be taken.
/// Twin: rtl/paper/slb_pool.sv.
#include "sim/systemc/paper/slb_step.h"

namespace kagesen::tlm_model::paper {

class SlbPool {
 public:
  void begin(RecordAddress buckets, std::uint32_t limit) {
    *this = SlbPool{};
    unused_ = buckets;
    end_ = buckets + limit;
  }
  RecordAddress spot() const { return kept_ ? spot_ : unused_; }
  bool has_spot() const { return kept_; }
  bool dry() const { return !kept_ && unused_ >= end_; }
  RecordAddress free() const { return free_; }
  bool has_free() const { return has_free_; }
  std::uint32_t used() const { return used_; }

  /// @param record  the one that is looked up
  void step(const SlbStep& s, const SlbRecord& record) {
    used_ += s.used_more;
    used_ -= s.used_less;
    if (s.take) {
      unused_ += !kept_;
      kept_ = false;
    } else if (s.keep) {
      spot_ = s.free_address;
      kept_ = true;
    } else if (s.free) {
      free_ = s.free_address;
      has_free_ = true;
    } else if (s.reuse) {
      spot_ = free_;
      kept_ = true;
      free_ = record.more;
      has_free_ = record.has_more;
    }
  }

 private:
  RecordAddress spot_ = 0, free_ = 0, unused_ = 0, end_ = 0;
  std::uint32_t used_ = 0;
  bool kept_ = false, has_free_ = false;
};

}  // namespace kagesen::tlm_model::paper

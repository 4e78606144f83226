#pragma once
/// What waits in a queue of the unit, by the cycle in which it went in: nearly always at the end,
/// else a few places before it.
#include <cstddef>
#include <cstdint>
#include <vector>

#include "sim/systemc/common/clock.h"

namespace kagesen::tlm_model {

class TimeQueue {
 public:
  struct Item {
    Cycle at;
    std::uint32_t slot;
  };

  /// @param depth  a power of two
  void reset(std::size_t depth) {
    items_.resize(depth);
    head_ = tail_ = 0;
  }
  bool empty() const { return head_ == tail_; }
  std::size_t size() const { return tail_ - head_; }
  const Item& front() const { return items_[head_ & (items_.size() - 1)]; }
  void pop() { ++head_; }
  void push(Cycle at, std::uint32_t slot) {
    const std::size_t mask = items_.size() - 1;
    std::size_t place = tail_++;
    for (; place != head_ && items_[(place - 1) & mask].at > at; --place) {
      items_[place & mask] = items_[(place - 1) & mask];
    }
    items_[place & mask] = {at, slot};
  }

 private:
  std::vector<Item> items_;
  std::size_t head_ = 0, tail_ = 0;
};

}  // namespace kagesen::tlm_model

#pragma once
/// Responses that are due, the first one first. Mostly they come in order, and go in at the end.
#include <cstddef>
#include <utility>
#include <vector>

#include "sim/systemc/common/clock.h"

namespace kagesen::tlm_model {

template <typename Response>
class DueQueue {
 public:
  void clear() { first_ = count_ = 0; }
  bool empty() const { return count_ == 0; }
  /// kNever: none is due.
  Cycle next() const { return count_ == 0 ? kNever : ring_[first_].at; }
  const Response& front() const { return ring_[first_].response; }

  void push(Cycle at, const Response& response) {
    if (count_ == ring_.size()) grow();
    std::size_t i = count_++;
    for (; i > 0 && place(i - 1).at > at; --i) place(i) = place(i - 1);
    place(i) = {at, response};
  }
  void pop() {
    first_ = (first_ + 1) & (ring_.size() - 1);
    --count_;
  }

 private:
  struct Due {
    Cycle at;
    Response response;
  };
  Due& place(std::size_t i) { return ring_[(first_ + i) & (ring_.size() - 1)]; }
  void grow() {
    std::vector<Due> more(ring_.empty() ? 16 : 2 * ring_.size());
    for (std::size_t i = 0; i < count_; ++i) more[i] = place(i);
    ring_ = std::move(more);
    first_ = 0;
  }

  std::vector<Due> ring_;  // a power of two
  std::size_t first_ = 0, count_ = 0;
};

}  // namespace kagesen::tlm_model

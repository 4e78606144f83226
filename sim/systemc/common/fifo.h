#pragma once
/// A queue: words stand in a memory and, ahead of it, an output register.
/// Twin: rtl/common/fifo.sv.
#include <cstddef>
#include <utility>
#include <vector>

namespace kagesen::tlm_model {

template <typename Word>
class Fifo {
 public:
  void reset(std::size_t depth) {
    depth_ = depth;
    head_ = count_ = 0;
    valid_ = false;
  }
  bool ready() const { return count_ != depth_; }
  bool valid() const { return valid_; }
  const Word& front() const { return out_; }
  bool empty() const { return !valid_ && count_ == 0; }
  std::size_t words() const { return count_ + valid_; }  ///< the one at the output too

  /// The clock's edge. @param push  null: nothing came  @param ready  the front is taken, if valid
  /// @return did anything change?
  bool step(const Word* push, bool ready) {
    const bool fetch = count_ != 0 && (!valid_ || ready);
    const bool changed = push != nullptr || fetch || (valid_ && ready);
    valid_ = fetch || (valid_ && !ready);
    if (fetch) {
      out_ = ring_[head_];
      head_ = (head_ + 1) & (ring_.size() - 1);
      --count_;
    }
    if (push != nullptr) {
      if (count_ == ring_.size()) grow();
      ring_[(head_ + count_++) & (ring_.size() - 1)] = *push;
    }
    return changed;
  }

 private:
  void grow() {
    std::vector<Word> more(ring_.empty() ? 16 : 2 * ring_.size());
    for (std::size_t i = 0; i < count_; ++i) more[i] = ring_[(head_ + i) & (ring_.size() - 1)];
    ring_ = std::move(more);
    head_ = 0;
  }

  std::size_t depth_ = 0;
  std::vector<Word> ring_;  // a power of two
  std::size_t head_ = 0, count_ = 0;
  Word out_{};
  bool valid_ = false;
};

}  // namespace kagesen::tlm_model

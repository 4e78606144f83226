#pragma once
/// A queue: words stand in a memory and, ahead of it, an output register.
/// Twin: rtl/common/fifo.sv.
#include <deque>
#include <utility>

namespace kagesen::tlm_model {

template <typename Word>
class Fifo {
 public:
  void reset(std::size_t depth) {
    depth_ = depth;
    words_.clear();
    valid_ = false;
  }
  bool ready() const { return words_.size() != depth_; }
  bool valid() const { return valid_; }
  const Word& front() const { return out_; }
  bool empty() const { return !valid_ && words_.empty(); }
  std::size_t words() const { return words_.size() + valid_; }  ///< the one at the output too

  /// The clock's edge. @param push  null: nothing came  @param ready  the front is taken, if valid
  /// @return did anything change?
  bool step(const Word* push, bool ready) {
    const bool fetch = !words_.empty() && (!valid_ || ready);
    const bool changed = push != nullptr || fetch || (valid_ && ready);
    valid_ = fetch || (valid_ && !ready);
    if (fetch) {
      out_ = std::move(words_.front());
      words_.pop_front();
    }
    if (push != nullptr) words_.push_back(*push);
    return changed;
  }

 private:
  std::size_t depth_ = 0;
  std::deque<Word> words_;
  Word out_{};
  bool valid_ = false;
};

}  // namespace kagesen::tlm_model

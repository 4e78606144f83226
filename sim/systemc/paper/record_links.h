#pragma once
/// Records that are hinted because a link leads to them: of each record that comes or is hinted again,
/// its chain's next one, or else the entry's continuation.
/// Twin: the links and the queue in rtl/paper/record_buffer.sv.
#include <vector>

#include "sim/systemc/common/fifo.h"
#include "sim/systemc/paper/slb_step.h"

namespace kagesen::tlm_model::paper {

class RecordLinks {
 public:
  /// What comes in a cycle.
  struct Inputs {
    bool hint = false, hint_ready = false;  ///< a visit's or an emptied entry's; any would be taken
    RecordAddress hint_address = 0;
    const SlbRecord* came = nullptr;  ///< from memory
    bool learn = false;               ///< `known` is what stands at an address
    RecordAddress learn_address = 0;
    SlbRecord known;
    bool active = false;  ///< visits are inside: links are followed
    bool soon = false;  ///< one more, less urgent
    RecordAddress soon_address = 0;
  };

  void reset(unsigned record_lines) {
    links_.assign(2 * std::size_t{record_lines}, {});
    queue_.reset(kQueue);
    asked_ = false;
  }
  bool valid() const { return queue_.valid(); }
  RecordAddress address() const { return queue_.front(); }
  std::size_t words() const { return queue_.words(); }  ///< that wait to be hinted
  /// Cycles that forgetting all links takes.
  std::size_t wipe_cycles() const { return links_.size(); }
  bool soon_ready(const SlbRecord* came) const { return queue_.ready() && !followed(came); }

  /// The clock's edge. @return did anything change?
  bool step(const Inputs& in) {
    const bool follows = followed(in.came);
    const RecordAddress next = !follows            ? in.soon_address
                               : in.came == nullptr ? link_.next
                               : in.came->has_next  ? in.came->next
                                                    : in.came->more;
    const bool push = (follows || in.soon) && queue_.ready();
    const bool hints = in.hint || (queue_.valid() && in.active);
    const RecordAddress hinted = in.hint ? in.hint_address : hints ? queue_.front() : 0;
    const bool before = asked_;
    asked_ = hints && in.hint_ready;
    asked_address_ = hinted;
    link_ = links_[hinted & (links_.size() - 1)];
    if (in.learn) {
      const SlbRecord& r = in.known;
      links_[in.learn_address & (links_.size() - 1)] = {r.has_next || r.has_more, in.learn_address,
                                                  r.has_next ? r.next : r.more};
    }
    const bool was_empty = queue_.empty();
    const bool changed = queue_.step(push ? &next : nullptr, !in.hint && in.hint_ready);
    if (in.active) return changed || before || asked_;
    queue_.reset(kQueue);
    return !was_empty || before || asked_;
  }

 private:
  struct Link {
    bool has = false;
    RecordAddress from = 0, next = 0;
  };
  static constexpr std::size_t kQueue = 16;

  bool followed(const SlbRecord* came) const {
    if (came != nullptr) return came->has_next || came->has_more;
    return asked_ && link_.has && link_.from == asked_address_;
  }

  std::vector<Link> links_;
  Link link_;  // of what was hinted in the last cycle
  Fifo<RecordAddress> queue_;
  bool asked_ = false;
  RecordAddress asked_address_ = 0;
};

}  // namespace kagesen::tlm_model::paper

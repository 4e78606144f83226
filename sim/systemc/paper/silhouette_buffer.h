#pragma once
/// The SLB's read port in pass 2: reads of fragments that go on, else of those that begin.
/// Twin: more_fifo, lookup_fifo and the choice between them in rtl/paper/shadow_lane.sv.
///
/// Timing: a request leaves its queue two cycles after it went in at the earliest, one a cycle;
///         which queue's turn it is is settled when one of them has something to offer.
#include <cstdint>
#include <systemc>
#include <vector>

#include "model/unit/fragment_trail.h"
#include "sim/systemc/common/memory_port.h"
#include "sim/systemc/common/queue_meter.h"
#include "sim/systemc/common/time_queue.h"
#include "sim/systemc/paper/shadow_decision.h"

namespace kagesen::tlm_model::paper {

class SilhouetteBuffer : public sc_core::sc_module {
 public:
  /// Reads of a slot's fragment.
  struct Walk {
    unit::FragmentTrail trail;            ///< what is to be read
    std::vector<MemoryPort::Read> reads;  ///< what was
  };
  struct Step {
    std::uint32_t slot;
    bool last;      ///< the slot is decided
    Cycle decided;  ///< in this cycle
  };

  MemoryPort port;
  ShadowDecision decision;
  QueueMeter lookup_meter, more_meter;

  explicit SilhouetteBuffer(const sc_core::sc_module_name& name)
      : sc_module(name), port("port"), decision("shadow_decision") {}

  void begin_pass(std::uint32_t slots, unsigned word_bytes) {
    port.begin_pass(word_bytes);
    walks_.resize(slots);
    lookups_.reset(slots);
    more_.reset(slots);
    lookup_meter.begin_pass();
    more_meter.begin_pass();
    free_ = 0;
  }
  Walk& walk(std::uint32_t slot) { return walks_[slot]; }

  /// A fragment begins to read: its request goes into its queue in this cycle.
  void look_up(Cycle at, std::uint32_t slot) { lookups_.push(at, slot); }
  bool idle() const { return lookups_.empty() && more_.empty(); }
  /// The next read of all. @pre some fragment has one to do; look_up() was called for all whose turn
  /// comes before
  Step step() {
    const Cycle more = more_.empty() ? kNever : more_.front().at + kQueue;
    const Cycle first = lookups_.empty() ? kNever : lookups_.front().at + kQueue;
    Cycle asked = more < first ? more : first;
    if (asked < free_) asked = free_;
    const bool goes_on = more <= asked;
    TimeQueue& queue = goes_on ? more_ : lookups_;
    const auto [queued, slot] = queue.front();
    queue.pop();
    Walk& walk = walks_[slot];
    const MemoryPort::Read read = port.read(asked, walk.trail.records[walk.reads.size()]);
    free_ = read.accepted + 1;
    (goes_on ? more_meter : lookup_meter).word(queued, read.accepted);
    walk.reads.push_back(read);
    const Cycle decided = decision.decided(read.responded);
    const bool last = walk.reads.size() == walk.trail.records.size();
    if (!last) more_.push(decided, slot);
    return {slot, last, decided};
  }

 private:
  static constexpr Cycle kQueue = 2;  // through a fifo

  std::vector<Walk> walks_;  // a slot each
  TimeQueue lookups_, more_;
  Cycle free_ = 0;  // for the next read
};

}  // namespace kagesen::tlm_model::paper

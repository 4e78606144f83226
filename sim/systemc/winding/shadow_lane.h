#pragma once
/// A lane of pass 2: when it takes each fragment, when its verdict leaves, and where the cycles go.
/// Twin: rtl/winding/shadow_lane.sv.
///
///   open() -> golden decides -> take(): tile -> texel word -> early decision -> list
///   retire(): reads of words and lists, in the order of time, until the oldest fragment is decided
///
/// Fragments go through in their order, each once. A fragment enters only when the one that had its
/// slot has left; by then everything is known of the reads up to that cycle, since whoever enters
/// later reads later.
#include <algorithm>
#include <cstdint>
#include <string>
#include <systemc>
#include <vector>

#include "model/cycle_causes.h"
#include "model/engine.h"
#include "model/unit/winding/fragment_trail.h"
#include "sim/systemc/common/cause_meter.h"
#include "sim/systemc/common/lane_slots.h"
#include "sim/systemc/winding/early_decision.h"
#include "sim/systemc/winding/list_reader.h"

namespace kagesen::tlm_model::winding {

class ShadowLane : public sc_core::sc_module {
 public:
  using Trail = unit::winding::FragmentTrail;

  struct Pass {
    std::uint32_t slots;
    Stalls offers, verdicts;          ///< cycles in which no fragment is offered, no verdict taken
    unsigned texel_bytes, slb_bytes;  ///< of a memory's word
    unsigned map_bits;                ///< of a texel's index
    FragmentCycles* cycles;           ///< of this lane's first fragment; may be null
    std::size_t stride;               ///< from one of its fragments to the next
  };

  LaneSlots slots;
  ListReader lists;
  EarlyDecision early;

  explicit ShadowLane(const sc_core::sc_module_name& name);

  MemoryPort& texel_port() { return early.port; }
  MemoryPort& slb_port() { return lists.port; }

  void begin_pass(const Pass& pass);
  /// What the next fragment reads is to be put here, before it is taken.
  Trail& open() {
    if (fragments_ >= slots.count()) free_slot();
    ListReader::Walk& walk = lists.walk(slots.slot_of(fragments_));
    walk.trail.clear();
    walk.records.clear();
    return walk.trail;
  }
  void take();
  /// Every fragment has been taken: the rest leave.
  void drain();
  /// Accounts for the cycles up to the pass's end.
  /// @param all_taken  first cycle by which every lane's fragments have been taken
  void end_pass(Cycle all_taken, Cycle cycles);

  Cycle last_accepted() const { return accepted_; }
  Cycle last_retired() const { return slots.last_taken(); }
  std::uint64_t fragments() const { return fragments_; }
  /// Of all passes since clear().
  const CauseMeter& causes() const { return causes_; }
  void add_queues(const std::string& lane, std::vector<QueueCycles>& queues);
  void clear();
  /// @param lane  what its tracks' names begin with
  void trace(Timeline* timeline, const std::string& lane);

 private:
  struct Metered {
    const char* queue;
    QueueMeter& meter;
  };
  std::vector<Metered> meters();
  bool decide_oldest(Cycle until);
  [[noreturn]] void stuck() const;
  void retire();
  void free_slot();
  bool verdict_waits(Cycle at);
  void blame_oldest(std::uint32_t oldest, Cycle to);
  void blame_entry(Cycle to);
  /// Cycles whose cause is not known yet have this one, as far as they lie before `end`.
  void blame(Cycle end, LaneCause why) {
    if (end <= unblamed_) return;
    causes_.add(why, unblamed_, end);
    unblamed_ = end;
  }

  Pass pass_;
  std::vector<Cycle> free_from_;  // of each slot
  std::uint64_t fragments_ = 0;
  Cycle accepted_ = 0;  // the last fragment
  Cycle entered_ = 0;   // and when it made way for the next one
  Cycle fetched_ = 0;   // the last verdict, from its slot
  Cycle unblamed_ = 0;  // first cycle whose cause is not known yet
  CauseMeter causes_{kLaneCauses};
};

}  // namespace kagesen::tlm_model::winding

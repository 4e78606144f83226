#pragma once
/// A lane of pass 2: when it takes each fragment, when its verdict leaves, and where the cycles go.
/// Twin: rtl/paper/shadow_lane.sv.
///
///   open() -> golden decides -> take(): place -> texel read -> early decision -> lookup
///   retire(): SLB reads, in the order of time, until the oldest fragment is decided
///
/// Fragments go through in their order, each once. A fragment enters only when the one that had its
/// slot has left; by then everything is known of the SLB's reads up to that cycle, since whoever
/// enters later reads later.
#include <cstdint>
#include <string>
#include <systemc>
#include <vector>

#include "model/cycle_causes.h"
#include "model/fragment_cycles.h"
#include "model/unit/fragment_trail.h"
#include "sim/systemc/common/cause_meter.h"
#include "sim/systemc/common/lane_slots.h"
#include "sim/systemc/paper/silhouette_buffer.h"
#include "sim/systemc/paper/texel_buffers.h"

namespace kagesen::tlm_model::paper {

class ShadowLane : public sc_core::sc_module {
 public:
  struct Pass {
    std::uint32_t slots;
    Stalls offers, verdicts;         ///< cycles in which no fragment is offered, no verdict taken
    unsigned texel_bytes, slb_bytes;  ///< of a memory's word
    unsigned pitch_log2;             ///< texel words of a row
    FragmentCycles* cycles;          ///< of this lane's first fragment; may be null
    std::size_t stride;              ///< from one of its fragments to the next
  };

  LaneSlots slots;
  TexelBuffers texels;
  SilhouetteBuffer slb;

  explicit ShadowLane(const sc_core::sc_module_name& name);

  MemoryPort& texel_port() { return texels.port; }
  MemoryPort& slb_port() { return slb.port; }

  void begin_pass(const Pass& pass);
  /// What the next fragment reads is to be put here, before it is taken.
  unit::FragmentTrail& open() {
    if (fragments_ >= slots.count()) free_slot();
    SilhouetteBuffer::Walk& walk = slb.walk(slots.slot_of(fragments_));
    walk.trail.clear();
    walk.reads.clear();
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
  void add_queues(const std::string& lane, std::vector<QueueCycles>& queues) const;
  void clear();
  /// @param lane  what its tracks' names begin with
  void trace(Timeline* timeline, const std::string& lane);

 private:
  Cycle retire();
  [[noreturn]] void stuck(std::uint64_t oldest);
  void free_slot();
  void blame_oldest(std::uint32_t oldest, Cycle to);
  /// Cycles whose cause is not known yet have this one, as far as they lie before `end`.
  void blame(Cycle end, LaneCause why) {
    if (end <= unblamed_) return;
    causes_.add(why, unblamed_, end);
    unblamed_ = end;
  }

  Pass pass_;
  std::vector<Cycle> early_;  // of each slot, its early decision; kNever without
  std::uint64_t fragments_ = 0;
  Cycle accepted_ = 0;   // the last fragment
  Cycle placed_ = 0;     // until when it keeps the next one out
  Cycle unblamed_ = 0;   // first cycle whose cause is not known yet
  CauseMeter causes_{kLaneCauses};
};

}  // namespace kagesen::tlm_model::paper

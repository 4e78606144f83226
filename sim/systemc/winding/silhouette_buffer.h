#pragma once
/// Carries out what a visit, or the end of pass 1, does to a texel with a list of clusters, or that
/// gets one: a step each time that the record it needs is on chip.
/// Twin: rtl/winding/silhouette_buffer.sv, whose states these are.
#include <deque>
#include <systemc>

#include "model/unit/config.h"
#include "sim/systemc/winding/cluster_update.h"
#include "sim/systemc/winding/list_step.h"

namespace kagesen::tlm_model::winding {

class SilhouetteBuffer : public sc_core::sc_module {
 public:
  enum class Cause : std::uint8_t { kChain, kRecord, kWrite };

  RecordCache records;
  RecordPool pool;

  explicit SilhouetteBuffer(const sc_core::sc_module_name& name);

  /// As after reset, for a configuration. No record is in use.
  void reset(const UnitConfig& config);
  /// What visits to come hide, and what settling finds, in order.
  void add_dropped(const std::vector<std::uint32_t>& numbers);
  void add_emptied(const std::vector<unit::winding::SettleTrail::Emptied>& clusters);
  /// A texel is passed over in settling.
  void skip(const ListVisit& visit);

  bool ready() const { return state_ == kIdle; }
  /// Begins in this cycle. @pre ready()
  void start(const ListVisit& visit, const TexelState& texel);
  /// This cycle, once it is known whether something begins. Returns whether it is the last one.
  bool step(Cycle now);
  /// @pre the step was the last one
  bool texel_changed() const { return changed_; }
  const TexelState& texel() const { return texel_; }
  Cause cause() const { return cause_; }  ///< of a step
  bool idle() const { return ready() && records.idle(); }

  /// The clock's edge. @return did anything change?
  bool clock(Cycle now);

 private:
  enum State : std::uint8_t {
    kIdle, kTake, kTaken, kCheck, kWalk, kOpen, kInsert, kWork, kErase, kLink, kLast, kSpill, kKeep, kDone
  };
  enum Mode : std::uint8_t { kFind, kCovers, kCoversDrop, kDrop, kSettle, kFree, kCount };

  std::uint32_t mark_of(const ListVisit& visit) const;
  void begin(ListStep& step);
  void check(ListStep& step);
  void open(ListStep& step);
  void insert(ListStep& step);
  void walk(ListStep& step);
  bool visit_record(ListStep& step);
  void end_walk(ListStep& step);
  void erase(ListStep& step);
  void link(ListStep& step);
  void take_last(ListStep& step);
  void spill(ListStep& step);
  void work(ListStep& step);
  void restart(ListStep& step, Mode mode);
  void drop_hidden(ListStep& step);
  void note(bool nearest) {
    texel_.covered = texel_.covered || nearest;
    changed_ = changed_ || nearest;
  }

  ClusterUpdate cluster_;
  bool paper_ = false;
  std::uint32_t chain_limit_ = 0;
  unsigned base_bits_ = 0, code_bits_ = 0;  // of planes
  ListVisit visit_;
  std::uint32_t mark_ = 0;
  std::deque<std::uint32_t> dropped_;
  std::deque<unit::winding::SettleTrail::Emptied> emptied_;

  State state_ = kIdle, next_state_ = kIdle;
  Mode mode_ = kFind;
  TexelState texel_;
  bool starts_ = false, changed_ = false, insert_ = false, continued_ = false, seen_ = false;
  bool prev_valid_ = false, next_valid_ = false;
  WordAddress at_ = 0, prev_ = 0, chain_ = 0, next_ = 0;
  std::uint32_t count_ = 0;  // records, by a walk
  std::uint32_t dropped_left_ = 0;  // clusters of this visit
  bool moved_ = false;       // something else than the state changed in this step
  Cause cause_ = Cause::kChain;
  RecordCache::Inputs requests_;
};

}  // namespace kagesen::tlm_model::winding

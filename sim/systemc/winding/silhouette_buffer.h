#pragma once
/// Carries out what a visit, or the end of pass 1, does to a texel with a list of clusters, or that
/// gets one: a step each time that the record it needs is on chip.
/// Twin: rtl/winding/silhouette_buffer.sv with list_control, whose states these are.
#include <systemc>

#include "model/unit/config.h"
#include "sim/systemc/winding/cluster_update.h"
#include "sim/systemc/winding/list_walk.h"

namespace kagesen::tlm_model::winding {

class SilhouetteBuffer : public sc_core::sc_module {
 public:
  enum class Cause : std::uint8_t { kChain, kRecord, kWrite };

  RecordCache records;
  RecordPool pool;
  ListTexel texel;
  ListWalk walk;
  ClusterUpdate cluster;

  explicit SilhouetteBuffer(const sc_core::sc_module_name& name);

  /// As after reset, for a configuration. No record is in use.
  void reset(const UnitConfig& config);

  bool ready() const { return state_ == kIdle; }
  /// Begins in this cycle. @pre ready()
  void start(const ListVisit& visit, const TexelState& before);
  /// This cycle, once it is known whether something begins. Returns whether it is the last one.
  bool step(Cycle now);
  Cause cause() const { return cause_; }  ///< of a step
  bool idle() const { return ready() && records.idle(); }
  /// Nothing changes until something begins.
  bool asleep() const { return idle() && !records.looks_up() && !seen_; }
  /// The clock's edge. @return did anything change?
  bool clock(Cycle now);

 private:
  enum State : std::uint8_t {
    kIdle, kTake, kTaken, kCheck, kOpen, kInsert, kWalk, kWork, kLast, kSpill, kKeep, kDone
  };

  static State first_state(TexelState::Kind kind);
  void begin(ListStep& step);
  void take(ListStep& step);
  void check(ListStep& step);
  void open(ListStep& step);
  void insert(ListStep& step);
  void go_on(ListWalk::End end, ListStep& step);
  void go_on(ClusterUpdate::End end, ListStep& step);
  void take_last(ListStep& step);
  void spill(ListStep& step);
  void begin_walk(ListStep& step, ListWalk::Mode mode);
  void drop_hidden(ListStep& step) {
    begin_walk(step, paper_ ? ListWalk::kCoversDrop : ListWalk::kDrop);
  }

  bool paper_ = false;
  std::uint32_t chain_limit_ = 0;
  ListVisit visit_;
  State state_ = kIdle, next_state_ = kIdle;
  bool starts_ = false;
  bool insert_ = false;  // after the spare is taken
  bool seen_ = false;    // the record that is looked up, in the cycle before
  bool moved_ = false;   // something changed in this step
  WordAddress at_ = 0;   // of the record that is looked up
  Cause cause_ = Cause::kChain;
  RecordCache::Inputs requests_;
};

}  // namespace kagesen::tlm_model::winding

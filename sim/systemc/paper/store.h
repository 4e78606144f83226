#pragma once
/// The store of pass 1: carries out visits strictly in order on the texel and SLB memories.
/// Twin: rtl/paper/store.sv with texel_buffers, silhouette_buffer and record_buffer.
///
/// It is stepped cycle by cycle, for what is on chip hangs on what meets in a cycle (line_cache.h);
/// cycles in which it only waits are passed over.
#include <systemc>
#include <vector>

#include "sim/systemc/common/cached_memory.h"
#include "sim/systemc/common/fifo.h"
#include "sim/systemc/common/store_meter.h"
#include "sim/systemc/paper/record_links.h"
#include "sim/systemc/paper/record_walk.h"
#include "sim/systemc/paper/span_hints.h"
#include "sim/systemc/paper/visit.h"

namespace kagesen::tlm_model::paper {

class Store : public sc_core::sc_module, public VisitTaker {
 public:
  CachedMemory texels, records;

  explicit Store(const sc_core::sc_module_name& name);

  /// As after reset, for a configuration.
  void reset(const UnitConfig& config);
  void begin_pass(unsigned texel_bytes, const Stalls& texel_writes, unsigned record_bytes,
                  const Stalls& record_writes);
  /// The wipe pass. Returns its cycles.
  Cycle wipe();
  /// Visits to come are of this triangle, until the next.
  void begin(const unit::TriangleTrail& triangle);
  Cycle take(const Visit& visit, Cycle offered) override;
  bool ready(Cycle at) override;
  /// All visits were taken; the front is idle from a cycle on. Returns the pass's cycles.
  Cycle finish(Cycle front_idle);
  /// Tells cycles without a visit, before one whose cause is known, from the front's causes.
  void tell(FrontCauses& front, Cycle until) { meter_.causes.tell(front, until); }
  /// @param timeline  takes what the store does; or null
  void trace(Timeline* timeline) { meter_.trace(timeline, texels.port, records.port); }
  const CauseMeter& causes() const { return meter_.causes.meter(); }
  /// Fills in causes, queues and tiles.
  void report(PassCycles& pass) const { meter_.report(pass); }
  /// See RecordWalk.
  void locate(unit::FragmentTrail& trail) const { walk_.locate(trail); }

 private:
  bool active() const;  // visits are inside
  bool idle() const;
  Operation operation_of(const Visit& visit);
  bool step(const Operation* offered, bool begins);
  void pass_over(Cycle until);
  void count(StoreCause cause, Cycle cycles);
  StoreMeter::Words words() const {
    return {coming_.words(), emptied_.words(), soon_.words(), visits_.words(), links_.words()};
  }

  UnitConfig config_;
  unsigned pitch_log2_ = 0;
  RecordWalk walk_;
  Fifo<Operation> coming_, visits_, emptied_, soon_;
  unsigned closing_ = 0;  // VisitEdgesDone in the queue
  RecordLinks links_;
  SpanHints spans_;
  std::vector<std::uint8_t> edges_;  // of each word: its texels' edge flags
  const unit::TriangleTrail* triangle_ = nullptr;
  std::size_t next_visit_ = 0, next_hiding_ = 0;  // in triangle_

  Cycle now_ = 0;           // the next cycle
  bool unchanged_ = false;  // the last one changed nothing
  StoreCause cause_ = StoreCause::kInput;  // of the last one
  StoreMeter meter_{{"store.coming", "store.emptied_list", "store.emptied_soon", "store.places",
                     "store.records.records.follow"}};
};

}  // namespace kagesen::tlm_model::paper

#pragma once
/// The front: when each triangle is taken, and each of its visits given to the store.
/// Twin: rtl/paper/front.sv.
///
/// A setup that goes on by itself, and a walk that moves as the store takes visits; the next
/// triangle's first edge is set up while one is walked.
#include <systemc>

#include "sim/systemc/common/front_causes.h"
#include "sim/systemc/paper/edge_setup.h"
#include "sim/systemc/paper/edge_walker.h"
#include "sim/systemc/paper/span_filler.h"

namespace kagesen::tlm_model::paper {

class Front : public sc_core::sc_module {
 public:
  explicit Front(const sc_core::sc_module_name& name);

  void begin_pass(const UnitConfig& config, unsigned texel_bits, VisitTaker& store);
  /// A triangle is offered from this cycle on. Returns the cycle in which it is taken.
  Cycle draw(const unit::TriangleTrail& triangle, Cycle offered);
  /// The first cycle with nothing inside, if no more triangles come.
  Cycle idle() const { return std::max({walked_, free_, visits_.empty()}); }
  /// Causes of the cycles before this one are told.
  Cycle told() const { return walked_; }
  /// Why there was no visit, up to the last one that draw() gave to the store.
  FrontCauses& causes() { return causes_; }

 private:
  EdgeSetup setup_;
  EdgeWalker walker_;
  VisitedRows rows_;
  SpanFiller filler_;
  VisitRegister visits_;
  FrontCauses causes_;
  Cycle walked_ = 0;  // the first cycle in which the next triangle's walk can begin
  Cycle free_ = 0;    // the first one after the last triangle was taken
};

}  // namespace kagesen::tlm_model::paper

#pragma once
/// Sets up one edge: when it is ready to be walked.
/// Twin: rtl/winding/edge_setup.sv.
///
/// Offsets to the first border of each axis that the edge crosses, then steps if it crosses two: a
/// product, which it asks plane_setup for, and a division each.
#include <algorithm>
#include <systemc>

#include "model/unit/winding/edge_walker.h"
#include "sim/systemc/common/divider.h"

namespace kagesen::tlm_model::winding {

class EdgeSetup : public sc_core::sc_module {
 public:
  explicit EdgeSetup(const sc_core::sc_module_name& name) : sc_module(name) {}

  /// An edge is at the input from this cycle on.
  void begin(const unit::winding::EdgeWalker::Figures& edge, Cycle at) {
    edge_ = edge;
    part_ = kOffsetV;
    at_ = at + kEnds;
    done_v_ = done_u_ = 0;
    go_on();
  }
  /// The cycle from which on a product is asked for; kNever: no more.
  Cycle wanted() const { return wanted_; }
  /// It is there.
  void product(Cycle at) {
    const bool along_u = part_ == kOffsetV || part_ == kStepV;
    const std::int64_t quotient = part_ == kOffsetV   ? edge_.offset_v
                                  : part_ == kOffsetU ? edge_.offset_u
                                  : part_ == kStepV   ? edge_.step_v
                                                      : edge_.step_u;
    (along_u ? done_v_ : done_u_) = at + division_cycles(quotient, kQuotientBits);
    at_ = at + 1;
    part_ = static_cast<Part>(part_ + 1);
    go_on();
  }
  /// The first cycle in which the edge is ready. @pre wanted() is kNever
  Cycle ready() const { return at_; }

 private:
  enum Part { kOffsetV, kOffsetU, kOffsets, kStepV, kStepU, kSteps };
  static constexpr Cycle kEnds = 6;  // to the edge's ends, one coordinate a cycle
  static constexpr unsigned kQuotientBits = 28;

  void go_on() {
    for (;; part_ = static_cast<Part>(part_ + 1)) {
      const bool more = edge_.borders_u > 1 || edge_.borders_v > 1;
      const bool wants = part_ == kOffsetV   ? edge_.borders_u > 0
                         : part_ == kOffsetU ? edge_.borders_v > 0
                         : part_ == kStepV   ? edge_.borders_u > 1
                         : part_ == kStepU   ? edge_.borders_v > 1
                                             : false;
      wanted_ = wants ? at_ : kNever;
      if (wants) return;
      if (part_ == kOffsets || part_ == kSteps) {
        at_ = std::max({at_, done_v_, done_u_});
        if (part_ == kSteps || !more) return;
        done_v_ = done_u_ = 0;
      }
      ++at_;
    }
  }

  unit::winding::EdgeWalker::Figures edge_{};
  Part part_ = kSteps;
  Cycle at_ = 0, wanted_ = kNever;
  Cycle done_v_ = 0, done_u_ = 0;  // divisions
};

}  // namespace kagesen::tlm_model::winding

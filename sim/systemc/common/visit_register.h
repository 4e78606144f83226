#pragma once
/// The register in which a front's visits wait for the store. While a visit waits there, nothing of
/// the front but its setup moves.
/// Twin: visit_q in rtl/paper/front.sv and rtl/winding/front.sv.
#include "sim/systemc/common/clock.h"

namespace kagesen::tlm_model {

/// Where visits go: the store, or what stands for it.
template <typename Visit>
class VisitTaker {
 public:
  virtual ~VisitTaker() = default;
  /// A visit is offered from a cycle on. Returns the cycle in which it is taken. Visits come in order.
  virtual Cycle take(const Visit& visit, Cycle offered) = 0;
  /// Would one be taken in this cycle? Not before any that was asked for or taken.
  virtual bool ready(Cycle at) = 0;
};

template <typename Visit>
class VisitRegister {
 public:
  void begin_pass(VisitTaker<Visit>& taker) {
    taker_ = &taker;
    moves_ = empty_ = offered_ = 0;
  }
  /// The first cycle in which the front can move again.
  Cycle moves() const { return moves_; }
  /// The first one with no visit in the register, unless another comes.
  Cycle empty() const { return empty_; }

  /// The first one in which no visit is offered, unless another comes.
  Cycle offered() const { return offered_; }

  /// The front moved in this cycle, and in all until then; no visit came.
  void pass(Cycle at) { moves_ = at + 1; }
  /// It moved, and a visit left it.
  void put(Cycle at, const Visit& visit) {
    moves_ = taker_->take(visit, at + 1);
    empty_ = offered_ = moves_ + 1;
  }
  /// It moved, and what came is dropped in the register, a cycle later.
  void drop(Cycle at) {
    moves_ = taker_->ready(at + 1) ? at + 1 : at + 2;
    empty_ = at + 2;
  }

 private:
  VisitTaker<Visit>* taker_ = nullptr;
  Cycle moves_ = 0, empty_ = 0, offered_ = 0;
};

}  // namespace kagesen::tlm_model

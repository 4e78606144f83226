#pragma once
/// Sets up a triangle's edges one after the other: when each is ready to be walked.
/// Twin: rtl/paper/edge_setup.sv and plane_setup.sv. It goes on while the front waits for the store.
#include <systemc>

#include "model/unit/config.h"
#include "model/unit/triangle_trail.h"
#include "sim/systemc/common/clock.h"

namespace kagesen::tlm_model::paper {

class EdgeSetup : public sc_core::sc_module {
 public:
  explicit EdgeSetup(const sc_core::sc_module_name& name) : sc_module(name) {}

  void begin_pass(const UnitConfig& config, unsigned texel_bits);
  /// A triangle is at the input from this cycle on. Returns the cycle in which its area is known;
  /// one without area is taken then.
  Cycle begin(const unit::TriangleTrail& triangle, Cycle offered);
  /// The cycle from which on the next edge is offered.
  Cycle edge_ready(unsigned edge);
  /// The edge was taken; the walker stood before its first texel in a later cycle, `fresh`.
  void take(Cycle at, Cycle fresh);

 private:
  // Cycles of the program, two a step.
  static constexpr Cycle kGradients = 16;  // to the first edge
  // From where an edge begins:
  static constexpr Cycle kSteps = 2;    // plane's steps are divided from here on,
  static constexpr Cycle kStart = 15;   // its depth in the first texel,
  static constexpr Cycle kRamps = 20;   // and the ramps; they come two cycles apart
  static constexpr Cycle kProgram = 38;
  static constexpr Cycle kFarthest = 1;  // steps begin so much later where a rise is wanted
  static constexpr Cycle kPlane = 2;    // from the walker's fresh cycle: the plane has been taken
  static constexpr Cycle kBetweenDivisions = 1;

  Cycle divide_steps(Cycle at) const;

  const unit::TriangleTrail* triangle_ = nullptr;
  bool farthest_ = false;
  unsigned texel_bits_ = 0, step_bits_ = 0, start_bits_ = 0;  // of quotients
  Cycle edge_cycles_ = 0;    // from where an edge begins, but for its plane
  Cycle begins_ = 0;         // the edge's, unless the plane of the one before stands
  Cycle plane_free_ = 0;
};

}  // namespace kagesen::tlm_model::paper

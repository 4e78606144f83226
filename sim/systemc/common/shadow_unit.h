#pragma once
/// The unit of one profile: golden says what happens, modules say when.
/// Twin: rtl/common/shadow_unit.sv.
#include <cstddef>
#include <memory>
#include <optional>
#include <systemc>
#include <vector>

#include "model/engine.h"
#include "sim/memory/timing.h"
#include "sim/systemc/common/clock.h"
#include "sim/common/timeline.h"

namespace kagesen::tlm_model {

class ShadowUnit : public sc_core::sc_module {
 public:
  explicit ShadowUnit(const sc_core::sc_module_name& name) : sc_module(name) {}

  /// A frame begins: buffers are empty, counts of cycles too.
  /// @pre the lanes are those that the unit was made with
  virtual void begin(const UnitConfig& config, const FrameSetup& setup, const Timing& timing) = 0;
  virtual void announce(const Fragment* fragments, std::size_t count) = 0;
  virtual void draw(const Caster* casters, std::size_t count) = 0;
  /// @param cycles  if not null: of each fragment, from the pass's first cycle on
  virtual void decide(const Fragment* fragments, std::size_t count, Verdict* verdicts,
                      FragmentCycles* cycles) = 0;
  /// Cycles of pass 1 so far; and when each triangle of the last draw() was taken in it.
  virtual Cycle drawn() const = 0;
  virtual const std::vector<Cycle>& taken() const = 0;
  /// @param timeline  takes what happens in pass 2, its first cycle being 0; or null
  virtual void trace(Timeline* timeline) { static_cast<void>(timeline); }
  /// Of what is modelled.
  virtual CycleReport cycles() const = 0;
  /// The buffers and the counters.
  virtual const Engine& golden() const = 0;
};

}  // namespace kagesen::tlm_model

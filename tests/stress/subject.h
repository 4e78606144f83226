#pragma once
/// A trace under test: what is true of it, and what a unit says of it.
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "model/engine.h"
#include "model/reference/reference.h"

namespace kagesen::stress {

using EngineFactory = std::function<std::unique_ptr<Engine>()>;

/// How a unit is set up.
struct Setting {
  UnitConfig config;
  bool facet_hints = true;  ///< false: the unit is told nothing of the mesh
};

/// The exact verdicts of a trace, computed when first asked for. Keeps a reference to it.
class Subject {
 public:
  explicit Subject(const Trace& trace) : trace_(trace) {}
  const Trace& trace() const { return trace_; }
  const ExactReference& reference() const;
  /// A fragment each, 1 = dark; decided by definition where it is averted, outside or off the map.
  const std::vector<std::uint8_t>& exact(Semantics semantics) const;

 private:
  const Trace& trace_;
  mutable std::optional<ExactReference> reference_;
  mutable std::optional<std::vector<std::uint8_t>> exact_[2];
};

/// Is the fragment neither averted nor outside nor off the map?
bool is_judged(const Trace& trace, const Fragment& fragment);

struct Answer {
  std::vector<Verdict> verdicts;
  std::vector<std::uint8_t> overflowed;  ///< a texel each; empty: there was room for everything
  bool in_overflow(const Trace& trace, const Fragment& fragment) const;
};

/// The configuration, with the trace's own map.
UnitConfig config_for(const Trace& trace, const Setting& setting);
/// What the host prepares of the frame for a unit that is set up like this.
FrameSetup frame_setup(const Trace& trace, const Setting& setting);
/// Both passes. `portions` other than 0: records come in portions of up to that many, and
/// fragments from the last to the first.
Answer ask(const Trace& trace, const Setting& setting, const FrameSetup& setup, Engine& engine,
           std::size_t portions = 0);
Answer ask(const Trace& trace, const Setting& setting, const EngineFactory& make_engine);

}  // namespace kagesen::stress

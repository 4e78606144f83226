#include "tests/stress/subject.h"

#include <algorithm>

#include "model/frame_setup.h"
#include "tests/stress/contract.h"

namespace kagesen::stress {

const ExactReference& Subject::reference() const {
  if (!reference_) reference_.emplace(trace_.all_casters);
  return *reference_;
}

const std::vector<std::uint8_t>& Subject::exact(Semantics semantics) const {
  auto& exact = exact_[static_cast<std::size_t>(semantics)];
  if (!exact) {
    exact.emplace();
    exact->reserve(trace_.all_fragments.size());
    for (const Fragment& f : trace_.all_fragments) {
      const bool averted = (f.flags & Fragment::kAverted) != 0;
      exact->push_back(is_judged(trace_, f) ? reference().dark(f, semantics) : averted);
    }
  }
  return *exact;
}

bool is_judged(const Trace& trace, const Fragment& fragment) {
  return (fragment.flags & (Fragment::kAverted | Fragment::kOutside)) == 0 &&
         on_map(trace, fragment);
}

bool Answer::in_overflow(const Trace& trace, const Fragment& fragment) const {
  if (overflowed.empty() || !on_map(trace, fragment)) return false;
  const TraceHeader& h = trace.header;
  const std::int64_t x = (fragment.position.x >> h.fraction_bits) + h.map_width / 2;
  const std::int64_t y = (fragment.position.y >> h.fraction_bits) + h.map_height / 2;
  return overflowed[static_cast<std::size_t>(y * h.map_width + x)] != 0;
}

UnitConfig config_for(const Trace& trace, const Setting& setting) {
  UnitConfig config = setting.config;
  config.map_width = trace.header.map_width;
  config.map_height = trace.header.map_height;
  return config;
}

FrameSetup frame_setup(const Trace& trace, const Setting& setting) {
  FrameSetup setup = make_frame_setup(trace, config_for(trace, setting));
  if (!setting.facet_hints) {
    setup.facets.clear();
    setup.planes.clear();
    setup.unshadowable.clear();
  }
  return setup;
}

Answer ask(const Trace& trace, const Setting& setting, const FrameSetup& setup, Engine& engine,
           std::size_t portions) {
  const std::vector<Caster>& casters = trace.all_casters;
  const std::vector<Fragment>& fragments = trace.all_fragments;
  engine.begin(config_for(trace, setting), setup);
  const std::size_t by = portions ? portions : std::max(casters.size(), fragments.size()) + 1;
  for (std::size_t at = 0; at < fragments.size(); at += by) {
    engine.announce(fragments.data() + at, std::min(by, fragments.size() - at));
  }
  for (std::size_t at = 0; at < casters.size(); at += by) {
    engine.draw(casters.data() + at, std::min(by, casters.size() - at));
  }
  Answer answer;
  answer.verdicts.resize(fragments.size());
  if (portions) {
    std::vector<Fragment> turned(fragments.rbegin(), fragments.rend());
    for (std::size_t at = 0; at < turned.size(); at += by) {
      engine.decide(turned.data() + at, std::min(by, turned.size() - at),
                    answer.verdicts.data() + at);
    }
    std::reverse(answer.verdicts.begin(), answer.verdicts.end());
  } else {
    engine.decide(fragments.data(), fragments.size(), answer.verdicts.data());
  }
  if (engine.counters().overflow_texels > 0) answer.overflowed = engine.contents().overflowed;
  return answer;
}

Answer ask(const Trace& trace, const Setting& setting, const EngineFactory& make_engine) {
  const std::unique_ptr<Engine> engine = make_engine();
  return ask(trace, setting, frame_setup(trace, setting), *engine);
}

}  // namespace kagesen::stress

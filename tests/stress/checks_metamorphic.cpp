// Two traces whose verdicts are bound to each other.
#include "tests/stress/checks.h"
#include "tests/stress/contract.h"
#include "tests/stress/dice.h"
#include "tests/stress/transforms.h"

namespace kagesen::stress {
namespace {

/// The contract on another trace, which the result keeps.
CheckResult contract_of(Trace changed, const CheckInput& in) {
  const Subject subject(changed);
  CheckResult result = check_contract({subject, in.setting, in.seed, in.make_engine});
  if (!result.failed.empty()) result.changed = std::move(changed);
  return result;
}

}  // namespace

CheckResult check_translation(const CheckInput& in) {
  Dice dice(in.seed);
  const Trace& trace = in.subject.trace();
  Trace moved = trace;
  CheckResult result;
  if (!translate(moved, dice)) return result;
  const Answer here = ask(trace, in.setting, in.make_engine);
  const Answer there = ask(moved, in.setting, in.make_engine);
  if (!here.overflowed.empty() || !there.overflowed.empty()) return result;
  for (std::size_t i = 0; i < trace.all_fragments.size(); ++i) {
    if (on_map(trace, trace.all_fragments[i]) != on_map(moved, moved.all_fragments[i])) continue;
    ++result.compared;
    if (here.verdicts[i] != there.verdicts[i]) {
      result.failed.push_back(static_cast<std::uint32_t>(i));
    }
  }
  if (!result.failed.empty()) result.changed = std::move(moved);
  return result;
}

CheckResult check_turn(const CheckInput& in) {
  Dice dice(in.seed);
  Trace changed = in.subject.trace();
  if (!turn(changed, dice)) return {};
  return contract_of(std::move(changed), in);
}

CheckResult check_refinement(const CheckInput& in) {
  if (in.subject.trace().all_casters.empty()) return {};
  Dice dice(in.seed);
  bool exact = false;
  Trace changed = refined(in.subject.trace(), dice, exact);
  if (exact) {  // then nothing has changed, for the reference either
    const Semantics semantics = in.setting.config.semantics;
    CheckResult result;
    const Subject subject(changed);
    for (std::size_t i = 0; i < changed.all_fragments.size(); ++i) {
      if (subject.exact(semantics)[i] != in.subject.exact(semantics)[i]) {
        result.failed.push_back(static_cast<std::uint32_t>(i));
      }
    }
    if (!result.failed.empty()) return result;
  }
  return contract_of(std::move(changed), in);
}

CheckResult check_hidden(const CheckInput& in) {
  Dice dice(in.seed);
  const Trace& trace = in.subject.trace();
  Trace changed = trace;
  const std::uint32_t depth = add_hidden(changed, dice);
  CheckResult result;
  const Answer before = ask(trace, in.setting, in.make_engine);
  const Answer after = ask(changed, in.setting, in.make_engine);
  if (!before.overflowed.empty() || !after.overflowed.empty()) return result;
  for (std::size_t i = 0; i < trace.all_fragments.size(); ++i) {
    if (trace.all_fragments[i].position.z > depth) continue;
    ++result.compared;
    if (before.verdicts[i] != after.verdicts[i]) {
      result.failed.push_back(static_cast<std::uint32_t>(i));
    }
  }
  if (!result.failed.empty()) result.changed = std::move(changed);
  return result;
}

}  // namespace kagesen::stress

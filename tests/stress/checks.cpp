// One trace, one or two settings: the contract, and what must not change a verdict.
#include "tests/stress/checks.h"

#include "model/reference/cause.h"
#include "tests/stress/contract.h"
#include "tests/stress/dice.h"
#include "tests/stress/transforms.h"

namespace kagesen::stress {
namespace {

constexpr double kOnOutline = 2;  // units; the reference tells distances to one

void set_skips(UnitConfig& c, unsigned bits) {
  c.skip_receiver_mask = bits & 1;
  c.skip_first_test = bits & 2;
  c.skip_tiles = bits & 4;
  c.skip_edges = bits & 8;
  c.skip_fragments = bits & 16;
}

/// Fragments whose verdicts differ. Where room ran out, order may matter: nothing is compared.
void compare(const Answer& a, const Answer& b, CheckResult& result) {
  if (!a.overflowed.empty() || !b.overflowed.empty()) return;
  result.compared += a.verdicts.size();
  for (std::size_t i = 0; i < a.verdicts.size(); ++i) {
    if (a.verdicts[i] != b.verdicts[i]) result.failed.push_back(static_cast<std::uint32_t>(i));
  }
}

}  // namespace

const std::vector<Check>& checks() {
  constexpr Profile kWinding = Profile::kWinding, kPaper = Profile::kPaper;
  static const std::vector<Check> all = {
      {"contract", "verdicts beyond the bound", kWinding, true, check_contract},
      {"skips", "verdicts that differ with other skips", kWinding, false, check_skips},
      {"order", "verdicts that differ in another order of casters and vertices", kWinding, false,
       check_order},
      {"portions", "verdicts that differ when records come in portions", kWinding, false,
       check_portions},
      {"translation", "verdicts that differ after a move by whole texels", kWinding, false,
       check_translation},
      {"turn", "verdicts beyond the bound after mirroring and turning", kWinding, true, check_turn},
      {"refinement", "verdicts beyond the bound once triangles are cut", kWinding, true,
       check_refinement},
      {"hidden", "verdicts changed by geometry behind", kWinding, false, check_hidden},
      {"causes", "wrong verdicts of no known cause", kPaper, false, check_causes},
      {"paper_portions", "verdicts that differ when records come in portions", kPaper, false,
       check_portions},
      {"paper_translation", "verdicts that differ after a move by whole texels", kPaper, false,
       check_translation},
      {"paper_hidden", "verdicts changed by geometry behind", kPaper, false, check_hidden},
  };
  return all;
}

const Check* find_check(const std::string& name) {
  for (const Check& check : checks()) {
    if (check.name == name) return &check;
  }
  return nullptr;
}

CheckResult check_contract(const CheckInput& in) {
  const Trace& trace = in.subject.trace();
  const UnitConfig& config = in.setting.config;
  const Answer answer = ask(trace, in.setting, in.make_engine);
  const std::vector<std::uint8_t>& exact = in.subject.exact(config.semantics);
  CheckResult result;
  result.judged = exact.size();
  for (std::size_t i = 0; i < exact.size(); ++i) {
    const Fragment& f = trace.all_fragments[i];
    const bool dark = answer.verdicts[i] == Verdict::kDark;
    if (dark == (exact[i] != 0)) continue;
    // What is decided by definition has no bound to be within.
    const bool breaks =
        !is_judged(trace, f) || (breaks_contract(trace, config, in.subject.reference(), f, dark) &&
                                 !answer.in_overflow(trace, f));
    if (breaks) result.failed.push_back(static_cast<std::uint32_t>(i));
  }
  return result;
}

CheckResult check_skips(const CheckInput& in) {
  Dice dice(in.seed);
  Setting other = in.setting;
  switch (dice.in(0, 3)) {
    case 0:
      set_skips(other.config, 0);
      break;
    case 1:
      set_skips(other.config, 31);
      break;
    case 2:  // one skip alone
      set_skips(other.config, 1u << dice.in(0, 4));
      break;
    default:
      set_skips(other.config, static_cast<unsigned>(dice.in(0, 31)));
  }
  CheckResult result;
  compare(ask(in.subject.trace(), in.setting, in.make_engine),
          ask(in.subject.trace(), other, in.make_engine), result);
  result.other = other;
  return result;
}

CheckResult check_order(const CheckInput& in) {
  Dice dice(in.seed);
  const Trace& trace = in.subject.trace();
  FrameSetup setup = frame_setup(trace, in.setting);
  const std::unique_ptr<Engine> engine = in.make_engine();
  const Answer before = ask(trace, in.setting, setup, *engine);
  CheckResult result;
  result.changed = shuffled(trace, dice, &setup);
  // Either the hints go with their casters, or the host works them out anew.
  if (dice.one_in(2)) setup = frame_setup(*result.changed, in.setting);
  compare(before, ask(*result.changed, in.setting, setup, *engine), result);
  return result;
}

CheckResult check_portions(const CheckInput& in) {
  Dice dice(in.seed);
  const Trace& trace = in.subject.trace();
  const FrameSetup setup = frame_setup(trace, in.setting);
  const std::unique_ptr<Engine> engine = in.make_engine();
  CheckResult result;
  const Answer before = ask(trace, in.setting, setup, *engine);
  const auto portion = static_cast<std::size_t>(dice.magnitude(7) + 1);
  compare(before, ask(trace, in.setting, setup, *engine, portion), result);
  return result;
}

CheckResult check_causes(const CheckInput& in) {
  const Trace& trace = in.subject.trace();
  const FrameSetup setup = frame_setup(trace, in.setting);
  const std::unique_ptr<Engine> engine = in.make_engine();
  const Answer answer = ask(trace, in.setting, setup, *engine);
  const std::vector<std::uint8_t>& exact = in.subject.exact(Semantics::kPaper);
  const MapContents contents = engine->contents();
  const UnitConfig config = config_for(trace, in.setting);
  const CauseFinder finder(trace, config, setup, contents, in.subject.reference());
  CheckResult result;
  result.judged = exact.size();
  for (std::size_t i = 0; i < exact.size(); ++i) {
    const Fragment& f = trace.all_fragments[i];
    if ((answer.verdicts[i] == Verdict::kDark) == (exact[i] != 0)) continue;
    // On the outline itself it is a convention which texel's lines tell of it: that has no name.
    const double distance = in.subject.reference().boundary_distance(
        f.position, f.object, Semantics::kPaper, 2 * kOnOutline);
    if (!is_judged(trace, f) ||
        (distance > kOnOutline && finder.find(f, exact[i] != 0) == Cause::kOther)) {
      result.failed.push_back(static_cast<std::uint32_t>(i));
    }
  }
  return result;
}

}  // namespace kagesen::stress

#include "tests/stress/case.h"

#include <fmt/format.h>

#include <initializer_list>

#include "tests/stress/fragments.h"

namespace kagesen::stress {
namespace {

/// Every width and policy that the contract must hold for; half of the cases keep most defaults.
UnitConfig winding_config(Dice& dice) {
  UnitConfig c;
  c.profile = Profile::kWinding;
  c.fraction_bits = dice.one_in(3) ? 8 : dice.in(4, 12);
  if (dice.one_in(2)) {
    // With a single guard bit a stored plane may lie farther off than the contact distance.
    c.end_guard_bits = dice.in(2, 4);
    c.gradient_bits = dice.in(3, 10);
    c.plane_step_bits = dice.in(0, 8);
    c.plane_tolerance = dice.one_in(3) ? 0 : dice.magnitude(12);
    c.segments_per_record = dice.in(1, 8);
  }
  c.skip_receiver_mask = dice.one_in(2);
  c.skip_first_test = dice.one_in(2);
  c.skip_tiles = dice.one_in(2);
  c.skip_edges = dice.one_in(2);
  c.skip_fragments = dice.one_in(2);
  return c;
}

UnitConfig paper_config(Dice& dice) {
  UnitConfig c;
  if (dice.one_in(2)) {
    c.fraction_bits = dice.in(2, 15);
    c.slope_bits = dice.in(2, 15);
    c.lines_per_entry = dice.in(1, 8);
    c.hidden_removal =
        dice.pick({HiddenRemoval::kOff, HiddenRemoval::kCentre, HiddenRemoval::kFarthest});
  }
  c.slb_buckets = 1 << 10;
  c.slb_entries = 1 << 15;
  return c;
}

class Planner {
 public:
  Planner(Dice& dice, const CaseOptions& options) : dice_(dice), options_(options) {}

  void add(const char* name, Setting setting) {
    for (const std::string& key : options_.given) {
      set_field(setting.config, key, get_field(options_.config, key));
    }
    plan.push_back({find_check(name), setting, dice_.next()});
  }
  /// One of several, or none.
  void add_one(std::initializer_list<const char*> names, const Setting& setting) {
    add(dice_.pick(names), setting);
  }

  std::vector<PlannedCheck> plan;

 private:
  Dice& dice_;
  const CaseOptions& options_;
};

void plan_winding(const UnitConfig& config, Dice& dice, Planner& planner) {
  Setting setting{config, !dice.one_in(4)};
  for (const Semantics semantics : {Semantics::kPhysical, Semantics::kPaper}) {
    setting.config.semantics = semantics;
    planner.add("contract", setting);
    planner.add("skips", setting);
    if (dice.one_in(2)) planner.add("order", setting);
    if (dice.one_in(2)) {
      planner.add_one({"portions", "translation", "turn", "refinement", "hidden"}, setting);
    }
  }
  if (dice.one_in(8)) {  // hardly any room
    setting.config.cluster_records = dice.magnitude(8);
    setting.config.corner_bits = dice.in(2, 4);
    planner.add("contract", setting);
  }
}

void plan_paper(Dice& dice, Planner& planner) {
  const Setting setting{paper_config(dice), true};
  planner.add("causes", setting);
  planner.add_one({"paper_portions", "paper_translation", "paper_hidden"}, setting);
}

}  // namespace

const Family& family_of(std::uint64_t number) { return families()[number % families().size()]; }

StressCase make_case(std::uint64_t seed, std::uint64_t number, const CaseOptions& options) {
  Dice dice = Dice::of_case(seed, number);
  StressCase out;
  out.number = number;
  out.family = &family_of(number);
  Builder builder(dice, out.trace);
  out.family->build(builder);
  TraceHeader& header = out.trace.header;
  header.source = fmt::format("stress seed {} case {} ({})", seed, number, out.family->name);
  header.seed = seed;

  // Fragments are placed by the bounds that the configuration sets, so it is drawn first.
  UnitConfig config = winding_config(dice);
  const bool thorough = dice.one_in(4);
  const auto count = static_cast<std::size_t>(thorough ? dice.in(1000, 3000) : dice.in(200, 1000));
  place_fragments(out.trace, config, count, dice);

  Planner planner(dice, options);
  if (options.profile != Profile::kPaper) plan_winding(config, dice, planner);
  if (options.profile != Profile::kWinding && (options.profile || dice.one_in(3))) {
    plan_paper(dice, planner);
  }
  out.plan = std::move(planner.plan);
  return out;
}

}  // namespace kagesen::stress

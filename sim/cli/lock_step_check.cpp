#include "sim/cli/lock_step_check.h"

#include <algorithm>
#include <set>

#include "sim/cli/cycle_check.h"

namespace kagesen {
namespace {

using stress::CheckInput;
using stress::CheckResult;
using stress::Dice;
using stress::PlannedCheck;

CheckResult check_lock_step(const CheckInput& in) {
  Dice dice = Dice::of_case(in.seed, 0);
  RtlOptions options;
  options.kind = BuildKind::kCheck;
  options.timing = draw_timing(dice);
  options.keep_cycles = true;
  RtlEngine engine(options);
  SystemcEngine model({options.timing, true});
  const Trace& trace = in.subject.trace();
  Frame frame{trace, config_for(trace, in.setting), frame_setup(trace, in.setting)};
  if (dice.one_in(4)) frame.portions = static_cast<std::size_t>(dice.in(1, 200));
  const Expected expected = expect(frame);
  const LockStepResult lock = lock_step(frame, expected, engine);
  CheckResult result;
  result.compared = trace.all_fragments.size();
  result.failed = lock.wrong_fragments;
  if (!lock.equal() && result.failed.empty()) result.failed.push_back(0);
  if (lock.equal()) {
    const CycleCheck cycles = check_cycles(frame, expected, engine, model);
    if (cycles.verdict_differences + cycles.cycle_differences > 0) {
      result.failed.push_back(static_cast<std::uint32_t>(cycles.first_fragment));
    }
  }
  return result;
}

std::string text_of(const stress::Setting& setting) {
  std::string text = setting.facet_hints ? "hints" : "";
  for (const ConfigField& field : config_fields()) {
    text += " " + get_field(setting.config, field.key);
  }
  return text;
}

}  // namespace

const std::vector<std::string>& width_keys() {
  static const std::vector<std::string> keys = {
      "fraction_bits",   "slope_bits",      "depth_bits",       "id_bits",
      "polygon_id_bits", "position_bits",   "lines_per_entry",  "end_guard_bits",
      "gradient_bits",   "plane_step_bits", "corner_bits",      "segments_per_record",
      "lanes",           "fragment_slots",  "visit_fifo_depth", "texel_lines",
      "record_lines"};
  return keys;
}

void draw_registers(Dice& dice, UnitConfig& c) {
  c.own_id_rule = dice.pick({OwnIdRule::kPerSource, OwnIdRule::kLiteral});
  c.vertex_rule = dice.pick({VertexRule::kPerLine, VertexRule::kPerEntry});
  c.table7 = dice.pick({Table7::kCorrected, Table7::kPrinted});
  c.depth_writes = dice.pick({DepthWrites::kCovered, DepthWrites::kAll});
  c.hidden_removal =
      dice.pick({HiddenRemoval::kOff, HiddenRemoval::kCentre, HiddenRemoval::kFarthest});
  c.match_polygon_id = dice.one_in(2);
  c.slb_buckets = std::int64_t{1} << dice.in(0, 14);
  c.semantics = dice.pick({Semantics::kPaper, Semantics::kPhysical});
  c.plane_tolerance = dice.one_in(2) ? 16 : dice.in(0, 200);
  for (bool* skip : {&c.skip_receiver_mask, &c.skip_first_test, &c.skip_tiles, &c.skip_edges,
                     &c.skip_fragments}) {
    *skip = !dice.one_in(3);
  }
  if (!dice.one_in(4)) return;
  // Hardly any room.
  c.slb_entries = std::max<std::int64_t>(1, dice.magnitude(10));
  c.link_depth = std::max<std::int64_t>(1, dice.magnitude(3));
  c.cluster_records = std::max<std::int64_t>(1, dice.magnitude(10));
  c.chain_records = std::max<std::int64_t>(1, dice.magnitude(3));
}

Timing draw_timing(Dice& dice) {
  Timing timing;
  const auto draw = [&](std::int64_t low, std::int64_t high) {
    return static_cast<std::uint32_t>(dice.in(low, high));
  };
  timing.seed = draw(0, 1 << 30);
  if (dice.one_in(2)) return timing;
  timing.latency = draw(1, dice.one_in(4) ? 200 : 60);
  timing.spread = dice.one_in(2) ? 0 : draw(1, 100);
  timing.memory_stall = dice.one_in(2) ? 0 : draw(1, 70);
  timing.stream_stall = dice.one_in(2) ? 0 : draw(1, 70);
  if (dice.one_in(2)) {
    timing.interval = draw(1, 4);
    timing.outstanding = dice.one_in(2) ? 0 : draw(1, 20);
  }
  if (dice.one_in(4)) {
    timing.banks = dice.pick({1u, 2u, 4u, 8u});
    timing.bank_busy = draw(1, 6);
    timing.row_words = dice.pick({0u, 4u, 64u});
    timing.row_miss = draw(0, 12);
  }
  // From tiny to as large as such a frame's memories.
  for (CacheShape* cache : {&timing.texel_cache, &timing.slb_cache}) {
    if (!dice.one_in(3)) continue;
    cache->lines = static_cast<std::uint32_t>(dice.magnitude(10));
    cache->ways = draw(1, 4);
    cache->line_words = dice.pick({1u, 2u, 3u, 8u});
  }
  timing.cache_latency = draw(1, 10);
  return timing;
}

const stress::Check& lock_step_check() {
  static const stress::Check check = {"lock_step", "the Verilog and golden, or the cycles of SystemC, disagree",
                                      Profile::kPaper, false, check_lock_step};
  return check;
}

void plan_lock_step(stress::StressCase& test) {
  std::set<std::string> known;
  std::vector<PlannedCheck> plan;
  for (PlannedCheck planned : test.plan) {
    planned.check = &lock_step_check();
    if (known.insert(text_of(planned.setting)).second) plan.push_back(planned);
  }
  // Once more, with what the suite leaves alone.
  if (!plan.empty()) {
    PlannedCheck drawn = plan.back();
    Dice dice = Dice::of_case(drawn.seed, 1);
    draw_registers(dice, drawn.setting.config);
    drawn.seed = dice.next();
    plan.push_back(drawn);
  }
  test.plan = std::move(plan);
}

}  // namespace kagesen

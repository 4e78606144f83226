#include "sim/cli/soak/rounds.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <utility>

#include "model/frame_setup.h"
#include "traces/raster/capture.h"
#include "traces/scene/scene.h"

namespace kagesen {
namespace {

using stress::Dice;

/// A million triangles take pass 1 minutes: once a profile.
constexpr const char* kHuge = "sphere1m";

struct SetFrame {
  std::string scene;
  int scale;
  Profile profile;
};

std::vector<SetFrame> frames_of_set(const std::optional<Profile>& only) {
  std::vector<SetFrame> frames;
  const auto add = [&](const std::string& scene, int scale) {
    for (const Profile profile : {Profile::kPaper, Profile::kWinding}) {
      if (!only || *only == profile) frames.push_back({scene, scale, profile});
    }
  };
  for (const int scale : {1, 16, 256}) {
    for (const SceneInfo& info : builtin_scenes()) {
      if (info.name != kHuge) add(info.name, scale);
    }
  }
  add(kHuge, 1);
  return frames;
}

void capture_scene(const std::string& scene, double scale, CaptureOptions capture, Round& round) {
  round.family = "scene " + scene;
  capture.scale_x = capture.scale_y = scale;
  kagesen::capture(make_builtin(scene), capture, round.trace);
}

void draw_scene(Dice& dice, Round& round) {
  std::vector<SceneInfo> scenes = builtin_scenes();
  scenes.erase(std::remove_if(scenes.begin(), scenes.end(),
                              [](const SceneInfo& info) { return info.name == kHuge; }),
               scenes.end());
  CaptureOptions capture;
  capture.map_width = static_cast<std::uint32_t>(dice.pick({64, 100, 256, 512, 1024}));
  capture.map_height =
      dice.one_in(4) ? static_cast<std::uint32_t>(dice.in(1, 1024)) : capture.map_width;
  const int side = dice.small(1, 3);  // of sixths of full HD
  capture.image_width = static_cast<std::uint32_t>(320 * side);
  capture.image_height = static_cast<std::uint32_t>(180 * side);
  const std::string scene = scenes[dice.index(scenes)].name;
  capture_scene(scene, dice.pick({1.0, 1.0, 4.0, 16.0, 64.0, 256.0}), capture, round);
}

void draw_stress(const RoundPlan& plan, std::uint64_t seed, std::uint64_t number, Profile profile,
                 Round& round) {
  stress::CaseOptions options;
  options.profile = profile;
  options.config = plan.config;
  for (const std::string& key : width_keys()) options.given.insert(key);
  stress::StressCase test = stress::make_case(seed, number, options);
  round.family = test.family->name;
  if (!test.plan.empty()) round.config = test.plan[number % test.plan.size()].setting.config;
  round.trace = std::move(test.trace);
}

/// Memories that answer out of order, and seldom take nothing: as many fragments as possible.
Timing draw_quick_timing(Dice& dice) {
  Timing timing;
  timing.seed = static_cast<std::uint64_t>(dice.in(0, 1 << 30));
  timing.latency = static_cast<std::uint32_t>(dice.in(1, 60));
  timing.spread = dice.one_in(2) ? 0 : static_cast<std::uint32_t>(dice.in(1, 60));
  timing.memory_stall = dice.one_in(2) ? 0 : static_cast<std::uint32_t>(dice.in(1, 20));
  timing.stream_stall = dice.one_in(4) ? static_cast<std::uint32_t>(dice.in(1, 20)) : 0;
  return timing;
}

/// Other widths are another build of the Verilog, so each shape holds for many frames: as it is
/// configured, then with more lanes and, once, a finer grid of segments' ends.
void draw_shape(std::uint64_t number, UnitConfig& config) {
  constexpr std::uint64_t kFrames = 40;
  const std::uint64_t shape = number / kFrames % 4;
  if (shape > 0) config.lanes = 1 + static_cast<std::int64_t>(shape);
  if (shape == 2 && config.profile == Profile::kWinding) config.end_guard_bits = 4;
}

void add_differences(std::uint64_t count, const std::string& what, LockStepResult& result) {
  result.verdict_differences += count;
  if (count == 0 || result.first) return;
  result.first.emplace();
  result.first->kind = "repeat";
  result.first->lines = {what};
}

}  // namespace

Round draw_round(const RoundPlan& plan, std::uint64_t seed, std::uint64_t number) {
  Dice dice = Dice::of_case(seed, number);
  Round round;
  round.config = plan.config;
  const bool hints = !dice.one_in(4);
  Profile profile = plan.profile.value_or(dice.one_in(2) ? Profile::kPaper : Profile::kWinding);
  const std::vector<SetFrame> set = frames_of_set(plan.profile);
  const std::uint64_t lap = number / 2 / set.size();
  const SetFrame& frame = set[number / 2 % set.size()];
  if (number % 2 == 0 && (lap == 0 || frame.scene != kHuge)) {
    CaptureOptions capture;
    capture.image_width = plan.image_width;
    capture.image_height = plan.image_height;
    profile = frame.profile;
    capture_scene(frame.scene, frame.scale, capture, round);
    round.family += fmt::format(" x{}", frame.scale);
    round.timing = draw_quick_timing(dice);
    for (int i = 0; i < 2; ++i) round.again.push_back(draw_quick_timing(dice));
  } else {
    if (dice.one_in(4)) {
      draw_scene(dice, round);
    } else {
      draw_stress(plan, seed, number, profile, round);
    }
    if (dice.one_in(8)) round.portions = static_cast<std::size_t>(dice.in(1, 5000));
    round.cuts = dice.one_in(2) ? 0 : static_cast<std::uint64_t>(dice.in(1, 3));
    round.timing = draw_timing(dice);
    if (dice.one_in(2)) round.again.push_back(draw_timing(dice));
  }
  round.config.profile = profile;
  // The set's first lap is as a person would run it.
  if ((number % 2 == 1 || lap > 0) && !dice.one_in(4)) draw_registers(dice, round.config);
  draw_shape(number, round.config);
  round.config.map_width = round.trace.header.map_width;
  round.config.map_height = round.trace.header.map_height;
  round.setup = stress::frame_setup(round.trace, {round.config, hints});
  round.cut_seed = dice.next();
  round.order_seed = dice.next();
  return round;
}

RoundRunner::RoundRunner(BuildKind kind) {
  RtlOptions options;
  options.kind = kind;
  options.keep_cycles = true;
  engine_ = std::make_unique<RtlEngine>(options);
}

LockStepResult RoundRunner::run(const Round& round) {
  const Frame frame{round.trace, round.config, round.setup, round.portions};
  expected_ = expect(frame);
  engine_->set_timing(round.timing);
  LockStepResult result;
  try {
    engine_->prepare(round.config).write(bench::Register::kCounterSelect, 0);
    for (std::uint64_t i = 0; i < round.cuts && cycles_; ++i) {
      cut_frame(frame, *engine_,
                i % 2 == 0 ? bench::Bench::Cut::kAbort : bench::Bench::Cut::kReset,
                round.cut_seed + i, *cycles_);
    }
    result = lock_step(frame, expected_, *engine_);
    if (result.cycles) cycles_ = result.cycles;
    if (result.failures == 0) {
      check_registers(result);
      check_model(round, frame, result);
      decide_again(round, result);
    }
  } catch (const bench::Failure& failure) {
    ++result.failures;
    if (!result.first) {
      result.first.emplace();
      result.first->kind = "failure";
      result.first->lines = {failure.what()};
    }
  }
  if (result.failures > 0) engine_->bench().reset();
  return result;
}

/// SystemC gives golden's verdicts in the Verilog's cycles.
void RoundRunner::check_model(const Round& round, const Frame& frame, LockStepResult& result) {
  model_.set_timing(round.timing);
  const CycleCheck check = check_cycles(frame, expected_, *engine_, model_);
  result.verdict_differences += check.verdict_differences;
  result.cycle_differences += check.cycle_differences;
  if (check.first.empty() || result.first) return;
  result.first.emplace();
  result.first->kind = "cycles";
  result.first->lines = check.first;
}

/// What a driver reads after pass 2 is what the bench saw.
void RoundRunner::check_registers(LockStepResult& result) {
  using bench::Register;
  bench::Bench& bench = engine_->bench();
  const bool overflow = bench.events().overflow_texels > 0;
  const std::pair<Register, std::uint32_t> wanted[] = {
      {Register::kIdentity, 0x4b470001u},
      {Register::kControl, 0},
      {Register::kStatus, std::uint32_t{overflow} << 8},
      {Register::kCounterSelect, 0}};
  for (const auto& [at, value] : wanted) {
    const std::uint32_t read = bench.read(at);
    if (read == value) continue;
    ++result.counter_differences;
    if (result.first) continue;
    result.first.emplace();
    result.first->kind = "counter";
    result.first->lines = {fmt::format("register {:#04x} reads {:#x} instead of {:#x}",
                                       static_cast<unsigned>(at), read, value)};
  }
}

void RoundRunner::decide_again(const Round& round, LockStepResult& result) {
  const std::vector<Fragment>& fragments = round.trace.all_fragments;
  std::vector<std::size_t> order(fragments.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  Dice dice(round.order_seed);
  std::vector<Fragment> shuffled(fragments.size());
  std::vector<Verdict> verdicts(fragments.size());
  for (const Timing& timing : round.again) {
    for (std::size_t i = order.size(); i > 1; --i) {
      std::swap(order[i - 1], order[static_cast<std::size_t>(dice.in(0, std::int64_t(i) - 1))]);
    }
    for (std::size_t i = 0; i < order.size(); ++i) shuffled[i] = fragments[order[i]];
    engine_->bench().set_timing(timing);
    engine_->decide(shuffled.data(), shuffled.size(), verdicts.data());
    std::uint64_t wrong = 0;
    for (std::size_t i = 0; i < order.size(); ++i) {
      wrong += verdicts[i] != expected_.verdicts[order[i]];
    }
    result.fragments += order.size();
    add_differences(wrong, fmt::format("{} verdicts of pass 2, run once more", wrong), result);
  }
}

std::vector<std::string> RoundRunner::wave(const Round& round, const FirstDifference& first,
                                           const std::string& path) const {
  const Frame frame{round.trace, round.config, round.setup, round.portions};
  return write_wave(frame, expected_, first, round.timing, path);
}

std::uint64_t differences(const LockStepResult& r) {
  return r.verdict_differences + r.buffer_differences + r.counter_differences +
         r.cycle_differences + r.failures;
}

}  // namespace kagesen

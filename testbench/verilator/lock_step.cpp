#include "testbench/verilator/lock_step.h"

#include <fmt/format.h>

#include <algorithm>

#include "testbench/verilator/compare.h"

namespace kagesen {
namespace {

constexpr std::uint64_t kWaveCycles = 1000;

const char* name_of(Verdict v) { return v == Verdict::kDark ? "dark" : "lit"; }

/// Calls use(at, count) for portions of `total`.
template <typename Use>
void in_portions(std::size_t total, std::size_t portion, Use use) {
  const std::size_t by = portion ? portion : total + 1;
  for (std::size_t at = 0; at < total; at += by) use(at, std::min(by, total - at));
}

void first_pass(const Frame& frame, std::size_t casters, Engine& engine) {
  const std::vector<Fragment>& fragments = frame.trace.all_fragments;
  engine.begin(frame.config, frame.setup);
  in_portions(fragments.size(), frame.portions, [&](std::size_t at, std::size_t count) {
    engine.announce(fragments.data() + at, count);
  });
  in_portions(casters, frame.portions, [&](std::size_t at, std::size_t count) {
    engine.draw(frame.trace.all_casters.data() + at, count);
  });
}

void second_pass(const Frame& frame, std::size_t fragments, Engine& engine,
                 std::vector<Verdict>& verdicts) {
  verdicts.assign(frame.trace.all_fragments.size(), Verdict::kLit);
  in_portions(fragments, frame.portions, [&](std::size_t at, std::size_t count) {
    engine.decide(frame.trace.all_fragments.data() + at, count, verdicts.data() + at);
  });
}

void add_texel(std::vector<std::string>& lines, const char* whose, const MapContents& contents,
               std::uint32_t x, std::uint32_t y) {
  for (const std::string& line : texel_lines(contents, x, y)) {
    lines.push_back(fmt::format("  {:<7}{}", whose, line));
  }
}

FirstDifference buffer_difference(const MapContents& golden, const MapContents& rtl,
                                  std::uint32_t x, std::uint32_t y) {
  FirstDifference first;
  first.kind = "buffer";
  first.x = x;
  first.y = y;
  first.lines.push_back(fmt::format("texel ({}, {}) after pass 1:", x, y));
  add_texel(first.lines, "golden", golden, x, y);
  add_texel(first.lines, "rtl", rtl, x, y);
  return first;
}

FirstDifference verdict_difference(const Frame& frame, const Expected& expected,
                                   const MapContents& rtl, std::size_t at, Verdict rtl_verdict) {
  const Fragment& f = frame.trace.all_fragments[at];
  const auto texel = [&](std::int32_t place, std::int64_t side) {
    return (place >> frame.setup.fraction_bits) + static_cast<std::int32_t>(side / 2);
  };
  const std::int32_t x = texel(f.position.x, frame.config.map_width);
  const std::int32_t y = texel(f.position.y, frame.config.map_height);
  FirstDifference first;
  first.kind = "verdict";
  first.fragment = at;
  first.lines.push_back(
      fmt::format("fragment {} of object {} at ({}, {}, {}), texel ({}, {}): golden {}, rtl {}", at,
                  f.object, f.position.x, f.position.y, f.position.z, x, y,
                  name_of(expected.verdicts[at]), name_of(rtl_verdict)));
  add_texel(first.lines, "golden", expected.contents, static_cast<std::uint32_t>(x),
            static_cast<std::uint32_t>(y));
  add_texel(first.lines, "rtl", rtl, static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y));
  return first;
}

void compare_all(const Frame& frame, const Expected& expected, RtlEngine& engine,
                 LockStepResult& result) {
  first_pass(frame, frame.trace.all_casters.size(), engine);
  const MapContents contents = engine.contents();
  const BufferDifferences buffers = compare_contents(expected.contents, contents);
  result.buffer_differences = buffers.texels;
  if (buffers.texels > 0) {
    result.first = buffer_difference(expected.contents, contents, buffers.first_x, buffers.first_y);
  }
  std::vector<Verdict> verdicts;
  second_pass(frame, frame.trace.all_fragments.size(), engine, verdicts);
  for (std::size_t i = 0; i < verdicts.size(); ++i) {
    if (verdicts[i] == expected.verdicts[i]) continue;
    ++result.verdict_differences;
    result.wrong_fragments.push_back(static_cast<std::uint32_t>(i));
    if (!result.first) {
      result.first = verdict_difference(frame, expected, contents, i, verdicts[i]);
    }
  }
  const std::vector<std::string> counters = compare_counters(expected.counters, engine.counters());
  result.counter_differences = counters.size();
  if (!counters.empty() && !result.first) {
    result.first.emplace();
    result.first->kind = "counter";
    result.first->lines = counters;
  }
  result.cycles = engine.cycles();
}

/// How many triangles it takes for the texel to differ.
std::size_t triangles_to_differ(const Frame& frame, std::uint32_t x, std::uint32_t y,
                                RtlEngine& engine) {
  const auto differs = [&](std::size_t casters) {
    const std::unique_ptr<Engine> golden = make_golden_engine();
    first_pass(frame, casters, *golden);
    first_pass(frame, casters, engine);
    return texel_lines(golden->contents(), x, y) != texel_lines(engine.contents(), x, y);
  };
  std::size_t equal = 0, different = frame.trace.all_casters.size();
  while (equal + 1 < different) {
    const std::size_t middle = equal + (different - equal) / 2;
    (differs(middle) ? different : equal) = middle;
  }
  return different;
}

}  // namespace

Expected expect(const Frame& frame) {
  Expected out;
  const std::unique_ptr<Engine> golden = make_golden_engine();
  first_pass(frame, frame.trace.all_casters.size(), *golden);
  out.contents = golden->contents();
  second_pass(frame, frame.trace.all_fragments.size(), *golden, out.verdicts);
  out.counters = golden->counters();
  return out;
}

std::vector<Verdict> run_frame(const Frame& frame, Engine& engine) {
  std::vector<Verdict> verdicts;
  first_pass(frame, frame.trace.all_casters.size(), engine);
  second_pass(frame, frame.trace.all_fragments.size(), engine, verdicts);
  return verdicts;
}

LockStepResult lock_step(const Frame& frame, const Expected& expected, RtlEngine& engine) {
  LockStepResult result;
  result.fragments = frame.trace.all_fragments.size();
  try {
    compare_all(frame, expected, engine, result);
  } catch (const bench::Failure& failure) {
    ++result.failures;
    if (!result.first) {
      result.first.emplace();
      result.first->kind = "failure";
      result.first->lines = {failure.what()};
    }
  }
  return result;
}

void cut_frame(const Frame& frame, RtlEngine& engine, bench::Bench::Cut how, std::uint64_t seed,
               const CycleReport& cycles) {
  bench::Bench& bench = engine.prepare(frame.config);
  const std::uint64_t passes[] = {*cycles.clear, *cycles.announce, cycles.pass1->total,
                                  *cycles.settle, cycles.pass2->total};
  // The draw wants no quality, only to differ from seed to seed.
  std::uint64_t state = seed * 0x9e3779b97f4a7c15u + 0x1234567;
  const auto draw = [&](std::uint64_t below) {
    state = state * 6364136223846793005u + 1442695040888963407u;
    return below ? (state >> 33) % below : 0;
  };
  std::uint64_t pass;
  do pass = draw(5);
  while (passes[pass] == 0);
  const std::uint64_t after = draw(passes[pass]);
  const auto cut_in = [&](std::uint64_t which) {
    if (which == pass) bench.cut_next_pass(how, after);
  };
  const Trace& trace = frame.trace;
  cut_in(0);
  engine.begin(frame.config, frame.setup);
  cut_in(1);
  if (passes[1] > 0) engine.announce(trace.all_fragments.data(), trace.all_fragments.size());
  cut_in(2);
  engine.draw(trace.all_casters.data(), trace.all_casters.size());
  cut_in(3);
  engine.settle();
  cut_in(4);
  std::vector<Verdict> verdicts(trace.all_fragments.size());
  engine.decide(trace.all_fragments.data(), trace.all_fragments.size(), verdicts.data());
}

std::vector<std::string> write_wave(const Frame& frame, const Expected& expected,
                                    const FirstDifference& first,
                                    const std::optional<Timing>& timing,
                                    const std::string& path) {
  RtlOptions options;
  options.kind = BuildKind::kTrace;
  options.timing = timing;
  options.keep_cycles = true;
  RtlEngine engine(options);
  bench::Bench& bench = engine.prepare(frame.config);
  std::vector<std::string> lines;

  std::size_t casters = frame.trace.all_casters.size();
  std::size_t fragments = first.kind == "verdict"  ? first.fragment + 1
                          : first.kind == "buffer" ? 0
                                                   : frame.trace.all_fragments.size();
  /// Runs up to the difference; how many cycles after the start it lies.
  const auto run = [&]() -> std::uint64_t {
    bench.reset();
    const std::uint64_t start = bench.now();
    try {
      first_pass(frame, casters, engine);
      if (first.kind == "buffer") return bench.now() - start;
      std::vector<Verdict> verdicts;
      second_pass(frame, fragments, engine, verdicts);
      if (first.kind == "verdict") {
        if (verdicts[first.fragment] == expected.verdicts[first.fragment]) {
          lines.push_back("the verdict is right when the frame runs alone");
        }
        return bench.pass_began() + engine.fragment_cycles()[first.fragment].retired -
               engine.decided_before() - start;
      }
    } catch (const bench::Failure& failure) {
      lines.push_back(failure.what());
    }
    return bench.now() - start;
  };

  try {
    if (first.kind == "buffer" && casters > 1) {
      casters = triangles_to_differ(frame, first.x, first.y, engine);
      lines.push_back(fmt::format("it begins with triangle {}", casters - 1));
    }
  } catch (const bench::Failure& failure) {
    lines.push_back(failure.what());
  }
  const std::uint64_t at = run();
  lines.push_back(fmt::format("cycle {} from the frame's start", at));
  // The reset takes a few cycles of the clock before the same run begins again.
  const std::uint64_t start = bench.now() + bench::Bench::kResetCycles;
  const std::uint64_t last = start + at;
  bench.trace(path.c_str(), last > start + kWaveCycles ? last - kWaveCycles : start, last);
  std::vector<std::string> kept = std::move(lines);
  run();
  bench.trace(nullptr, 0, 0);
  kept.push_back(fmt::format("waves of the last {} cycles: {}", std::min(kWaveCycles, at), path));
  return kept;
}

}  // namespace kagesen

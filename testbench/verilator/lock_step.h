#pragma once
/// One frame through the golden unit and the Verilated one: every verdict, the whole contents of
/// the buffers, every counter.
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "testbench/verilator/rtl_engine.h"
#include "traces/format/records.h"

namespace kagesen {

/// A frame as both engines get it. Keeps a reference to the trace.
struct Frame {
  const Trace& trace;
  UnitConfig config;
  FrameSetup setup;
  /// Both passes in portions of up to so many records; 0: at once.
  std::size_t portions = 0;
};

/// What golden made of a frame.
struct Expected {
  std::vector<Verdict> verdicts;
  MapContents contents;
  UnitCounters counters;
};
Expected expect(const Frame& frame);
/// Both passes through any engine.
std::vector<Verdict> run_frame(const Frame& frame, Engine& engine);

struct FirstDifference {
  std::string kind;                ///< "verdict", "buffer", "counter" or "failure"
  std::vector<std::string> lines;  ///< what a person wants to know
  std::uint64_t fragment = 0;      ///< verdict
  std::uint32_t x = 0, y = 0;      ///< buffer
};

struct LockStepResult {
  std::uint64_t fragments = 0;
  std::uint64_t verdict_differences = 0, buffer_differences = 0, counter_differences = 0;
  std::uint64_t cycle_differences = 0;  ///< from the SystemC model; lock_step() does not look
  std::uint64_t failures = 0;  ///< an assertion, or no progress
  std::vector<std::uint32_t> wrong_fragments;
  std::optional<CycleReport> cycles;
  std::optional<FirstDifference> first;
  bool equal() const {
    return verdict_differences + buffer_differences + counter_differences + cycle_differences +
               failures ==
           0;
  }
};

/// Runs the frame and compares. Failures of the bench are a difference too; the engine is then no
/// use any more.
LockStepResult lock_step(const Frame& frame, const Expected& expected, RtlEngine& engine);

/// Starts the frame and cuts it short in a pass drawn from `seed`, after a drawn number of cycles.
/// @param cycles  what a whole run took
void cut_frame(const Frame& frame, RtlEngine& engine, bench::Bench::Cut how, std::uint64_t seed,
               const CycleReport& cycles);

/// Looks for the difference again in a build with waves and writes those of the last thousand
/// cycles before it. Returns what it found out, a line each.
std::vector<std::string> write_wave(const Frame& frame, const Expected& expected,
                                    const FirstDifference& first,
                                    const std::optional<Timing>& timing,
                                    const std::string& path);

}  // namespace kagesen

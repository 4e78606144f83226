#pragma once
/// Frames of the stress suite with any policy, capacity and timing.
#include <cstdlib>
#include <random>
#include <string>

#include "model/frame_setup.h"
#include "sim/memory/timing.h"
#include "tests/stress/case.h"
#include "tests/stress/families.h"

namespace kagesen {

/// How many a test runs; KAGESEN_FRAMES: more, or fewer.
inline std::uint64_t random_frames() {
  const char* const given = std::getenv("KAGESEN_FRAMES");
  return given != nullptr ? std::stoull(given) : 40;
}

struct RandomFrame {
  explicit RandomFrame(std::uint64_t seed) : dice(static_cast<unsigned>(seed)) {
    stress::CaseOptions options;
    options.profile = Profile::kPaper;
    stress::StressCase c = stress::make_case(11, seed, options);
    trace = std::move(c.trace);
    // Small ones; of others, what fits.
    if (trace.all_casters.size() > 300) trace.all_casters.resize(300);
    const auto side = [](std::uint32_t of) { return std::min<std::int64_t>(of, 256); };
    config.map_width = side(trace.header.map_width);
    config.map_height = side(trace.header.map_height);
    config.depth_writes = chance(2) ? DepthWrites::kAll : DepthWrites::kCovered;
    config.hidden_removal = static_cast<HiddenRemoval>(dice() % 3);
    config.match_polygon_id = chance(2);
    config.slb_buckets = std::int64_t{1} << dice() % 9;
    if (chance(2)) config.slb_entries = 1 + static_cast<std::int64_t>(dice() % 100);
    if (chance(2)) config.link_depth = 1 + static_cast<std::int64_t>(dice() % 6);
    setup = make_frame_setup(trace, config);
    timing.latency = chance(4) ? 1 : 1 + dice() % (chance(2) ? 200 : 30);
    if (chance(2)) timing.spread = dice() % 80;
    if (chance(2)) timing.memory_stall = dice() % 80;
    if (chance(2)) timing.stream_stall = dice() % 80;
    if (chance(4)) timing.interval = 1 + dice() % 4;
    if (chance(4)) timing.outstanding = 1 + dice() % 8;
    timing.seed = dice();
    text = "frame " + std::to_string(seed) + " of " + c.family->name;
  }

  std::mt19937 dice;
  Trace trace;
  UnitConfig config;
  FrameSetup setup;
  Timing timing;
  std::string text;

 private:
  bool chance(unsigned one_in) { return dice() % one_in == 0; }
};

}  // namespace kagesen

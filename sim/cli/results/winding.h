#pragma once
/// What docs/results.md says of the winding profile: its errors, its memory, its skips, and the
/// conservative first test that one of them goes back to.
#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "model/engine.h"
#include "model/reference/judge.h"
#include "model/rivals/conservative_map.h"
#include "model/unit/config.h"
#include "traces/raster/capture.h"

namespace kagesen {

using Report = std::function<void(const std::string& stage, double done)>;  ///< may be empty

/// The winding profile with its defaults, set to a semantics.
UnitConfig winding_unit(Semantics semantics);

/// A semantics each.
template <class T>
struct InBoth {
  T paper{}, physical{};
  const T& in(Semantics semantics) const {
    return semantics == Semantics::kPaper ? paper : physical;
  }
  T& in(Semantics semantics) { return semantics == Semantics::kPaper ? paper : physical; }
};

/// The unit set to each semantics, held against that one.
struct WindingAccuracy {
  unsigned scale = 1;
  InBoth<ErrorFigures> errors;
  InBoth<EquivalentResolution> equivalent;
};

/// Bytes of the map and of the allocated records.
struct WindingMemory {
  struct Bytes {
    std::uint64_t without_mask = 0, with_mask = 0;
  };
  unsigned scale = 1;
  InBoth<Bytes> bytes;
};

/// All skips against none, and against all but one.
struct SkipUse {
  UnitCounters counters;         ///< with all of them
  std::uint64_t map_texels = 0;  ///< of the whole map
  std::uint64_t compared = 0;    ///< verdicts of all settings held against those with all skips
  std::uint64_t differing = 0;   ///< of these
  double on_s = 0, off_s = 0;    ///< announcing and both passes, wall time, best of five
};

struct FirstTest {
  std::uint32_t side = 0;  ///< of the conservative map, texels
  ReductionRates rates;    ///< physical semantics
};

struct WindingResults {
  std::vector<WindingAccuracy> accuracy;  ///< by scale
  std::vector<WindingMemory> memory;      ///< scales 1 and 16, where measured
  std::optional<InBoth<SkipUse>> skips;   ///< scale 1
  std::vector<FirstTest> first_test;      ///< scale 1, by side
};

/// @param exact  of this frame; see JudgeOptions
WindingAccuracy winding_accuracy(const Trace& trace, unsigned scale,
                                 const std::shared_ptr<ExactFrame>& exact, const Report& report);
WindingMemory winding_memory(const Trace& trace, unsigned scale, const Report& report);
InBoth<SkipUse> winding_skips(const Trace& trace, const Report& report);
/// @param capturing  how the frame is made, but for the map's size
std::vector<FirstTest> first_tests(const Scene& scene, CaptureOptions capturing,
                                   const Report& report);

}  // namespace kagesen

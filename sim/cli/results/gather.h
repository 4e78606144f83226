#pragma once
/// The measurements behind docs/results.md: every scene at every scale, the paper profile with 4
/// and 8 bits and the winding profile with 8.
#include <cstdint>
#include <string>
#include <vector>

#include "model/reference/judge.h"
#include "sim/cli/results/winding.h"
#include "sim/report/canvas.h"

namespace kagesen {

struct ResultsOptions {
  std::vector<std::string> scenes;  ///< names of built-in scenes
  std::vector<unsigned> scales{1, 4, 16, 64, 256, 1024};
  std::uint32_t image_width = 1920, image_height = 1080;
  Report progress;
};

/// One run of the paper profile.
struct Measurement {
  unsigned scale = 1, bits = 8;
  std::uint64_t fragments = 0, texels = 0, lines = 0;
  std::uint64_t payload_bytes = 0, allocated_bytes = 0, overflow_lines = 0;
  std::uint64_t map_bytes = 0;
  ErrorFigures paper, physical;
  EquivalentResolution equivalent;
  PlainFigures plain_same_side, plain_equal_bytes;
};

struct SceneResults {
  std::string name, description;
  std::uint64_t triangles = 0, objects = 0;
  std::vector<Measurement> runs;  ///< by scale, 8 bits before 4
  WindingResults winding;
  Canvas sheet{1, 1};  ///< crops of the frame: a column a scale; 8 bits, 4 bits, plain map
  /// The run at a scale and width.
  const Measurement& at(unsigned scale, unsigned bits) const;
};

/// Captures each scene once a scale. Throws UserError for an unknown scene.
std::vector<SceneResults> gather_results(const ResultsOptions& options);

}  // namespace kagesen

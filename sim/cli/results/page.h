#pragma once
/// docs/results.md, made of measurements alone. Only its run times, which are named as such, differ
/// from machine to machine.
#include <string>
#include <vector>

#include "sim/cli/results/gather.h"

namespace kagesen {

/// @param images  folder of the pictures, relative to the page
/// @param stress  a section that is ready; may be empty
std::string results_page(const std::vector<SceneResults>& results, const ResultsOptions& options,
                         const std::string& images, const std::string& stress);

/// The paper's Table 8 beside what this unit needs for scenes of the same kind.
std::string paper_section(const std::vector<SceneResults>& results);

/// What the paper says of its pictures, held against the measurements.
std::string findings_section(const std::vector<SceneResults>& results,
                             const std::vector<unsigned>& scales);

/// Payload by the formula that reproduces Table 8: 42 bits a silhouette texel and 36 bits a line.
double payload_kb(std::uint64_t texels, std::uint64_t lines);

}  // namespace kagesen

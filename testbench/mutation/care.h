#pragma once
/// Which output pins mean something in a cycle: data does not while its valid is low.
#include <cstddef>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "testbench/mutation/recording.h"

namespace kagesen {

/// Outputs that mean something only while another one is high or, as "pin=2", has a value, where
/// their names do not say so.
using Qualifiers = std::vector<std::pair<std::string, std::string>>;

/// One output: where it stands, and what says whether it means something.
struct CareField {
  unsigned low, width;
  unsigned valid_low = 0, valid_width = 0;  ///< width 0: it always does
  unsigned valid_value = 1;
};
/// Of every output, the first standing highest.
std::vector<CareField> care_fields(const Recording& recording, const Qualifiers& qualifiers);

/// The recording as lines "KIND INPUTS OUTPUTS CARE": N a new instance, R a reset, B a beat, and
/// CARE ones where an output means something.
/// @param most  beats
void write_vectors(const Recording& recording, const Qualifiers& qualifiers, std::size_t most,
                   const std::filesystem::path& file);

}  // namespace kagesen

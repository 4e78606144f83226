#pragma once
/// shadow_pkg.sv for a configuration: the widths that one netlist is built with.
#include <string>
#include <vector>

#include "model/unit/config.h"
#include "testbench/verilator/sources.h"

namespace kagesen {

/// The package's text. Configurations that differ only in registers (capacities below the default,
/// policies, smaller maps) share one.
std::string shadow_package(const UnitConfig& config);

/// Widths that the package derives.
struct PackageWidths {
  explicit PackageWidths(const UnitConfig& config);
  int map_bits, record_addr_bits;
  int texel_bits;  ///< of a texel in a word of the texel memory
};

/// The folder of a profile under rtl/.
std::string profile_folder(Profile profile);
/// The RTL of a profile without the package: rtl/common and rtl/<profile>.
std::vector<SourceText> rtl_sources(Profile profile);

}  // namespace kagesen

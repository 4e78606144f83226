#pragma once
/// The longest path of a mapped netlist, by OpenSTA.
#include <filesystem>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "testbench/synthesis/cell_library.h"
#include "testbench/synthesis/gates.h"

namespace kagesen {

struct Timing {
  double fmax_mhz = 0;
  std::string from, to;
  std::vector<PathReport> paths;
};
/// Works in `folder`, which holds ports_split.v, which goes; leaves timing.txt there. Throws UserError with
/// OpenSTA's words where it refuses.
Timing measure_timing(const std::filesystem::path& folder, const std::string& top,
                      const CellLibrary& library, const std::string& sta);

}  // namespace kagesen

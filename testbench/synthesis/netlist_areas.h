#pragma once
/// Adds up the cells of a mapped netlist, module by module.
#include <string>

#include "testbench/synthesis/cell_library.h"
#include "testbench/synthesis/gates.h"

namespace kagesen {

/// Fills in what `report` says of cells, blocks and memories.
/// @param netlist  text that Yosys' write_json wrote
void add_areas(const std::string& netlist, const std::string& top, const CellLibrary& library,
               GateReport& report);

/// "fifo" of "$paramod$4f..\fifo" and "$paramod\fifo\Width=..."; other names as they are.
std::string source_name(const std::string& module);

}  // namespace kagesen

#pragma once
/// A standard cell library: the Liberty file and the Verilog models of its cells.
#include <map>
#include <string>

namespace kagesen {

struct CellLibrary {
  std::string name;                     ///< osu018
  std::string liberty;                  ///< file
  std::string models;                   ///< file, Verilog
  std::map<std::string, double> areas;  ///< of each cell, in the library's own unit
  double nand2_area = 0;                ///< one gate equivalent
  /// Storage that an RTL mistake infers; a netlist must hold none.
  static bool is_latch(const std::string& cell) { return cell == "LATCH"; }
};

/// Finds the library in Debian's qflow-tech-NAME, below /usr/share/qflow or $QFLOW_TECH. Throws
/// UserError naming the package, or the names there are.
CellLibrary find_cell_library(const std::string& name);

}  // namespace kagesen

#pragma once
/// Maps the RTL to cells, module by module, and keeps each: a run maps what has changed since.
#include <filesystem>
#include <functional>
#include <string>

namespace kagesen {

struct MappingInputs {
  std::string top, liberty, sources,
      parameters;  ///< sources: file names; parameters: as Yosys takes them
  bool flatten = false;
  std::string abc;    ///< script for ABC
  std::string tools;  ///< versions, part of what a result is kept under
  std::string yosys;  ///< program
  /// All scripts as they stand, for a hash.
  std::string scripts() const;
};

/// Leaves in `folder` netlist.json, with the hierarchy, and flat.json. Throws UserError with Yosys'
/// words.
void map_to_cells(const MappingInputs& in, const std::filesystem::path& folder,
                  const std::function<void(const std::string&)>& progress);

/// Runs NAME.ys in a folder, with its log beside it. Throws UserError with Yosys' words.
void run_yosys(const std::string& yosys, const std::string& what, const std::string& script,
               const std::string& name, const std::filesystem::path& folder);

}  // namespace kagesen

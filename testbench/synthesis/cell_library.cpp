#include "testbench/synthesis/cell_library.h"

#include <cstdlib>
#include <filesystem>
#include <regex>

#include "testbench/tools/cache.h"
#include "traces/format/error.h"

namespace kagesen {
namespace {

namespace fs = std::filesystem;

std::string find_file(const fs::path& folder, const std::string& name) {
  std::error_code ignored;
  for (fs::recursive_directory_iterator file(folder, ignored), end; file != end; ++file) {
    if (file->path().filename() == name) return file->path().string();
  }
  return {};
}

}  // namespace

CellLibrary find_cell_library(const std::string& name) {
  if (name != "osu018" && name != "osu035") {
    throw UserError("--library", "there is no '" + name + "'", "choose one of osu018, osu035");
  }
  const char* set = std::getenv("QFLOW_TECH");
  const fs::path folder = set && *set ? set : "/usr/share/qflow";
  CellLibrary library;
  library.name = name;
  library.liberty = find_file(folder, name + "_stdcells.lib");
  library.models = find_file(folder, name + "_stdcells.v");
  if (library.liberty.empty() || library.models.empty()) {
    throw UserError("cell library " + name, "is not below " + folder.string(),
                    "apt-get install qflow-tech-" + name);
  }
  static const std::regex cell(R"(\n\s*cell\s*\((\w+)\)\s*\{[^{}]*?\barea\s*:\s*([0-9.]+))");
  const std::string text = read_file(library.liberty);
  for (std::sregex_iterator found(text.begin(), text.end(), cell), end; found != end; ++found) {
    library.areas[(*found)[1]] = std::stod((*found)[2]);
  }
  library.nand2_area = library.areas.count("NAND2X1") ? library.areas["NAND2X1"] : 0;
  if (library.nand2_area <= 0) {
    throw UserError(library.liberty, "has no area of NAND2X1",
                    "apt-get install --reinstall qflow-tech-" + name);
  }
  return library;
}

}  // namespace kagesen

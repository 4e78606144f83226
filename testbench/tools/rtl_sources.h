#pragma once
/// The RTL's files: where a module stands and which others it takes.
#include <map>
#include <string>
#include <vector>

#include "model/unit/config.h"

namespace kagesen {

/// The folder that holds rtl/, testbench/ and tests/.
std::string source_folder();

/// Synthesizable modules of one profile, rtl/common and rtl/<profile>, by name.
class RtlSources {
 public:
  explicit RtlSources(Profile profile);
  /// Adds or replaces a module, for blocks of a test and for broken copies.
  void add_file(const std::string& path);
  bool has(const std::string& module) const { return files_.count(module) != 0; }
  /// Files of `top` and all it takes, itself last; ram_1r1w is not among them, nor is the package.
  /// Throws UserError naming the nearest module if there is no `top`.
  std::vector<std::string> of(const std::string& top) const;
  std::vector<std::string> modules() const;

 private:
  std::map<std::string, std::string> files_;
};

std::string common_folder();  ///< of the include files
std::string ram_file();       ///< ram_1r1w.sv
std::string rtl_folder(Profile profile);

/// The text of a package with some of its constants replaced, each given as "Name=value". Throws
/// UserError for one that it does not have.
std::string with_package_sets(std::string package, const std::vector<std::string>& sets);

}  // namespace kagesen

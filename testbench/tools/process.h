#pragma once
/// Programs that this one starts.
#include <string>
#include <vector>

namespace kagesen {

struct ProcessResult {
  int status = 0;  ///< exit status; 128 + n if signal n ended it
  bool timed_out = false;
  double seconds = 0;
};

/// Runs a program with its output and errors in the file `log`, in folder `folder`. The program and
/// all it started are killed after `limit_s` seconds (0: never), and when this program is
/// interrupted.
ProcessResult run_process(const std::vector<std::string>& command, const std::string& folder,
                          const std::string& log, double limit_s = 0);

/// The path of a program. Throws UserError naming the Debian package that has it.
std::string find_tool(const std::string& name, const std::string& package);

/// First line that `name` prints when run with `arguments`.
std::string tool_version(const std::string& path, const std::vector<std::string>& arguments);

}  // namespace kagesen

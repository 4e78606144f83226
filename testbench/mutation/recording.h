#pragma once
/// The pins of a block while its test runs (testbench/verilator/recorder.cmake).
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "testbench/mutation/blocks.h"

namespace kagesen {

struct Recording {
  std::string top, package;  ///< module; file, or empty
  std::vector<std::string> sources;
  std::vector<std::pair<std::string, std::string>> parameters;
  struct Pin {
    std::string name;
    unsigned width;
  };
  std::vector<Pin> inputs, outputs;  ///< beside clk_i; the first stands highest in a beat
  bool clocked = true;
  /// A file of lines: N (a new instance), R (reset fell), INPUTS OUTPUTS in hexadecimal, as they
  /// stood before a rising clock.
  std::string pins;
};

/// Builds the test with recorders, in a build folder of its own in the cache, and runs it. Throws
/// UserError when the build or the test fails.
Recording record(const MutationBlock& block);

/// What recorder.cmake wrote of a module.
Recording read_manifest(const std::filesystem::path& file);

unsigned total_width(const std::vector<Recording::Pin>& pins);
/// "port, port, ..." connections of all pins to slices of vectors `in` and `out`.
std::string pin_connections(const Recording& recording, const std::string& in,
                            const std::string& out, const std::string& reset);

}  // namespace kagesen

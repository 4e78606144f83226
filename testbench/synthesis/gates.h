#pragma once
/// What the unit costs in gates, memory and time, from Yosys and OpenSTA.
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "model/unit/config.h"

namespace kagesen {

/// Assumed of the memories, which are not synthesised.
inline constexpr double kRamAccessNs = 1.5;  ///< rising clock to data
inline constexpr double kRamSetupNs = 0.3;   ///< of address, data and enables
inline constexpr double kTargetMhz = 150;

struct GateOptions {
  std::string library = "osu018";
  std::string top = "shadow_unit";
  std::string abc;       ///< another script for ABC; empty: the committed one
  bool flatten = false;  ///< before mapping; then there is only one block
  /// What the package is changed in, as "Name=value" of its own constants; for what no key sets.
  std::vector<std::string> package_sets;
  /// Of a block that stands alone: its parameters, and its files instead of the tree's, the package
  /// among them.
  std::vector<std::pair<std::string, std::string>> parameters;
  std::vector<std::string> sources;
};

struct MemoryReport {
  std::string path;  ///< instance, from the top
  std::uint64_t width = 0, depth = 0;
  std::uint64_t bits() const { return width * depth; }
};

/// All instances of a module together, whatever their parameters.
struct BlockReport {
  std::uint64_t instances = 0;
  double own_ge = 0;              ///< cells of its own
  double ge = 0;                  ///< with all that it holds
  std::uint64_t memory_bits = 0;  ///< with all that it holds
};

/// The longest path to a register, a port or a pin of a memory, whichever bit of it.
struct PathReport {
  std::string from, to;
  double ns = 0;           ///< with the end's setup time
  std::uint64_t bits = 0;  ///< of the end
};

struct GateReport {
  double total_ge = 0, fmax_mhz = 0;
  double flop_ge = 0;    ///< of the total, flip-flops
  double buffer_ge = 0;  ///< of the total, the trees of fanout.h, which belong to no block
  std::uint64_t memory_bits = 0, cells = 0, flops = 0, buffers = 0;
  std::map<std::string, std::uint64_t>
      unmapped;  ///< cells that are not of the library, and latches
  std::map<std::string, BlockReport> blocks;
  std::vector<MemoryReport> memories;
  std::string critical_path;  ///< "from -> to"
  std::vector<PathReport> paths;  ///< to every end, longest first
  std::string profile, top, library, tools, scripts;
  double nand2_area = 0;
  bool flattened = false;
  std::string folder;  ///< where netlist.v, timing.txt and the logs are
};

/// Throws UserError when a tool or library is absent, and when Yosys or OpenSTA refuse the RTL (the
/// message has their words).
/// @param progress  told what is being done
GateReport measure_gates(const UnitConfig& config, const GateOptions& options,
                         const std::function<void(const std::string&)>& progress);
/// What measure_gates() found before and kept; runs no synthesis. Nothing where there is no such result.
std::optional<GateReport> kept_gates(const UnitConfig& config, const GateOptions& options);

}  // namespace kagesen

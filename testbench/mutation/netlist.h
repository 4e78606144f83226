#pragma once
/// The mapped netlist of a block against the recorded pins of its test, in Icarus Verilog.
#include <functional>
#include <string>

#include "model/unit/config.h"
#include "testbench/mutation/recording.h"

namespace kagesen {

struct NetlistRun {
  std::size_t beats = 0, wrong = 0;
  std::string log;  ///< file
};
/// Outputs are compared bit for bit in every beat, X being wrong, but for data while its valid is
/// low and for what `qualifiers` ("data_o=hit_o") say of other data.
/// @param beats  at most so many
NetlistRun run_netlist(const MutationBlock& block, const std::string& library, std::size_t beats,
                       const std::function<void(const std::string&)>& progress);

/// The same for the whole unit, on a short frame: triangles and fragments that meet in a few
/// texels. Its verdicts are golden's, or this throws.
NetlistRun run_unit_netlist(const UnitConfig& config, const std::string& library, std::size_t beats,
                            const std::function<void(const std::string&)>& progress);

}  // namespace kagesen

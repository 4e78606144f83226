#pragma once
/// Puts faults into a block and runs the stimulus of its test against each.
#include <functional>
#include <string>
#include <vector>

#include "testbench/mutation/care.h"

namespace kagesen {

struct Mutant {
  unsigned number = 0;
  std::string what;         ///< mode, cell and port as Yosys names them
  std::string place;        ///< file and line
  long killed_at = -1;      ///< beat of the recording; -1: never
  bool equivalent = false;  ///< proven: no input tells it from the block
};
struct MutationResult {
  std::string block;
  std::vector<Mutant> mutants;
  std::size_t beats = 0;   ///< of the recording
  std::size_t unlike = 0;  ///< beats in which the replay is not what was recorded
  std::size_t killed() const;
  std::size_t equivalent() const;
  std::size_t survivors() const { return mutants.size() - killed() - equivalent(); }
};

/// The result is kept in the cache until the RTL, the recorded pins or the numbers change.
/// @param count    mutants
/// @param limit_s  of the search for a proof, a survivor
MutationResult mutate(const MutationBlock& block, unsigned count, double limit_s,
                      const std::function<void(const std::string&)>& progress);

/// Is the mutant the same as the block wherever outputs mean something, for runs of any length from
/// a state of zeros?
/// @param folder  where mutants.v is
bool proven_equivalent(const Recording& recording, const Qualifiers& qualifiers,
                       const std::string& folder, unsigned mutant, double limit_s);

/// The table of docs/mutation.md.
std::string mutation_page(const std::vector<MutationResult>& results, const std::string& command);

}  // namespace kagesen

#include <fmt/format.h>

#include "testbench/mutation/mutation.h"

namespace kagesen {

std::string mutation_page(const std::vector<MutationResult>& results, const std::string& command) {
  std::string text = fmt::format(
      "# Mutation\n\nWritten by `{}`. Each mutant is one fault that Yosys puts into a block (a bit "
      "inverted, "
      "stuck\nor taken from elsewhere). It is killed where any output pin differs in any cycle of "
      "the pins "
      "recorded\nfrom the block's test. What survives is tried for equivalence: block and mutant "
      "side by "
      "side, proven equal\nfor every input and runs of any length from a state of zeros.\n\n"
      "| block | mutants | killed | proven equivalent | survivors | beats "
      "|\n|---|---:|---:|---:|---:|---:|\n",
      command);
  std::size_t all = 0, killed = 0, equivalent = 0;
  for (const MutationResult& result : results) {
    text += fmt::format("| {} | {} | {} | {} | {} | {} |\n", result.block, result.mutants.size(),
                        result.killed(), result.equivalent(), result.survivors(), result.beats);
    all += result.mutants.size();
    killed += result.killed();
    equivalent += result.equivalent();
  }
  text += fmt::format("| all | {} | {} | {} | {} | |\n", all, killed, equivalent,
                      all - killed - equivalent);
  if (all == killed + equivalent) return text;
  text += "\n## Survivors\n\n";
  for (const MutationResult& result : results) {
    for (const Mutant& mutant : result.mutants) {
      if (mutant.killed_at >= 0 || mutant.equivalent) continue;
      text += fmt::format("- {} {}: `{}`, {}\n", result.block, mutant.number, mutant.what,
                          mutant.place);
    }
  }
  return text;
}

}  // namespace kagesen

#pragma once
/// The blocks that faults are put into, and the tests whose stimulus has to find them.
#include <string>
#include <utility>
#include <vector>

namespace kagesen {

struct MutationBlock {
  std::string name;  ///< as a person names it
  std::string test;  ///< target of tests/rtl
  std::string dut;   ///< what it verilates
  unsigned mutants;  ///< by default
  /// Outputs that mean something only while another one is high (testbench/mutation/care.h).
  std::vector<std::pair<std::string, std::string>> qualifiers = {};
  unsigned beats = 60000;  ///< of the test's clock cycles that are kept, at most
};
const std::vector<MutationBlock>& mutation_blocks();

}  // namespace kagesen

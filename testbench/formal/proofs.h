#pragma once
/// Unbounded proofs: a harness holds the properties, Yosys makes a graph of it, ABC proves or
/// refutes.
///
/// NAME_proof.sv is a module of that name without reset input. Its header comment states what is
/// proven and, behind a line without text, may say
///   // profile: winding      package and folder of the blocks; else paper
///   // package: NAME=VALUE... constants that replace the package's; each such line is a proof
///   // pipeline: 3            nothing lives longer than so many cycles: all runs of one cycle more
///                             are all runs; else the search is unbounded
///   // long run               no test of ctest
///   // broken: FILE: `old` => `new`   a copy of the RTL that the proof must refuse
#include <string>
#include <vector>

namespace kagesen {

struct BrokenCopy {
  std::string file, old_text, new_text;
};
struct Proof {
  std::string name;       ///< without _proof
  std::string statement;  ///< what is proven: the header comment's text
  std::string file, profile = "paper";
  std::vector<std::vector<std::string>> packages;  ///< NAME=VALUE...; one at least
  std::vector<std::string> parameters;             ///< NAME=VALUE of the harness
  unsigned pipeline = 0;                           ///< 0: state may live for ever
  std::vector<BrokenCopy> broken;
};

/// All harnesses in testbench/formal, by name. Throws UserError where a header cannot be read.
std::vector<Proof> find_proofs();

enum class Outcome { kProved, kRefuted, kUndecided };
struct Verdict {
  Outcome outcome = Outcome::kUndecided;
  double seconds = 0;
  std::string log;  ///< file
};

/// @param broken   nullptr: the RTL as it is, and all packages have to be proved; else one that
///                 refutes is enough
/// @param limit_s  of a search
Verdict run_proof(const Proof& proof, const BrokenCopy* broken, double limit_s);

}  // namespace kagesen

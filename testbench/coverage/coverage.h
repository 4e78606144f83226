#pragma once
/// What a run of a build with coverage reached: reads Verilator's file of counts, leaves out what
/// exclusions.txt names, and sums up by module.
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace kagesen {

enum class CoverKind : std::uint8_t {
  kLine,    ///< a block of statements
  kBranch,  ///< an arm of an if or of ?:
  kToggle,  ///< a bit of a signal inside a module
  kPort,    ///< a bit of a port
};
inline constexpr CoverKind kCoverKinds[] = {CoverKind::kLine, CoverKind::kBranch,
                                            CoverKind::kToggle, CoverKind::kPort};
const char* name_of(CoverKind kind);

/// A point of a module, whatever its instances and their parameters.
struct CoverPoint {
  CoverKind kind = CoverKind::kLine;
  std::string file;  ///< as the build names it: rtl/paper/front.sv
  unsigned line = 0, column = 0;
  std::string module, what;  ///< what: "block", "if", "else", or the bit: "valid_o", "data_i[3]"
  std::uint64_t count = 0;   ///< the most of any instance
  bool covered() const;
};

/// Changes of a bit that show both directions: two, and the one from its state at power-up, which
/// Verilator counts too.
inline constexpr std::uint64_t kBothDirections = 3;

/// Reads the text of a file that VerilatedCov::write() wrote; points ordered by file and line.
/// Throws UserError where it is no such file.
std::vector<CoverPoint> read_coverage(const std::string& text, const std::string& name);

/// A line of exclusions.txt: PATTERN | KIND | REASON. A pattern with * and ? names a module
/// ("fifo"), a point of one ("fifo.data_o[3]"), or a line of a file by its number ("fifo.sv:12") or
/// by what stands in it ("fifo.sv:`default:`"). Kinds are those of name_of(), or "bin" for a
/// functional bin, which the pattern then names. "paper: " or "winding: " before it holds it back
/// for one profile.
struct Exclusion {
  std::string profile, pattern, kind, reason;
  std::uint64_t used = 0;  ///< points left out that were not covered
};
std::vector<Exclusion> read_exclusions(const std::string& text, const std::string& name);

/// A glob of * and ?.
bool matches(const std::string& pattern, const std::string& text);
/// The exclusion that leaves a point out, or nullptr.
/// @param source  the text of the point's line
Exclusion* find_exclusion(std::vector<Exclusion>& exclusions, const std::string& profile,
                          const CoverPoint& point, const std::string& source);
Exclusion* find_bin_exclusion(std::vector<Exclusion>& exclusions, const std::string& profile,
                              const std::string& bin);

struct Share {
  std::uint64_t hit = 0, all = 0, excluded = 0;
  bool full() const { return hit == all; }
  double per_cent() const { return all ? 100.0 * double(hit) / double(all) : 100.0; }
};
struct CoverageSummary {
  std::map<std::string, std::map<CoverKind, Share>> modules;
  std::map<CoverKind, Share> total;
  std::vector<CoverPoint> missed;  ///< not covered and not left out
};
/// @param sources  text by file; counts what each exclusion leaves out
CoverageSummary summarise(const std::vector<CoverPoint>& points, const std::string& profile,
                          const std::map<std::string, std::string>& sources,
                          std::vector<Exclusion>& exclusions);

}  // namespace kagesen

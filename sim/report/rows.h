#pragma once
/// The lines that the table of a run is made of.
#include <fmt/format.h>

#include <cstdint>
#include <string>
#include <utility>

#include "sim/report/run_result.h"

namespace kagesen {

/// Rows "label  text"; the label is empty where a row continues the one above.
class Rows {
 public:
  void add(const std::string& label, const std::string& text) {
    out_ += fmt::format("  {:<18}{}\n", label, text);
  }
  void heading(const std::string& text) { out_ += fmt::format("\n{}\n", text); }
  /// One column a semantics.
  void pair(const std::string& label, const std::string& paper, const std::string& physical) {
    add(label, fmt::format("{:>28}{:>28}", paper, physical));
  }
  std::string take() { return std::move(out_); }

 private:
  std::string out_;
};

/// "37.5 %"; "-" of nothing.
inline std::string percent(std::uint64_t part, std::uint64_t whole) {
  return whole ? fmt::format("{:.1f} %", 100.0 * double(part) / double(whole)) : "-";
}

/// What the winding profile alone has to say (table_winding.cpp): whether its contract held, and
/// what its skips saved.
void contract_rows(Rows& rows, const RunResult& result);
void skip_rows(Rows& rows, const RunResult& result);

}  // namespace kagesen

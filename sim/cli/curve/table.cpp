#include "sim/cli/curve/table.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <tuple>

#include "traces/format/error.h"

namespace kagesen {
namespace {

std::string header_line() {
  std::string line;
  CurveRow row;
  visit_columns(row, [&](const char* name, const auto&) {
    line += line.empty() ? "" : ",";
    line += name;
  });
  return line;
}

std::string cell(const std::string& value) { return value; }
std::string cell(std::uint64_t value) { return fmt::format("{}", value); }
std::string cell(double value) { return fmt::format("{:.6g}", value); }

bool parse(const std::string& text, std::string& value) {
  value = text;
  return !text.empty();
}
template <class Number>
bool parse(const std::string& text, Number& value) {
  const char* end = text.data() + text.size();
  const auto [stopped, error] = std::from_chars(text.data(), end, value);
  return error == std::errc() && stopped == end && std::isfinite(double(value)) && value >= 0;
}

/// False unless the line is a row of this table.
bool parse_line(const std::string& line, CurveRow& row) {
  std::size_t from = 0;
  bool good = true;
  visit_columns(row, [&](const char*, auto& value) {
    const std::size_t to = std::min(line.find(',', from), line.size());
    good = good && from <= line.size() && parse(line.substr(from, to - from), value);
    from = good ? to + 1 : 0;
  });
  return good && from == line.size() + 1;
}

}  // namespace

bool CurveRow::same_setting(const CurveRow& o) const {
  const auto key = [](const CurveRow& r) {
    return std::tie(r.scene, r.profile, r.semantics, r.fraction_bits, r.slope_bits, r.map, r.scale,
                    r.image);
  };
  return key(*this) == key(o);
}

std::string curve_csv(const std::vector<CurveRow>& rows) {
  std::string text = header_line() + "\n";
  for (const CurveRow& row : rows) {
    bool first = true;
    visit_columns(row, [&](const char*, const auto& value) {
      text += first ? "" : ",";
      text += cell(value);
      first = false;
    });
    text += "\n";
  }
  return text;
}

std::vector<CurveRow> read_curve_csv(const std::string& path) {
  std::vector<CurveRow> rows;
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return rows;
  std::ifstream in(path);
  if (!in) throw UserError(path, "cannot read it", "check its permissions, or write elsewhere");
  std::string line;
  for (std::size_t number = 1; std::getline(in, line); ++number) {
    const std::string where = fmt::format("{}:{}", path, number);
    if (number == 1) {
      if (line == header_line()) continue;
      throw UserError(where, "these are not the columns of a curve",
                      "move the file away, or write elsewhere");
    }
    CurveRow row;
    if (!parse_line(line, row)) {
      throw UserError(where, "is not a row of a curve", "remove the line; it is measured again");
    }
    rows.push_back(row);
  }
  return rows;
}

}  // namespace kagesen

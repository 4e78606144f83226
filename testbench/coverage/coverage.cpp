#include "testbench/coverage/coverage.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <regex>
#include <sstream>
#include <tuple>

#include "traces/format/error.h"

namespace kagesen {
namespace {

/// "fifo__W8_D4" or "fifo__pi1": the module without its parameters.
std::string without_parameters(const std::string& module) {
  return module.substr(0, module.find("__"));
}

bool is_port(const std::string& name) {
  static const std::regex port(R"([^.\[]*_n?[io]([.\[].*)?)");
  return std::regex_match(name, port);
}

/// The keys of a point: \001 key \002 value, again and again.
std::map<std::string, std::string> keys_of(const std::string& text) {
  std::map<std::string, std::string> keys;
  for (std::size_t at = text.find('\001'); at != std::string::npos;) {
    const std::size_t next = text.find('\001', at + 1);
    const std::string one = text.substr(at + 1, next == std::string::npos ? next : next - at - 1);
    const std::size_t split = one.find('\002');
    if (split != std::string::npos) keys[one.substr(0, split)] = one.substr(split + 1);
    at = next;
  }
  return keys;
}

/// False for what is no point of ours (cover properties).
bool fill(const std::map<std::string, std::string>& keys, CoverPoint& point) {
  const auto of = [&](const char* key) {
    const auto at = keys.find(key);
    return at == keys.end() ? std::string() : at->second;
  };
  const std::string page = of("page");
  const std::size_t slash = page.find('/');
  if (slash == std::string::npos) return false;
  const std::string type = page.substr(0, slash);
  point.module = without_parameters(page.substr(slash + 1));
  point.file = of("f");
  point.line = static_cast<unsigned>(std::strtoul(of("l").c_str(), nullptr, 10));
  point.column = static_cast<unsigned>(std::strtoul(of("n").c_str(), nullptr, 10));
  point.what = of("o");
  if (type == "v_line") {
    point.kind = CoverKind::kLine;
  } else if (type == "v_branch") {
    point.kind = CoverKind::kBranch;
  } else if (type == "v_toggle") {
    point.kind = is_port(point.what) ? CoverKind::kPort : CoverKind::kToggle;
  } else {
    return false;
  }
  return true;
}

std::string trimmed(const std::string& text) {
  const std::size_t first = text.find_first_not_of(" \t\r");
  if (first == std::string::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

bool is_kind(const std::string& text) {
  return text == "bin" || std::any_of(std::begin(kCoverKinds), std::end(kCoverKinds),
                                      [&](CoverKind kind) { return text == name_of(kind); });
}

bool names(const std::string& pattern, const CoverPoint& point, const std::string& source) {
  const std::string file = std::filesystem::path(point.file).filename().string();
  const std::size_t tick = pattern.find(":`");
  if (tick != std::string::npos && pattern.back() == '`' && pattern.size() > tick + 3) {
    const std::string part = pattern.substr(tick + 2, pattern.size() - tick - 3);
    return matches(pattern.substr(0, tick), file) && source.find(part) != std::string::npos;
  }
  return matches(pattern, point.module) || matches(pattern, point.module + "." + point.what) ||
         matches(pattern, fmt::format("{}:{}", file, point.line));
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

}  // namespace

const char* name_of(CoverKind kind) {
  switch (kind) {
    case CoverKind::kLine:
      return "line";
    case CoverKind::kBranch:
      return "branch";
    case CoverKind::kToggle:
      return "toggle";
    case CoverKind::kPort:
      return "port";
  }
  return "";
}

bool CoverPoint::covered() const {
  const bool toggles = kind == CoverKind::kToggle || kind == CoverKind::kPort;
  return count >= (toggles ? kBothDirections : 1);
}

std::vector<CoverPoint> read_coverage(const std::string& text, const std::string& name) {
  const std::vector<std::string> lines = lines_of(text);
  if (lines.empty() || lines.front().find("SystemC::Coverage") == std::string::npos) {
    throw UserError(name, "no coverage file of Verilator's", "run the build with coverage again");
  }
  using Key = std::tuple<std::string, unsigned, unsigned, CoverKind, std::string, std::string>;
  std::map<Key, CoverPoint> merged;
  for (const std::string& line : lines) {
    if (line.rfind("C '", 0) != 0) continue;
    const std::size_t end = line.rfind("' ");
    if (end == std::string::npos || end < 3) {
      throw UserError(name, "a point without a count", "run the build with coverage again");
    }
    CoverPoint point;
    if (!fill(keys_of(line.substr(3, end - 3)), point)) continue;
    point.count = std::strtoull(line.c_str() + end + 2, nullptr, 10);
    const Key key(point.file, point.line, point.column, point.kind, point.module, point.what);
    const auto [at, is_new] = merged.emplace(key, point);
    if (!is_new) at->second.count = std::max(at->second.count, point.count);
  }
  std::vector<CoverPoint> points;
  for (auto& [key, point] : merged) points.push_back(std::move(point));
  return points;
}

std::vector<Exclusion> read_exclusions(const std::string& text, const std::string& name) {
  std::vector<Exclusion> out;
  unsigned number = 0;
  for (const std::string& raw : lines_of(text)) {
    ++number;
    const std::string line = trimmed(raw);
    if (line.empty() || line.front() == '#') continue;
    const std::size_t first = line.find(" | ");
    const std::size_t second = first == std::string::npos ? first : line.find(" | ", first + 3);
    Exclusion e;
    if (second != std::string::npos) {
      e.pattern = trimmed(line.substr(0, first));
      e.kind = trimmed(line.substr(first + 3, second - first - 3));
      e.reason = trimmed(line.substr(second + 3));
    }
    if (e.pattern.empty() || e.reason.empty() || !is_kind(e.kind)) {
      throw UserError(fmt::format("{}:{}", name, number), "no exclusion",
                      "write PATTERN | line, branch, toggle, port or bin | REASON");
    }
    for (const char* profile : {"paper", "winding"}) {
      const std::string prefix = std::string(profile) + ": ";
      if (e.pattern.rfind(prefix, 0) != 0) continue;
      e.profile = profile;
      e.pattern = trimmed(e.pattern.substr(prefix.size()));
    }
    out.push_back(std::move(e));
  }
  return out;
}

bool matches(const std::string& pattern, const std::string& text) {
  std::size_t p = 0, t = 0, star = std::string::npos, from = 0;
  while (t < text.size()) {
    if (p < pattern.size() && pattern[p] == '*') {
      star = p++;
      from = t;
    } else if (p < pattern.size() && (pattern[p] == '?' || pattern[p] == text[t])) {
      ++p;
      ++t;
    } else if (star != std::string::npos) {
      p = star + 1;
      t = ++from;
    } else {
      return false;
    }
  }
  while (p < pattern.size() && pattern[p] == '*') ++p;
  return p == pattern.size();
}

Exclusion* find_exclusion(std::vector<Exclusion>& exclusions, const std::string& profile,
                          const CoverPoint& point, const std::string& source) {
  for (Exclusion& e : exclusions) {
    if (e.kind != name_of(point.kind)) continue;
    if (!e.profile.empty() && e.profile != profile) continue;
    if (names(e.pattern, point, source)) return &e;
  }
  return nullptr;
}

Exclusion* find_bin_exclusion(std::vector<Exclusion>& exclusions, const std::string& profile,
                              const std::string& bin) {
  for (Exclusion& e : exclusions) {
    if (e.kind != "bin" || (!e.profile.empty() && e.profile != profile)) continue;
    if (matches(e.pattern, bin)) return &e;
  }
  return nullptr;
}

CoverageSummary summarise(const std::vector<CoverPoint>& points, const std::string& profile,
                          const std::map<std::string, std::string>& sources,
                          std::vector<Exclusion>& exclusions) {
  std::map<std::string, std::vector<std::string>> lines;
  for (const auto& [file, text] : sources) lines[file] = lines_of(text);
  CoverageSummary out;
  for (const CoverPoint& point : points) {
    Share& of = out.modules[point.module][point.kind];
    Share& total = out.total[point.kind];
    if (!point.covered()) {
      const std::vector<std::string>& text = lines[point.file];
      const std::string source =
          point.line >= 1 && point.line <= text.size() ? text[point.line - 1] : std::string();
      if (Exclusion* e = find_exclusion(exclusions, profile, point, source)) {
        ++e->used;
        ++of.excluded;
        ++total.excluded;
        continue;
      }
      out.missed.push_back(point);
    }
    of.hit += point.covered();
    total.hit += point.covered();
    ++of.all;
    ++total.all;
  }
  return out;
}

}  // namespace kagesen

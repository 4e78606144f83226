#include "testbench/coverage/page.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <utility>

namespace kagesen {
namespace {

std::string cell(const Share& share) {
  if (share.all == 0) return share.excluded ? "all excluded" : "-";
  return fmt::format("{}/{} {:.1f} %", share.hit, share.all, share.per_cent());
}

Share share_of(const std::map<CoverKind, Share>& shares, CoverKind kind) {
  const auto at = shares.find(kind);
  return at == shares.end() ? Share{} : at->second;
}

std::string headline(const ProfileCoverage& run) {
  const std::vector<std::string> missed = run.missed_bins();
  return fmt::format(
      "{} frames ({} more cut short), {} fragments, {} clock cycles, {} differences from golden, "
      "{:.0f} s. Bins: {} of {} met, {} excluded.",
      run.frames, run.cut, run.fragments, run.cycles, run.differences, run.seconds,
      run.bins.size() - run.excluded_bins.size() - missed.size(),
      run.bins.size() - run.excluded_bins.size(), run.excluded_bins.size());
}

/// "data_i[3]" without its index.
std::pair<std::string, std::string> split_bit(const std::string& what) {
  const std::size_t bracket = what.rfind('[');
  if (bracket == std::string::npos || what.back() != ']') return {what, ""};
  return {what.substr(0, bracket), what.substr(bracket + 1, what.size() - bracket - 2)};
}

std::string bins_section(const ProfileCoverage& run) {
  std::string text = "\n| group | bins | met | excluded |\n|:--|--:|--:|--:|\n";
  std::vector<std::string> order;
  std::map<std::string, Share> groups;
  for (const Bin& bin : run.bins) {
    if (groups.count(bin.group) == 0) order.push_back(bin.group);
    Share& share = groups[bin.group];
    ++share.all;
    share.hit += bin.count > 0;
    share.excluded += run.is_excluded(bin);
  }
  for (const std::string& group : order) {
    const Share& share = groups[group];
    text += fmt::format("| {} | {} | {} | {} |\n", group, share.all, share.hit, share.excluded);
  }
  return text;
}

std::string run_section(const ProfileCoverage& run) {
  std::string text = fmt::format("\n## {} profile\n\n{}\n\n", run.profile, headline(run));
  text +=
      "| module | line | branch | port bits | inner bits | excluded |\n|:--|--:|--:|--:|--:|--:|\n";
  const auto row = [&](const std::string& name, const std::map<CoverKind, Share>& shares) {
    std::uint64_t excluded = 0;
    for (const auto& [kind, share] : shares) excluded += share.excluded;
    text += fmt::format(
        "| {} | {} | {} | {} | {} | {} |\n", name, cell(share_of(shares, CoverKind::kLine)),
        cell(share_of(shares, CoverKind::kBranch)), cell(share_of(shares, CoverKind::kPort)),
        cell(share_of(shares, CoverKind::kToggle)), excluded);
  };
  for (const auto& [name, shares] : run.code.modules) row(name, shares);
  row("**all**", run.code.total);
  text += bins_section(run);
  for (const CoverKind kind : {CoverKind::kLine, CoverKind::kBranch, CoverKind::kPort}) {
    const std::vector<std::string> lines = missed_lines(run.code.missed, kind);
    if (lines.empty()) continue;
    text +=
        fmt::format("\nNot met, {}:\n\n", kind == CoverKind::kPort ? "port bits" : name_of(kind));
    for (const std::string& line : lines) text += "- " + line + "\n";
  }
  const std::vector<std::string> bins = run.missed_bins();
  if (!bins.empty()) text += "\nNot met, bins:\n\n";
  for (const std::string& bin : bins) text += "- " + bin + "\n";
  return text;
}

}  // namespace

bool ProfileCoverage::is_excluded(const Bin& bin) const {
  return std::find(excluded_bins.begin(), excluded_bins.end(), bin.full_name()) !=
         excluded_bins.end();
}

std::vector<std::string> ProfileCoverage::missed_bins() const {
  std::vector<std::string> out;
  for (const Bin& bin : bins) {
    if (bin.count == 0 && !is_excluded(bin)) out.push_back(bin.full_name());
  }
  return out;
}

bool ProfileCoverage::reached() const {
  return differences == 0 && missed_bins().empty() &&
         share_of(code.total, CoverKind::kLine).full() &&
         share_of(code.total, CoverKind::kBranch).full() &&
         share_of(code.total, CoverKind::kPort).full();
}

std::vector<std::string> missed_lines(const std::vector<CoverPoint>& missed, CoverKind kind) {
  std::vector<std::string> order;
  std::map<std::string, std::string> bits;
  for (const CoverPoint& point : missed) {
    if (point.kind != kind) continue;
    const auto [signal, bit] = split_bit(point.what);
    const std::string name =
        fmt::format("{}:{} {}.{}", std::filesystem::path(point.file).filename().string(),
                    point.line, point.module, signal);
    if (bits.count(name) == 0) order.push_back(name);
    std::string& all = bits[name];
    if (!bit.empty()) all += (all.empty() ? "" : ", ") + bit;
  }
  std::vector<std::string> out;
  for (const std::string& name : order) {
    out.push_back(bits[name].empty() ? name : name + "[" + bits[name] + "]");
  }
  return out;
}

std::string coverage_table(const std::vector<ProfileCoverage>& runs) {
  std::string text;
  for (const ProfileCoverage& run : runs) {
    text += fmt::format("{} profile: {}\n{:<22}{:>18}{:>20}{:>20}{:>20}\n", run.profile,
                        headline(run), "module", "line", "branch", "port bits", "inner bits");
    const auto row = [&](const std::string& name, const std::map<CoverKind, Share>& shares) {
      text += fmt::format(
          "{:<22}{:>18}{:>20}{:>20}{:>20}\n", name, cell(share_of(shares, CoverKind::kLine)),
          cell(share_of(shares, CoverKind::kBranch)), cell(share_of(shares, CoverKind::kPort)),
          cell(share_of(shares, CoverKind::kToggle)));
    };
    for (const auto& [name, shares] : run.code.modules) row(name, shares);
    row("all", run.code.total);
    for (const CoverKind kind : {CoverKind::kLine, CoverKind::kBranch, CoverKind::kPort}) {
      for (const std::string& line : missed_lines(run.code.missed, kind)) {
        text += fmt::format("  not met, {}: {}\n", name_of(kind), line);
      }
    }
    for (const std::string& bin : run.missed_bins()) text += "  not met, bin: " + bin + "\n";
    text += "\n";
  }
  return text;
}

std::string coverage_page(const std::vector<ProfileCoverage>& runs,
                          const std::vector<Exclusion>& exclusions, const std::string& command) {
  std::string text = fmt::format(
      "# Coverage\n\nWritten by `{}`: small frames of the built-in scenes at scales 1, 16 and 256, "
      "and stress\ncases, with random policies, capacities, latencies, stalls and aborts, in lock "
      "step with golden.\n\nGoals: every line, every branch, every bit of a port in both "
      "directions, every bin. A point of a\nmodule is met if one of its instances meets it. A bit "
      "counts when one instance changes it {} times:\ntwice both ways, and once from its state at "
      "power-up. Bits inside modules are no goal.\n",
      command, kBothDirections);
  for (const ProfileCoverage& run : runs) text += run_section(run);
  text +=
      "\n## Exclusions\n\n`testbench/coverage/exclusions.txt`; *points*: left out of what is "
      "above.\n\n| pattern | kind | points | reason |\n|:--|:--|--:|:--|\n";
  for (const Exclusion& e : exclusions) {
    std::string pattern = (e.profile.empty() ? "" : e.profile + ": ") + e.pattern;
    for (std::size_t at = 0; (at = pattern.find('|', at)) != std::string::npos; at += 2) {
      pattern.replace(at, 1, "\\|");
    }
    text += fmt::format("| {} | {} | {} | {} |\n", pattern, e.kind, e.used, e.reason);
  }
  return text;
}

nlohmann::ordered_json coverage_json(const std::vector<ProfileCoverage>& runs,
                                     const std::vector<Exclusion>& exclusions) {
  using Json = nlohmann::ordered_json;
  const auto shares_json = [](const std::map<CoverKind, Share>& shares) {
    Json json;
    for (const auto& [kind, share] : shares) {
      json[name_of(kind)] = {{"hit", share.hit}, {"all", share.all}, {"excluded", share.excluded}};
    }
    return json;
  };
  Json json;
  for (const ProfileCoverage& run : runs) {
    Json one = {{"reached", run.reached()}, {"frames", run.frames},
                {"cut", run.cut},           {"fragments", run.fragments},
                {"cycles", run.cycles},     {"differences", run.differences},
                {"seconds", run.seconds},   {"total", shares_json(run.code.total)}};
    for (const auto& [name, shares] : run.code.modules) one["modules"][name] = shares_json(shares);
    for (const Bin& bin : run.bins) one["bins"][bin.full_name()] = bin.count;
    for (const CoverKind kind : kCoverKinds) {
      one["missed"][name_of(kind)] = missed_lines(run.code.missed, kind);
    }
    one["missed"]["bin"] = run.missed_bins();
    json["profiles"][run.profile] = one;
  }
  json["exclusions"] = Json::array();
  for (const Exclusion& e : exclusions) {
    json["exclusions"].push_back({{"profile", e.profile},
                                  {"pattern", e.pattern},
                                  {"kind", e.kind},
                                  {"points", e.used},
                                  {"reason", e.reason}});
  }
  return json;
}

}  // namespace kagesen

#include "sim/report/timeline_vcd.h"

#include <fmt/format.h>

#include <map>

namespace kagesen {
namespace {

/// VCD's short name of a track.
std::string id_of(std::uint32_t track) {
  return std::string{static_cast<char>('!' + track % 90), static_cast<char>('!' + track / 90)};
}

/// Names with dots become scopes.
void declare(const std::vector<Timeline::Track>& tracks, std::string& out) {
  for (std::uint32_t t = 0; t < tracks.size(); ++t) {
    std::string name = tracks[t].name;
    int scopes = 0;
    for (std::size_t dot; (dot = name.find('.')) != std::string::npos; ++scopes) {
      out += fmt::format("$scope module {} $end\n", name.substr(0, dot));
      name.erase(0, dot + 1);
    }
    out += tracks[t].kind == Timeline::Kind::kState
               ? fmt::format("$var string 1 {} {}_state $end\n", id_of(t), name)
               : fmt::format("$var wire 32 {} {} $end\n", id_of(t), name);
    for (; scopes > 0; --scopes) out += "$upscope $end\n";
  }
}

}  // namespace

std::string timeline_vcd(const Timeline& timeline) {
  const std::vector<Timeline::Track>& tracks = timeline.tracks();
  std::string out = "$timescale 1 ns $end\n$scope module unit $end\n";
  declare(tracks, out);
  out += "$upscope $end\n$enddefinitions $end\n";

  std::map<Cycle, std::map<std::uint32_t, std::string>> changes;  // by cycle, by track
  std::map<Cycle, std::map<std::uint32_t, int>> pieces;           // more or less of them
  for (const Timeline::Event& e : timeline.events()) {
    switch (tracks[e.track].kind) {
      case Timeline::Kind::kState:
        changes[e.from][e.track] = fmt::format("s{} {}", e.what, id_of(e.track));
        break;
      case Timeline::Kind::kAmount:
        changes[e.from][e.track] = fmt::format("b{:b} {}", e.number, id_of(e.track));
        break;
      case Timeline::Kind::kWork:
        ++pieces[std::max(e.from, timeline.first())][e.track];
        --pieces[e.to + 1][e.track];
        break;
    }
  }
  std::map<std::uint32_t, int> under_way;
  for (const auto& [cycle, steps] : pieces) {
    if (cycle > timeline.last() + 1) break;
    for (const auto& [track, step] : steps) {
      const int now = under_way[track] += step;
      if (step != 0) changes[cycle][track] = fmt::format("b{:b} {}", now, id_of(track));
    }
  }
  for (const auto& [cycle, values] : changes) {
    out += fmt::format("#{}\n", cycle);
    for (const auto& [track, value] : values) out += value + "\n";
  }
  return out + fmt::format("#{}\n", timeline.last() + 1);
}

}  // namespace kagesen

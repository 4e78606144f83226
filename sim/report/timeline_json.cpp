#include "sim/report/timeline_json.h"

#include <fmt/format.h>

namespace kagesen {
namespace {

/// One JSON event; @param fields  beyond name, phase, process and time
void add_event(std::string& out, const std::string& name, const char* phase, std::uint32_t track,
               Cycle at, const std::string& fields) {
  out += fmt::format(",\n{{\"name\":\"{}\",\"ph\":\"{}\",\"pid\":{},\"tid\":0,\"ts\":{}{}}}", name,
                     phase, track + 1, at, fields);
}

}  // namespace

std::string timeline_json(const Timeline& timeline) {
  std::string out = "{\"displayTimeUnit\":\"ns\",\"traceEvents\":[\n";
  const std::vector<Timeline::Track>& tracks = timeline.tracks();
  for (std::size_t t = 0; t < tracks.size(); ++t) {
    out += fmt::format(
        "{}{{\"name\":\"process_name\",\"ph\":\"M\",\"pid\":{},\"tid\":0,\"args\":{{\"name\":\"{}\"}}}}",
        t == 0 ? "" : ",\n", t + 1, tracks[t].name);
  }
  // Work of a track overlaps: each piece is one of its own, told apart by its number here.
  std::uint64_t id = 0;
  for (const Timeline::Event& e : timeline.events()) {
    switch (tracks[e.track].kind) {
      case Timeline::Kind::kWork: {
        const std::string name = fmt::format("{} {}", e.what, e.number);
        const std::string fields = fmt::format(",\"cat\":\"{}\",\"id\":{}", e.what, id++);
        add_event(out, name, "b", e.track, e.from, fields);
        add_event(out, name, "e", e.track, e.to, fields);
        break;
      }
      case Timeline::Kind::kState:
        add_event(out, e.what, "X", e.track, e.from, fmt::format(",\"dur\":{}", e.to - e.from));
        break;
      case Timeline::Kind::kAmount:
        add_event(out, tracks[e.track].name, "C", e.track, e.from,
                  fmt::format(",\"args\":{{\"{}\":{}}}", e.what, e.number));
        break;
    }
  }
  return out + "\n]}\n";
}

}  // namespace kagesen

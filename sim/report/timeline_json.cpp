#include "sim/report/timeline_json.h"

#include <fmt/format.h>

namespace kagesen {

std::string timeline_json(const Timeline& timeline) {
  std::string out = "{\"displayTimeUnit\":\"ns\",\"traceEvents\":[\n";
  for (std::size_t t = 0; t < timeline.tracks().size(); ++t) {
    out += fmt::format(
        "{}{{\"name\":\"process_name\",\"ph\":\"M\",\"pid\":{},\"tid\":0,\"args\":{{\"name\":\"{}\"}}}}",
        t == 0 ? "" : ",\n", t + 1, timeline.tracks()[t]);
  }
  // Events of a track overlap: each is one of its own, told apart by its number here.
  std::uint64_t id = 0;
  for (const Timeline::Event& e : timeline.events()) {
    const auto event = [&](char phase, Cycle at) {
      out += fmt::format(
          ",\n{{\"name\":\"{0} {1}\",\"cat\":\"{0}\",\"ph\":\"{2}\",\"id\":{3},\"pid\":{4},\"tid\":0,"
          "\"ts\":{5}}}",
          e.what, e.number, phase, id, e.track + 1, at);
    };
    event('b', e.from);
    event('e', e.to);
    ++id;
  }
  return out + "\n]}\n";
}

}  // namespace kagesen

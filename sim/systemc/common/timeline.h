#pragma once
/// What blocks did when, within a window of cycles: a track a block.
#include <cstdint>
#include <string>
#include <vector>

#include "sim/memory/timing.h"

namespace kagesen {

class Timeline {
 public:
  struct Event {
    std::uint32_t track;
    const char* what;
    std::uint64_t number;  ///< of the fragment, or the word's address
    Cycle from, to;
  };

  Timeline(Cycle first, Cycle last) : first_(first), last_(last) {}

  std::uint32_t add_track(const std::string& name) {
    tracks_.push_back(name);
    return static_cast<std::uint32_t>(tracks_.size() - 1);
  }
  /// Cycles of events to come count from here.
  void set_base(Cycle base) { base_ = base; }
  void add(std::uint32_t track, const char* what, std::uint64_t number, Cycle from, Cycle to) {
    if (base_ + from > last_ || base_ + to < first_) return;
    events_.push_back({track, what, number, base_ + from, base_ + to});
  }
  const std::vector<std::string>& tracks() const { return tracks_; }
  const std::vector<Event>& events() const { return events_; }

 private:
  Cycle first_, last_, base_ = 0;
  std::vector<std::string> tracks_;
  std::vector<Event> events_;
};

}  // namespace kagesen

#pragma once
/// What blocks did when, within a window of cycles of one pass: a track a block. The SystemC model and
/// the Verilated bench fill it alike, track by track and event by event.
#include <algorithm>
#include <cstdint>
#include <cstring>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "sim/memory/timing.h"

namespace kagesen {

class Timeline {
 public:
  enum class Kind : std::uint8_t {
    kWork,    ///< pieces of work, which overlap
    kState,   ///< one state in each cycle
    kAmount,  ///< a number in each cycle
  };
  struct Track {
    std::string name;
    Kind kind;
  };
  struct Event {
    std::uint32_t track;
    const char* what;      ///< outlives the timeline
    std::uint64_t number;  ///< of the fragment or triangle, the word's address, or the amount
    Cycle from, to;        ///< work: first and last cycle; else `to` is the first that is not of it any more
  };

  /// @param pass  1 or 2, whose first cycle is 0
  Timeline(unsigned pass, Cycle first, Cycle last) : pass_(pass), first_(first), last_(last) {}

  unsigned pass() const { return pass_; }
  Cycle first() const { return first_; }
  Cycle last() const { return last_; }
  /// The same for the same name.
  std::uint32_t track(const std::string& name, Kind kind) {
    for (std::size_t t = 0; t < tracks_.size(); ++t) {
      if (tracks_[t].name == name) return static_cast<std::uint32_t>(t);
    }
    tracks_.push_back({name, kind});
    return static_cast<std::uint32_t>(tracks_.size() - 1);
  }
  /// Events to come are of this pass, and count their cycles from `base`.
  void begin(unsigned pass, Cycle base) {
    open_ = pass == pass_;
    base_ = base;
  }
  /// May events of a cycle still count?
  bool open(Cycle at) const { return open_ && base_ + at <= last_; }

  void work(std::uint32_t track, const char* what, std::uint64_t number, Cycle from, Cycle to) {
    if (!open_ || base_ + from > last_ || base_ + to < first_) return;
    events_.push_back({track, what, number, base_ + from, base_ + to});
  }
  /// In the cycles from `from` to before `to`.
  void state(std::uint32_t track, const char* what, Cycle from, Cycle to, std::uint64_t number = 0) {
    if (!open_) return;
    from = std::max(base_ + from, first_);
    to = std::min(base_ + to, last_ + 1);
    if (from < to) events_.push_back({track, what, number, from, to});
  }

  /// In the order of tracks' names and of time; what goes on in the next cycle is one event. Tracks without any go.
  void finish() {
    sort_tracks();
    std::stable_sort(events_.begin(), events_.end(), [](const Event& a, const Event& b) {
      return std::tie(a.track, a.from, a.number, a.to) < std::tie(b.track, b.from, b.number, b.to);
    });
    std::vector<Event> events;
    for (const Event& e : events_) {
      Event* const before = events.empty() ? nullptr : &events.back();
      const bool goes_on = before != nullptr && tracks_[e.track].kind != Kind::kWork &&
                           before->track == e.track && before->to == e.from &&
                           before->number == e.number && std::strcmp(before->what, e.what) == 0;
      if (goes_on) {
        before->to = e.to;
      } else {
        events.push_back(e);
      }
    }
    events_ = std::move(events);
  }
  const std::vector<Track>& tracks() const { return tracks_; }
  const std::vector<Event>& events() const { return events_; }

 private:
  void sort_tracks() {
    std::vector<std::uint32_t> order(tracks_.size()), place(tracks_.size());
    for (std::size_t t = 0; t < order.size(); ++t) order[t] = static_cast<std::uint32_t>(t);
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
      return tracks_[a].name < tracks_[b].name;
    });
    std::vector<bool> used(tracks_.size());
    for (const Event& e : events_) used[e.track] = true;
    std::vector<Track> tracks;
    for (const std::uint32_t t : order) {
      place[t] = static_cast<std::uint32_t>(tracks.size());
      if (used[t]) tracks.push_back(tracks_[t]);
    }
    tracks_ = std::move(tracks);
    for (Event& e : events_) e.track = place[e.track];
  }

  unsigned pass_;
  Cycle first_, last_, base_ = 0;
  bool open_ = false;
  std::vector<Track> tracks_;
  std::vector<Event> events_;
};

}  // namespace kagesen

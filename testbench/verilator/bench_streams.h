#pragma once
/// What enters and leaves the unit during a pass, beat by beat. In each cycle: offer() before its outputs
/// settle, take() after, edge() after the clock's edge.
#include <array>

#include "sim/memory/timing.h"
#include "testbench/verilator/bench_top.h"

namespace kagesen::bench {

/// Cycles in which the far ends of streams and write ports do not move.
class StreamStalls {
 public:
  void begin_pass(const Timing& timing, const PassNumber& number) {
    any_ = timing.stream_stall != 0;
    for (unsigned l = 0; l < kLanes; ++l) {
      for (const Channel c : {Channel::kFragments, Channel::kVerdicts}) {
        stalls_[l][std::size_t(c)] = Stalls(timing.stream_stall, Chance(timing.seed, number, c, l));
      }
    }
    const auto set = [&](Channel c, std::uint32_t per_cent) {
      stalls_[0][std::size_t(c)] = Stalls(per_cent, Chance(timing.seed, number, c, 0));
    };
    set(Channel::kTriangles, timing.stream_stall);
    set(Channel::kTexelWrites, timing.memory_stall);
    set(Channel::kSlbWrites, timing.memory_stall);
  }
  bool any() const { return any_; }
  bool at(Cycle now, Channel channel, unsigned lane = 0) const {
    return stalls_[lane][std::size_t(channel)].at(now);
  }

 private:
  bool any_ = false;
  std::array<std::array<Stalls, kChannels>, kLanes> stalls_{};  // by channel
};

/// A pass as its streams see it.
struct Stage {
  Vshadow_bench& top;
  const StreamStalls& stalls;
  Events& events;
  std::uint64_t& items;  ///< of the pass
  Cycle now = 0;         ///< from the pass's first cycle on
};

struct Nothing {
  void offer(Stage&) {}
  bool take(Stage&) { return false; }
  void edge(Stage&) {}
};

struct Triangles {
  const Triangle* beats;
  std::size_t count;
  std::uint64_t* cycles;  // of the next item; may be null
  std::size_t next = 0;
  bool taken = false;  // in this cycle

  void offer(Stage& s) {
    Vshadow_bench& top = s.top;
    if (top.tri_valid_i || next == count || s.stalls.at(s.now, Channel::kTriangles)) return;
    const Triangle& t = beats[next];
    top.tri_valid_i = 1;
    top.tri_kind_i = static_cast<std::uint8_t>(t.is_plane << 4 | t.shares << 3 | t.inner);
    top.tri_polygon_i = t.polygon & 0xffffff;
    top.tri_object_i = t.object;
    top.tri_x0_i = t.x[0] & 0xfffffff;
    top.tri_y0_i = t.y[0] & 0xfffffff;
    top.tri_z0_i = t.z[0];
    top.tri_x1_i = t.x[1] & 0xfffffff;
    top.tri_y1_i = t.y[1] & 0xfffffff;
    top.tri_z1_i = t.z[1];
    top.tri_x2_i = t.x[2] & 0xfffffff;
    top.tri_y2_i = t.y[2] & 0xfffffff;
    top.tri_z2_i = t.z[2];
  }
  bool take(Stage& s) {
    taken = s.top.tri_valid_i && s.top.tri_ready_o;
    if (!taken || beats[next++].is_plane) return taken;
    ++s.items;
    if (cycles != nullptr) *cycles++ = s.now;
    return taken;
  }
  void edge(Stage& s) {
    if (taken) s.top.tri_valid_i = 0;
  }
};

struct Fragments {
  const Fragment* fragments;
  std::size_t count;
  unsigned lanes;
  Verdict* verdicts;       // null: an announcement
  FragmentCycles* cycles;  // may be null
  unsigned taken = 0;      // in this cycle, a bit a lane
  std::array<std::size_t, kLanes> sent{}, answered{};

  void offer(Stage& s) {
    Vshadow_bench& top = s.top;
    for (unsigned l = 0; l < lanes; ++l) {
      const std::size_t next = sent[l] * lanes + l;
      if ((top.frag_valid_i >> l & 1) != 0 || next >= count ||
          s.stalls.at(s.now, Channel::kFragments, l)) {
        continue;
      }
      const Fragment& f = fragments[next];
      top.frag_valid_i |= static_cast<std::uint8_t>(1u << l);
      set_field(top.frag_flags_i, 3 * l, 3, f.unshadowable << 2 | f.outside << 1 | f.averted);
      set_field(top.frag_object_i, 24 * l, 24, f.object);
      set_field(top.frag_x_i, 28 * l, 28, static_cast<std::uint32_t>(f.x));
      set_field(top.frag_y_i, 28 * l, 28, static_cast<std::uint32_t>(f.y));
      set_field(top.frag_z_i, 24 * l, 24, f.z);
    }
    unsigned ready = (1u << kLanes) - 1;
    if (s.stalls.any()) {
      for (unsigned l = 0; l < kLanes; ++l) {
        ready &= ~(unsigned{s.stalls.at(s.now, Channel::kVerdicts, l)} << l);
      }
    }
    top.verdict_ready_i = static_cast<std::uint8_t>(ready);
  }
  bool take(Stage& s) {
    taken = s.top.frag_valid_i & s.top.frag_ready_o;
    for (unsigned l = 0; taken >> l != 0; ++l) {
      if ((taken >> l & 1) == 0) continue;
      const std::size_t at = sent[l]++ * lanes + l;
      if (cycles != nullptr) cycles[at].accepted = s.now;
      ++s.items;
    }
    const unsigned given = s.top.verdict_valid_o & s.top.verdict_ready_i;
    for (unsigned l = 0; given >> l != 0; ++l) {
      if ((given >> l & 1) != 0) answer(l, s);
    }
    return (taken | given) != 0;
  }
  void edge(Stage& s) {
    if (taken != 0) s.top.frag_valid_i &= static_cast<std::uint8_t>(~taken);
  }

 private:
  void answer(unsigned lane, Stage& s) {
    const std::size_t at = answered[lane]++ * lanes + lane;
    if (verdicts == nullptr || at >= count) {
      throw Failure("the unit gave a verdict that nobody asked for");
    }
    const unsigned dark = s.top.verdict_dark_o >> lane & 1;
    const auto by = static_cast<unsigned>(field(s.top.verdict_by_o, 3 * lane, 3));
    verdicts[at] = {static_cast<std::uint8_t>(dark), static_cast<std::uint8_t>(by & 7)};
    ++s.events.verdicts[dark][by];
    if (cycles != nullptr) cycles[at].retired = s.now;
  }
};

}  // namespace kagesen::bench

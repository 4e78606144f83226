#include "sim/systemc/paper/slb_step.h"

namespace kagesen::tlm_model::paper {

SlbStep entry_move(SlbState& state, SlbWalk& w, const SlbFacts& f, const SlbRecord& record) {
  SlbStep s;
  s.act = f.hit;
  s.look = true;
  s.look_address = w.entry;
  s.write_address = f.at;
  s.link_has = true;
  s.link_address = w.place;
  s.free_address = w.next;
  const auto joined = [&] {
    w.relink = false;
    w.settled = w.head = true;
    w.record = 0;
    state = SlbState::kScan;
  };
  switch (state) {
    case SlbState::kBehind:
      state = SlbState::kStay;
      if (f.same_texel && f.before_it) {
        s.look_address = w.is_own ? w.entry : w.prev;
        state = w.is_own ? SlbState::kUnlinkCopy : SlbState::kUnlink;
      } else if (!f.same_texel && record.has_next) {
        s.look_address = record.next;
        state = SlbState::kBehind;
      }
      break;
    case SlbState::kStay:
      s.write = s.set_nearest = true;
      joined();
      break;
    case SlbState::kUnlink:
      s.write = s.set_next = s.restart = true;
      s.link_has = w.has_next;
      s.link_address = w.next;
      w.relink = true;
      break;
    case SlbState::kUnlinkCopy:
      s.write = s.take = true;
      s.write_address = w.entry = f.spot;
      s.look_address = w.next;
      state = SlbState::kUnlinkPull;
      break;
    case SlbState::kUnlinkPull:
      s.write = s.keep = s.restart = true;
      s.write_address = w.own;
      w.relink = true;
      break;
    case SlbState::kRejoin:
      s.write = s.set_next = s.set_nearest = true;
      s.link_has = w.has_next;
      s.link_address = w.next;
      w.is_own = false;
      joined();
      break;
    case SlbState::kRejoinOwn:
      s.write = s.set_next = s.set_nearest = s.keep = true;
      s.write_address = w.own;
      s.free_address = w.entry;
      w.is_own = true;
      w.entry = s.look_address = w.own;
      joined();
      break;
    default:
      s.act = false;
  }
  return s;
}

}  // namespace kagesen::tlm_model::paper

#include "sim/systemc/paper/slb_step.h"

namespace kagesen::tlm_model::paper {

SlbStep chain_erase(SlbState& state, SlbWalk& w, const SlbFacts& f, const SlbRecord& record) {
  SlbStep s;
  const bool all = w.mode == Erase::kAll;
  const bool erases = f.same_texel && (all || (w.mode == Erase::kHidden && f.erasable));
  bool linked = false;  // the chain is closed again
  bool finish = false;  // all entries of the texel were looked at, or need not be
  s.act = f.hit;
  s.look_address = s.write_address = s.free_address = f.at;
  s.link_has = w.has_next;
  s.link_address = w.next;
  s.more_has = f.has_free;
  s.more_address = f.free;
  switch (state) {
    case SlbState::kJudge:
      s.act = true;
      s.stored = s.last = !f.too_long;
      state = SlbState::kOverflow;
      break;
    case SlbState::kOverflow:
      s.act = s.touch = s.set_edge = s.walk = true;
      w.mode = Erase::kAll;
      break;
    case SlbState::kWalk:
      s.act = f.hit && f.texel_hit;
      w.next = record.next;
      w.has_next = record.has_next;
      s.look = true;
      if (erases) {
        s.touch = all;
        w.head = true;
        state = SlbState::kErase;
      } else {
        w.kept = w.kept || f.same_texel;
        w.prev = f.at;
        w.has_prev = true;
        s.look_address = record.next;
        finish = !record.has_next;
      }
      break;
    case SlbState::kErase: {
      const bool head = w.head;
      s.used_less = true;
      if (head) w.ahead = w.has_prev ? f.at : record.more;
      w.head = false;
      s.look = true;
      s.look_address = record.more;
      if (!record.has_more) {
        if (!head || w.has_prev) {
          s.write = s.set_more = s.free = true;
          s.free_address = w.ahead;
        }
        s.look_address = w.has_prev ? w.prev : w.next;
        s.look = w.has_prev || w.has_next;
        state = SlbState::kEraseLink;
      }
      break;
    }
    case SlbState::kEraseLink:
      s.write = true;
      if (w.has_prev) {
        s.set_next = linked = true;
      } else if (w.has_next) {
        s.write_address = w.own;
        state = SlbState::kEraseFree;
      } else {
        s.act = s.unused_record = finish = true;
        s.write_address = w.own;
      }
      break;
    case SlbState::kEraseFree:
      s.write = s.set_more = s.free = linked = true;
      break;
    default:
      s.act = false;
  }
  if (linked && w.emptying) {
    w.emptying = false;
    w.mode = w.covered && f.wants_hiding ? Erase::kHidden : Erase::kNone;
    s.walk = w.mode == Erase::kHidden ? w.kept || w.has_next : !w.kept && w.has_next;
    finish = !s.walk;
  } else if (linked && !w.has_prev) {
    s.walk = true;
  } else if (linked) {
    s.look = true;
    s.look_address = w.next;
    state = SlbState::kWalk;
    finish = !w.has_next;
  }
  if (finish) {
    s.spread = true;
    s.touch = !all && (!w.kept || w.covered);
    s.set_edge = !all;
    s.edge_flag = w.kept;
  }
  return s;
}

}  // namespace kagesen::tlm_model::paper

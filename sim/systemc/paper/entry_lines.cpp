#include "sim/systemc/paper/slb_step.h"

namespace kagesen::tlm_model::paper {
namespace {

void scan(SlbState& state, SlbWalk& w, const SlbFacts& f, const SlbRecord& record, SlbStep& s) {
  if (w.head) {
    w.next = record.next;
    w.has_next = record.has_next;
    w.nearer = f.nearer;
    w.new_corner = f.new_corner;
    w.new_vertex = f.new_vertex;
  }
  ++w.length;
  if (w.gap || (!w.settled && f.match)) {
    if (record.has_more) {
      w.ahead = f.at;
      s.look_address = record.more;
      state = SlbState::kLift;
      return;
    }
    s.write = true;
    if (w.head) {
      s.remove = s.set_corner = s.last = true;
      s.emptied = record.count == 1;
    } else if (record.count == 1) {
      s.set_more = s.free = s.used_less = true;
      s.look_address = w.ahead;
      state = SlbState::kCut;
    } else {
      s.remove = true;
      s.last = !w.new_corner;
      state = SlbState::kMark;
    }
  } else if (record.has_more) {
    w.ahead = f.at;
    w.head = false;
    ++w.record;
    s.look_address = record.more;
  } else if (!w.settled && f.hidden) {
    s.last = true;
  } else if (!w.settled && w.nearer) {
    s.look_address = !w.is_first ? w.prev : w.has_next ? w.next : w.entry;
    state = !w.is_first  ? SlbState::kUnlink
            : w.has_next ? SlbState::kBehind
                         : SlbState::kStay;
  } else if (f.room) {
    s.write = s.append = true;
    s.set_corner = s.set_vertex = w.head;
    s.stored = s.last = w.head || !(w.new_corner || w.new_vertex);
    w.storing = true;
    state = SlbState::kMark;
  } else if (f.full) {
    s.look = false;
    state = SlbState::kOverflow;
  } else {
    s.write = s.set_more = s.more_has = s.look_new = true;
    s.more_address = s.look_address = f.spot;
    state = SlbState::kExtend;
  }
}

}  // namespace

SlbStep entry_lines(SlbState& state, SlbWalk& w, const SlbFacts& f, const SlbRecord& record) {
  SlbStep s;
  s.act = f.hit;
  s.look = true;
  s.look_address = w.entry;
  s.write_address = s.free_address = f.at;
  s.more_has = f.has_free;
  s.more_address = f.free;
  switch (state) {
    case SlbState::kScan:
      scan(state, w, f, record, s);
      break;
    case SlbState::kLift:
      s.look_address = w.ahead;
      state = SlbState::kClose;
      break;
    case SlbState::kClose:
      s.write = s.remove = s.refill = true;
      w.ahead = f.at;
      w.head = false;
      w.gap = true;
      s.look_address = record.more;
      state = SlbState::kScan;
      break;
    case SlbState::kCut:
      s.write = s.set_more = true;
      s.more_has = false;
      state = SlbState::kMark;
      break;
    case SlbState::kExtend:
      s.act = s.write = s.take = s.used_more = s.fresh = s.append = true;
      s.write_address = f.spot;
      w.storing = w.grown = true;
      state = SlbState::kMark;
      break;
    case SlbState::kMark:
      s.write = s.set_corner = true;
      s.set_vertex = w.storing;
      if (w.grown && !(f.short_chain && (f.few || !w.has_next))) {
        w.length = 0;
        s.look_address = w.own;
        state = SlbState::kLength;
      } else {
        s.stored = w.storing;
        s.last = true;
      }
      break;
    case SlbState::kLength:
      if (f.same_texel) ++w.length;
      w.next = record.next;
      w.has_next = record.has_next;
      s.look_address = record.next;
      if (f.same_texel && record.has_more) {
        s.look_address = record.more;
        state = SlbState::kLengthMore;
      } else if (!record.has_next) {
        s.look = false;
        state = SlbState::kJudge;
      }
      break;
    case SlbState::kLengthMore:
      ++w.length;
      s.look_address = record.more;
      if (!record.has_more) {
        s.look = w.has_next;
        s.look_address = w.next;
        state = w.has_next ? SlbState::kLength : SlbState::kJudge;
      }
      break;
    default:
      s.act = false;
  }
  return s;
}

}  // namespace kagesen::tlm_model::paper

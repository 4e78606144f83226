#include "sim/systemc/paper/slb_step.h"

namespace kagesen::tlm_model::paper {
namespace {

/// An emptied entry, found.
void give_up(SlbState& state, SlbWalk& w, const SlbFacts& f, const SlbRecord& record, SlbStep& s) {
  w.covered = f.covered;
  w.next = record.next;
  w.has_next = record.has_next;
  w.kept = w.seen;
  w.emptying = true;
  w.mode = Erase::kNone;
  s.look = true;
  state = SlbState::kEraseLink;
  if (record.count != 0) {
    s.last = true;
    return;
  }
  s.used_less = true;
  if (w.has_prev) {
    s.look_address = w.prev;
    s.keep = !f.has_spot;
    s.free = s.write = f.has_spot;
    s.set_more = true;
  } else if (record.has_next) {
    s.look_address = record.next;
  } else {
    s.write = s.unused_record = s.touch = s.set_edge = s.last = true;
  }
}

void find(SlbState& state, SlbWalk& w, const SlbFacts& f, const SlbRecord& record, SlbStep& s,
          bool& store_new, bool& store_here) {
  const bool first_line = f.is_edge && !w.relink;
  s.act = f.texel_hit && f.hit;
  if (first_line && f.dry && f.has_free) {
    s.act = s.look = true;
    s.look_address = f.free;
    state = SlbState::kReuse;
  } else if (first_line && f.overflow) {
    s.act = f.texel_hit;
    s.touch = s.last = true;
  } else if (first_line && !f.edge_flag && f.hidden) {
    s.act = f.texel_hit;
    s.last = true;
  } else if (first_line && !f.edge_flag && f.full) {
    s.act = f.texel_hit;
    s.touch = s.last = true;
  } else if (first_line && !f.edge_flag) {
    s.write = true;
    if (record.used) {
      s.set_next = s.look = s.look_new = true;
      w.next = record.next;
      w.has_next = record.has_next;
      s.look_address = f.spot;
      state = SlbState::kNew;
    } else {
      store_new = s.last = true;
    }
  } else if (!f.is_edge && !f.edge_flag) {
    s.act = f.texel_hit;
    s.last = true;
  } else if (f.same_entry && first_line) {
    w.entry = f.at;
    w.is_own = !w.has_prev;
    w.is_first = !w.seen;
    w.head = true;
    w.record = 0;
    if (record.has_more && !f.match) {
      w.next = record.next;
      w.has_next = record.has_next;
      w.nearer = f.nearer;
      w.new_corner = f.new_corner;
      w.new_vertex = f.new_vertex;
      ++w.length;
      w.ahead = f.at;
      w.head = false;
      w.record = 1;
      s.look = true;
      s.look_address = record.more;
      state = SlbState::kScan;
    } else if (f.match && !record.has_more) {
      s.write = s.remove = s.set_corner = s.last = true;
      s.emptied = record.count == 1;
    } else if (f.hidden && !f.match) {
      s.last = true;
    } else if (f.room && !f.match && !(f.nearer && (w.seen || record.has_next))) {
      s.write = store_here = s.stored = s.last = true;
      s.set_nearest = f.nearer;
    } else {
      s.look = true;
      s.look_address = f.at;
      state = SlbState::kScan;
    }
  } else if (f.same_entry && !f.is_edge) {
    give_up(state, w, f, record, s);
  } else {
    const SlbWalk before = w;
    if (f.same_texel) {
      w.seen = true;
      ++w.length;
      w.continued = w.continued || record.has_more;
      if (!w.placed) {
        if (f.beyond_it) {
          w.placed = true;
          w.push = !before.has_prev;
          w.place = before.prev;
        } else {
          w.place = f.at;
        }
      }
    }
    w.prev = f.at;
    w.has_prev = true;
    s.look = true;
    s.look_address = record.next;
    if (!record.has_next) {
      s.look_address = w.push ? w.own : w.place;
      state = w.push ? SlbState::kPush : SlbState::kLink;
      if (!f.is_edge || (first_line && f.hidden)) {
        s.last = true;
      } else if (first_line && f.full) {
        s.look = false;
        state = SlbState::kOverflow;
      }
    }
  }
}

}  // namespace

SlbStep chain_find(SlbState& state, SlbWalk& w, const SlbFacts& f, const SlbRecord& record) {
  const SlbState now = state;
  SlbStep s;
  bool store_new = false, store_here = false;
  s.act = f.hit;
  s.look_address = w.own;
  s.write_address = s.free_address = f.at;
  s.link_has = true;
  s.link_address = f.spot;
  s.more_has = f.has_free;
  s.more_address = f.free;
  switch (now) {
    case SlbState::kSpan:
      s.act = f.texel_hit;
      s.touch = s.spread = true;
      w.todo = f.wants_hiding ? f.edges : 0;
      break;
    case SlbState::kFind:
      find(state, w, f, record, s, store_new, store_here);
      break;
    case SlbState::kNew:
      s.act = s.write = s.take = store_new = true;
      s.write_address = f.spot;
      s.link_has = w.has_next;
      s.link_address = w.next;
      break;
    case SlbState::kLink:
      s.write = s.set_next = s.look = s.look_new = true;
      w.next = record.next;
      w.has_next = record.has_next;
      s.look_address = f.spot;
      state = SlbState::kNew;
      if (w.relink) {
        s.link_address = s.look_address = w.entry;
        s.look_new = false;
        state = SlbState::kRejoin;
      }
      break;
    case SlbState::kPush:
      s.write = s.take = s.look = true;
      s.write_address = w.place = f.spot;
      state = SlbState::kPushNew;
      if (w.relink) {
        s.look_address = w.entry;
        state = SlbState::kRejoinOwn;
      }
      break;
    case SlbState::kPushNew:
      s.write = store_new = true;
      s.link_address = w.place;
      break;
    case SlbState::kReuse:
      s.reuse = s.look = true;
      state = SlbState::kFind;
      break;
    default:
      s.act = false;
  }
  if (store_new) {
    s.fresh = s.used_more = true;
    s.set_next = now != SlbState::kFind;
    w.storing = true;
    if (now == SlbState::kFind || f.short_chain) {
      s.stored = s.last = true;
    } else {
      s.look = true;
      w.length = 0;
      state = SlbState::kLength;
    }
  }
  if (store_new || store_here) s.append = s.set_corner = s.set_vertex = true;
  return s;
}

}  // namespace kagesen::tlm_model::paper

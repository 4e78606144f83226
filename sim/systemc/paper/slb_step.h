#pragma once
/// How an operation walks the SLB: what one step does to records, pool and texel, and what comes next.
/// Twin: slb_walk_t, slb_facts_t, slb_step_t in shadow_pkg.sv; chain_find, entry_lines, entry_move,
/// chain_erase in rtl/paper, of which each function here has the name.
///
/// A record stands here without its lines, and a step without what takes no time. What the operation
/// finds in texel and lines, golden has said.
#include <array>
#include <cstdint>

namespace kagesen::tlm_model::paper {

using RecordAddress = std::uint32_t;

struct SlbRecord {
  bool used = false, has_next = false, has_more = false, corner = false, vertex = false;
  std::uint8_t count = 0;  ///< lines
  RecordAddress next = 0, more = 0;
  std::uint32_t texel = 0, object = 0, nearest = 0;
};

enum class SlbState : std::uint8_t {
  kIdle, kSpan, kFind, kNew, kLink, kPush, kPushNew, kReuse,                       // chain_find
  kScan, kLift, kClose, kCut, kExtend, kMark, kLength, kLengthMore,                // entry_lines
  kBehind, kStay, kUnlink, kUnlinkCopy, kUnlinkPull, kRejoin, kRejoinOwn, kUnused, // entry_move
  kJudge, kOverflow, kWalk, kErase, kEraseLink, kEraseFree                         // chain_erase
};

enum class Erase : std::uint8_t { kAll, kHidden, kNone };

/// What an operation knows from one step to the next.
struct SlbWalk {
  unsigned word_x = 0;
  RecordAddress own = 0, ahead = 0, prev = 0, entry = 0, place = 0, next = 0;
  bool has_prev = false, head = false, is_own = false, is_first = false, push = false,
       placed = false, seen = false, has_next = false, relink = false, settled = false,
       nearer = false, new_corner = false, new_vertex = false, gap = false, grown = false, storing = false, continued = false, kept = false,
       covered = false, emptying = false;
  std::uint32_t length = 0, record = 0;  ///< record: of the entry, from 0
  Erase mode = Erase::kAll;
  unsigned todo = 0;
};

/// What is so in this cycle.
struct SlbFacts {
  bool hit, texel_hit, is_edge, edge_flag, overflow, same_texel, same_entry, match, hidden, nearer,
      new_corner, new_vertex, before_it, beyond_it, room, erasable, full, few, short_chain, too_long, wants_hiding, covered,
      has_spot, dry, has_free;
  RecordAddress at, spot, free;
  unsigned edges;
};

/// What is done in a cycle, all of it or, if a memory takes no write, nothing.
struct SlbStep {
  bool act = false, last = false, look = false, look_new = false, restart = false, walk = false,
       spread = false;
  RecordAddress look_address = 0;
  // record
  bool write = false, fresh = false, unused_record = false, set_next = false, link_has = false,
       set_more = false, more_has = false, set_nearest = false, set_corner = false, set_vertex = false, append = false, remove = false,
       refill = false, emptied = false;
  RecordAddress write_address = 0, link_address = 0, more_address = 0;
  // pool
  bool take = false, keep = false, free = false, reuse = false, used_more = false, used_less = false;
  RecordAddress free_address = 0;
  // texel
  bool touch = false, stored = false, set_edge = false, edge_flag = false;
};

SlbStep chain_find(SlbState& state, SlbWalk& walk, const SlbFacts& facts, const SlbRecord& record);
SlbStep entry_lines(SlbState& state, SlbWalk& walk, const SlbFacts& facts, const SlbRecord& record);
SlbStep entry_move(SlbState& state, SlbWalk& walk, const SlbFacts& facts, const SlbRecord& record);
SlbStep chain_erase(SlbState& state, SlbWalk& walk, const SlbFacts& facts, const SlbRecord& record);

}  // namespace kagesen::tlm_model::paper

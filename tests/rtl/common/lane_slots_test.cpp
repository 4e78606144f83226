#include <gtest/gtest.h>

#include <deque>
#include <random>
#include <vector>

#include "Vlane_slots_test_dut.h"

namespace {

/// Slots decided by any of the three stages in any order; fails if a verdict is lost, doubled, out
/// of order or another stage's.
TEST(LaneSlots, RetiresInOrderWhateverDecides) {
  enum Stage { kKnown, kEarly, kLate };
  struct Slot {
    unsigned slot, verdict;
    Stage by;
    int stage = 0;  // what saw it: nothing, known, early, ...
    bool done = false;
  };
  for (int seed = 1; seed <= 20; ++seed) {
    std::mt19937 random(seed);
    Vlane_slots_test_dut dut;
    dut.clk_i = dut.clear_i = dut.rst_ni = 0;
    dut.take_i = dut.known_i = dut.early_i = dut.late_i = dut.verdict_ready_i = 0;
    dut.eval();
    dut.rst_ni = 1;
    std::deque<Slot> slots;   // given out, in order
    unsigned verdicts = 0;
    const unsigned take = 1 + random() % 10, act = 1 + random() % 10, ready = 1 + random() % 10;
    for (int cycle = 0; cycle < 20000; ++cycle) {
      dut.clear_i = random() % 2000 == 0;
      dut.take_i = dut.known_i = dut.early_i = dut.late_i = 0;
      dut.eval();
      // One slot for each stage, none twice in a cycle.
      std::vector<Slot*> waits[3];
      for (Slot& s : slots) {
        if (!s.done) waits[std::min(s.stage, 2)].push_back(&s);
      }
      const auto pick = [&](std::vector<Slot*>& from) -> Slot* {
        return from.empty() || random() % 10 >= act ? nullptr : from[random() % from.size()];
      };
      Slot* known = pick(waits[0]);
      Slot* early = pick(waits[1]);
      Slot* late = pick(waits[2]);
      if (known != nullptr) {
        dut.known_i = 1;
        dut.known_slot_i = known->slot;
        dut.known_final_i = known->by == kKnown;
        dut.known_verdict_i = known->by == kKnown ? known->verdict : random() % 16;
      }
      if (early != nullptr) {
        dut.early_i = 1;
        dut.early_slot_i = early->slot;
        dut.early_final_i = early->by == kEarly;
        dut.early_verdict_i = early->by == kEarly ? early->verdict : random() % 16;
      }
      if (late != nullptr) {
        dut.late_i = 1;
        dut.late_slot_i = late->slot;
        dut.late_verdict_i = late->verdict;
      }
      dut.take_i = dut.free_o && random() % 10 < take;
      dut.verdict_ready_i = random() % 10 < ready;
      dut.eval();
      const unsigned next_slot = dut.slot_o;
      if (dut.verdict_valid_o && dut.verdict_ready_i && !dut.clear_i) {
        ASSERT_FALSE(slots.empty());
        ASSERT_TRUE(slots.front().done);
        ASSERT_EQ(dut.verdict_o, slots.front().verdict);
        slots.pop_front();
        ++verdicts;
      }
      for (Slot* s : {known, early, late}) {
        if (s == nullptr || slots.empty()) continue;
        s->done = s->by == s->stage;
        ++s->stage;
      }
      if (dut.take_i) {
        slots.push_back({next_slot, static_cast<unsigned>(random() % 16), Stage(random() % 3)});
      }
      ASSERT_LE(slots.size(), 9u);  // eight slots and the verdict that is offered
      if (dut.clear_i) slots.clear();
      dut.clk_i = 1;
      dut.eval();
      dut.clk_i = 0;
      dut.eval();
      dut.clear_i = dut.take_i = 0;
      dut.eval();
      ASSERT_EQ(dut.idle_o != 0, slots.empty());
    }
    EXPECT_GT(verdicts, 500u);
  }
}

}  // namespace

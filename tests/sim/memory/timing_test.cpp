/// Each gate of a read port: refused a cycle early, taken in time. Jumping from request to request
/// gives what stepping through every cycle does.
#include "sim/memory/timing.h"

#include <gtest/gtest.h>

#include <random>
#include <set>

namespace kagesen {
namespace {

ReadTiming port(const Timing& timing) {
  ReadTiming port;
  port.configure(timing);
  return port;
}

TEST(ReadTiming, IntervalIsTight) {
  Timing timing;
  timing.interval = 5;
  ReadTiming stepped = port(timing), jumped = port(timing);
  stepped.accept(10, 0);
  EXPECT_FALSE(stepped.ready(14));
  EXPECT_TRUE(stepped.ready(15));
  jumped.accept(10, 0);
  EXPECT_EQ(jumped.next_ready(11), 15u);
}

TEST(ReadTiming, LimitIsTight) {
  Timing timing;
  timing.latency = 20;
  timing.outstanding = 2;
  ReadTiming stepped = port(timing), jumped = port(timing);
  for (ReadTiming* p : {&stepped, &jumped}) {
    EXPECT_EQ(p->accept(10, 0), 30u);
    EXPECT_TRUE(p->ready(11));
    p->accept(11, 0);
  }
  EXPECT_FALSE(stepped.ready(29));
  EXPECT_TRUE(stepped.ready(30));
  EXPECT_EQ(jumped.next_ready(12), 30u);
}

TEST(ReadTiming, BanksAndRowsAreTight) {
  Timing timing;
  timing.latency = 20;
  timing.banks = 2;
  timing.bank_busy = 4;
  timing.row_words = 8;
  timing.row_miss = 6;
  ReadTiming p = port(timing);
  EXPECT_EQ(p.accept(0, 0), 26u);    // opens row 0 of bank 0, which is busy until 10
  EXPECT_EQ(p.accept(1, 8), 27u);    // bank 1 is another one
  EXPECT_EQ(p.accept(9, 7), 30u);    // same row, a cycle too early: starts in 10
  EXPECT_EQ(p.accept(14, 3), 34u);   // in time
  EXPECT_EQ(p.accept(18, 16), 44u);  // another row of bank 0
}

TEST(ReadTiming, ResponsesNeverMeet) {
  Timing timing;
  timing.latency = 3;
  timing.spread = 30;
  ReadTiming p = port(timing);
  std::set<Cycle> responses;
  for (Cycle now = 0; now < 20'000; ++now) {
    const Cycle at = p.accept(now, 0);
    EXPECT_GE(at, now + 3);
    EXPECT_TRUE(responses.insert(at).second) << now;
  }
}

TEST(ReadTiming, JumpsAsItSteps) {
  std::mt19937 random(4);
  for (int round = 0; round < 200; ++round) {
    Timing timing;
    timing.latency = 1 + random() % 40;
    timing.spread = random() % 2 ? 0 : random() % 30;
    timing.memory_stall = random() % 2 ? 0 : random() % 90;
    timing.interval = 1 + random() % 3;
    timing.outstanding = random() % 2 ? 0 : 1 + random() % 8;
    timing.seed = random();
    ReadTiming stepped = port(timing), jumped = port(timing);
    Cycle asked = 0, now = 0;
    for (int i = 0; i < 200; ++i) {
      asked += random() % 20 == 0 ? random() % 60 : 0;
      for (now = std::max(now, asked); !stepped.ready(now);) ++now;
      const Cycle accepted = jumped.next_ready(asked);
      ASSERT_EQ(accepted, now) << round;
      ASSERT_EQ(stepped.accept(now, i), jumped.accept(accepted, i)) << round;
      asked = ++now;
    }
  }
}

TEST(Stalls, AsOftenAsAskedAndOfTheirOwnInEveryPass) {
  const Stalls one(30, Chance(1, {5, 0}, Channel::kTexelReads, 0));
  const Stalls next(30, Chance(1, {5, 1}, Channel::kTexelReads, 0));
  const Stalls lane(30, Chance(1, {5, 0}, Channel::kTexelReads, 1));
  int stalls = 0, unlike_next = 0, unlike_lane = 0;
  for (Cycle now = 0; now < 100'000; ++now) {
    stalls += one.at(now);
    unlike_next += one.at(now) != next.at(now);
    unlike_lane += one.at(now) != lane.at(now);
  }
  EXPECT_NEAR(stalls, 30'000, 600);
  EXPECT_NEAR(unlike_next, 42'000, 800);
  EXPECT_NEAR(unlike_lane, 42'000, 800);
}

}  // namespace
}  // namespace kagesen

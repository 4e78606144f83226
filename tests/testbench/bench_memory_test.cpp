#include "testbench/verilator/bench_memory.h"

#include <gtest/gtest.h>

#include <array>
#include <map>
#include <random>
#include <set>
#include <vector>

#include "testbench/verilator/ports.h"

namespace kagesen::bench {
namespace {

using Wide = std::array<std::uint32_t, 4>;  // as VlWide<4>, for what ports.h asks of it

Timing timing(std::uint32_t latency, std::uint32_t spread = 0) {
  Timing timing;
  timing.latency = latency;
  timing.spread = spread;
  return timing;
}

TEST(ReadPort, AnswersAtTheLatencyAndNotBefore) {
  for (const std::uint32_t latency : {1u, 2u, 20u, 1000u}) {
    ReadPort<1> port;
    port.configure(timing(latency));
    const std::uint32_t word = 7;
    port.accept(100, 5, 0, &word);
    for (std::uint64_t now = 100; now < 100 + latency; ++now) EXPECT_EQ(port.take(now), nullptr);
    const auto* response = port.take(100 + latency);
    ASSERT_NE(response, nullptr);
    EXPECT_EQ(response->tag, 5);
    EXPECT_EQ(response->words[0], 7u);
    EXPECT_EQ(port.take(100 + latency + 1), nullptr);
  }
}

TEST(ReadPort, RandomLatenciesOvertakeAndLoseNothing) {
  ReadPort<1> port;
  port.configure(timing(3, 40));
  std::map<int, std::uint64_t> asked;
  std::set<int> free;
  for (int tag = 0; tag < 256; ++tag) free.insert(tag);
  std::uint64_t answered = 0, overtook = 0, newest = 0;
  for (std::uint64_t now = 0; now < 20'000; ++now) {
    if (const auto* r = port.take(now)) {
      const std::uint64_t at = asked.at(r->tag);
      EXPECT_GE(now, at + 3);
      EXPECT_EQ(r->words[0], at);
      overtook += at < newest;
      newest = std::max(newest, at);
      asked.erase(r->tag);
      free.insert(r->tag);
      ++answered;
    }
    if (now >= 19'000 || free.empty()) continue;
    const int tag = *free.begin();
    free.erase(free.begin());
    const auto word = static_cast<std::uint32_t>(now);
    asked[tag] = now;
    port.accept(now, static_cast<std::uint8_t>(tag), 0, &word);
  }
  EXPECT_TRUE(asked.empty());
  EXPECT_EQ(answered, 19'000u);
  EXPECT_GT(overtook, 5'000u);
}

TEST(ReadPort, RefusesATagThatIsUnderWayUnlessItWasDropped) {
  ReadPort<1> port;
  port.configure(timing(10));
  const std::uint32_t word = 0;
  port.accept(0, 5, 0, &word);
  EXPECT_THROW(port.accept(1, 5, 0, &word), Failure);
  port.drop();
  for (std::uint64_t now = 0; now < 20; ++now) EXPECT_EQ(port.take(now), nullptr);
  EXPECT_NO_THROW(port.accept(20, 5, 0, &word));
}

TEST(Ports, FieldsOfEveryTypeAndPlace) {
  std::mt19937_64 random(5);
  for (int round = 0; round < 20'000; ++round) {
    const unsigned width = 1 + unsigned(random() % 64), lsb = unsigned(random() % (129 - width));
    Wide wide;
    for (std::uint32_t& w : wide) w = static_cast<std::uint32_t>(random());
    const Wide before = wide;
    const std::uint64_t value = random() & low_bits(width);
    set_field(wide, lsb, width, value);
    for (unsigned bit = 0; bit < 128; ++bit) {
      const bool was = before[bit / 32] >> (bit % 32) & 1, is = wide[bit / 32] >> (bit % 32) & 1;
      const bool inside = bit >= lsb && bit < lsb + width;
      ASSERT_EQ(is, inside ? (value >> (bit - lsb) & 1) != 0 : was) << lsb << " " << width;
    }
    ASSERT_EQ(field(wide, lsb, width), value);
  }
  std::uint8_t small = 0;
  set_field(small, 3, 2, 3);
  EXPECT_EQ(small, 0x18);
  EXPECT_EQ(field(small, 4, 1), 1u);
}

TEST(Ports, WordsGoThereAndBack) {
  Wide port{};
  const std::uint32_t words[2] = {0x12345678, 0x1f};
  set_words<37, true>(port, 50, words);
  std::uint32_t back[2];
  get_words<37>(port, 50, back);
  EXPECT_EQ(back[0], words[0]);
  EXPECT_EQ(back[1], words[1]);
  std::uint64_t narrow = 0;
  set_words<37, false>(narrow, 0, words);
  EXPECT_EQ(narrow, 0x1f12345678u);
}

}  // namespace
}  // namespace kagesen::bench

#include <gtest/gtest.h>

#include <map>
#include <random>

#include "Vline_cache_test_dut.h"
#include "Vline_cache_ways_dut.h"
#include "testbench/verilator/memory.h"

namespace kagesen::rtl {
namespace {

constexpr unsigned kWidth = 20, kAddresses = 32;  // as CMakeLists.txt sets them; 4 lines

template <typename Dut>
struct CacheBench {
  explicit CacheBench(std::uint64_t seed, const MemorySettings& settings)
      : random(seed), memory(kWidth, settings) {
    dut.clk_i = 0;
    dut.rst_ni = 0;
    dut.clear_i = dut.hint_valid_i = dut.hint_weak_i = 0;
    dut.lookup_i = dut.lookup_new_i = dut.lookup_end_i = 0;
    dut.update_i = 0;
    dut.rsp_valid_i = 0;
    dut.eval();
    dut.rst_ni = 1;
    for (std::uint64_t a = 0; a < kAddresses; ++a) {
      expected[a] = static_cast<std::uint32_t>(memory.peek(a)[0]);
    }
  }
  void start() {
    memory.start();
    dut.rd_ready_i = memory.read_ready();
    dut.wr_ready_i = memory.write_ready();
    dut.rsp_valid_i = memory.response().valid;
    if (memory.response().valid) {
      dut.rsp_tag_i = static_cast<std::uint8_t>(memory.response().tag);
      to_port(dut.rsp_data_i, memory.response().data);
    }
  }
  void finish() {
    if (dut.rd_valid_o) memory.read(dut.rd_addr_o, dut.rd_tag_o);
    if (dut.wr_valid_o) memory.write(dut.wr_addr_o, from_port(dut.wr_data_o));
    dut.clk_i = 1;
    dut.eval();
    dut.clk_i = 0;
    dut.eval();
  }
  Dut dut;
  std::mt19937_64 random;
  Memory memory;
  std::map<std::uint64_t, std::uint32_t> expected;  // newest value of each address
};

using Bench = CacheBench<Vline_cache_test_dut>;

/// Random lookups, updates, hints and clears; every hit must show the newest word.
template <typename Dut>
void hits_show_the_newest_word() {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    std::mt19937_64 random(seed);
    MemorySettings settings;
    settings.seed = seed;
    settings.least_latency = 1 + random() % 3;
    settings.most_latency = settings.least_latency + random() % 40;
    settings.read_ready_percent = 20 + random() % 81;
    settings.write_ready_percent = 20 + random() % 81;
    CacheBench<Dut> bench(seed, settings);
    auto& dut = bench.dut;
    const bool clears = seed % 4 == 0;
    const unsigned spread = seed % 2 ? kAddresses : 8;
    bool looking = false, fresh = false;  // fresh: not to be fetched
    std::uint64_t address = 0, hits = 0, waited = 0;
    for (int cycle = 0; cycle < 8000; ++cycle) {
      bench.start();
      dut.hint_valid_i = random() % 2;
      dut.hint_addr_i = random() % spread;
      dut.hint_weak_i = random() % 2;
      dut.update_i = 0;
      dut.lookup_i = dut.lookup_end_i = 0;
      dut.clear_i = clears && random() % 200 == 0;
      dut.eval();
      if (looking) {
        if (dut.hit_o) {
          ++hits;
          waited = 0;
          ASSERT_EQ(dut.data_o, bench.expected[address]) << seed << " cycle " << cycle;
        } else {
          ASSERT_LT(waited += !fresh, 2000u) << "no hit";
        }
      } else {
        ASSERT_FALSE(dut.hit_o);
      }
      const bool act = !looking || dut.hit_o || fresh;
      if (act || random() % 8 == 0) {
        dut.update_i = random() % 2;
        dut.update_addr_i = looking && random() % 4 != 0 ? address : random() % spread;
        dut.update_data_i = random() & ((1u << kWidth) - 1);
      }
      std::uint64_t next = random() % 3 ? address : random() % spread;
      if (act) {
        dut.lookup_i = random() % 4 != 0;
        dut.lookup_new_i = random() % 4 == 0;
        dut.lookup_end_i = !dut.lookup_i && random() % 2;
        dut.lookup_addr_i = next;
      }
      dut.eval();
      if (dut.update_i && dut.update_ready_o) bench.expected[dut.update_addr_i] = dut.update_data_i;
      if (dut.lookup_i) {
        looking = true;
        fresh = dut.lookup_new_i;
        address = next;
      } else if (dut.lookup_end_i) {
        looking = false;
      }
      const bool cleared = dut.clear_i;
      bench.finish();
      if (cleared) {  // what waited to be written is gone
        looking = false;
        for (auto& [a, value] : bench.expected) value = bench.memory.peek(a)[0];
      }
    }
    EXPECT_GT(hits, 100u) << seed;
  }
}

TEST(LineCache, HitsShowTheNewestWord) { hits_show_the_newest_word<Vline_cache_test_dut>(); }
TEST(LineCache, HitsShowTheNewestWordInTwoWays) { hits_show_the_newest_word<Vline_cache_ways_dut>(); }

/// One lookup and update a cycle where all hit, the same word again and again included.
TEST(LineCache, OneAWordACycleOnHits) {
  Bench bench(1, MemorySettings{});
  auto& dut = bench.dut;
  unsigned turn = 0, last = 0;
  const unsigned order[] = {0, 0, 0, 1, 2, 1, 2, 2, 3, 0};
  for (int cycle = 0; cycle < 400; ++cycle) {
    bench.start();
    dut.lookup_i = dut.update_i = 0;
    dut.eval();
    if (turn == 0 || dut.hit_o) {
      if (turn > 0) {
        ASSERT_EQ(dut.data_o, bench.expected[last]);
        dut.update_i = 1;
        dut.update_addr_i = last;
        dut.update_data_i = bench.expected[last] = turn;
      }
      last = order[turn++ % 10];
      dut.lookup_i = 1;
      dut.lookup_addr_i = last;
    }
    dut.eval();
    if (dut.update_i && !dut.update_ready_o) {
      FAIL() << "an update had to wait";
    }
    bench.finish();
  }
  EXPECT_GE(turn, 400u - 4 * 24);
  EXPECT_EQ(bench.memory.reads(), 4u);
}

/// A word that is to be written is not fetched, takes its line with the update and leaves others theirs.
TEST(LineCache, NewWordIsNotFetched) {
  CacheBench<Vline_cache_ways_dut> bench(1, MemorySettings{});
  auto& dut = bench.dut;
  for (int cycle = 0; cycle < 80; ++cycle) {
    bench.start();
    dut.hint_valid_i = cycle == 0;  // of the same set
    dut.hint_addr_i = 2;
    dut.lookup_i = cycle == 40 || cycle == 41 || cycle == 42;
    dut.lookup_addr_i = cycle == 42 ? 2 : 8;
    dut.lookup_new_i = cycle == 40;
    dut.update_i = cycle == 41;
    dut.update_addr_i = 8;
    dut.update_data_i = 77;
    dut.eval();
    if (cycle == 41) {
      ASSERT_FALSE(dut.hit_o);
      ASSERT_TRUE(dut.update_ready_o);
    } else if (cycle == 42) {
      ASSERT_TRUE(dut.hit_o);
      ASSERT_EQ(dut.data_o, 77u);
    } else if (cycle == 43) {
      ASSERT_TRUE(dut.hit_o);
      ASSERT_EQ(dut.data_o, bench.expected[2]);
    }
    bench.finish();
  }
  EXPECT_EQ(bench.memory.reads(), 1u);
}

/// A word that was hinted in time is there at once.
TEST(LineCache, HintHidesLatency) {
  Bench bench(1, MemorySettings{});
  auto& dut = bench.dut;
  for (int cycle = 0; cycle < 60; ++cycle) {
    bench.start();
    dut.hint_valid_i = cycle < 4;
    dut.hint_addr_i = cycle;
    dut.lookup_i = cycle >= 40 && cycle < 44;
    dut.lookup_addr_i = cycle - 40;
    dut.eval();
    if (cycle > 40 && cycle <= 44) {
      ASSERT_TRUE(dut.hit_o);
      ASSERT_EQ(dut.data_o, bench.expected[cycle - 41]);
    }
    bench.finish();
  }
  EXPECT_EQ(bench.memory.reads(), 4u);
  EXPECT_TRUE(dut.idle_o);
}

}  // namespace
}  // namespace kagesen::rtl

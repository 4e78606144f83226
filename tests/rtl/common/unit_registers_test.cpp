#include <gtest/gtest.h>

#include <map>
#include <random>

#include "Vunit_registers_test_dut.h"

namespace {

class Registers : public testing::Test {
 protected:
  void SetUp() override {
    dut.clk_i = dut.rst_ni = 0;
    dut.s_awvalid_i = dut.s_wvalid_i = dut.s_arvalid_i = dut.s_bready_i = dut.s_rready_i = 0;
    dut.busy_i = 0;
    dut.pass_i = 0;
    dut.overflow_i = 0;
    dut.eval();
    dut.rst_ni = 1;
  }
  void clock() {
    dut.eval();
    starts += dut.start_o;
    aborts += dut.abort_o;
    dut.clk_i = 1;
    dut.eval();
    dut.clk_i = 0;
    dut.eval();
  }
  /// Address and data in random order and distance, the answer taken late.
  void write(std::uint8_t address, std::uint32_t data) {
    int address_in = static_cast<int>(random() % 4), data_in = static_cast<int>(random() % 4);
    dut.s_awaddr_i = address;
    dut.s_wdata_i = data;
    for (bool taken = false; !taken; --address_in, --data_in) {
      dut.s_awvalid_i = address_in <= 0;
      dut.s_wvalid_i = data_in <= 0;
      dut.eval();
      ASSERT_EQ(dut.s_awready_o, dut.s_wready_o);
      taken = dut.s_awvalid_i && dut.s_wvalid_i && dut.s_awready_o;
      clock();
    }
    dut.s_awvalid_i = dut.s_wvalid_i = 0;
    for (auto late = random() % 3; late > 0; --late) {
      clock();
      ASSERT_TRUE(dut.s_bvalid_o);
    }
    dut.s_bready_i = 1;
    clock();
    dut.s_bready_i = 0;
    ASSERT_FALSE(dut.s_bvalid_o);
  }
  std::uint32_t read(std::uint8_t address) {
    dut.s_araddr_i = address;
    dut.s_arvalid_i = 1;
    do clock();
    while (!dut.s_rvalid_o);
    dut.s_arvalid_i = 0;
    for (auto late = random() % 3; late > 0; --late) clock();
    const std::uint32_t data = dut.s_rdata_o;
    dut.s_rready_i = 1;
    clock();
    dut.s_rready_i = 0;
    return data;
  }

  Vunit_registers_test_dut dut;
  std::mt19937 random{1};
  int starts = 0, aborts = 0;
};

// Of the settings: address and how many bits it keeps (docs/rtl.md).
const std::map<std::uint8_t, int> kSettings = {{0x08, 32}, {0x0c, 5},  {0x10, 13}, {0x14, 13},
                                               {0x18, 4},  {0x1c, 5},  {0x20, 25}, {0x24, 25},
                                               {0x28, 17}, {0x2c, 7}};

TEST_F(Registers, KeepWhatIsWrittenWhileIdle) {
  for (int round = 0; round < 50; ++round) {
    std::map<std::uint8_t, std::uint32_t> expected;
    for (const auto& [address, bits] : kSettings) {
      const auto data = static_cast<std::uint32_t>(random());
      write(address, data);
      expected[address] = bits == 32 ? data : data & ((1u << bits) - 1);
    }
    for (const auto& [address, data] : expected) EXPECT_EQ(read(address), data) << int(address);
  }
  EXPECT_EQ(starts, 0);
  EXPECT_EQ(read(0x40), 0x4b470001u);
}

TEST_F(Registers, IgnoreSettingsAndStartsWhileBusy) {
  for (const auto& [address, bits] : kSettings) write(address, 5);
  dut.busy_i = 1;
  for (const auto& [address, bits] : kSettings) write(address, 2);
  write(0x00, 3);
  EXPECT_EQ(starts, 0);
  for (const auto& [address, bits] : kSettings) EXPECT_EQ(read(address), 5u) << int(address);
}

TEST_F(Registers, StartOnceAndAbortAtAnyTime) {
  write(0x00, 4);
  EXPECT_EQ(starts, 1);
  EXPECT_EQ(dut.pass_o, 4);
  write(0x00, 0);
  EXPECT_EQ(starts, 1);
  dut.busy_i = 1;
  write(0x00, 0x80);
  dut.busy_i = 0;
  write(0x00, 0x83);
  EXPECT_EQ(aborts, 2);
  EXPECT_EQ(starts, 1);
}

TEST_F(Registers, TellTheUnitsState) {
  dut.busy_i = 1;
  dut.pass_i = 5;
  dut.overflow_i = 1;
  EXPECT_EQ(read(0x04), 0x151u);
  dut.cycles_i = 0x12345678;
  dut.records_i = 0x1abcdef;
  dut.counter_i = 0x87654321;
  EXPECT_EQ(read(0x30), 0x12345678u);
  EXPECT_EQ(read(0x34), 0x1abcdefu);
  EXPECT_EQ(read(0x3c), 0x87654321u);
  write(0x38, 0x3f);
  EXPECT_EQ(dut.counter_select_o, 0x3f);
}

/// Every word of the address space, in every state: what is not there reads 0 and takes nothing.
TEST_F(Registers, AreWhereTheMapSaysAndNowhereElse) {
  for (int round = 0; round < 60; ++round) {
    std::map<unsigned, std::uint32_t> expected;
    for (unsigned address = 0; address < 0x100; address += 4) {
      if (address == 0) continue;  // CONTROL starts passes
      const auto data = static_cast<std::uint32_t>(random());
      write(static_cast<std::uint8_t>(address), data);
      const auto found = kSettings.find(static_cast<std::uint8_t>(address));
      if (found != kSettings.end()) {
        expected[address] = found->second == 32 ? data : data & ((1u << found->second) - 1);
      }
      if (address == 0x38) expected[address] = data & 0x3f;
    }
    dut.busy_i = random() % 2;
    dut.pass_i = random() % 8;
    dut.overflow_i = random() % 2;
    dut.cycles_i = static_cast<std::uint32_t>(random());
    dut.records_i = random() & 0x1ffffff;
    dut.counter_i = static_cast<std::uint32_t>(random());
    expected[0x04] = dut.overflow_i << 8 | dut.pass_i << 4 | dut.busy_i;
    expected[0x30] = dut.cycles_i;
    expected[0x34] = dut.records_i;
    expected[0x3c] = dut.counter_i;
    expected[0x40] = 0x4b470001u;
    for (unsigned address = 0; address < 0x100; address += 4) {
      ASSERT_EQ(read(static_cast<std::uint8_t>(address)), expected[address]) << address;
    }
    dut.busy_i = 0;
  }
  EXPECT_EQ(starts, 0);
  EXPECT_EQ(aborts, 0);
}

}  // namespace

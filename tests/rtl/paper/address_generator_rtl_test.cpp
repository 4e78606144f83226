#include "model/unit/address_generator.h"

#include <gtest/gtest.h>

#include <random>

#include "Vaddress_generator_rtl_test_dut.h"
#include "testbench/verilator/paper_layout.h"

namespace kagesen::rtl {
namespace {

/// Texels, buckets and pitches from anywhere.
TEST(AddressGenerator, EqualsGoldenAnywhere) {
  const PaperWidths widths;
  const PaperLayout layout(UnitConfig{}, widths);
  Vaddress_generator_rtl_test_dut dut;
  std::mt19937 random(1);
  for (int round = 0; round < 20000; ++round) {
    UnitConfig config;
    config.map_width = 1 + random() % 1024;
    const std::uint32_t buckets_log2 = random() % widths.record_addr_bits;
    config.slb_buckets = std::int64_t{1} << buckets_log2;
    to_port(dut.settings_i, layout.make_settings(config, 16));
    const auto x = static_cast<std::uint32_t>(random() % config.map_width);
    const auto y = static_cast<std::uint32_t>(random() % 1024);
    dut.x_i = static_cast<std::uint16_t>(x);
    dut.y_i = static_cast<std::uint16_t>(y);
    dut.eval();
    ASSERT_EQ(dut.bucket_o, unit::bucket_of(x, y, 1u << buckets_log2));
    ASSERT_EQ(dut.texel_o,
              y << PaperLayout::pitch_log2(static_cast<std::uint32_t>(config.map_width)) | x >> 2);
  }
}

/// Every texel of the largest map, for every number of buckets and pitch in turn.
TEST(AddressGenerator, EqualsGolden) {
  const PaperWidths widths;
  const PaperLayout layout(UnitConfig{}, widths);
  Vaddress_generator_rtl_test_dut dut;
  std::uint32_t buckets_log2 = 0;
  for (std::uint32_t width = 1; width <= 1024; width = width * 2 + width % 3) {
    UnitConfig config;
    config.map_width = width;
    buckets_log2 = (buckets_log2 + 2) % widths.record_addr_bits;
    config.slb_buckets = std::int64_t{1} << buckets_log2;
    to_port(dut.settings_i, layout.make_settings(config, 16));
    for (std::uint32_t y = 0; y < 1024; ++y) {
      for (std::uint32_t x = 0; x < width; ++x) {
        dut.x_i = static_cast<std::uint16_t>(x);
        dut.y_i = static_cast<std::uint16_t>(y);
        dut.eval();
        ASSERT_EQ(dut.bucket_o, unit::bucket_of(x, y, 1u << buckets_log2));
        ASSERT_EQ(dut.texel_o, y << PaperLayout::pitch_log2(width) | x >> 2);
      }
    }
  }
}

}  // namespace
}  // namespace kagesen::rtl

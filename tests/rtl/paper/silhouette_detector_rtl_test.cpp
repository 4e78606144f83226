#include "model/unit/silhouette_detector.h"

#include <gtest/gtest.h>

#include <random>

#include "Vsilhouette_detector_rtl_test_dut.h"
#include "testbench/verilator/paper_layout.h"

namespace kagesen::rtl {
namespace {

constexpr std::uint32_t kLines = 3;

void put(const PaperLayout::Line& l, const unit::Line& line, Word& word, std::size_t base) {
  using unit::Line;
  l.left.set(word, line.has(Line::kLeft), base);
  l.cross.set(word, line.has(Line::kCross), base);
  l.x_major.set(word, line.has(Line::kXMajor), base);
  l.x_positive.set(word, line.has(Line::kXPositive), base);
  l.start_here.set(word, line.has(Line::kStartHere), base);
  l.end_here.set(word, line.has(Line::kEndHere), base);
  l.polygon.set(word, line.polygon, base);
  l.slope.set(word, line.slope, base);
  l.fraction.set(word, line.fraction, base);
}

unit::Line random_line(std::mt19937& random) {
  unit::Line line;
  line.fraction = random() & 0xff;
  line.slope = random() & 0xff;
  line.polygon = random() & 0x3fff;
  line.flags = random() & 0x3f;
  return line;
}

/// Lines that differ from the new one in at most two bits, so that each bit decides now and then.
TEST(SilhouetteDetector, EqualsGolden) {
  const PaperLayout layout(UnitConfig{}, PaperWidths{});
  Vsilhouette_detector_rtl_test_dut dut;
  std::mt19937 random(1);
  std::uint64_t found = 0;
  for (int n = 0; n < 300000; ++n) {
    const unit::Line line = random_line(random);
    const bool match_id = random() % 2;
    const auto count = static_cast<std::uint32_t>(random() % (kLines + 1));
    Word word = make_word(kLines * layout.line.bits), single = make_word(layout.line.bits);
    put(layout.line, line, single, 0);
    std::uint32_t first = kLines;
    for (std::uint32_t i = 0; i < kLines; ++i) {
      unit::Line other = line;
      if (random() % 8 != 0) other.flags ^= unit::Line::kLeft;
      if (random() % 2) other.polygon = random() & 0x3fff;
      for (unsigned flips = random() % 3; flips > 0; --flips) {
        const unsigned bit = random() % 22;
        if (bit < 6) other.flags ^= 1u << bit;
        else if (bit < 14) other.slope ^= static_cast<std::uint16_t>(1u << (bit - 6));
        else other.fraction ^= static_cast<std::uint16_t>(1u << (bit - 14));
      }
      put(layout.line, other, word, i * layout.line.bits);
      if (first == kLines && i < count && unit::cancels(line, other, match_id)) first = i;
    }
    to_port(dut.line_i, single);
    to_port(dut.lines_i, word);
    dut.count_i = count;
    dut.match_polygon_id_i = match_id;
    dut.eval();
    ASSERT_EQ(dut.found_o != 0, first < kLines);
    for (std::uint32_t i = 0; i < kLines; ++i)
      ASSERT_EQ(dut.from_first_o >> i & 1, i >= first ? 1u : 0u);
    found += first < kLines;
  }
  EXPECT_GT(found, 10000u);
}

}  // namespace
}  // namespace kagesen::rtl

// The decision on narrow fields against the golden functions: each line and point, each pair of
// lines, and whole chains of entries of several records.
#include "model/unit/shadow_decision.h"

#include <gtest/gtest.h>

#include <random>

#include "Vcombine_3bit_dut.h"
#include "Vshadow_decision_rtl_test_dut.h"
#include "testbench/verilator/bits.h"
#include "tests/rtl/paper/encode_contents.h"

namespace kagesen::rtl {
namespace {

constexpr int kBits = 3, kPointBits = 4;  // as CMakeLists.txt builds the modules
constexpr unsigned kOne = 1u << kBits, kPointOne = 1u << kPointBits;

UnitConfig config_of(unsigned policies) {
  UnitConfig config;
  config.fraction_bits = config.slope_bits = kBits;
  if (policies & 1) config.vertex_rule = VertexRule::kPerEntry;
  if (policies & 2) config.table7 = Table7::kPrinted;
  return config;
}

/// Line n of 2^(6 + 2 kBits).
unit::Line line_of(unsigned n) {
  unit::Line line;
  line.flags = n & 63;
  line.fraction = static_cast<std::uint16_t>(n >> 6 & (kOne - 1));
  line.slope = static_cast<std::uint16_t>(n >> (6 + kBits) & (kOne - 1));
  return line;
}
constexpr unsigned kLines = 64 * kOne * kOne;

PaperLayout layout() {
  PaperLayout l;
  l.fraction = l.slope = kBits;
  l.polygon = 1;
  return l;
}
LineRecord record_of(const unit::Line& line) {
  LineRecord r;
  r.fraction = line.fraction;
  r.slope = line.slope;
  r.left = line.has(unit::Line::kLeft);
  r.cross = line.has(unit::Line::kCross);
  r.x_major = line.has(unit::Line::kXMajor);
  r.x_positive = line.has(unit::Line::kXPositive);
  r.start_here = line.has(unit::Line::kStartHere);
  r.end_here = line.has(unit::Line::kEndHere);
  return r;
}

TEST(Combine, EveryPairOfLinesOf3Bits) {
  Vcombine_3bit_dut dut;
  std::vector<unit::Line> lines;
  std::vector<std::uint64_t> words;
  for (unsigned n = 0; n < kLines; ++n) {
    lines.push_back(line_of(n));
    words.push_back(layout().line(record_of(lines.back())));
  }
  const unit::ShadowDecision golden[] = {
      unit::ShadowDecision(config_of(0)), unit::ShadowDecision(config_of(1)),
      unit::ShadowDecision(config_of(2)), unit::ShadowDecision(config_of(3))};
  for (unsigned a = 0; a < kLines; ++a) {
    dut.a_i = static_cast<SData>(words[a]);
    dut.a_complement_i = static_cast<CData>(kOne - lines[a].fraction);
    for (unsigned b = 0; b < kLines; ++b) {
      const unsigned vertex = (b >> 3 ^ a >> 6) & 1;
      dut.b_i = static_cast<SData>(words[b]);
      dut.vertex_i = static_cast<CData>(vertex);
      dut.b_complement_i = static_cast<CData>(kOne - lines[b].fraction);
      for (unsigned policies = 0; policies < 4; ++policies) {
        dut.vertex_per_entry_i = policies & 1;
        dut.table7_printed_i = policies >> 1;
        dut.eval();
        const bool expected =
            golden[policies].combine(lines[a], lines[b], vertex != 0) == unit::Combine::kAnd;
        ASSERT_EQ(dut.and_o != 0, expected) << "lines " << a << ' ' << b << ", policies " << policies;
      }
    }
  }
}

/// A fragment before a chain of records, alone or in turns with another one in the next slot.
class Decision {
 public:
  struct Question {
    unsigned x = 0, y = 0, depth = 0, object = 0, texel = 0;
  };
  struct Answer {
    bool dark = false;
    unsigned entries_read = 0, lines_read = 0, records_read = 0;
  };

  Decision() {
    dut_.clk_i = dut_.clear_i = dut_.valid_i = 0;
    dut_.rst_ni = 0;
    dut_.eval();
    dut_.rst_ni = 1;
  }
  void set_policies(unsigned policies) {
    for (std::size_t i = 0; i < 3; ++i) dut_.settings_i[i] = 0;
    set_bits(dut_.settings_i, 5, 1, policies & 1);
    set_bits(dut_.settings_i, 4, 1, policies >> 1 & 1);
  }

  Answer decide(const std::vector<Word>& records, const Question& q, unsigned slot) {
    Answer answer;
    bool first = true, in_entry = false;
    std::uint64_t at = 0;
    for (;;) {
      dut_.valid_i = 1;
      dut_.slot_i = static_cast<CData>(slot);
      to_port(dut_.record_i, records.at(at));
      dut_.x_i = static_cast<CData>(q.x);
      dut_.nx_i = static_cast<CData>(kPointOne - q.x);
      dut_.y_i = static_cast<CData>(q.y);
      dut_.depth_i = q.depth;
      dut_.object_i = static_cast<SData>(q.object);
      dut_.texel_i = q.texel;
      tick();
      dut_.valid_i = 0;
      dut_.first_i = first;
      dut_.in_entry_i = in_entry;
      dut_.at_i = static_cast<IData>(at);
      tick();
      dut_.eval();
      EXPECT_TRUE(dut_.slot_valid_o && dut_.slot_o == slot);
      ++answer.records_read;
      answer.entries_read += dut_.entry_read_o;
      answer.lines_read += dut_.lines_read_o;
      if (dut_.decided_o) {
        answer.dark = dut_.dark_o;
        tick();
        return answer;
      }
      first = false;
      in_entry = dut_.next_in_entry_o;
      at = dut_.next_at_o;
      tick();
      if (answer.records_read > 100000) throw std::logic_error("never decided");
    }
  }

 private:
  void tick() {
    dut_.clk_i = 1;
    dut_.eval();
    dut_.clk_i = 0;
    dut_.eval();
  }
  Vshadow_decision_rtl_test_dut dut_;
};

TEST(ShadowDecision, EveryLineAndPoint) {
  const unit::ShadowDecision golden(config_of(0));
  Decision decision;
  decision.set_policies(0);
  for (unsigned n = 0; n < kLines; ++n) {
    const unit::Line line = line_of(n);
    PaperLayout::Record record;
    record.used = true;
    record.entry.nearest = 5;
    record.entry.object = 1;
    record.entry.lines = {record_of(line)};
    const std::vector<Word> records{layout().record(record)};
    for (unsigned x = 0; x < kPointOne; ++x) {
      for (unsigned y = 0; y < kPointOne; ++y) {
        const bool expected = golden.contains(line, {x, y, kPointBits});
        ASSERT_EQ(decision.decide(records, {x, y, 6, 2, 0}, n % 64).dark, expected)
            << "line " << n << ", point " << x << ' ' << y;
      }
    }
  }
}

TEST(ShadowDecision, ChainsOfEntriesOfManyLines) {
  std::mt19937 random(5);
  Decision decision;
  std::uint64_t dark = 0, looped = 0;
  for (int round = 0; round < 60000; ++round) {
    const unsigned policies = random() % 4;
    const unit::ShadowDecision golden(config_of(policies));
    decision.set_policies(policies);
    // Few kinds of lines make ties; many lines an entry make candidates that are killed late.
    const unsigned entries = 1 + random() % 4, most_lines = 1 + random() % 12;
    struct Entry {
      PaperLayout::Record record;
      std::vector<unit::Line> lines;
    };
    std::vector<Entry> chain(entries);
    unsigned nearest = 1;
    for (Entry& e : chain) {
      e.record.entry.texel_x = random() % 4 == 0;
      e.record.entry.object = random() % 4;
      e.record.entry.nearest = nearest += random() % 3;
      e.record.entry.vertex = random() % 2 != 0;
      for (unsigned i = 1 + random() % most_lines; i > 0; --i) e.lines.push_back(line_of(random()));
    }
    const bool empty = random() % 20 == 0;
    std::vector<PaperLayout::Record> records;
    std::vector<std::size_t> heads;
    for (const Entry& e : chain) {
      heads.push_back(records.size());
      for (std::size_t first = 0; first < e.lines.size(); first += 3) {
        records.push_back(e.record);
        for (std::size_t i = first; i < e.lines.size() && i < first + 3; ++i) {
          records.back().entry.lines.push_back(record_of(e.lines[i]));
        }
        records.back().more = first + 3 < e.lines.size() ? records.size() : 0;
      }
    }
    for (std::size_t i = 0; i + 1 < heads.size(); ++i) records[heads[i]].next = heads[i + 1];
    records[0].used = !empty;
    if (empty) records[0].next = 0;
    std::vector<Word> words;
    for (const auto& r : records) words.push_back(layout().record(r));

    const unsigned point_x = random() % kPointOne, point_y = random() % kPointOne;
    const Decision::Question q{point_x, point_y, static_cast<unsigned>(random() % 12),
                               static_cast<unsigned>(random() % 4), 0};
    Decision::Answer expected;
    for (const Entry& e : chain) {
      if (empty) break;
      if (e.record.entry.texel_x != 0) continue;
      if (q.depth <= e.record.entry.nearest) break;
      ++expected.entries_read;
      if (e.record.entry.object == q.object) continue;
      expected.lines_read += static_cast<unsigned>(e.lines.size());
      expected.dark = golden.inside(e.lines.data(), static_cast<std::uint32_t>(e.lines.size()),
                                    e.record.entry.vertex, {point_x, point_y, kPointBits});
      if (expected.dark) break;
    }
    const Decision::Answer got = decision.decide(words, q, static_cast<unsigned>(random() % 64));
    ASSERT_EQ(got.dark, expected.dark) << "round " << round;
    ASSERT_EQ(got.entries_read, expected.entries_read) << "round " << round;
    ASSERT_EQ(got.lines_read, expected.lines_read) << "round " << round;
    dark += got.dark;
    looped += got.records_read > records.size();
  }
  EXPECT_GT(dark, 10000u);
  EXPECT_GT(looped, 1000u);
}

}  // namespace
}  // namespace kagesen::rtl

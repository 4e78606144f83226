// The decision on narrow fields against the golden functions: each line and point, each pair of
// lines, and whole chains of entries of several records.
#include <gtest/gtest.h>

#include "Vcombine_3bit_dut.h"
#include "tests/rtl/paper/decision_bench.h"

namespace kagesen::rtl {
namespace {

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
        ASSERT_EQ(dut.and_o != 0, expected)
            << "lines " << a << ' ' << b << ", policies " << policies;
      }
    }
  }
}

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
    const Decision::Chain records{{0, layout().record(record)}};
    for (unsigned x = 0; x < kPointOne; x += 8) {  // as many points as there are slots
      std::vector<Decision::Question> questions;
      for (unsigned slot = 0; slot < 8 * kPointOne; ++slot) {
        questions.push_back({slot, x + slot % 8, slot / 8, 6, 2, 0, &records});
      }
      const std::vector<Decision::Answer> answers = decision.decide(questions);
      for (const Decision::Question& q : questions) {
        ASSERT_EQ(answers[q.slot].dark, golden.contains(line, {q.x, q.y, kPointBits}))
            << "line " << n << ", point " << q.x << ' ' << q.y;
      }
    }
  }
}

TEST(ShadowDecision, ChainsOfEntriesOfManyLinesInTurns) {
  std::mt19937 random(5);
  Decision decision;
  std::uint64_t dark = 0, looped = 0;
  for (int round = 0; round < 6000; ++round) {
    const unsigned policies = random() % 4;
    const unit::ShadowDecision golden(config_of(policies));
    decision.set_policies(policies);
    std::vector<TestChain> chains;
    for (unsigned n = 1 + random() % 16; n > 0; --n) chains.push_back(draw_chain(random));
    std::vector<Decision::Question> questions;
    const unsigned first_slot = random() % 128, slot_step = random() | 1;
    for (std::size_t i = 0; i < chains.size(); ++i) {
      const TestChain& c = chains[i];
      const auto slot = static_cast<unsigned>((first_slot + i * slot_step) % 128);
      questions.push_back({slot, static_cast<unsigned>(random() % kPointOne),
                           static_cast<unsigned>(random() % kPointOne),
                           c.depth + unsigned(random() % 12), c.objects[random() % 4],
                           c.texel_y << 10 | c.texel_x, &c.records});
    }
    const std::vector<Decision::Answer> got = decision.decide(questions, 1 + random() % 3);
    for (std::size_t i = 0; i < chains.size(); ++i) {
      const Decision::Answer expected = expected_of(chains[i], questions[i], golden);
      ASSERT_EQ(got[i].dark, expected.dark) << "round " << round;
      ASSERT_EQ(got[i].entries_read, expected.entries_read) << "round " << round;
      ASSERT_EQ(got[i].lines_read, expected.lines_read) << "round " << round;
      dark += got[i].dark;
      looped += got[i].records_read > chains[i].records_used;
    }
  }
  EXPECT_GT(dark, 10000u);
  EXPECT_GT(looped, 1000u);
}

}  // namespace
}  // namespace kagesen::rtl

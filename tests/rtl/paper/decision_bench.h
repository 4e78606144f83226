#pragma once
/// Narrow lines, and the decision with fragments before chains of records.
#include <gtest/gtest.h>

#include <map>
#include <random>
#include <vector>

#include "Vshadow_decision_rtl_test_dut.h"
#include "model/unit/shadow_decision.h"
#include "testbench/verilator/bits.h"
#include "tests/rtl/paper/encode_contents.h"

namespace kagesen::rtl {

constexpr int kBits = 3, kPointBits = 4;  // as CMakeLists.txt builds the modules
constexpr unsigned kOne = 1u << kBits, kPointOne = 1u << kPointBits;

inline UnitConfig config_of(unsigned policies) {
  UnitConfig config;
  config.fraction_bits = config.slope_bits = kBits;
  if (policies & 1) config.vertex_rule = VertexRule::kPerEntry;
  if (policies & 2) config.table7 = Table7::kPrinted;
  return config;
}

/// Line n of 2^(6 + 2 kBits).
inline unit::Line line_of(unsigned n) {
  unit::Line line;
  line.flags = n & 63;
  line.fraction = static_cast<std::uint16_t>(n >> 6 & (kOne - 1));
  line.slope = static_cast<std::uint16_t>(n >> (6 + kBits) & (kOne - 1));
  return line;
}
constexpr unsigned kLines = 64 * kOne * kOne;

inline PaperLayout layout() {
  PaperLayout l;
  l.fraction = l.slope = kBits;
  l.polygon = 1;
  return l;
}
inline LineRecord record_of(const unit::Line& line) {
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

/// Fragments before chains of records, any number of them in turns, each in a slot of its own.
class Decision {
 public:
  using Chain = std::map<std::uint64_t, Word>;  ///< records by address; the bucket's own at 0
  struct Question {
    unsigned slot = 0, x = 0, y = 0, depth = 0, object = 0, texel = 0;
    const Chain* records = nullptr;
  };
  struct Answer {
    bool decided = false, dark = false;
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

  /// @param gaps  a record comes in one of so many cycles
  std::vector<Answer> decide(const std::vector<Question>& questions, unsigned gaps = 1) {
    std::vector<Walk> walks(questions.size());
    for (std::size_t i = 0; i < questions.size(); ++i) walks[i].question = questions[i];
    Walk *read = nullptr, *middle = nullptr;  // whose record came this cycle, a cycle ago
    std::size_t left = walks.size();
    for (std::uint64_t cycle = 0; left > 0; ++cycle) {
      if (cycle > 1000000) throw std::logic_error("never decided");
      read = random_() % gaps == 0 ? ready(walks, cycle) : nullptr;
      if (read) put(*read);
      dut_.valid_i = read != nullptr;
      if (middle) {
        dut_.first_i = middle->first;
        dut_.in_entry_i = middle->in_entry;
        dut_.at_i = static_cast<IData>(middle->at);
      }
      tick();
      if (middle) left -= take(*middle, cycle);
      middle = read;
    }
    std::vector<Answer> answers;
    for (const Walk& walk : walks) answers.push_back(walk.answer);
    return answers;
  }

 private:
  struct Walk {
    Question question;
    Answer answer;
    bool first = true, in_entry = false, inside = false;
    std::uint64_t at = 0, ready_at = 0;
  };
  Walk* ready(std::vector<Walk>& walks, std::uint64_t cycle) {
    const std::size_t from = random_() % walks.size();
    for (std::size_t i = 0; i < walks.size(); ++i) {
      Walk& walk = walks[(from + i) % walks.size()];
      if (!walk.inside && !walk.answer.decided && walk.ready_at <= cycle) return &walk;
    }
    return nullptr;
  }
  void put(Walk& walk) {
    const Question& q = walk.question;
    dut_.slot_i = static_cast<CData>(q.slot);
    to_port(dut_.record_i, q.records->at(walk.at));
    dut_.x_i = static_cast<CData>(q.x);
    dut_.nx_i = static_cast<CData>(kPointOne - q.x);
    dut_.y_i = static_cast<CData>(q.y);
    dut_.depth_i = q.depth;
    dut_.object_i = static_cast<SData>(q.object);
    dut_.texel_i = q.texel;
    walk.inside = true;
  }
  /// The answer to a record of two cycles ago. True: it is the verdict.
  bool take(Walk& walk, std::uint64_t cycle) {
    EXPECT_TRUE(dut_.slot_valid_o && dut_.slot_o == walk.question.slot);
    Answer& answer = walk.answer;
    ++answer.records_read;
    answer.entries_read += dut_.entry_read_o;
    answer.lines_read += dut_.lines_read_o;
    walk.inside = walk.first = false;
    walk.ready_at = cycle + 2;  // what is kept of it is there
    answer.decided = dut_.decided_o;
    if (answer.decided) {
      answer.dark = dut_.dark_o;
    } else {
      walk.in_entry = dut_.next_in_entry_o;
      walk.at = dut_.next_at_o;
    }
    return answer.decided;
  }
  void tick() {
    dut_.clk_i = 1;
    dut_.eval();
    dut_.clk_i = 0;
    dut_.eval();
  }
  Vshadow_decision_rtl_test_dut dut_;
  std::mt19937 random_{7};
};

/// A chain of entries at addresses of any size, and what its texel's fragments are told.
struct TestChain {
  struct Entry {
    PaperLayout::Record record;
    std::vector<unit::Line> lines;
  };
  std::vector<Entry> entries;
  Decision::Chain records;
  std::uint32_t texel_x = 0, texel_y = 0, depth = 0;
  std::uint32_t objects[4] = {};
  std::size_t records_used = 0;
  bool empty = false;
};

inline TestChain draw_chain(std::mt19937& random) {
  TestChain chain;
  // Few kinds of lines make ties; many lines an entry make candidates that are killed late.
  const unsigned entries = 1 + random() % 4, most_lines = 1 + random() % 12;
  const unsigned kinds[] = {unsigned(random()), unsigned(random()), unsigned(random())};
  chain.texel_x = random() % 1024, chain.texel_y = random() % 1024;
  chain.depth = random() % 0xfffff0;
  for (std::uint32_t& object : chain.objects) object = random() % 0x10000;
  chain.objects[1] = chain.objects[0] ^ 1u << random() % 16;
  chain.empty = random() % 20 == 0;
  unsigned nearest = chain.depth + 1;
  for (unsigned i = 0; i < entries; ++i) {
    TestChain::Entry e;
    e.record.entry.texel_x = chain.texel_x;
    e.record.entry.texel_y = chain.texel_y;
    if (random() % 4 == 0) {  // of another texel
      (random() % 2 ? e.record.entry.texel_x : e.record.entry.texel_y) ^= 1u << random() % 10;
    }
    e.record.entry.object = chain.objects[random() % 4];
    e.record.entry.nearest = nearest += random() % 3;
    e.record.entry.vertex = random() % 2 != 0;
    for (unsigned n = 1 + random() % most_lines; n > 0; --n) {
      e.lines.push_back(line_of(random() % 2 ? kinds[random() % 3] : random()));
    }
    chain.entries.push_back(e);
  }
  // Record n stands at an address of its own, the bucket's own at 0.
  const std::uint64_t step = random() | 1, mask = (1u << 19) - 1;
  const auto address = [&](std::size_t n) { return n * step & mask; };
  std::vector<PaperLayout::Record> records;
  std::vector<std::size_t> heads;
  for (const TestChain::Entry& e : chain.entries) {
    heads.push_back(records.size());
    for (std::size_t first = 0; first < e.lines.size(); first += 3) {
      records.push_back(e.record);
      for (std::size_t i = first; i < e.lines.size() && i < first + 3; ++i) {
        records.back().entry.lines.push_back(record_of(e.lines[i]));
        records.back().entry.lines.back().polygon = random() % 2;
      }
      records.back().more = first + 3 < e.lines.size() ? address(records.size()) : 0;
    }
  }
  for (std::size_t i = 0; i + 1 < heads.size(); ++i) records[heads[i]].next = address(heads[i + 1]);
  records[0].used = !chain.empty;
  if (chain.empty) records[0].next = 0;
  for (std::size_t n = 0; n < records.size(); ++n) {
    chain.records[address(n)] = layout().record(records[n]);
  }
  chain.records_used = records.size();
  return chain;
}

inline Decision::Answer expected_of(const TestChain& chain, const Decision::Question& q,
                                    const unit::ShadowDecision& golden) {
  Decision::Answer expected;
  for (const TestChain::Entry& e : chain.entries) {
    if (chain.empty) break;
    const TexelEntry& entry = e.record.entry;
    if (entry.texel_x != chain.texel_x || entry.texel_y != chain.texel_y) continue;
    if (q.depth <= entry.nearest) break;
    ++expected.entries_read;
    if (entry.object == q.object) continue;
    expected.lines_read += static_cast<unsigned>(e.lines.size());
    expected.dark = golden.inside(e.lines.data(), static_cast<std::uint32_t>(e.lines.size()),
                                  entry.vertex, {q.x, q.y, kPointBits});
    if (expected.dark) break;
  }
  return expected;
}

}  // namespace kagesen::rtl

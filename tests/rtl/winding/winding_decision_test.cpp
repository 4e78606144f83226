// One SLB record against the golden functions: crossing(), ThresholdPlane::at(), and how a cluster's records
// add up (ShadowUnit::inside).
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "Vwinding_decision_narrow_dut.h"
#include "Vwinding_decision_test_dut.h"
#include "model/unit/winding/plane.h"
#include "model/unit/winding/segment.h"
#include "testbench/verilator/bits.h"

namespace kagesen::rtl {
namespace {

using unit::winding::Crossing;
using unit::winding::Place;
using unit::winding::Segment;
using unit::winding::Threshold;
using unit::winding::ThresholdPlane;
using unit::winding::Widths;

constexpr unsigned kWindingBits = 22 + 4 + 1, kAddressBits = 22, kMostBits = 26;

struct Record {
  Threshold threshold;
  std::uint32_t object = 0, corner = 0, next = 0;
  bool full = false, goes_on = false, has_next = false;
  std::vector<Segment> segments;
};
struct Context {
  bool continues = false, shadows = false, holds = false;
  std::int64_t winding = 0;
};
struct Answer {
  bool dark, lit, begins;
  unsigned slot, count;
  std::uint32_t next;
  Context context;
};

template <typename Dut>
struct Decision {
  Dut dut;
  unsigned g, base_bits, code_bits, corner_bits = 8, id_bits = 16;

  explicit Decision(const Widths& w)
      : g(unsigned(w.end_bits)), base_bits(unsigned(w.base_bits())),
        code_bits(unsigned(w.gradient_code_bits())) {
    dut.clk_i = dut.rst_ni = dut.clear_i = dut.valid_i = dut.paper_semantics_i = 0;
    dut.eval();
    dut.rst_ni = 1;
  }
  void put(unsigned slot, const Record& r, const Context& c, std::uint64_t x, std::uint64_t y,
           std::uint32_t depth, std::uint32_t object) {
    const unsigned segment_bits = 3 + 4 * (g + 1);
    std::size_t left =
        base_bits + 2 * code_bits + id_bits + corner_bits + 3 + 4 + kAddressBits + 2 * segment_bits;
    const auto field = [&](unsigned width, std::uint64_t value) {
      left -= width;
      set_bits(dut.record_i, left, width, value & ((std::uint64_t{1} << width) - 1));
    };
    field(base_bits, std::uint32_t(r.threshold.base));
    field(code_bits, r.threshold.gradient_x);
    field(code_bits, r.threshold.gradient_y);
    field(id_bits, r.object);
    field(corner_bits, r.corner);
    field(1, r.full);
    field(4, r.segments.size());
    field(1, r.goes_on);
    field(1, r.has_next);
    field(kAddressBits, r.next);
    for (std::size_t i = 0; i < r.segments.size(); ++i) {
      const Segment& s = r.segments[i];
      left = (i + 1) * segment_bits;
      field(1, s.inner());
      field(1, s.crosses_left());
      field(1, s.positive());
      for (const std::int32_t end : {s.x0, s.y0, s.x1, s.y1}) field(g + 1, std::uint32_t(end));
    }
    dut.context_i = std::uint32_t(c.continues) << (kWindingBits + 2) | std::uint32_t(c.shadows) << (kWindingBits + 1) |
                    std::uint32_t(c.holds) << kWindingBits |
                    (std::uint32_t(c.winding) & ((1u << kWindingBits) - 1));
    dut.slot_i = slot;
    dut.x_i = std::uint32_t(x);
    dut.y_i = std::uint32_t(y);
    dut.depth_i = depth;
    dut.object_i = object;
    dut.valid_i = 1;
  }
  /// Until the record that was put is taken. @param answered  called in a cycle with an answer
  template <typename Answered>
  void take(Answered answered) {
    for (bool taken = false; !taken;) {
      dut.eval();
      taken = dut.ready_o != 0;
      clock(answered);
    }
    dut.valid_i = 0;
  }
  template <typename Answered>
  void clock(Answered answered) {
    dut.clk_i = 1;
    dut.eval();
    dut.clk_i = 0;
    dut.eval();
    if (dut.valid_o) answered();
  }
  Answer answer() {
    const std::uint32_t c = dut.context_o;
    const auto winding = std::int32_t(c << (32 - kWindingBits)) >> (32 - kWindingBits);
    return {dut.dark_o != 0, dut.lit_o != 0, dut.begins_o != 0, dut.slot_o, dut.count_o, dut.next_o,
            {(c >> (kWindingBits + 2) & 1) != 0, (c >> (kWindingBits + 1) & 1) != 0,
             (c >> kWindingBits & 1) != 0, winding}};
  }
};

// G = 3, places of 1/16 texel: half steps, where "near" ends, are among them. Every segment, every place.
TEST(ShadowDecision, CrossesEverySegmentAt3BitsAsTheGoldenFunctionDoes) {
  constexpr int kG = 3, kF = 4, kUnits = 1 << kF;
  UnitConfig config;
  config.fraction_bits = 2;
  config.end_guard_bits = 1;
  Decision<Vwinding_decision_narrow_dut> decision(Widths(config, 16));
  ASSERT_EQ(decision.g, unsigned(kG));
  std::vector<Crossing> expected;
  std::uint64_t wrong = 0, near = 0;
  std::size_t answers = 0;
  const auto check = [&] {
    const Context c = decision.answer().context;
    wrong += c.winding != expected[answers].winding || c.holds != expected[answers].near;
    near += c.holds;
    ++answers;
  };
  Record r;
  r.goes_on = true;
  r.segments.resize(1);
  for (int ends = 0; ends < 9 * 9 * 9 * 9; ++ends) {
    for (int flags = 0; flags < 4; ++flags) {
      Segment& s = r.segments[0];
      s.x0 = ends % 9, s.y0 = ends / 9 % 9, s.x1 = ends / 81 % 9, s.y1 = ends / 729;
      s.flags = std::uint8_t(flags);
      if (s.crosses_left() && s.x0 != 0) continue;
      expected.clear();
      for (int p = 0; p < kUnits * kUnits; ++p) {
        const Place place{p % kUnits, p / kUnits};
        expected.push_back(crossing(s, place, kF - kG));
        decision.put(0, r, {}, std::uint64_t(place.x) << (kMostBits - kF),
                     std::uint64_t(place.y) << (kMostBits - kF), 0, 0);
        decision.take(check);
      }
      for (int i = 0; i < 3; ++i) decision.clock(check);
      ASSERT_EQ(answers, expected.size());
      answers = 0;
    }
  }
  EXPECT_EQ(wrong, 0u);
  EXPECT_GT(near, 100000u);
}

// Default widths, f = 16 to 26: planes, ties of depth, places on and beside segments, contexts.
TEST(ShadowDecision, AnswersRandomRecordsAsTheGoldenFunctionsDo) {
  std::mt19937_64 random(5);
  std::uint64_t darks = 0, lits = 0, ties = 0, nears = 0;
  for (int f = 16; f <= 26; ++f) {
    const Widths w(UnitConfig{}, f);
    Decision<Vwinding_decision_test_dut> decision(w);
    const std::int64_t one = std::int64_t{1} << w.end_bits;
    const int shift = f - w.end_bits;
    std::vector<Answer> expected;
    std::size_t answers = 0;
    const auto check = [&] {
      ASSERT_LT(answers, expected.size());
      const Answer want = expected[answers++], got = decision.answer();
      ASSERT_EQ(got.slot, want.slot);
      ASSERT_EQ(got.context.winding, want.context.winding) << "f " << f << " record " << answers;
      ASSERT_EQ(got.context.holds, want.context.holds) << "f " << f << " record " << answers;
      ASSERT_EQ(got.context.shadows, want.context.shadows) << "f " << f << " record " << answers;
      ASSERT_EQ(got.context.continues, want.context.continues);
      ASSERT_EQ(got.dark, want.dark);
      ASSERT_EQ(got.lit, want.lit);
      ASSERT_EQ(got.begins, want.begins);
      ASSERT_EQ(got.count, want.count);
      ASSERT_EQ(got.next, want.next);
    };
    for (int n = 0; n < 25000; ++n) {
      const bool paper = (n / 1000) % 2 != 0;
      decision.dut.paper_semantics_i = paper;
      Record r;
      const bool tame = random() % 2 != 0;
      const auto code = [&] {
        const auto exponent = tame ? random() % 14 : random() % 32;
        return std::uint16_t((random() % 2) << 12 | exponent << 7 | random() % 128);
      };
      r.threshold = {std::int32_t(std::int64_t(random() % (1u << 27)) - (1 << 26)), code(), code()};
      if (tame) r.threshold.base = std::int32_t(random() % (1 << 20));
      r.object = std::uint32_t(random() % 3);
      r.corner = std::uint32_t(random() % 4 == 0 ? random() % 256 : random() % 2);
      r.full = random() % 16 == 0;
      r.goes_on = random() % 3 == 0;
      r.has_next = r.goes_on || random() % 2 == 0;
      r.next = std::uint32_t(random() % (1u << kAddressBits));
      r.segments.resize(random() % 3);
      const std::int64_t texel = std::int64_t{1} << f;
      Place p{std::int64_t(random()) & (texel - 1), std::int64_t(random()) & (texel - 1)};
      for (Segment& s : r.segments) {
        const auto end = [&] { return std::int32_t(random() % 8 == 0 ? random() % 2 * one : random() % (one + 1)); };
        s = {end(), end(), end(), end(), std::uint8_t(random() % 8)};
        if (random() % 4 == 0) s.x1 = std::int32_t(std::clamp<std::int64_t>(s.x0 + std::int64_t(random() % 7) - 3, 0, one));
        if (random() % 4 == 0) s.y1 = std::int32_t(std::clamp<std::int64_t>(s.y0 + std::int64_t(random() % 7) - 3, 0, one));
        if (s.crosses_left()) s.x0 = 0;
        if (random() % 2 == 0) {  // a place on it, or half a step beside it
          const std::int64_t part = std::int64_t(random() % 1025);
          const std::int64_t off = std::int64_t(random() % 5 - 2) * ((std::int64_t{1} << shift) / 2);
          const auto along = [&](std::int64_t a, std::int64_t b) {
            return std::clamp<std::int64_t>(((a * (1024 - part) + b * part) << shift) / 1024, 0, texel - 1);
          };
          p = {std::clamp<std::int64_t>(along(s.x0, s.x1) + off, 0, texel - 1), along(s.y0, s.y1)};
        }
      }
      const std::int64_t at = ThresholdPlane(r.threshold, w).at(p.x >> shift, p.y >> shift, w);
      std::uint32_t depth = std::uint32_t(random() % (kDepthMax + 1));
      if (at >= 0 && at < kDepthMax && random() % 2 == 0) {
        depth = std::uint32_t(at) + std::uint32_t(random() % 2);
        ++ties;
      }
      const auto object = std::uint32_t(random() % 3);
      Context c;
      if (random() % 3 == 0) {
        c = {true, random() % 2 == 0, random() % 8 == 0, std::int64_t(random() % 7) - 3};
      }

      Context out = c;
      if (!c.continues) {
        out.shadows = depth > at && !(paper && r.object == object);
        out.holds = r.full;
        out.winding = r.corner;
      }
      for (const Segment& s : r.segments) {
        const Crossing met = crossing(s, p, shift);
        out.winding += met.winding;
        out.holds |= met.near;
        nears += met.near;
      }
      out.continues = r.goes_on;
      const bool dark = !r.goes_on && out.shadows && (out.holds || out.winding > 0);
      const unsigned slot = unsigned(n) % 64;
      expected.push_back({dark, !r.goes_on && !r.has_next && !dark, !c.continues, slot,
                          unsigned(r.segments.size()), r.next, out});
      darks += dark, lits += expected.back().lit;
      decision.put(slot, r, c, std::uint64_t(p.x) << (kMostBits - f), std::uint64_t(p.y) << (kMostBits - f),
                   depth, object);
      decision.take(check);
      if (random() % 4 == 0) decision.clock(check);
      if (testing::Test::HasFatalFailure()) return;
    }
    for (int i = 0; i < 3; ++i) decision.clock(check);
    ASSERT_EQ(answers, expected.size());
  }
  EXPECT_GT(darks, 4000u);
  EXPECT_GT(lits, 4000u);
  EXPECT_GT(ties, 4000u);
  EXPECT_GT(nears, 4000u);
}

}  // namespace
}  // namespace kagesen::rtl

#include "model/unit/combination.h"

#include <gtest/gtest.h>

#include <random>

namespace kagesen::unit {
namespace {

/// Entries of any size, beyond a word of 64 lines too, and the definition.
TEST(Combination, AnswersAsTheDecisionDoes) {
  std::mt19937 random(1);
  for (const VertexRule rule : {VertexRule::kPerLine, VertexRule::kPerEntry}) {
    for (const Table7 table : {Table7::kCorrected, Table7::kPrinted}) {
      UnitConfig config;
      config.fraction_bits = config.slope_bits = 3;
      config.vertex_rule = rule;
      config.table7 = table;
      const ShadowDecision decision(config);
      int inside = 0, asked = 0;
      for (const std::size_t count : {1u, 2u, 3u, 4u, 7u, 63u, 64u, 65u, 128u, 129u}) {
        for (int n = 0; n < 30; ++n) {
          std::vector<Line> lines(count);
          for (Line& l : lines) {
            l.fraction = random() % 8;
            l.slope = random() % 8;
            // Mostly Left, up: large entries then hold points at all.
            l.flags = random() % 64;
            if (count > 7 && random() % 8 != 0) l.flags = Line::kLeft | Line::kXPositive;
          }
          const bool vertex = n % 2 == 0;
          Combination combination(decision, lines, vertex);
          for (int p = 0; p < 20; ++p) {
            const SubTexel point{static_cast<std::int64_t>(random() % 32),
                                 static_cast<std::int64_t>(random() % 32), 5};
            const bool expected =
                decision.inside(lines.data(), static_cast<std::uint32_t>(count), vertex, point);
            ASSERT_EQ(combination.inside(decision, point), expected) << count;
            inside += expected;
            ++asked;
          }
        }
      }
      EXPECT_GT(inside, asked / 50);
      EXPECT_LT(inside, asked * 49 / 50);
    }
  }
}

}  // namespace
}  // namespace kagesen::unit

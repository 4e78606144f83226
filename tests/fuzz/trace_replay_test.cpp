/// Replays the fuzzer's corpus: names that begin with "good" are accepted, with "bad" refused.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "tests/fuzz/trace_exercise.h"

namespace kagesen {
namespace {

TEST(TraceCorpus, EveryInputEndsAsItsNameSays) {
  int good = 0, bad = 0;
  for (const auto& entry : std::filesystem::directory_iterator(KAGESEN_TEST_DATA "/fuzz/trace")) {
    std::ifstream in(entry.path(), std::ios::binary);
    const std::string input{std::istreambuf_iterator<char>(in), {}};
    const std::string name = entry.path().filename().string();
    const bool expected = name.compare(0, 4, "good") == 0;
    EXPECT_TRUE(expected || name.compare(0, 3, "bad") == 0) << name;
    EXPECT_EQ(exercise(input), expected) << name;
    (expected ? good : bad) += 1;
  }
  EXPECT_GE(good, 3);
  EXPECT_GE(bad, 3);
}

}  // namespace
}  // namespace kagesen

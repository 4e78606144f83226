#include "model/unit/address_generator.h"

#include <gtest/gtest.h>

#include <set>

namespace kagesen::unit {
namespace {

static_assert(bucket_of(3, 2, 1024) == 3 + 362);
static_assert(bucket_of(1023, 5, 1024) == (1023 + 905) % 1024);
static_assert(bucket_of(4095, 4095, 1) == 0);

TEST(AddressGenerator, StaysBelowTheBucketsAndSeparatesARow) {
  for (const std::uint32_t buckets : {1u, 2u, 64u, 4096u}) {
    for (std::uint32_t y = 0; y < 300; y += 7) {
      std::set<std::uint32_t> seen;
      for (std::uint32_t x = 500; x < 500 + buckets; ++x) {
        const std::uint32_t bucket = bucket_of(x, y, buckets);
        ASSERT_LT(bucket, buckets);
        ASSERT_TRUE(seen.insert(bucket).second) << x << ',' << y;
      }
    }
  }
}

TEST(AddressGenerator, SeparatesTheTexelsAroundAnOutline) {
  // A block of 64 rows, 181 apart, does not meet itself in as many buckets as it has texels.
  std::set<std::uint32_t> seen;
  for (std::uint32_t y = 0; y < 64; ++y) {
    for (std::uint32_t x = 0; x < 128; ++x) seen.insert(bucket_of(x, y, 65536));
  }
  EXPECT_EQ(seen.size(), 64u * 128u);
}

}  // namespace
}  // namespace kagesen::unit

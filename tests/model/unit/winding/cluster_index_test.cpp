#include "model/unit/winding/cluster_index.h"

#include <gtest/gtest.h>

#include <optional>
#include <random>
#include <vector>

#include "tests/model/unit/winding/region.h"

namespace kagesen::unit::winding {
namespace {

/// A list of random clusters: triangles of every size in and around one texel, some of several
/// facets, some full, some without segments.
class RandomList {
 public:
  RandomList(unsigned seed, int texel_bits, int end_bits, unsigned least = 1) : random_(seed) {
    widths.texel_bits = texel_bits;
    widths.end_bits = end_bits;
    slb.clear(1u << 20, 2);
    const unsigned count = least + random_() % 150;
    for (unsigned i = 0; i < count; ++i) add(int(i));
  }

  Place place() {
    const std::int64_t side = std::int64_t{1} << widths.texel_bits;
    return {std::int64_t(random_() % std::uint64_t(side)),
            std::int64_t(random_() % std::uint64_t(side))};
  }
  std::uint64_t bits() { return random_(); }

  Widths widths;
  SilhouetteBuffer slb;
  std::uint32_t head = SilhouetteBuffer::kNone;

 private:
  void add(int number) {
    const std::uint32_t at = slb.insert(head, {number, 0, 0}, 0);
    Region region;
    const unsigned facets = random_() % 4;
    for (unsigned i = 0; i < facets; ++i) {
      const std::int64_t side = std::int64_t{1} << widths.texel_bits;
      const std::int64_t size = std::max<std::int64_t>(2, side >> (random_() % 9));
      const std::int64_t x = random_in(-side / 2, side * 3 / 2);
      const std::int64_t y = random_in(-side / 2, side * 3 / 2);
      Caster c;
      for (LightPoint& p : c.vertex) {
        p = {std::int32_t(x + random_in(-size, size)), std::int32_t(y + random_in(-size, size)), 0};
      }
      region.add(c, 0, 0, widths.texel_bits, widths.end_bits, true);
    }
    slb[at].corner = region.corner;
    if (random_() % 16 == 0) {
      slb[at].full = true;
      slb[at].corner = 0;
      return;
    }
    TexelVisit::Meeting meeting;
    for (const Segment& s : region.segments) slb.add(slb[at], s, meeting);
  }
  std::int64_t random_in(std::int64_t low, std::int64_t high) {
    return low + std::int64_t(random_() % std::uint64_t(high - low + 1));
  }

  std::mt19937_64 random_;
};

bool inside(const RandomList& list, const Cluster& c, const Place& p) {
  int winding = c.corner;
  bool near = c.full;
  list.slb.each_segment(c, [&](const Segment& s) {
    const Crossing met = crossing(s, p, list.widths.texel_bits - list.widths.end_bits);
    winding += met.winding;
    near = near || met.near;
    return true;
  });
  return near || winding > 0;
}

class WindingClusterIndex : public testing::TestWithParam<std::pair<int, int>> {};

/// Whatever clusters a fragment is beyond, the first one that holds it is that of the list.
TEST_P(WindingClusterIndex, FindsTheFirstHolderThatReadingThroughFinds) {
  const auto [texel_bits, end_bits] = GetParam();
  std::uint64_t sure = 0, unsure = 0, found = 0;
  for (unsigned seed = 0; seed < 60; ++seed) {
    RandomList list(seed, texel_bits, end_bits);
    const ClusterIndex index(list.slb, list.head, list.widths);
    for (int query = 0; query < 400; ++query) {
      const Place p = list.place();
      const std::uint64_t beyond = list.bits();
      std::optional<std::uint32_t> expected, got;
      std::uint32_t rank = 0;
      for (std::uint32_t at = list.head; at != SilhouetteBuffer::kNone; at = list.slb[at].next) {
        if ((beyond >> rank % 64 & 1) != 0 && inside(list, list.slb[at], p)) {
          expected = rank;
          break;
        }
        ++rank;
      }
      std::int64_t before = -1;
      index.candidates(p, [&](std::uint32_t candidate, bool surely) {
        EXPECT_GT(std::int64_t{candidate}, before) << "not in list order";
        before = candidate;
        const bool holds = inside(list, list.slb[index.member(candidate)], p);
        EXPECT_TRUE(holds || !surely);
        ++(surely ? sure : unsure);
        if (!holds || (beyond >> candidate % 64 & 1) == 0) return true;
        got = candidate;
        return false;
      });
      ASSERT_EQ(got, expected) << "seed " << seed << " at " << p.x << ',' << p.y;
      ASSERT_FALSE(HasFailure());
      found += got.has_value();
    }
  }
  EXPECT_GT(sure, 1000u);
  EXPECT_GT(unsure, 1000u);
  EXPECT_GT(found, 1000u);
}

INSTANTIATE_TEST_SUITE_P(Widths, WindingClusterIndex,
                         testing::Values(std::pair(4, 2), std::pair(4, 4), std::pair(7, 5),
                                         std::pair(16, 10), std::pair(16, 16), std::pair(26, 12)));

TEST(WindingClusterIndexAlone, CountsMembersAndSegmentsInListOrder) {
  RandomList list(77, 16, 10, ClusterIndex::kWorthwhile + 1);
  const ClusterIndex index(list.slb, list.head, list.widths);
  std::uint32_t rank = 0;
  std::uint64_t segments = 0;
  for (std::uint32_t at = list.head; at != SilhouetteBuffer::kNone; at = list.slb[at].next) {
    ASSERT_LT(rank, index.count());
    EXPECT_EQ(index.member(rank), at);
    EXPECT_EQ(index.segments_before(rank), segments);
    segments += list.slb[at].segment_count;
    ++rank;
  }
  EXPECT_EQ(index.count(), rank);
  EXPECT_EQ(index.segments_before(rank), segments);
  EXPECT_GT(rank, ClusterIndex::kWorthwhile);
}

}  // namespace
}  // namespace kagesen::unit::winding

#include "model/unit/winding/silhouette_buffer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <tuple>
#include <vector>

namespace kagesen::unit::winding {
namespace {

constexpr std::uint32_t kNone = SilhouetteBuffer::kNone;
constexpr std::size_t kLists = 3;

/// Few different ones, half of them opposed to another.
Segment segment(unsigned n) {
  return {int(n >> 1 & 3), 1, 5, 2,
          std::uint8_t(Segment::kInner | (n & 1 ? Segment::kPositive : 0))};
}
auto key(const Segment& s) { return std::tuple(s.x0, s.flags); }

struct Held {
  std::uint32_t at;
  Threshold threshold;
  std::uint32_t object;
  int corner;
  std::vector<unsigned> segments;
};

/// The buffer beside vectors of what it should hold.
class Twin {
 public:
  Twin(std::uint32_t capacity, std::uint32_t per_record)
      : capacity_(capacity), per_record_(per_record), heads_(kLists, kNone), lists_(kLists) {
    slb_.clear(capacity, per_record);
  }

  void insert(std::size_t list, std::uint32_t number) {
    const Threshold t{int(number) - 40, std::uint16_t(number % 7), std::uint16_t(number % 5)};
    const bool room = used() < capacity_;
    const std::uint32_t head = heads_[list];
    const std::uint32_t at = slb_.insert(heads_[list], t, number % 3);
    ASSERT_EQ(at != kNone, room);
    if (!room) {
      ASSERT_EQ(heads_[list], head);
      return;
    }
    ASSERT_FALSE(slb_[at].full);
    ASSERT_EQ(slb_[at].corner, 0);
    slb_[at].corner = int(number);
    lists_[list].insert(lists_[list].begin(), {at, t, number % 3, int(number), {}});
    peak_ = std::max(peak_, used());
  }

  void add(std::size_t list, std::size_t rank, unsigned n) {
    if (lists_[list].empty()) return;
    Held& held = lists_[list][rank % lists_[list].size()];
    const auto opposed = std::find_if(held.segments.begin(), held.segments.end(), [&](unsigned m) {
      return (m >> 1 & 3) == (n >> 1 & 3) && ((m ^ n) & 1) != 0;
    });
    const bool cancels = opposed != held.segments.end();
    const bool full = !held.segments.empty() && held.segments.size() % per_record_ == 0;
    const bool room = cancels || !full || used() < capacity_;
    TexelVisit::Meeting meeting;
    ASSERT_EQ(slb_.add(slb_[held.at], segment(n), meeting), room);
    ASSERT_EQ(meeting.cancels(), cancels);
    if (cancels) {
      held.segments.erase(opposed);
    } else if (room) {
      held.segments.push_back(n);
    }
    peak_ = std::max(peak_, used());
  }

  void drop(std::size_t list, std::size_t rank) {
    if (lists_[list].empty()) return;
    Held& held = lists_[list][rank % lists_[list].size()];
    slb_.drop_segments(slb_[held.at]);
    held.segments.clear();
  }

  void erase(std::size_t list, std::size_t rank) {
    auto& held = lists_[list];
    if (held.empty()) return;
    rank %= held.size();
    slb_.erase(heads_[list], rank == 0 ? kNone : held[rank - 1].at);
    held.erase(held.begin() + std::ptrdiff_t(rank));
  }

  void check() const {
    ASSERT_EQ(slb_.records(), used());
    ASSERT_EQ(slb_.peak_records(), peak_);
    for (std::size_t list = 0; list < kLists; ++list) {
      std::uint32_t at = heads_[list];
      for (const Held& held : lists_[list]) {
        ASSERT_EQ(at, held.at);
        check(held);
        at = slb_[at].next;
      }
      ASSERT_EQ(at, kNone);
    }
  }

  /// Erases all, then fills the buffer to the last record: a lost record would show.
  void expect_no_leak() {
    for (std::size_t list = 0; list < kLists; ++list) {
      while (!lists_[list].empty()) erase(list, 1);
    }
    check();
    for (std::uint32_t i = 0; i < capacity_; ++i) insert(0, i);
    insert(0, 0);
    check();
  }

 private:
  std::uint64_t records(const Held& h) const {
    return std::max<std::uint64_t>(1, (h.segments.size() + per_record_ - 1) / per_record_);
  }
  std::uint64_t used() const {
    std::uint64_t sum = 0;
    for (const auto& list : lists_) {
      for (const Held& h : list) sum += records(h);
    }
    return sum;
  }
  void check(const Held& held) const {
    const Cluster& c = slb_[held.at];
    ASSERT_TRUE(c.same_plane(held.threshold, held.object));
    ASSERT_EQ(c.corner, held.corner);
    ASSERT_EQ(c.segment_count, held.segments.size());
    ASSERT_EQ(slb_.records_of(c), records(held));
    std::vector<std::tuple<std::int32_t, std::uint8_t>> found, expected;
    slb_.each_segment(c, [&](const Segment& s) {
      found.push_back(key(s));
      return found.size() <= held.segments.size();
    });
    for (const unsigned n : held.segments) expected.push_back(key(segment(n)));
    std::sort(found.begin(), found.end());
    std::sort(expected.begin(), expected.end());
    ASSERT_EQ(found, expected);
  }

  SilhouetteBuffer slb_;
  std::uint64_t capacity_, per_record_, peak_ = 0;
  std::vector<std::uint32_t> heads_;
  std::vector<std::vector<Held>> lists_;
};

class WindingSilhouetteBuffer : public testing::TestWithParam<std::pair<unsigned, unsigned>> {};

TEST_P(WindingSilhouetteBuffer, AgreesWithVectorsUnderRandomOperations) {
  const auto [capacity, per_record] = GetParam();
  for (unsigned seed = 0; seed < 40; ++seed) {
    std::mt19937 random(seed);
    Twin twin(capacity, per_record);
    const unsigned erasing = seed % 2 ? 12 : 9;
    for (unsigned n = 0; n < 600; ++n) {
      const std::size_t list = random() % kLists, rank = random() % 8;
      const unsigned what = random() % erasing, number = random() % 97;
      if (what < 3) {
        twin.insert(list, number);
      } else if (what < 8) {
        // Now and then equal ones alone, so that clusters grow.
        twin.add(list, rank, seed % 3 == 0 ? number & ~1u : number);
      } else if (what < 9) {
        twin.drop(list, rank);
      } else {
        twin.erase(list, rank);
      }
      if (HasFatalFailure()) return;
      twin.check();
      if (HasFatalFailure()) return;
    }
    twin.expect_no_leak();
    if (HasFatalFailure()) return;
  }
}

INSTANTIATE_TEST_SUITE_P(Shapes, WindingSilhouetteBuffer,
                         testing::Values(std::pair(64u, 1u), std::pair(9u, 2u), std::pair(30u, 3u),
                                         std::pair(1u, 1u), std::pair(200u, 2u),
                                         std::pair(5u, 15u)));

TEST(WindingSilhouetteBufferAlone, EachSegmentStopsWhenTold) {
  SilhouetteBuffer slb;
  slb.clear(8, 2);
  std::uint32_t head = kNone;
  const std::uint32_t at = slb.insert(head, {}, 0);
  TexelVisit::Meeting meeting;
  for (unsigned n = 0; n < 8; n += 2) ASSERT_TRUE(slb.add(slb[at], segment(n), meeting));
  int seen = 0;
  slb.each_segment(slb[at], [&](const Segment&) { return ++seen < 3; });
  EXPECT_EQ(seen, 3);
}

TEST(WindingSilhouetteBufferAlone, OnlyInnerPiecesCancelAndADotIsStoredOnce) {
  SilhouetteBuffer slb;
  slb.clear(8, 2);
  std::uint32_t head = kNone;
  const std::uint32_t at = slb.insert(head, {}, 0);
  TexelVisit::Meeting meeting;
  for (const unsigned n : {2u, 3u}) {  // the sides of a needle
    Segment side = segment(n);
    side.flags ^= Segment::kInner;
    ASSERT_TRUE(slb.add(slb[at], side, meeting));
    EXPECT_FALSE(meeting.cancels());
  }
  EXPECT_EQ(slb[at].segment_count, 2u);
  for (int i = 0; i < 3; ++i) ASSERT_TRUE(slb.add(slb[at], {4, 4, 4, 4, 0}, meeting));
  EXPECT_EQ(slb[at].segment_count, 3u);
}

TEST(WindingSilhouetteBufferAlone, ClearForgetsAll) {
  SilhouetteBuffer slb;
  slb.clear(4, 1);
  std::uint32_t head = kNone;
  for (int i = 0; i < 4; ++i) slb.insert(head, {i, 0, 0}, 0);
  slb.clear(2, 3);
  EXPECT_EQ(slb.records(), 0u);
  EXPECT_EQ(slb.peak_records(), 0u);
  head = kNone;
  EXPECT_NE(slb.insert(head, {}, 0), kNone);
  EXPECT_EQ(slb[head].next, kNone);
  EXPECT_NE(slb.insert(head, {}, 0), kNone);
  EXPECT_EQ(slb.insert(head, {}, 0), kNone);
}

}  // namespace
}  // namespace kagesen::unit::winding

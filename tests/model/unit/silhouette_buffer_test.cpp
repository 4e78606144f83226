#include "model/unit/silhouette_buffer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <optional>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace kagesen::unit {
namespace {

constexpr std::uint32_t kNone = SilhouetteBuffer::kNone;
constexpr std::uint32_t kTexels = 5, kObjects = 4;

Line line(unsigned number) {
  Line out;
  out.polygon = number;
  return out;
}

/// The buffer beside a map of what it should hold.
class Twin {
 public:
  Twin(std::uint32_t buckets, std::uint32_t capacity, std::uint32_t lines)
      : buckets_(buckets), capacity_(capacity), per_record_(lines) {
    slb_.clear(buckets, capacity, lines);
  }

  void insert(std::uint32_t texel, std::uint32_t object, std::uint32_t nearest) {
    if (map_.count({texel, object}) != 0) return;
    const bool room = used() < capacity_;
    const std::uint32_t at = slb_.insert(bucket(texel), texel, object, nearest);
    ASSERT_EQ(at != kNone, room);
    if (!room) return;
    map_[{texel, object}] = {nearest, {}};
    peak_ = std::max(peak_, used());
    EXPECT_FALSE(slb_[at].corner_covered);
    EXPECT_FALSE(slb_[at].vertex);
    // Behind all that are as near.
    for (std::uint32_t i = slb_.next_of(at); i != kNone; i = slb_.next_of(i))
      EXPECT_GT(slb_[i].nearest, nearest);
  }

  void append(std::uint32_t texel, std::uint32_t object, unsigned number) {
    const auto it = map_.find({texel, object});
    if (it == map_.end()) return;
    const std::size_t held = it->second.lines.size();
    const bool needs_record = held != 0 && held % per_record_ == 0;
    const bool room = !needs_record || used() < capacity_;
    ASSERT_EQ(slb_.append(find(texel, object), line(number)), room);
    if (!room) return;
    it->second.lines.push_back(number);
    peak_ = std::max(peak_, used());
  }

  void remove_first(std::uint32_t texel, std::uint32_t object, unsigned residue) {
    const auto it = map_.find({texel, object});
    if (it == map_.end()) return;
    const auto match = [&](unsigned number) { return number % 3 == residue; };
    auto& lines = it->second.lines;
    const auto victim = std::find_if(lines.begin(), lines.end(), match);
    const bool removed =
        slb_.remove_first(find(texel, object), [&](const Line& l) { return match(l.polygon); });
    ASSERT_EQ(removed, victim != lines.end());
    if (removed) lines.erase(victim);
  }

  void set_nearest(std::uint32_t texel, std::uint32_t object, std::uint32_t nearest) {
    const auto it = map_.find({texel, object});
    if (it == map_.end()) return;
    slb_.set_nearest(bucket(texel), find(texel, object), nearest);
    it->second.nearest = nearest;
  }

  void erase(std::uint32_t texel, std::uint32_t object) {
    const auto it = map_.find({texel, object});
    if (it == map_.end()) return;
    slb_.erase(bucket(texel), find(texel, object));
    map_.erase(it);
    EXPECT_EQ(slb_.find(bucket(texel), texel, object), kNone);
  }

  void check() const {
    ASSERT_EQ(slb_.peak(), peak_);
    for (std::uint32_t texel = 0; texel < kTexels; ++texel) check_texel(texel);
    // Every entry hangs in the chain of its own bucket, once.
    std::size_t linked = 0;
    for (std::uint32_t b = 0; b < buckets_; ++b) {
      for (std::uint32_t at = slb_.head(b); at != kNone; at = slb_[at].next) {
        ASSERT_EQ(bucket(slb_[at].texel), b);
        ASSERT_LE(++linked, map_.size());
      }
    }
    ASSERT_EQ(linked, map_.size());
  }

  /// Erases all, then fills the buffer to the last record: a lost record would show.
  void expect_no_leak() {
    while (!map_.empty()) {
      const auto key = map_.begin()->first;
      erase(key.first, key.second);
    }
    check();
    for (std::uint32_t i = 0; i < capacity_; ++i) ASSERT_NE(slb_.insert(0, 1000 + i, 0, 0), kNone);
    ASSERT_EQ(slb_.insert(0, 0, 0, 0), kNone);
  }

 private:
  struct Entry {
    std::uint32_t nearest;
    std::vector<unsigned> lines;
  };

  std::uint32_t bucket(std::uint32_t texel) const { return texel % buckets_; }
  std::uint32_t find(std::uint32_t texel, std::uint32_t object) const {
    return slb_.find(bucket(texel), texel, object);
  }
  std::uint32_t records(const Entry& e) const {
    const auto lines = static_cast<std::uint32_t>(e.lines.size());
    return std::max(1u, (lines + per_record_ - 1) / per_record_);
  }
  std::uint32_t used() const {
    std::uint32_t sum = 0;
    for (const auto& [key, entry] : map_) sum += records(entry);
    return sum;
  }

  void check_texel(std::uint32_t texel) const {
    std::optional<std::uint32_t> before;
    std::set<std::uint32_t> seen;
    std::uint32_t chain = 0;
    for (std::uint32_t at = slb_.first_of(bucket(texel), texel); at != kNone;
         at = slb_.next_of(at)) {
      const auto it = map_.find({texel, slb_[at].object});
      ASSERT_NE(it, map_.end());
      ASSERT_TRUE(seen.insert(slb_[at].object).second);
      ASSERT_EQ(slb_[at].nearest, it->second.nearest);
      ASSERT_LE(before.value_or(0), slb_[at].nearest) << "not from the light outwards";
      before = slb_[at].nearest;
      std::vector<Line> lines;
      slb_.copy_lines(at, lines);
      std::vector<unsigned> numbers;
      for (const Line& l : lines) numbers.push_back(l.polygon);
      ASSERT_EQ(numbers, it->second.lines);
      ASSERT_EQ(slb_.line_count(at), numbers.size());
      for (std::uint32_t i = 0; i < slb_[at].lines; ++i)
        ASSERT_EQ(slb_.lines_of(at)[i].polygon, numbers[i]);
      chain += records(it->second);
    }
    for (std::uint32_t object = 0; object < kObjects; ++object) {
      ASSERT_EQ(find(texel, object) != kNone, map_.count({texel, object}) != 0);
      ASSERT_EQ(seen.count(object), map_.count({texel, object}));
    }
    ASSERT_EQ(slb_.chain_length(bucket(texel), texel), chain);
  }

  SilhouetteBuffer slb_;
  std::uint32_t buckets_, capacity_, per_record_, peak_ = 0;
  std::map<std::pair<std::uint32_t, std::uint32_t>, Entry> map_;
};

struct Shape {
  std::uint32_t buckets, capacity, lines;
};

class SilhouetteBufferShapes : public testing::TestWithParam<Shape> {};

TEST_P(SilhouetteBufferShapes, AgreesWithAMapUnderRandomOperations) {
  const Shape shape = GetParam();
  for (unsigned seed = 0; seed < 40; ++seed) {
    std::mt19937 random(seed);
    Twin twin(shape.buckets, shape.capacity, shape.lines);
    const unsigned erasing = seed % 2 == 0 ? 12 : 8;  // shrinks, or grows until full
    for (unsigned n = 0; n < 600; ++n) {
      const std::uint32_t texel = random() % kTexels, object = random() % kObjects;
      const std::uint32_t nearest = random() % 6;  // ties are frequent
      const unsigned what = random() % erasing;
      if (what < 2) {
        twin.insert(texel, object, nearest);
      } else if (what < 6) {
        twin.append(texel, object, n);
      } else if (what < 7) {
        twin.set_nearest(texel, object, nearest);
      } else if (what < 10) {
        twin.remove_first(texel, object, random() % 3);
      } else {
        twin.erase(texel, object);
      }
      if (HasFatalFailure()) return;
      twin.check();
      if (HasFatalFailure()) return;
    }
    twin.expect_no_leak();
    if (HasFatalFailure()) return;
  }
}

INSTANTIATE_TEST_SUITE_P(Shapes, SilhouetteBufferShapes,
                         testing::Values(Shape{1, 64, 1}, Shape{1, 12, 2}, Shape{4, 7, 3},
                                         Shape{2, 40, 4}, Shape{8, 1, 1}, Shape{8, 200, 3}));

TEST(SilhouetteBuffer, AFullBufferKeepsWhatItHolds) {
  SilhouetteBuffer slb;
  slb.clear(1, 2, 1);
  const std::uint32_t a = slb.insert(0, 1, 0, 5);
  ASSERT_TRUE(slb.append(a, line(1)));
  ASSERT_TRUE(slb.append(a, line(2)));
  EXPECT_FALSE(slb.append(a, line(3)));
  EXPECT_EQ(slb.insert(0, 2, 0, 5), kNone);
  EXPECT_EQ(slb.line_count(a), 2u);
  EXPECT_EQ(slb.peak(), 2u);
}

TEST(SilhouetteBuffer, ClearForgetsAll) {
  SilhouetteBuffer slb;
  slb.clear(2, 8, 2);
  for (std::uint32_t i = 0; i < 8; ++i) slb.insert(i % 2, i, 0, i);
  slb.clear(4, 3, 1);
  EXPECT_EQ(slb.buckets(), 4u);
  EXPECT_EQ(slb.peak(), 0u);
  for (std::uint32_t b = 0; b < 4; ++b) EXPECT_EQ(slb.head(b), kNone);
  for (std::uint32_t i = 0; i < 3; ++i) EXPECT_NE(slb.insert(0, i, 0, 0), kNone);
  EXPECT_EQ(slb.insert(0, 9, 0, 0), kNone);
}

TEST(SilhouetteBuffer, AReusedRecordStartsAfresh) {
  SilhouetteBuffer slb;
  slb.clear(1, 1, 2);
  const std::uint32_t at = slb.insert(0, 1, 0, 5);
  slb[at].vertex = true;
  slb[at].corner_covered = true;
  slb.append(at, line(1));
  slb.erase(0, at);
  const std::uint32_t again = slb.insert(0, 2, 1, 6);
  ASSERT_NE(again, kNone);
  EXPECT_FALSE(slb[again].vertex);
  EXPECT_FALSE(slb[again].corner_covered);
  EXPECT_EQ(slb.line_count(again), 0u);
}

}  // namespace
}  // namespace kagesen::unit

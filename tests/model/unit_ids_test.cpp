#include "model/unit_ids.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/model/unit/frame.h"

namespace kagesen {
namespace {

/// `count` flat squares of half a texel on a row, `pitch` texels apart, and a fragment on each.
Trace row_of_objects(std::uint32_t count, std::int32_t pitch) {
  Trace trace;
  trace.header.objects.resize(count);
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::int32_t x = static_cast<std::int32_t>(i) * pitch * kTexel + 99;
    trace.all_casters.push_back(
        triangle({x, 99, 10 + i}, {x + kTexel / 2, 99, 10 + i}, {x, kTexel / 2, 10 + i}, i, i));
    trace.all_fragments.push_back(fragment_at(x + 50, 150, 1000, i));
  }
  return trace;
}

TEST(UnitIds, KeepTheirNumbersWhereTheyFit) {
  EXPECT_TRUE(assign_unit_ids(row_of_objects(4, 1), kMinFractionBits, 2).ids.empty());
  EXPECT_EQ(assign_unit_ids(row_of_objects(4, 1), kMinFractionBits, 2).sharing, 0u);
}

TEST(UnitIds, DistantObjectsShareAndNeighboursDoNot) {
  const UnitIds far = assign_unit_ids(row_of_objects(40, 9), kMinFractionBits, 1);
  ASSERT_EQ(far.ids.size(), 40u);
  EXPECT_EQ(far.sharing, 0u);
  // One texel of margin on either side: at a pitch of 2 each meets its neighbours, at 3 none.
  const UnitIds near = assign_unit_ids(row_of_objects(40, 2), kMinFractionBits, 1);
  EXPECT_EQ(near.sharing, 0u);
  for (std::size_t i = 1; i < 40; ++i) EXPECT_NE(near.ids[i], near.ids[i - 1]) << i;
}

TEST(UnitIds, WhatMustShareIsCounted) {
  // Five objects in one place and two IDs: three of them share.
  const UnitIds ids = assign_unit_ids(row_of_objects(5, 0), kMinFractionBits, 1);
  EXPECT_EQ(ids.sharing, 3u);
  for (const std::uint32_t id : ids.ids) EXPECT_LT(id, 2u);
  EXPECT_NE(ids.ids[0], ids.ids[1]);
}

TEST(UnitIds, AFragmentCountsToItsObjectsPlace) {
  // Objects 0 and 2 are far apart, but a fragment of object 2 lies under object 0.
  Trace trace = row_of_objects(3, 20);
  const Fragment under = fragment_at(150, 150, 1000, 2);
  trace.all_fragments.push_back(under);
  const UnitIds ids = assign_unit_ids(trace, kMinFractionBits, 1);
  EXPECT_NE(ids.ids[0], ids.ids[2]);
}

TEST(UnitIds, SharingWithoutMeetingChangesNoVerdict) {
  for (unsigned seed = 0; seed < 60; ++seed) {
    constexpr int kSide = 64, kObjects = 20;
    RandomScene scene(seed, kSide, kObjects, 0);
    std::mt19937 random(seed);
    // Fragments over their own object and its surroundings only, so that boxes stay small.
    for (const Caster& c : scene.frame.casters) {
      for (int n = 0; n < 6; ++n) {
        const auto near = [&](std::int32_t v) {
          return v + static_cast<std::int32_t>(random() % (4u * kTexel)) - 2 * kTexel;
        };
        scene.frame.fragments.push_back(
            fragment_at(near(c.vertex[0].x), near(c.vertex[0].y), random() & kDepthMax, c.object));
      }
    }
    Trace trace;
    trace.header.objects.resize(kObjects);
    trace.all_casters = scene.frame.casters;
    trace.all_fragments = scene.frame.fragments;
    const UnitIds ids = assign_unit_ids(trace, kMinFractionBits, 4);
    ASSERT_EQ(ids.ids.size(), std::size_t{kObjects});
    ASSERT_LT(*std::max_element(ids.ids.begin(), ids.ids.end()), 16u);
    ASSERT_EQ(ids.sharing, 0u) << seed << ": pick a sparser scene";
    UnitConfig wide = small_config(kSide), narrow = wide;
    narrow.id_bits = 4;
    FrameSetup setup;
    setup.unit_ids = ids.ids;
    ASSERT_EQ(run(scene.frame, narrow, setup).verdicts, run(scene.frame, wide).verdicts) << seed;
  }
}

}  // namespace
}  // namespace kagesen

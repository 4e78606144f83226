#include "model/unit/texel_buffers.h"

#include <gtest/gtest.h>

namespace kagesen::unit {
namespace {

TEST(TexelBuffers, StartEmpty) {
  TexelBuffers texels;
  texels.clear(3, 2, 999);
  for (std::uint32_t i = 0; i < 6; ++i) {
    EXPECT_EQ(texels[i].depth, 999u);
    EXPECT_EQ(texels[i].id(), Texel::kNoId);
    EXPECT_FALSE(texels[i].edge());
    EXPECT_FALSE(texels[i].overflow());
  }
}

TEST(TexelBuffers, HoldExactlyTheirRectangle) {
  TexelBuffers texels;
  texels.clear(3, 2, 999);
  EXPECT_TRUE(texels.holds(0, 0));
  EXPECT_TRUE(texels.holds(2, 1));
  EXPECT_FALSE(texels.holds(3, 1));
  EXPECT_FALSE(texels.holds(2, 2));
  EXPECT_FALSE(texels.holds(-1, 0));
  EXPECT_FALSE(texels.holds(0, -1));
  EXPECT_EQ(texels.index(2, 1), 5u);
}

TEST(TexelBuffers, TheNearerDepthStaysAndTheFirstOfEqualOnes) {
  Texel texel{999, Texel::kNoId};
  texel.cover(500, 7);
  texel.cover(600, 8);
  EXPECT_EQ(texel.depth, 500u);
  EXPECT_EQ(texel.id(), 7u);
  texel.cover(500, 9);
  EXPECT_EQ(texel.id(), 7u);
  texel.cover(499, 9);
  EXPECT_EQ(texel.depth, 499u);
  EXPECT_EQ(texel.id(), 9u);
}

TEST(TexelBuffers, FlagsAndIdAreIndependent) {
  constexpr std::uint32_t kLargestId = (1u << 24) - 1;
  Texel texel{999, Texel::kNoId};
  texel.set_edge(true);
  texel.cover(5, kLargestId);
  EXPECT_TRUE(texel.edge());
  EXPECT_FALSE(texel.overflow());
  texel.set_overflow();
  texel.cover(4, 0);
  EXPECT_EQ(texel.id(), 0u);
  EXPECT_TRUE(texel.edge());
  EXPECT_TRUE(texel.overflow());
  texel.set_edge(false);
  EXPECT_FALSE(texel.edge());
  EXPECT_TRUE(texel.overflow());
  EXPECT_EQ(texel.id(), 0u);
}

TEST(TexelBuffers, ClearForgetsAll) {
  TexelBuffers texels;
  texels.clear(2, 2, 99);
  texels[3].cover(1, 1);
  texels[3].set_edge(true);
  texels[3].set_overflow();
  texels.clear(2, 2, 77);
  EXPECT_EQ(texels[3].depth, 77u);
  EXPECT_EQ(texels[3].tag, Texel::kNoId);
}

}  // namespace
}  // namespace kagesen::unit

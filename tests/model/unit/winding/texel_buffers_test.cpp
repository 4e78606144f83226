#include "model/unit/winding/texel_buffers.h"

#include <gtest/gtest.h>

#include <set>

namespace kagesen::unit::winding {
namespace {

TEST(WindingTexelBuffers, EveryTexelHasARecordOfItsOwn) {
  for (const auto& [width, height] : {std::pair(1u, 1u), {8u, 8u}, {9u, 17u}, {40u, 7u}}) {
    TexelBuffers b;
    b.clear(width, height);
    EXPECT_EQ(b.tile_count(), ((width + 7) / 8) * ((height + 7) / 8));
    EXPECT_EQ(b.touched_texels(), 0u);
    std::set<const Tile*> tiles;
    for (std::uint32_t y = 0; y < height; ++y) {
      for (std::uint32_t x = 0; x < width; ++x) {
        Tile& tile = b.tile(x, y);
        ASSERT_EQ(&tile, &b.tile(x / 8 * 8, y / 8 * 8));
        if (tile.slot == Tile::kUntouched) {
          ASSERT_TRUE(tiles.insert(&tile).second);
          b.touch(tile);
        }
        Texel& texel = b.texel(tile, x, y);
        ASSERT_TRUE(texel.empty());
        texel.object = y * width + x;
      }
    }
    EXPECT_EQ(tiles.size(), b.tile_count());
    EXPECT_EQ(b.touched_texels(), 64 * b.tile_count());
    const TexelBuffers& read = b;
    for (std::uint32_t y = 0; y < height; ++y) {
      for (std::uint32_t x = 0; x < width; ++x) {
        ASSERT_EQ(read.texel(read.tile(x, y), x, y).object, y * width + x);
      }
    }
  }
}

TEST(WindingTexelBuffers, HoldsWhatLiesInTheMap) {
  TexelBuffers b;
  b.clear(9, 5);
  for (int y = -3; y < 20; ++y) {
    for (int x = -3; x < 20; ++x) {
      EXPECT_EQ(b.holds(x, y), x >= 0 && x < 9 && y >= 0 && y < 5);
    }
  }
}

TEST(WindingTexelBuffers, BitsOfATileRunRowByRow) {
  std::uint32_t expected = 0;
  for (std::uint32_t y = 24; y < 32; ++y) {
    for (std::uint32_t x = 8; x < 16; ++x) EXPECT_EQ(TexelBuffers::within(x, y), expected++);
  }
}

TEST(WindingTexelBuffers, ATexelIsInOneState) {
  Texel t;
  const auto states = [&t] {
    return std::tuple(t.empty(), t.one_plane(), t.has_list(), t.overflow());
  };
  EXPECT_EQ(states(), std::tuple(true, false, false, false));
  t.object = 0;
  EXPECT_EQ(states(), std::tuple(false, true, false, false));
  t.list = 5;
  EXPECT_EQ(states(), std::tuple(false, false, true, false));
  t.object = Texel::kNobody;
  EXPECT_EQ(states(), std::tuple(false, false, true, false));
  t.list = Texel::kOverflow;
  EXPECT_EQ(states(), std::tuple(false, false, false, true));
}

TEST(WindingTexelBuffers, ClearForgetsAll) {
  TexelBuffers b;
  b.clear(16, 16);
  b.touch(b.tile(3, 3));
  b.tile(3, 3).occupied = 7;
  b.tile(3, 3).nearest = 5;
  b.texel(b.tile(3, 3), 3, 3).object = 4;
  b.clear(16, 16);
  EXPECT_EQ(b.touched_texels(), 0u);
  for (const Tile& tile : b.tiles()) {
    EXPECT_EQ(tile.slot, Tile::kUntouched);
    EXPECT_EQ(tile.occupied, 0u);
    EXPECT_EQ(tile.nearest, ThresholdPlane::kUnbounded);
  }
  b.touch(b.tile(3, 3));
  EXPECT_TRUE(b.texel(b.tile(3, 3), 3, 3).empty());
}

}  // namespace
}  // namespace kagesen::unit::winding

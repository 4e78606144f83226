// Is every pixel covered exactly once, whatever the triangles' corners, and in the stated order?
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/traces/raster_support.h"
#include "traces/raster/clip.h"
#include "traces/raster/pixel_raster.h"
#include "traces/raster/view.h"
#include "traces/scene/random.h"

namespace kagesen {
namespace {

constexpr int kSide = 64;

class Counts {
 public:
  void add(const ScreenPoint& a, const ScreenPoint& b, const ScreenPoint& c) {
    raster_triangle({a, b, c}, kSide, kSide,
                    [&](int x, int y) { ++count_[static_cast<std::size_t>(y * kSide + x)]; });
  }
  bool all(int expected) const {
    return std::all_of(count_.begin(), count_.end(), [=](int n) { return n == expected; });
  }
  int at(int x, int y) const { return count_[static_cast<std::size_t>(y * kSide + x)]; }

 private:
  std::vector<int> count_ = std::vector<int>(kSide * kSide, 0);
};

ScreenPoint pixels(double x, double y) {
  return {static_cast<std::int64_t>(x * kSubpixels), static_cast<std::int64_t>(y * kSubpixels)};
}

TEST(TopLeftRule, AQuadOfTwoTrianglesCoversItsPixelsOnce) {
  // Corners on pixel centres: every edge is a tie.
  Counts counts;
  const ScreenPoint a = pixels(2.5, 3.5), b = pixels(10.5, 3.5), c = pixels(10.5, 9.5),
                    d = pixels(2.5, 9.5);
  counts.add(a, b, c);
  counts.add(c, a, d);
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      EXPECT_EQ(counts.at(x, y), x >= 2 && x < 10 && y >= 3 && y < 9 ? 1 : 0) << x << "," << y;
    }
  }
}

TEST(TopLeftRule, RandomFansCoverTheImageOnce) {
  Random random(1);
  for (int round = 0; round < 300; ++round) {
    // Odd rounds put the hub and the spokes on pixel centres and corners, where ties are.
    const double grid = round % 2 ? 2 : static_cast<double>(kSubpixels);
    const auto at = [&](double x, double y) {
      return pixels(std::floor(x * grid) / grid, std::floor(y * grid) / grid);
    };
    const ScreenPoint hub = at(random.uniform(0, kSide), random.uniform(0, kSide));
    std::vector<ScreenPoint> rim;
    const int spokes = 3 + static_cast<int>(random.uniform(0, 40));
    const double reach = round % 3 ? 2000 : 100000;
    for (int i = 0; i < spokes; ++i) {
      const double angle = 6.283185307 * (i + random.uniform(0, 0.5)) / spokes;
      rim.push_back(at(32 + reach * std::cos(angle), 32 + reach * std::sin(angle)));
    }
    Counts counts;
    for (int i = 0; i < spokes; ++i) {
      const ScreenPoint &a = rim[static_cast<std::size_t>(i)],
                        &b = rim[static_cast<std::size_t>((i + 1) % spokes)];
      if (i % 2) {
        counts.add(hub, a, b);
      } else {
        counts.add(b, a, hub);
      }
    }
    ASSERT_TRUE(counts.all(1)) << "round " << round;
  }
}

TEST(TopLeftRule, RandomMeshesOfTinyTrianglesCoverOnce) {
  Random random(2);
  constexpr int kCells = 90;  // smaller than a pixel
  std::vector<ScreenPoint> grid;
  for (int j = 0; j <= kCells; ++j) {
    for (int i = 0; i <= kCells; ++i) {
      grid.push_back(pixels(-2 + 68.0 * (i + random.uniform(-0.2, 0.2)) / kCells,
                            -2 + 68.0 * (j + random.uniform(-0.2, 0.2)) / kCells));
    }
  }
  Counts counts;
  for (int j = 0; j < kCells; ++j) {
    for (int i = 0; i < kCells; ++i) {
      const auto at = [&](int x, int y) {
        return grid[static_cast<std::size_t>((j + y) * (kCells + 1) + i + x)];
      };
      // So little jitter turns no triangle round.
      counts.add(at(0, 0), at(1, 0), at(1, 1));
      counts.add(at(0, 0), at(1, 1), at(0, 1));
    }
  }
  EXPECT_TRUE(counts.all(1));
}

TEST(Order, TilesThenQuadsThenPixels) {
  std::vector<std::pair<int, int>> walked, expected;
  raster_triangle({pixels(-100, -100), pixels(300, -100), pixels(-100, 300)}, 20, 18,
                  [&](int x, int y) { walked.emplace_back(x, y); });
  visit_pixels(20, 18, [&](int x, int y) { expected.emplace_back(x, y); });
  EXPECT_EQ(walked, expected);
  ASSERT_EQ(walked.size(), 20u * 18u);
  using P = std::pair<int, int>;
  EXPECT_EQ(walked[1], P(1, 0));
  EXPECT_EQ(walked[2], P(0, 1));
  EXPECT_EQ(walked[4], P(2, 0));
  EXPECT_EQ(walked[16], P(0, 2));
  EXPECT_EQ(walked[64], P(8, 0));
}

TEST(Clip, NeighboursGetTheSameCutPoints) {
  Random random(3);
  const auto any = [&] {
    return glm::dvec4(random.uniform(-3, 3), random.uniform(-3, 3), random.uniform(-1, 2),
                      random.uniform(0.1, 2));
  };
  for (int round = 0; round < 10000; ++round) {
    const glm::dvec4 a = any(), b = any(), plane(1, 0.3, -0.2, 1);
    if ((glm::dot(plane, a) >= 0) == (glm::dot(plane, b) >= 0)) continue;
    ASSERT_EQ(cut_edge(a, b, plane), cut_edge(b, a, plane));
  }
}

/// A floor of jittered triangles through and behind the camera, far beyond the image.
Scene floor_scene(double jitter_seed) {
  Random random(static_cast<std::uint64_t>(jitter_seed));
  std::vector<glm::dvec3> grid;
  constexpr int kCells = 12;
  for (int j = 0; j <= kCells; ++j) {
    for (int i = 0; i <= kCells; ++i) {
      grid.push_back({(i - 6 + random.uniform(-0.3, 0.3)) * 1000, 0,
                      (j - 6 + random.uniform(-0.3, 0.3)) * 1000});
    }
  }
  std::vector<std::array<glm::dvec3, 3>> triangles;
  for (int j = 0; j < kCells; ++j) {
    for (int i = 0; i < kCells; ++i) {
      const auto at = [&](int x, int y) {
        return grid[static_cast<std::size_t>((j + y) * (kCells + 1) + i + x)];
      };
      triangles.push_back({at(0, 0), at(0, 1), at(1, 1)});
      triangles.push_back({at(0, 0), at(1, 1), at(1, 0)});
    }
  }
  Scene scene = flat_scene(triangles);
  scene.camera.eye = {random.uniform(-900, 900), 1.7, random.uniform(-900, 900)};
  scene.camera.target = scene.camera.eye + glm::dvec3(random.uniform(-1, 1), -0.9, 0.4);
  scene.camera.up = {0, 1, 0};
  return scene;
}

TEST(Camera, ClippedFloorsCoverEveryPixelOnce) {
  for (int seed = 1; seed <= 20; ++seed) {
    CaptureOptions options = small_options(160, 90);
    options.mode = FragmentMode::kAll;
    const Trace trace = captured(floor_scene(seed), options);
    ASSERT_EQ(trace.all_fragments.size(), 160u * 90u) << "seed " << seed;
  }
}

}  // namespace
}  // namespace kagesen

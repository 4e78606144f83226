#pragma once
/// Which pixels a triangle covers, exactly once each: integer edge functions and the top-left rule.
#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

namespace kagesen {

inline constexpr int kSubpixelBits = 12;
inline constexpr std::int64_t kSubpixels = std::int64_t{1} << kSubpixelBits;  ///< a pixel
/// Corners must lie within +-kGuardPixels: edge functions then stay below 2^62.
inline constexpr std::int64_t kGuardPixels = std::int64_t{1} << (29 - kSubpixelBits);

/// A corner on the screen, y downwards. Units of 1 / kSubpixels pixel.
struct ScreenPoint {
  std::int64_t x = 0, y = 0;
};

/// One side of a triangle: value(x, y) >= 0 at the pixel centres it lets through.
struct PixelEdge {
  PixelEdge(const ScreenPoint& a, const ScreenPoint& b) {
    const std::int64_t dx = b.x - a.x, dy = b.y - a.y;
    const std::int64_t half = kSubpixels / 2;
    // The interior lies on the right of a-b as seen; ties go to top edges and left edges.
    const bool owns_ties = dy < 0 || (dy == 0 && dx > 0);
    step_x = -dy * kSubpixels;
    step_y = dx * kSubpixels;
    origin = dx * (half - a.y) - dy * (half - a.x) - (owns_ties ? 0 : 1);
  }
  std::int64_t at(std::int64_t x, std::int64_t y) const { return origin + x * step_x + y * step_y; }
  std::int64_t step_x, step_y, origin;
};

/// Calls emit(x, y) for every pixel whose centre the triangle covers, either winding: 8x8 tiles in
/// row-major order, in a tile 2x2 quads in row-major order, in a quad pixels in row-major order.
/// @pre corners within the guard band; width and height at most kGuardPixels
template <typename Emit>
void raster_triangle(std::array<ScreenPoint, 3> p, int width, int height, Emit&& emit) {
  constexpr int kTile = 8;
  const std::int64_t area =
      (p[1].x - p[0].x) * (p[2].y - p[0].y) - (p[1].y - p[0].y) * (p[2].x - p[0].x);
  if (area == 0) return;
  if (area < 0) std::swap(p[1], p[2]);

  // Pixel x has its centre at x + 1/2; shifting a negative number rounds down.
  constexpr std::int64_t kHalf = kSubpixels / 2;
  const auto first = [](std::int64_t v) { return (v + kHalf - 1) >> kSubpixelBits; };
  const auto last = [](std::int64_t v) { return (v - kHalf) >> kSubpixelBits; };
  const auto x_range = std::minmax({p[0].x, p[1].x, p[2].x});
  const auto y_range = std::minmax({p[0].y, p[1].y, p[2].y});
  const int x0 = static_cast<int>(std::max<std::int64_t>(first(x_range.first), 0));
  const int y0 = static_cast<int>(std::max<std::int64_t>(first(y_range.first), 0));
  const int x1 = static_cast<int>(std::min<std::int64_t>(last(x_range.second), width - 1));
  const int y1 = static_cast<int>(std::min<std::int64_t>(last(y_range.second), height - 1));
  if (x0 > x1 || y0 > y1) return;

  const PixelEdge edges[3] = {{p[0], p[1]}, {p[1], p[2]}, {p[2], p[0]}};
  for (int tile_y = y0 & ~(kTile - 1); tile_y <= y1; tile_y += kTile) {
    for (int tile_x = x0 & ~(kTile - 1); tile_x <= x1; tile_x += kTile) {
      const int left = std::max(tile_x, x0), right = std::min(tile_x + kTile - 1, x1);
      const int top = std::max(tile_y, y0), bottom = std::min(tile_y + kTile - 1, y1);
      bool misses = false, full = true;
      for (const PixelEdge& e : edges) {
        const std::int64_t best = e.at(e.step_x > 0 ? right : left, e.step_y > 0 ? bottom : top);
        const std::int64_t worst = e.at(e.step_x > 0 ? left : right, e.step_y > 0 ? top : bottom);
        misses = misses || best < 0;
        full = full && worst >= 0;
      }
      if (misses) continue;
      for (int quad_y = top & ~1; quad_y <= bottom; quad_y += 2) {
        for (int quad_x = left & ~1; quad_x <= right; quad_x += 2) {
          for (int y = std::max(quad_y, top); y <= std::min(quad_y + 1, bottom); ++y) {
            for (int x = std::max(quad_x, left); x <= std::min(quad_x + 1, right); ++x) {
              // No sign bit set: inside all three.
              if (full || (edges[0].at(x, y) | edges[1].at(x, y) | edges[2].at(x, y)) >= 0) {
                emit(x, y);
              }
            }
          }
        }
      }
    }
  }
}

/// Calls emit(x, y) for every pixel of an image, in the order raster_triangle keeps in a triangle.
template <typename Emit>
void visit_pixels(std::uint32_t width, std::uint32_t height, Emit&& emit) {
  const auto w = static_cast<int>(width), h = static_cast<int>(height);
  for (int tile_y = 0; tile_y < h; tile_y += 8) {
    for (int tile_x = 0; tile_x < w; tile_x += 8) {
      for (int i = 0; i < 64; ++i) {
        // i counts quads in its upper bits, pixels of a quad in its lower two.
        const int x = tile_x + (i >> 2 & 3) * 2 + (i & 1), y = tile_y + (i >> 4) * 2 + (i >> 1 & 1);
        if (x < w && y < h) emit(x, y);
      }
    }
  }
}

}  // namespace kagesen

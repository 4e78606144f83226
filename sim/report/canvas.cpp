#include "sim/report/canvas.h"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "sim/report/font.h"

namespace kagesen {

Rgb mix(Rgb a, Rgb b, double t) {
  t = std::clamp(t, 0.0, 1.0);
  const auto blend = [t](std::uint8_t from, std::uint8_t to) {
    return static_cast<std::uint8_t>(std::lround(from + (double(to) - from) * t));
  };
  return {blend(a.r, b.r), blend(a.g, b.g), blend(a.b, b.b)};
}

Rgb scaled(Rgb colour, double factor) { return mix({}, colour, factor); }

Canvas::Canvas(int width, int height, Rgb fill)
    : width_(std::max(width, 1)),
      height_(std::max(height, 1)),
      pixels_(static_cast<std::size_t>(width_) * height_, fill) {}

void Canvas::set(int x, int y, Rgb colour) {
  if (x < 0 || y < 0 || x >= width_ || y >= height_) return;
  pixels_[static_cast<std::size_t>(y) * width_ + x] = colour;
}

void Canvas::rectangle(int x, int y, int width, int height, Rgb colour) {
  for (int row = y; row < y + height; ++row) {
    for (int column = x; column < x + width; ++column) set(column, row, colour);
  }
}

void Canvas::text(int x, int y, const std::string& words, Rgb colour, int scale) {
  for (const char letter : words) {
    for (int row = 0; row < kGlyphHeight; ++row) {
      for (int column = 0; column < kGlyphWidth; ++column) {
        if (glyph_bit(letter, column, row)) {
          rectangle(x + column * scale, y + row * scale, scale, scale, colour);
        }
      }
    }
    x += (kGlyphWidth + 1) * scale;
  }
}

int Canvas::text_width(const std::string& words, int scale) {
  return static_cast<int>(words.size()) * (kGlyphWidth + 1) * scale;
}

Canvas Canvas::cropped(int x, int y, int width, int height) const {
  Canvas result(width, height);
  for (int row = 0; row < height; ++row) {
    for (int column = 0; column < width; ++column) {
      result.set(column, row,
                 get(std::clamp(x + column, 0, width_ - 1), std::clamp(y + row, 0, height_ - 1)));
    }
  }
  return result;
}

Canvas Canvas::enlarged(int factor) const {
  Canvas result(width_ * factor, height_ * factor);
  for (int y = 0; y < height_; ++y) {
    for (int x = 0; x < width_; ++x) {
      result.rectangle(x * factor, y * factor, factor, factor, get(x, y));
    }
  }
  return result;
}

}  // namespace kagesen

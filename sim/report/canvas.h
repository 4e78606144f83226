#pragma once
/// A small RGB picture to draw on: pixels, rectangles and text in a built-in 5 x 7 font.
#include <cstdint>
#include <string>
#include <vector>

namespace kagesen {

struct Rgb {
  std::uint8_t r = 0, g = 0, b = 0;
};
/// a where t = 0, b where t = 1.
Rgb mix(Rgb a, Rgb b, double t);
Rgb scaled(Rgb colour, double factor);

class Canvas {
 public:
  Canvas(int width, int height, Rgb fill = {});
  int width() const { return width_; }
  int height() const { return height_; }
  /// Outside the canvas nothing happens.
  void set(int x, int y, Rgb colour);
  Rgb get(int x, int y) const { return pixels_[static_cast<std::size_t>(y) * width_ + x]; }
  void rectangle(int x, int y, int width, int height, Rgb colour);
  /// Upper left corner at (x, y); a glyph is 6 x 8 times `scale` pixels. Letters become capitals.
  void text(int x, int y, const std::string& words, Rgb colour, int scale = 1);
  static int text_width(const std::string& words, int scale = 1);
  /// Rows, top first, three bytes a pixel.
  const Rgb* data() const { return pixels_.data(); }
  Canvas cropped(int x, int y, int width, int height) const;
  Canvas enlarged(int factor) const;

 private:
  int width_, height_;
  std::vector<Rgb> pixels_;
};
static_assert(sizeof(Rgb) == 3, "an image library reads the pixels as bytes");

}  // namespace kagesen

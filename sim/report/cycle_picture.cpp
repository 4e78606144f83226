#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sim/report/fragment_figures.h"
#include "sim/report/palette.h"
#include "sim/report/pictures.h"

namespace kagesen {
namespace {

constexpr double kDoublings = 7;  // of a cycle, until the scale ends

Rgb colour_of(double cycles) {
  return heat_colour(std::clamp(std::log2(std::max(cycles, 1.0)) / kDoublings, 0.0, 1.0));
}

}  // namespace

Canvas cycle_picture(const Trace& trace, const RunResult& result) {
  const int width = static_cast<int>(trace.header.image_width);
  const int height = static_cast<int>(trace.header.image_height);
  const int scale = width >= 960 ? 2 : 1, band = 26 * scale;
  Canvas picture(width, height + band, {24, 24, 28});
  // All fragments of a pixel count, those that are hidden in the end too.
  std::vector<std::uint64_t> cycles(std::size_t(width) * height);
  const std::vector<std::uint32_t> costs = fragment_costs(result.fragment_cycles);
  for (std::size_t i = 0; i < costs.size(); ++i) {
    const Fragment& f = trace.all_fragments[i];
    cycles[std::size_t(f.pixel_y) * width + f.pixel_x] += costs[i];
  }
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const std::uint64_t here = cycles[std::size_t(y) * width + x];
      if (here > 0) picture.set(x, y, colour_of(double(here)));
    }
  }
  int x = 4 * scale;
  const int top = height + 4 * scale;
  picture.text(x, top, "cycles a pixel", {235, 235, 235}, scale);
  for (int doubling = 0; doubling <= int(kDoublings); ++doubling) {
    const double value = std::exp2(doubling);
    const std::string words = fmt::format("{:.0f}", value);
    picture.rectangle(x, top + 11 * scale, 7 * scale, 7 * scale, colour_of(value));
    picture.text(x + 10 * scale, top + 11 * scale, words, {235, 235, 235}, scale);
    x += 16 * scale + Canvas::text_width(words, scale);
  }
  return picture;
}

}  // namespace kagesen

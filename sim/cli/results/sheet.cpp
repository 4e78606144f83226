#include "sim/cli/results/sheet.h"

#include <fmt/format.h>

#include <algorithm>

#include "sim/report/pictures.h"

namespace kagesen {
namespace {

constexpr int kWindowWidth = 80, kWindowHeight = 60, kEnlarged = 2;
constexpr int kTileWidth = kWindowWidth * kEnlarged, kTileHeight = kWindowHeight * kEnlarged;
constexpr int kGap = 4, kLeft = 64, kTop = 16;
constexpr Rgb kPaperWhite{250, 250, 248}, kInk{40, 40, 44};

}  // namespace

Sheet::Sheet(std::vector<unsigned> scales)
    : scales_(std::move(scales)),
      picture_(kLeft + static_cast<int>(scales_.size()) * (kTileWidth + kGap),
               kTop + 3 * (kTileHeight + kGap), kPaperWhite) {
  const char* rows[] = {"8 bits", "4 bits", "plain map"};
  for (int row = 0; row < 3; ++row) {
    picture_.text(4, kTop + row * (kTileHeight + kGap) + kTileHeight / 2 - 4, rows[row], kInk);
  }
  for (std::size_t i = 0; i < scales_.size(); ++i) {
    picture_.text(kLeft + static_cast<int>(i) * (kTileWidth + kGap), 4,
                  fmt::format("scale {}", scales_[i]), kInk);
  }
}

void Sheet::choose_window(const Trace& trace, const std::vector<std::uint8_t>& exact) {
  const int width = static_cast<int>(trace.header.image_width);
  const int height = static_cast<int>(trace.header.image_height);
  std::vector<Verdict> verdicts(exact.size());
  std::transform(exact.begin(), exact.end(), verdicts.begin(),
                 [](std::uint8_t dark) { return dark ? Verdict::kDark : Verdict::kLit; });
  const std::vector<std::uint8_t> mask = mask_values(trace, verdicts);
  std::vector<std::uint32_t> object(mask.size(), kNoObject);
  for (const Fragment& f : trace.all_fragments) {
    if (f.flags & Fragment::kVisible) {
      object[static_cast<std::size_t>(f.pixel_y) * width + f.pixel_x] = f.object;
    }
  }
  long best = -1;
  for (int top = 0; top + kWindowHeight <= height; top += kWindowHeight / 4) {
    for (int left = 0; left + kWindowWidth <= width; left += kWindowWidth / 4) {
      long edge = 0;
      for (int y = top; y < top + kWindowHeight; ++y) {
        const std::size_t row = static_cast<std::size_t>(y) * width;
        for (int x = left + 1; x < left + kWindowWidth; ++x) {
          // A change from one object to the next is no shadow's edge.
          edge += mask[row + x] != mask[row + x - 1] && object[row + x] == object[row + x - 1];
        }
      }
      if (edge <= best) continue;
      best = edge;
      x_ = left;
      y_ = top;
    }
  }
  chosen_ = true;
}

void Sheet::add(const Trace& trace, const std::vector<Verdict>& verdicts, unsigned scale, Row row) {
  const auto column = std::find(scales_.begin(), scales_.end(), scale) - scales_.begin();
  const Canvas tile = shaded_picture(trace, verdicts)
                          .cropped(x_, y_, kWindowWidth, kWindowHeight)
                          .enlarged(kEnlarged);
  const int left = kLeft + static_cast<int>(column) * (kTileWidth + kGap);
  const int top = kTop + static_cast<int>(row) * (kTileHeight + kGap);
  for (int y = 0; y < kTileHeight; ++y) {
    for (int x = 0; x < kTileWidth; ++x) picture_.set(left + x, top + y, tile.get(x, y));
  }
}

}  // namespace kagesen

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sim/report/encode.h"
#include "sim/report/palette.h"
#include "sim/report/pictures.h"
#include "sim/report/table.h"

namespace kagesen {
namespace {

/// Calls visit(texel index, lines) for every entry, or every cluster and its segments.
template <class Visit>
void for_each_entry(const MapContents& contents, Visit visit) {
  const auto index = [&](const auto& at) {
    return std::size_t(at.texel_y) * contents.width + at.texel_x;
  };
  for (const TexelEntry& entry : contents.entries) visit(index(entry), entry.lines.size());
  for (const TexelCluster& cluster : contents.clusters) {
    visit(index(cluster), cluster.segments.size());
  }
}

std::vector<std::uint32_t> lines_per_texel(const MapContents& contents) {
  std::vector<std::uint32_t> lines(std::size_t(contents.width) * contents.height, 0);
  for_each_entry(contents, [&](std::size_t texel, std::size_t count) {
    lines[texel] += static_cast<std::uint32_t>(count);
  });
  return lines;
}

/// Which texels hold a depth; the winding profile may know it without an object.
std::vector<bool> texels_with_depth(const RunResult& result) {
  const MapContents& contents = result.contents;
  const std::uint32_t empty = kDepthMax >> (kDepthBits - result.config.depth_bits);
  std::vector<bool> written;
  written.reserve(contents.depth.size());
  for (std::size_t i = 0; i < contents.depth.size(); ++i) {
    written.push_back(contents.object[i] != kNoObject || contents.depth[i] < empty);
  }
  return written;
}

/// Where a count stands between 1 and the largest, by ratio.
double heat(std::uint32_t lines, std::uint32_t largest) {
  return largest > 1 ? std::log(double(lines)) / std::log(double(largest)) : 0.0;
}

/// One line is bright enough already to be seen on the depth buffer.
Rgb line_colour(double t) { return heat_colour(0.4 + 0.6 * t); }

void draw_scale(Canvas& picture, const char* title, int top, std::uint32_t largest, int scale) {
  const Rgb ink{235, 235, 235};
  const int margin = 6 * scale, bar = std::max(1, picture.width() - 2 * margin);
  picture.text(margin, top + 4 * scale, title, ink, scale);
  for (int x = 0; x < bar; ++x) {
    picture.rectangle(margin + x, top + 15 * scale, 1, 8 * scale, line_colour(double(x) / bar));
  }
  int free_from = 0;
  std::vector<std::uint32_t> marks{1};
  for (std::uint32_t mark = 3; mark < largest; mark *= 3) marks.push_back(mark);
  if (largest > 1) marks.push_back(largest);
  for (const std::uint32_t mark : marks) {
    const std::string words = grouped(mark);
    const int wide = Canvas::text_width(words, scale);
    const int x = std::min(margin + int(heat(mark, largest) * bar), picture.width() - wide);
    if (x < free_from) continue;
    picture.text(x, top + 26 * scale, words, ink, scale);
    free_from = x + wide + 4 * scale;
  }
}

}  // namespace

Canvas lines_picture(const RunResult& result) {
  const MapContents& contents = result.contents;
  const int width = static_cast<int>(contents.width), height = static_cast<int>(contents.height);
  const std::vector<std::uint32_t> lines = lines_per_texel(contents);
  const std::uint32_t largest = lines.empty() ? 0 : *std::max_element(lines.begin(), lines.end());
  const std::vector<bool> written = texels_with_depth(result);
  std::uint32_t nearest = 0xffffffffu, farthest = 0;
  for (std::size_t i = 0; i < contents.depth.size(); ++i) {
    if (!written[i]) continue;
    nearest = std::min(nearest, contents.depth[i]);
    farthest = std::max(farthest, contents.depth[i]);
  }
  const double range = farthest > nearest ? double(farthest) - nearest : 1.0;

  Canvas map(width, height, {14, 14, 18});
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const std::size_t i = std::size_t(y) * contents.width + x;
      if (lines[i] > 0) {
        map.set(x, y, line_colour(heat(lines[i], largest)));
      } else if (written[i]) {
        map.set(x, y, mix({110, 118, 130}, {40, 44, 52}, (contents.depth[i] - nearest) / range));
      }
    }
  }
  constexpr int kSmall = 512;
  const Canvas enlarged = map.enlarged(std::max(1, kSmall / std::max(width, height)));
  const int scale = enlarged.width() >= 960 ? 2 : 1;
  Canvas picture(enlarged.width(), enlarged.height() + 38 * scale, {24, 24, 28});
  for (int y = 0; y < enlarged.height(); ++y) {
    for (int x = 0; x < enlarged.width(); ++x) picture.set(x, y, enlarged.get(x, y));
  }
  const bool winding = result.config.profile == Profile::kWinding;
  draw_scale(picture, winding ? "segments a texel" : "lines a texel", enlarged.height(), largest,
             scale);
  return picture;
}

std::string map_exr(const RunResult& result) {
  const MapContents& contents = result.contents;
  const std::size_t texels = std::size_t(contents.width) * contents.height;
  std::vector<Channel> channels;
  for (const char* name : {"depth", "object", "lines", "entries", "overflowed"}) {
    channels.push_back({name, std::vector<float>(texels, 0.0f)});
  }
  const std::vector<bool> written = texels_with_depth(result);
  for (std::size_t i = 0; i < texels; ++i) {
    const bool known = contents.object[i] != kNoObject;
    channels[0].values[i] = written[i] ? float(contents.depth[i]) : -1.0f;
    channels[1].values[i] = known ? float(contents.object[i]) : -1.0f;
    channels[4].values[i] = float(contents.overflowed[i]);
  }
  for_each_entry(contents, [&](std::size_t texel, std::size_t lines) {
    channels[2].values[texel] += float(lines);
    channels[3].values[texel] += 1.0f;
  });
  return encode_exr(static_cast<int>(contents.width), static_cast<int>(contents.height), channels,
                    /*half=*/false);
}

}  // namespace kagesen

#include <fmt/format.h>

#include <algorithm>

#include "sim/report/encode.h"
#include "sim/report/palette.h"
#include "sim/report/pictures.h"
#include "sim/report/table.h"

namespace kagesen {
namespace {

/// Calls visit(pixel index, fragment index) for each sample that the camera finally sees.
template <class Visit>
void for_each_visible(const Trace& trace, Visit visit) {
  const std::size_t width = trace.header.image_width;
  for (std::size_t i = 0; i < trace.all_fragments.size(); ++i) {
    const Fragment& f = trace.all_fragments[i];
    if (f.flags & Fragment::kVisible) visit(f.pixel_y * width + f.pixel_x, i);
  }
}

Light3 fragment_light(const Trace& trace, const std::vector<Verdict>& verdicts, std::size_t index) {
  const Fragment& f = trace.all_fragments[index];
  return shaded(trace.header.objects[f.object], f.object, f.shade,
                verdicts[index] == Verdict::kDark);
}

/// What the legend says, one entry a cause.
struct LegendEntry {
  std::string words;
  Rgb colour;
};

std::vector<LegendEntry> legend_entries(const ErrorFigures& figures) {
  std::vector<LegendEntry> entries;
  for (std::size_t i = 1; i < kCauseCount; ++i) {
    const auto cause = static_cast<Cause>(i);
    std::string name = cause_name(cause);
    std::replace(name.begin(), name.end(), '_', ' ');
    entries.push_back(
        {fmt::format("{} {}", name, grouped(figures.causes[i])), cause_colour(cause)});
  }
  return entries;
}

/// Lays the entries out in lines as wide as the picture; draws only when given a canvas.
int flow_legend(const std::vector<LegendEntry>& entries, int width, int scale, int top,
                Canvas* canvas) {
  const int margin = 4 * scale, line = 11 * scale;
  int x = margin, y = top;
  for (const LegendEntry& entry : entries) {
    const int wide = 10 * scale + Canvas::text_width(entry.words, scale) + 6 * scale;
    if (x > margin && x + wide > width) {
      x = margin;
      y += line;
    }
    if (canvas) {
      canvas->rectangle(x, y, 7 * scale, 7 * scale, entry.colour);
      canvas->text(x + 10 * scale, y, entry.words, {235, 235, 235}, scale);
    }
    x += wide;
  }
  return y + line;
}

}  // namespace

Canvas shaded_picture(const Trace& trace, const std::vector<Verdict>& verdicts) {
  const int width = static_cast<int>(trace.header.image_width);
  const int height = static_cast<int>(trace.header.image_height);
  Canvas picture(width, height);
  for (int y = 0; y < height; ++y) {
    picture.rectangle(0, y, width, 1, encoded(sky(double(y) / height)));
  }
  for_each_visible(trace, [&](std::size_t, std::size_t i) {
    const Fragment& f = trace.all_fragments[i];
    picture.set(f.pixel_x, f.pixel_y, encoded(fragment_light(trace, verdicts, i)));
  });
  return picture;
}

std::vector<std::uint8_t> mask_values(const Trace& trace, const std::vector<Verdict>& verdicts) {
  std::vector<std::uint8_t> mask(std::size_t(trace.header.image_width) * trace.header.image_height,
                                 128);
  for_each_visible(trace, [&](std::size_t pixel, std::size_t i) {
    mask[pixel] = verdicts[i] == Verdict::kDark ? 0 : 255;
  });
  return mask;
}

Canvas error_picture(const Trace& trace, const RunResult& result, bool legend) {
  const Canvas frame = shaded_picture(trace, result.verdicts);
  const Semantics semantics = main_semantics(result.config);
  const ErrorFigures& figures = result.judgement->figures_in(semantics);
  const std::vector<Cause>& causes = result.judgement->causes_in(semantics);
  const int width = frame.width(), height = frame.height();
  const int scale = width >= 960 ? 2 : 1;
  const auto entries = legend_entries(figures);
  const int title_height = 14 * scale;
  const int band = legend ? flow_legend(entries, width, scale, title_height, nullptr) : 0;

  Canvas picture(width, height + band, {24, 24, 28});
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const Rgb c = frame.get(x, y);
      const int grey = 20 + (c.r * 3 + c.g * 6 + c.b) / 25;
      const auto level = static_cast<std::uint8_t>(grey);
      picture.set(x, y, {level, level, level});
    }
  }
  // A halo first, so that a single wrong pixel of a large frame is seen, then the pixels
  // themselves.
  for (const bool halo : {true, false}) {
    for_each_visible(trace, [&](std::size_t, std::size_t i) {
      const Cause cause = causes[i];
      if (cause == Cause::kNone) return;
      const Fragment& f = trace.all_fragments[i];
      if (!halo) {
        picture.set(f.pixel_x, f.pixel_y, cause_colour(cause));
        return;
      }
      for (int y = std::max(0, f.pixel_y - 1); y <= std::min(height - 1, f.pixel_y + 1); ++y) {
        for (int x = f.pixel_x - 1; x <= f.pixel_x + 1; ++x) {
          picture.set(x, y, scaled(cause_colour(cause), 0.55));
        }
      }
    });
  }
  if (legend) {
    picture.text(4 * scale, height + 4 * scale,
                 fmt::format("{} of {} wrong", grouped(figures.wrong), grouped(figures.judged)),
                 {235, 235, 235}, scale);
    flow_legend(entries, width, scale, height + title_height, &picture);
  }
  return picture;
}

std::string frame_exr(const Trace& trace, const RunResult& result) {
  const int width = static_cast<int>(trace.header.image_width);
  const int height = static_cast<int>(trace.header.image_height);
  const std::size_t pixels = std::size_t(width) * height;
  std::vector<Channel> channels;
  std::vector<std::string> names{"R", "G", "B", "mask", "object"};
  if (result.judgement) {
    names.insert(names.end(), {"exact.paper", "exact.physical", "cause.paper", "cause.physical"});
  }
  for (const std::string& name : names) {
    const bool colour = channels.size() < 3;
    channels.push_back({name, std::vector<float>(pixels, colour ? 0.0f : -1.0f)});
  }
  for (int y = 0; y < height; ++y) {
    const Light3 light = sky(double(y) / height);
    std::fill_n(channels[0].values.begin() + std::ptrdiff_t(y) * width, width, light.r);
    std::fill_n(channels[1].values.begin() + std::ptrdiff_t(y) * width, width, light.g);
    std::fill_n(channels[2].values.begin() + std::ptrdiff_t(y) * width, width, light.b);
  }
  for_each_visible(trace, [&](std::size_t pixel, std::size_t i) {
    const Light3 light = fragment_light(trace, result.verdicts, i);
    channels[0].values[pixel] = light.r;
    channels[1].values[pixel] = light.g;
    channels[2].values[pixel] = light.b;
    channels[3].values[pixel] = result.verdicts[i] == Verdict::kDark ? 1.0f : 0.0f;
    channels[4].values[pixel] = float(trace.all_fragments[i].object);
    if (!result.judgement) return;
    channels[5].values[pixel] = float(result.judgement->exact_paper[i]);
    channels[6].values[pixel] = float(result.judgement->exact_physical[i]);
    channels[7].values[pixel] = float(result.judgement->cause_paper[i]);
    channels[8].values[pixel] = float(result.judgement->cause_physical[i]);
  });
  constexpr std::size_t kHalfExact = 2048;
  return encode_exr(width, height, channels, trace.header.objects.size() <= kHalfExact);
}

}  // namespace kagesen

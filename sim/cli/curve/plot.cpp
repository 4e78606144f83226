#include "sim/cli/curve/plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <string>

#include "sim/cli/curve/chart.h"

namespace kagesen {
namespace {

constexpr Rgb kPaperWhite{252, 252, 250}, kInk{40, 40, 44}, kPlain{125, 125, 125};
constexpr struct {
  const char *name, *legend;
  Rgb colour;
} kProfiles[] = {{"paper", "paper profile", {213, 94, 0}},
                 {"winding", "winding profile", {0, 114, 178}}};
constexpr int kLeft = 128, kRight = 16, kGap = 14, kRow = 1282, kHeight = 300;
constexpr int kTop = 118, kBetween = 132, kBottom = 66;

using Column = std::uint64_t CurveRow::*;

std::vector<std::uint64_t> values_of(const std::vector<CurveRow>& rows, Column column) {
  std::set<std::uint64_t> values;
  for (const CurveRow& row : rows) values.insert(row.*column);
  return {values.begin(), values.end()};
}

/// The value nearest to the default of the unit.
std::uint64_t nearest_to(std::uint64_t wanted, const std::vector<std::uint64_t>& values) {
  return *std::min_element(values.begin(), values.end(), [&](std::uint64_t a, std::uint64_t b) {
    const auto off = [&](std::uint64_t v) {
      return std::abs(std::log2(double(v) / double(wanted)));
    };
    return off(a) < off(b);
  });
}

std::string map_label(std::uint64_t side) {
  return side >= 1024 && side % 1024 == 0 ? fmt::format("{}K", side / 1024)
                                          : fmt::format("{}", side);
}

struct Lines {
  std::vector<ChartLine> lines;
  void include_in(LogRange& x, LogRange& y) const {
    for (const ChartLine& line : lines) {
      for (const ChartPoint& p : line.points) {
        x.include(p.x);
        y.include(p.y);
      }
    }
  }
};

class Plot {
 public:
  explicit Plot(const std::vector<CurveRow>& rows)
      : rows_(rows),
        scales_(values_of(rows, &CurveRow::scale)),
        bits_(values_of(rows, &CurveRow::fraction_bits)),
        maps_(values_of(rows, &CurveRow::map)),
        bits_shown_(nearest_to(8, bits_)),
        map_shown_(nearest_to(1024, maps_)),
        width_((kRow + kGap) / int(scales_.size()) - kGap),
        canvas_(kLeft + kRow + kRight, kTop + 2 * kHeight + kBetween + kBottom, kPaperWhite) {}

  Canvas picture() {
    legend();
    std::vector<Lines> above, below;
    for (const std::uint64_t scale : scales_) {
      above.push_back(through_bits(scale));
      below.push_back(through_maps(scale));
    }
    row_of_charts(
        kTop, above,
        fmt::format("Map {}, labels: bits. Wrong of those within a texel of an edge", map_shown_),
        "run time of both passes / plain map of the same side");
    row_of_charts(kTop + kHeight + kBetween, below,
                  fmt::format("{} bits, labels: map side. Wrong of all fragments", bits_shown_),
                  fmt::format("run time of both passes / plain map of side {}", map_shown_));
    return std::move(canvas_);
  }

 private:
  const CurveRow* find(const char* profile, std::uint64_t bits, std::uint64_t map,
                       std::uint64_t scale) const {
    const auto at = std::find_if(rows_.begin(), rows_.end(), [&](const CurveRow& r) {
      return r.profile == profile && r.fraction_bits == bits && r.map == map && r.scale == scale;
    });
    return at == rows_.end() ? nullptr : &*at;
  }

  Lines through_bits(std::uint64_t scale) const {
    Lines out;
    for (const auto& profile : kProfiles) {
      ChartLine line{profile.colour, {}};
      for (const std::uint64_t bits : bits_) {
        const CurveRow* row = find(profile.name, bits, map_shown_, scale);
        if (row) line.points.push_back({row->total_ratio, row->band_rate, fmt::format("{}", bits)});
      }
      out.lines.push_back(std::move(line));
    }
    return out;
  }

  /// Seconds to draw a plain map and look it up, the best of all runs beside it.
  double plain_seconds(std::uint64_t map, std::uint64_t scale) const {
    double best = std::numeric_limits<double>::infinity();
    for (const CurveRow& r : rows_) {
      if (r.map == map && r.scale == scale)
        best = std::min(best, r.plain_pass1_s + r.plain_pass2_s);
    }
    return best;
  }

  Lines through_maps(std::uint64_t scale) const {
    const double unit = plain_seconds(map_shown_, scale);
    Lines out;
    ChartLine plain{kPlain, {}};
    for (const auto& profile : kProfiles) {
      ChartLine line{profile.colour, {}};
      for (const std::uint64_t map : maps_) {
        const CurveRow* row = find(profile.name, bits_shown_, map, scale);
        if (!row || row->judged == 0) continue;
        const double judged = double(row->judged);
        line.points.push_back(
            {(row->pass1_s + row->pass2_s) / unit, double(row->wrong) / judged, map_label(map)});
        if (&profile != &kProfiles[0]) continue;
        plain.points.push_back({plain_seconds(map, scale) / unit,
                                double(row->plain_same_side_wrong) / judged, map_label(map)});
      }
      out.lines.push_back(std::move(line));
    }
    out.lines.push_back(std::move(plain));
    return out;
  }

  void row_of_charts(int top, const std::vector<Lines>& columns, const std::string& title,
                     const std::string& along_x) {
    LogRange x, y;
    for (const Lines& lines : columns) lines.include_in(x, y);
    canvas_.text(kLeft, top - 52, title, kInk, 2);
    for (std::size_t i = 0; i < columns.size(); ++i) {
      const int left = kLeft + int(i) * (width_ + kGap);
      canvas_.text(left, top - 24, fmt::format("scale {}", scales_[i]), kInk, 2);
      const Chart chart(canvas_, {left, top, width_, kHeight}, x, y);
      chart.draw_axes(i == 0);
      chart.draw_lines(columns[i].lines);
    }
    canvas_.text(kLeft, top + kHeight + 34, along_x, kInk, 2);
  }

  void legend() {
    int x = kLeft;
    const auto entry = [&](const std::string& words, Rgb colour) {
      draw_stroke(canvas_, x, 30, x + 34, 30, 2.4, colour);
      draw_dot(canvas_, x + 17, 30, 5, colour);
      canvas_.text(x + 46, 23, words, kInk, 2);
      x += 46 + Canvas::text_width(words, 2) + 36;
    };
    for (const auto& profile : kProfiles) entry(profile.legend, profile.colour);
    entry("plain map", kPlain);
    const std::string name = "scene: " + rows_.front().scene;
    canvas_.text(x, 23, name, kInk, 2);
  }

  const std::vector<CurveRow>& rows_;
  std::vector<std::uint64_t> scales_, bits_, maps_;
  std::uint64_t bits_shown_, map_shown_;
  int width_;  ///< of a chart
  Canvas canvas_;
};

}  // namespace

Canvas curve_plot(const std::vector<CurveRow>& rows) { return Plot(rows).picture(); }

}  // namespace kagesen

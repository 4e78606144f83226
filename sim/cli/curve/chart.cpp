#include "sim/cli/curve/chart.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace kagesen {
namespace {

constexpr Rgb kInk{40, 40, 44}, kGrid{226, 226, 222}, kFrame{150, 150, 148};
constexpr int kTextScale = 2, kTextHeight = 7 * kTextScale;
constexpr int kZeroGap = 40;  // pixels between the axis and the line of zeros
constexpr double kDotRadius = 5;

int text_width(const std::string& words) {
  return Canvas::text_width(words, kTextScale) - kTextScale;
}

/// Round numbers in the range, more of them in a narrow one.
std::vector<double> round_numbers(const LogRange& range) {
  const bool narrow = range.high < 6 * range.low;
  std::vector<double> out;
  for (int power = -9; power <= 9; ++power) {
    for (const double digit : {1.0, 1.5, 2.0, 3.0, 5.0}) {
      if (!narrow && (digit == 1.5 || digit == 3)) continue;
      const double v = digit * std::pow(10.0, power);
      if (v > range.low * 0.999 && v < range.high * 1.001) out.push_back(v);
    }
  }
  return out;
}

struct Rectangle {
  double x0, y0, x1, y1;
  bool meets(const Rectangle& r) const { return x0 < r.x1 && r.x0 < x1 && y0 < r.y1 && r.y0 < y1; }
};

}  // namespace

void LogRange::include(double value) {
  if (!(value > 0)) return;
  low = empty ? value : std::min(low, value);
  high = empty ? value : std::max(high, value);
  empty = false;
}

void draw_stroke(Canvas& canvas, double x0, double y0, double x1, double y1, double width,
                 Rgb colour) {
  const double reach = width / 2 + 1, dx = x1 - x0, dy = y1 - y0;
  const double length_squared = std::max(dx * dx + dy * dy, 1e-9);
  const int left = std::max(int(std::min(x0, x1) - reach), 0);
  const int right = std::min(int(std::max(x0, x1) + reach), canvas.width() - 1);
  const int top = std::max(int(std::min(y0, y1) - reach), 0);
  const int bottom = std::min(int(std::max(y0, y1) + reach), canvas.height() - 1);
  for (int y = top; y <= bottom; ++y) {
    for (int x = left; x <= right; ++x) {
      const double t = std::clamp(((x - x0) * dx + (y - y0) * dy) / length_squared, 0.0, 1.0);
      const double distance = std::hypot(x - x0 - t * dx, y - y0 - t * dy);
      const double cover = std::clamp(width / 2 + 0.5 - distance, 0.0, 1.0);
      if (cover > 0) canvas.set(x, y, mix(canvas.get(x, y), colour, cover));
    }
  }
}

void draw_dot(Canvas& canvas, double x, double y, double radius, Rgb colour) {
  draw_stroke(canvas, x, y, x, y, 2 * radius, colour);
}

Chart::Chart(Canvas& canvas, Area area, LogRange x, LogRange y)
    : canvas_(canvas), area_(area), x_(x), y_(y) {
  // A margin and at least a factor of 4 along x, so that noise stays small; from a whole decade up
  // and at least two of them along y.
  const double widen = std::max(1.15, std::sqrt(4 * x_.low / x_.high));
  x_.low /= widen;
  x_.high *= widen;
  y_.low = std::pow(10.0, std::floor(std::log10(y_.low)));
  y_.high = std::max(y_.high * 1.6, y_.low * 100);
}

Chart::Place Chart::place(const ChartPoint& p) const {
  const auto share = [](double v, const LogRange& r) {
    return std::log(v / r.low) / std::log(r.high / r.low);
  };
  const double bottom = area_.y + area_.height - kZeroGap;
  const double x = area_.x + share(p.x, x_) * area_.width;
  if (!(p.y > 0)) return {x, bottom + kZeroGap / 2.0};
  return {x, bottom - share(p.y, y_) * (bottom - area_.y)};
}

void Chart::draw_axes(bool with_y_numbers) const {
  const int bottom = area_.y + area_.height;
  const auto number_left = [&](const std::string& words, int y) {
    if (!with_y_numbers) return;
    canvas_.text(area_.x - text_width(words) - 10, y - kTextHeight / 2, words, kInk, kTextScale);
  };
  for (double v = y_.low; v < y_.high * 1.001; v *= 10) {
    const int y = int(place({x_.low, v, {}}).y);
    canvas_.rectangle(area_.x, y, area_.width, 1, kGrid);
    const int decimals = std::max(0, -int(std::lround(std::log10(v * 100))));
    number_left(fmt::format("{:.{}f}%", v * 100, decimals), y);
  }
  number_left("none", int(place({x_.low, 0, {}}).y));
  int taken = area_.x - 6;  // numbers keep clear of each other and of the next chart's
  for (const double v : round_numbers(x_)) {
    const int x = int(place({v, 0, {}}).x);
    canvas_.rectangle(x, area_.y, 1, area_.height, kGrid);
    const std::string words = fmt::format("{:g}", v);
    const int half = text_width(words) / 2;
    if (x - half < taken || x + half > area_.x + area_.width + 6) continue;
    canvas_.text(x - half, bottom + 8, words, kInk, kTextScale);
    taken = x + half + 12;
  }
  canvas_.rectangle(area_.x, bottom - kZeroGap, area_.width, 1, kFrame);
  canvas_.rectangle(area_.x, area_.y, area_.width, 1, kFrame);
  canvas_.rectangle(area_.x, bottom, area_.width + 1, 1, kFrame);
  canvas_.rectangle(area_.x, area_.y, 1, area_.height, kFrame);
  canvas_.rectangle(area_.x + area_.width, area_.y, 1, area_.height, kFrame);
}

void Chart::draw_lines(const std::vector<ChartLine>& lines) const {
  for (const ChartLine& line : lines) {
    for (std::size_t i = 1; i < line.points.size(); ++i) {
      const Place a = place(line.points[i - 1]), b = place(line.points[i]);
      draw_stroke(canvas_, a.x, a.y, b.x, b.y, 2.4, line.colour);
    }
  }
  for (const ChartLine& line : lines) {
    for (const ChartPoint& point : line.points) {
      const Place p = place(point);
      draw_dot(canvas_, p.x, p.y, kDotRadius + 1.2, {255, 255, 255});
      draw_dot(canvas_, p.x, p.y, kDotRadius, line.colour);
    }
  }
  draw_labels(lines);
}

void Chart::draw_labels(const std::vector<ChartLine>& lines) const {
  std::vector<Rectangle> taken;
  for (const ChartLine& line : lines) {
    for (std::size_t i = 0; i < line.points.size(); ++i) {
      const Place p = place(line.points[i]);
      taken.push_back({p.x - kDotRadius, p.y - kDotRadius, p.x + kDotRadius, p.y + kDotRadius});
      if (i == 0) continue;
      // A line's way, as a string of small boxes.
      const Place from = place(line.points[i - 1]);
      const int steps = int(std::hypot(p.x - from.x, p.y - from.y) / 3) + 1;
      for (int s = 0; s < steps; ++s) {
        const double x = from.x + (p.x - from.x) * s / steps;
        const double y = from.y + (p.y - from.y) * s / steps;
        taken.push_back({x - 1, y - 1, x + 1, y + 1});
      }
    }
  }
  const auto try_label = [&](const ChartLine& line, const ChartPoint& point) {
    const Place p = place(point);
    const double width = text_width(point.label), gap = kDotRadius + 4;
    const double middle_x = p.x - width / 2, middle_y = p.y - kTextHeight / 2.0;
    const double low = p.y + gap, high = p.y - gap - kTextHeight;
    const double right = p.x + gap, left = p.x - gap - width;
    const Place choices[] = {{right, middle_y}, {left, middle_y}, {middle_x, high}, {middle_x, low},
                             {right, high},     {left, high},     {right, low},     {left, low}};
    for (const Place& c : choices) {
      const Rectangle box{c.x - 1, c.y - 1, c.x + width + 1, c.y + kTextHeight + 1};
      const bool within = box.x0 > area_.x + 1 && box.x1 < area_.x + area_.width &&
                          box.y0 > area_.y + 1 && box.y1 < area_.y + area_.height;
      const bool free = std::none_of(taken.begin(), taken.end(),
                                     [&](const Rectangle& r) { return r.meets(box); });
      if (!within || !free) continue;
      canvas_.text(int(c.x), int(c.y), point.label, scaled(line.colour, 0.8), kTextScale);
      taken.push_back(box);
      return;
    }
  };
  // The ends of a line say which way it runs, so they choose first.
  for (const bool ends : {true, false}) {
    for (const ChartLine& line : lines) {
      for (const ChartPoint& point : line.points) {
        const bool end = &point == &line.points.front() || &point == &line.points.back();
        if (end == ends) try_label(line, point);
      }
    }
  }
}

}  // namespace kagesen

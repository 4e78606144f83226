#pragma once
/// A small chart on logarithmic axes: lines through labelled points.
#include <string>
#include <vector>

#include "sim/report/canvas.h"

namespace kagesen {

struct ChartPoint {
  double x = 0, y = 0;  ///< x above 0; a y of 0 has its own line below the axis
  std::string label;
};
struct ChartLine {
  Rgb colour;
  std::vector<ChartPoint> points;
};

/// Both ends above 0.
struct LogRange {
  double low = 1, high = 1;
  bool empty = true;
  void include(double value);
};

class Chart {
 public:
  struct Area {
    int x, y, width, height;  ///< pixels, without the numbers beside it
  };
  /// @param x, y  what to show; they grow to round numbers. Lines of charts of equal ranges and
  ///              areas can be compared.
  Chart(Canvas& canvas, Area area, LogRange x, LogRange y);

  /// The grid with its numbers. Percentages along y; those only where `with_y_numbers`.
  void draw_axes(bool with_y_numbers) const;
  /// Lines, then points, then each label where it hides nothing; one that fits nowhere is left out.
  void draw_lines(const std::vector<ChartLine>& lines) const;

 private:
  struct Place {
    double x, y;
  };
  Place place(const ChartPoint& p) const;
  void draw_labels(const std::vector<ChartLine>& lines) const;

  Canvas& canvas_;
  Area area_;
  LogRange x_, y_;
};

/// A line and a filled circle with smooth edges; pixels.
void draw_stroke(Canvas& canvas, double x0, double y0, double x1, double y1, double width,
                 Rgb colour);
void draw_dot(Canvas& canvas, double x, double y, double radius, Rgb colour);

}  // namespace kagesen

#pragma once
/// Span filler: the texels strictly between a polygon's outlines, and its depth there (3.3.3).
#include <array>
#include <cstdint>
#include <vector>

#include "model/unit/fixed.h"
#include "traces/format/records.h"

namespace kagesen::unit {

/// A polygon's plane and inside test, in exact integers.
class Polygon {
 public:
  /// @param bits  log2 of a texel's units
  Polygon(const Caster& caster, int bits);
  /// Zero area after snapping: covers nothing, draws nothing.
  bool degenerate() const { return twice_area_ == 0; }
  /// Does the inside hold the texel's corner (least x, least y), moved by (+e^2, +e)?
  bool covers_corner(std::int32_t texel_x, std::int32_t texel_y) const;
  /// floor of the plane's depth at the texel's centre, clamped to the polygon's own range.
  std::uint32_t centre_depth(std::int32_t texel_x, std::int32_t texel_y) const;
  /// centre_depth along a row, one addition a texel; exact like it, without the clamp.
  ExactRamp centre_ramp(std::int32_t texel_x, std::int32_t texel_y) const;
  /// An upper bound of the plane's depth within a texel, given its centre's: |gradient| / 2 an
  /// axis, up.
  std::uint32_t farthest(std::uint32_t centre) const;
  std::uint32_t clamp(std::int64_t depth) const;

  // The plane's depth as fractions of twice the area: per unit, and at a texel's centre less the
  // first vertex's.
  std::uint32_t first_depth() const { return v_[0].z; }
  std::int64_t twice_area() const { return twice_area_; }
  std::int64_t gradient_x() const { return planed().gradient_x_; }
  std::int64_t gradient_y() const { return planed().gradient_y_; }
  Int128 depth_numerator(std::int32_t texel_x, std::int32_t texel_y) const;

 private:
  const Polygon& planed() const {
    if (!plane_ready_) make_plane();
    return *this;
  }
  void make_plane() const;

  LightPoint v_[3];  // counter-clockwise
  int bits_;
  std::int64_t twice_area_;
  std::uint32_t least_, most_;
  mutable bool plane_ready_ = false;
  mutable std::int64_t gradient_x_ = 0, gradient_y_ = 0;  // times twice_area_, depth a unit
  mutable std::uint32_t half_texel_rise_ = 0;
};

/// The texels a polygon's outlines visit, a row at a time: one interval an edge.
class VisitedRows {
 public:
  void begin(std::int32_t first_row, std::int32_t last_row);
  void visit(int edge, std::int32_t x, std::int32_t y) {
    Row& row = rows_[static_cast<std::size_t>(y - first_row_)];
    if (x < row.low[edge]) row.low[edge] = x;
    if (x > row.high[edge]) row.high[edge] = x;
  }
  /// Did one of `edges` (bit i: edge i) visit the texel?
  bool visited(unsigned edges, std::int32_t x, std::int32_t y) const {
    const Row& row = rows_[static_cast<std::size_t>(y - first_row_)];
    for (int e = 0; e < 3; ++e) {
      if ((edges >> e & 1) != 0 && row.low[e] <= x && x <= row.high[e]) return true;
    }
    return false;
  }
  /// Calls fill(y, first_x, last_x) for every run of texels strictly between visited ones of a row.
  template <typename Fill>
  void gaps(Fill fill) const;

 private:
  struct Row {
    std::array<std::int32_t, 3> low, high;  // low > high: edge not in this row
  };
  std::int32_t first_row_ = 0;
  std::size_t count_ = 0;
  std::vector<Row> rows_;
};

template <typename Fill>
void VisitedRows::gaps(Fill fill) const {
  for (std::size_t i = 0; i < count_; ++i) {
    Row row = rows_[i];
    const auto order = [&row](int a, int b) {
      if (row.low[a] > row.low[b]) {
        std::swap(row.low[a], row.low[b]);
        std::swap(row.high[a], row.high[b]);
      }
    };
    order(0, 1);
    order(1, 2);
    order(0, 1);
    std::int32_t reached = row.high[0];
    for (int e = 1; e < 3 && row.low[e] <= row.high[e]; ++e) {
      if (row.low[e] > reached + 1) {
        fill(first_row_ + static_cast<std::int32_t>(i), reached + 1, row.low[e] - 1);
      }
      if (row.high[e] > reached) reached = row.high[e];
    }
  }
}

}  // namespace kagesen::unit

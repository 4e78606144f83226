#pragma once
/// Shadow decision: is a point of a texel inside what an entry's lines outline? (4.2, Tables 5 to
/// 7)
#include <cstdint>

#include "model/unit/config.h"
#include "model/unit/line.h"

namespace kagesen::unit {

/// The fraction of a fragment's position, 0 <= x, y < 2^bits.
struct SubTexel {
  std::int64_t x = 0, y = 0;  ///< Mx, My, UQ0.bits texel
  int bits = 0;               ///< at least fraction_bits
};

/// How two lines of an entry combine (Table 7, 4.2.1).
enum class Combine : std::uint8_t { kAnd, kOr };

class ShadowDecision {
 public:
  ShadowDecision() = default;
  explicit ShadowDecision(const UnitConfig& config)
      : fraction_bits_(static_cast<int>(config.fraction_bits)),
        slope_bits_(static_cast<int>(config.slope_bits)),
        vertex_rule_(config.vertex_rule),
        table7_(config.table7) {}

  /// Table 5 without its division: minor - Fraction - Slope * (major - Cross), exact, in units of
  /// 2^-(point.bits + slope_bits) texel; major and minor run with the direction of travel.
  std::int64_t offset(const Line& line, const SubTexel& point) const {
    const std::int64_t one = std::int64_t{1} << point.bits;
    const std::int64_t u = line.has(Line::kXPositive) ? point.x : one - point.x;
    const bool x_major = line.has(Line::kXMajor);
    const std::int64_t major = x_major ? u : point.y;
    const std::int64_t minor = x_major ? point.y : u;
    const std::int64_t along = line.has(Line::kCross) ? major - one : major;
    return (minor << slope_bits_) -
           (std::int64_t{line.fraction} << (point.bits + slope_bits_ - fraction_bits_)) -
           line.slope * along;
  }

  /// Tables 5 and 6: does the line's own half plane hold the point?
  bool contains(const Line& line, const SubTexel& point) const {
    const std::int64_t d = offset(line, point);
    // Mx < x: the point lies left of the line.
    const bool above_is_left = line.has(Line::kXMajor) == line.has(Line::kXPositive);
    const bool left_of_line = above_is_left ? d > 0 : d < 0;
    return line.has(Line::kLeft) != left_of_line;
  }

  /// How a and b combine; `vertex` is the entry's Vertex Flag, which counts only as printed.
  /// Symmetric but for Table 7 as printed.
  Combine combine(const Line& a, const Line& b, bool vertex) const;

  /// Inside iff some line holds the point and every line that it is ANDed with does too.
  bool inside(const Line* lines, std::uint32_t count, bool vertex, const SubTexel& point) const {
    if (count == 1) return contains(lines[0], point);
    return inside_of_many(lines, count, vertex, point);
  }

 private:
  bool inside_of_many(const Line* lines, std::uint32_t count, bool vertex,
                      const SubTexel& point) const;
  Combine by_table7(const Line& a, const Line& b) const;
  Combine by_table7_printed(const Line& a, const Line& b) const;
  Combine by_fractions(const Line& a, const Line& b) const;
  bool holds_fraction_of(const Line& line, const Line& other) const;
  std::uint32_t angle(const Line& line) const;

  int fraction_bits_ = 8, slope_bits_ = 8;
  VertexRule vertex_rule_ = VertexRule::kPerLine;
  Table7 table7_ = Table7::kCorrected;
};

}  // namespace kagesen::unit

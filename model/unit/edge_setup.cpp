#include "model/unit/edge_setup.h"

#include <utility>

namespace kagesen::unit {
namespace {

struct Axis {
  std::int64_t from, to;  // units, from <= to
  std::int32_t first(int bits) const { return static_cast<std::int32_t>(from >> bits); }
  /// An end on a border belongs to the texel before it; on an axis without extent to the one after.
  std::int32_t last(int bits) const {
    return static_cast<std::int32_t>(to > from ? ((to + (std::int64_t{1} << bits) - 1) >> bits) - 1
                                               : to >> bits);
  }
  std::int64_t extent() const { return to - from; }
};

}  // namespace

EdgeSetup setup_edge(const LightPoint& a, const LightPoint& b, const LightPoint& opposite,
                     int texel_bits, int slope_bits) {
  const bool swap = b.y < a.y || (b.y == a.y && b.x < a.x);
  const LightPoint& from = swap ? b : a;
  const LightPoint& to = swap ? a : b;
  const std::int64_t dx = std::int64_t{to.x} - from.x, dy = std::int64_t{to.y} - from.y;

  EdgeSetup edge;
  edge.x_positive = dx >= 0;
  const Axis u =
      edge.x_positive ? Axis{from.x, to.x} : Axis{-std::int64_t{from.x}, -std::int64_t{to.x}};
  const Axis y{from.y, to.y};
  edge.x_major = u.extent() > y.extent();
  const Axis& major = edge.x_major ? u : y;
  const Axis& minor = edge.x_major ? y : u;

  const std::int64_t turn =
      dx * (std::int64_t{opposite.y} - from.y) - dy * (std::int64_t{opposite.x} - from.x);
  edge.left = turn < 0;
  edge.first_major = major.first(texel_bits);
  edge.last_major = major.last(texel_bits);
  edge.first_minor = minor.first(texel_bits);
  edge.last_minor = minor.last(texel_bits);

  const std::int64_t length = major.extent();
  const std::int64_t rise = minor.extent();
  const std::int64_t texel = std::int64_t{1} << texel_bits;
  edge.slope = static_cast<std::uint32_t>(((rise << (slope_bits + 1)) + length) / (2 * length));
  if (edge.slope >> slope_bits) edge.slope = (1u << slope_bits) - 1;

  const std::int64_t into_major = major.from - edge.first_major * texel;
  const std::int64_t into_minor = minor.from - edge.first_minor * texel;
  edge.minor = ExactRamp::make(into_minor, -rise * into_major, rise * texel, length);

  const std::int64_t dz = std::int64_t{to.z} - from.z;
  edge.first_depth = from.z;
  edge.last_depth = to.z;
  edge.major_depth = ExactRamp::make(from.z, dz * (texel - into_major), dz * texel, length);
  edge.minor_moves = rise > 0;
  if (edge.minor_moves) {
    edge.minor_depth = ExactRamp::make(from.z, dz * (texel - into_minor), dz * texel, rise);
  }
  return edge;
}

}  // namespace kagesen::unit

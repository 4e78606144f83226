#include "model/rivals/plain_map.h"

#include "model/reference/triangle.h"
#include "model/rivals/row_span.h"

namespace kagesen {
namespace {

/// No caster reaches a sample outside the range of coordinates.
bool in_range(std::int64_t v) { return v >= kCoordinateMin && v <= kCoordinateMax; }

/// Cuts [low, high] to the x of row y that lie on the inner side of the edge from a to b.
/// `orientation` is 1 if that side is the one of positive edge functions, else -1.
void cut_row(const LightPoint& a, const LightPoint& b, std::int64_t orientation, std::int64_t y,
             std::int64_t& low, std::int64_t& high) {
  const std::int64_t slope = -orientation * (std::int64_t{b.y} - a.y);  // slope x + constant >= 0
  const std::int64_t constant = orientation * (std::int64_t{b.x} - a.x) * (y - a.y) - slope * a.x;
  cut_span(slope, constant, low, high);
}

}  // namespace

std::int64_t PlainAxis::first_from(std::int64_t v) const {
  // The sample lies within its texel, so the answer is the texel of v or the one after it.
  if (v <= origin_) return 0;
  if (v - origin_ >= extent_) return side_;
  const std::int64_t guess = (v - origin_) * side_ / extent_;
  return sample(guess) >= v ? guess : guess + 1;
}

PlainMap::PlainMap(std::uint32_t width, std::uint32_t height, std::uint32_t map_width,
                   std::uint32_t map_height, std::uint32_t fraction_bits)
    : texels_(std::size_t{width} * height, Texel{kDepthMax, DepthSample{}.object}),
      x_(width, map_width, fraction_bits),
      y_(height, map_height, fraction_bits),
      columns_(width) {
  for (std::uint32_t i = 0; i < width; ++i) {
    columns_[i] = std::int32_t(std::clamp<std::int64_t>(x_.sample(i), INT32_MIN, INT32_MAX));
  }
}

void PlainMap::draw(const Caster& caster) {
  const std::int64_t area = doubled_area(caster);
  if (area == 0) return;
  const std::int64_t orientation = area > 0 ? 1 : -1;
  const LightPoint* v = caster.vertex;
  const Box box = bounding_box(caster);
  const std::int64_t last_row = y_.first_from(std::int64_t{box.y1} + 1);
  for (std::int64_t row = y_.first_from(box.y0); row < last_row; ++row) {
    const std::int64_t y = y_.sample(row);
    std::int64_t low = box.x0, high = box.x1;
    for (int i = 0; i < 3; ++i) cut_row(v[i], v[(i + 1) % 3], orientation, y, low, high);
    if (low > high) continue;
    const std::int64_t last = x_.first_from(high + 1);
    for (std::int64_t column = x_.first_from(low); column < last; ++column) {
      const Weights w = weights_at(caster, columns_[std::size_t(column)], std::int32_t(y));
      const std::uint32_t depth = floor_depth(caster, w);
      Texel& texel = texels_[std::size_t(row * x_.side() + column)];
      // At kDepthMax an empty texel stays empty: nothing lies behind it.
      if (depth < texel.depth) texel = {depth, caster.object};
    }
  }
}

DepthSample plain_map_sample(const ExactReference& reference, const Fragment& f, std::uint64_t side,
                             std::uint32_t map_width, std::uint32_t map_height,
                             std::uint32_t fraction_bits) {
  const PlainAxis x_axis(side, map_width, fraction_bits), y_axis(side, map_height, fraction_bits);
  const std::int64_t x = x_axis.sample(x_axis.texel(f.position.x));
  const std::int64_t y = y_axis.sample(y_axis.texel(f.position.y));
  if (!in_range(x) || !in_range(y)) return {};
  return reference.nearest(std::int32_t(x), std::int32_t(y));
}

Verdict plain_map_verdict(const ExactReference& reference, const Fragment& f, Semantics semantics,
                          std::uint64_t side, std::uint32_t map_width, std::uint32_t map_height,
                          std::uint32_t fraction_bits) {
  return PlainMap::decide(
      plain_map_sample(reference, f, side, map_width, map_height, fraction_bits), f, semantics);
}

}  // namespace kagesen

#include "model/rivals/conservative_map.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "model/reference/triangle.h"
#include "model/rivals/row_span.h"

namespace kagesen {
namespace {

/// Smallest r with r * r >= n. n below 2^112.
std::int64_t root_rounded_up(Int128 n) {
  auto r = static_cast<std::int64_t>(std::sqrt(static_cast<double>(n)));
  while (r > 0 && Int128{r - 1} * (r - 1) >= n) --r;
  while (Int128{r} * r < n) ++r;
  return r;
}

/// An edge's half-plane in half units (X = 2 x, Y = 2 y, so that centres of texels are integers):
/// twice its edge function, along_x * X + along_y * Y + constant, is at least 0 inside. 61 bits.
struct HalfPlane {
  /// @param keep_off  units; the half-plane's border is moved inwards by keep_off / sqrt(2)
  HalfPlane(const LightPoint& a, const LightPoint& b, bool positive, std::int64_t keep_off) {
    const std::int64_t dx = std::int64_t{b.x} - a.x, dy = std::int64_t{b.y} - a.y;
    along_x = positive ? -dy : dy;
    along_y = positive ? dx : -dx;
    constant = -2 * (along_x * a.x + along_y * a.y);
    // An edge function is the distance times the edge's length; it is doubled here.
    const Int128 length_squared = Int128{dx} * dx + Int128{dy} * dy;
    constant -= root_rounded_up(2 * length_squared * keep_off * keep_off);
  }
  std::int64_t along_x, along_y, constant;
};

/// ceil(v / 2^shift)
std::int64_t shift_up(std::int64_t v, std::uint32_t shift) { return -(-v >> shift); }

/// Depth of the plane, rounded up, from the caster with its depths mirrored. Exact.
std::uint32_t depth_rounded_up(const Caster& mirrored, std::int32_t x, std::int32_t y) {
  return kDepthMax - floor_depth(mirrored, weights_at(mirrored, x, y));
}

}  // namespace

ConservativeMap::ConservativeMap(std::uint32_t width, std::uint32_t height,
                                 std::uint32_t fraction_bits, CoverageTest test)
    : width_(width),
      height_(height),
      fraction_bits_(fraction_bits),
      test_(test),
      texels_(std::size_t{width} * height) {}

void ConservativeMap::draw(const Caster& caster) {
  const std::int64_t area = doubled_area(caster);
  if (area == 0) return;
  const std::int64_t texel = std::int64_t{1} << fraction_bits_;
  const std::int64_t left = width_ / 2, above = height_ / 2;
  const Box box = bounding_box(caster);
  // Texels whose two borders lie within the box.
  const std::int64_t first_row =
      std::max(shift_up(box.y0, fraction_bits_) + above, std::int64_t{0});
  const std::int64_t end_row = std::min((box.y1 >> fraction_bits_) + above, std::int64_t{height_});
  if (first_row >= end_row) return;

  const LightPoint* v = caster.vertex;
  const bool corners = test_ == CoverageTest::kCorners;
  const std::int64_t keep_off = corners ? 0 : texel;
  const HalfPlane edges[] = {{v[0], v[1], area > 0, keep_off},
                             {v[1], v[2], area > 0, keep_off},
                             {v[2], v[0], area > 0, keep_off}};
  Caster mirrored = caster;
  for (LightPoint& p : mirrored.vertex) p.z = kDepthMax - p.z;
  // Signed area times the change of depth along x and y: 57 bits.
  std::int64_t slope_x = 0, slope_y = 0;
  for (int i = 0; i < 3; ++i) {
    const LightPoint &a = v[(i + 1) % 3], &b = v[(i + 2) % 3];
    slope_x += (std::int64_t{a.y} - b.y) * v[i].z;
    slope_y += (std::int64_t{b.x} - a.x) * v[i].z;
  }
  const std::int64_t far_x = (slope_x > 0) == (area > 0) ? texel : 0;
  const std::int64_t far_y = (slope_y > 0) == (area > 0) ? texel : 0;

  // Half units from a texel's corner to the samples that its edges on either side must contain.
  const std::int64_t low_sample = corners ? 0 : texel, high_sample = corners ? 2 * texel : texel;
  for (std::int64_t row = first_row; row < end_row; ++row) {
    const std::int64_t y = (row - above) * texel;
    std::int64_t low = 2 * std::int64_t{box.x0}, high = 2 * std::int64_t{box.x1};
    for (const HalfPlane& e : edges) {
      const std::int64_t worst = 2 * y + (e.along_y > 0 ? low_sample : high_sample);
      cut_span(e.along_x, e.along_y * worst + e.constant, low, high);
    }
    const std::int64_t first = shift_up(low - low_sample, fraction_bits_ + 1) + left;
    const std::int64_t last = ((high - high_sample) >> (fraction_bits_ + 1)) + left;
    for (std::int64_t column = std::max(first, std::int64_t{0});
         column <= std::min(last, std::int64_t{width_} - 1); ++column) {
      const std::int64_t x = (column - left) * texel;
      const std::uint32_t depth =
          depth_rounded_up(mirrored, std::int32_t(x + far_x), std::int32_t(y + far_y));
      Texel& t = texels_[std::size_t(row) * width_ + std::size_t(column)];
      if (depth < t.depth || (depth == t.depth && caster.object < t.object)) {
        t = {depth, caster.object};
      }
    }
  }
}

bool ConservativeMap::surely_dark(const Fragment& f, Semantics semantics) const {
  if (f.flags & (Fragment::kAverted | Fragment::kOutside)) return false;
  const std::int64_t column = (f.position.x >> fraction_bits_) + std::int64_t{width_ / 2};
  const std::int64_t row = (f.position.y >> fraction_bits_) + std::int64_t{height_ / 2};
  if (column < 0 || row < 0 || column >= width_ || row >= height_) return false;
  const Texel& t = at(std::uint32_t(column), std::uint32_t(row));
  return f.position.z > t.depth && (semantics == Semantics::kPhysical || t.object != f.object);
}

std::uint64_t ConservativeMap::covered_texels() const {
  return std::uint64_t(std::count_if(texels_.begin(), texels_.end(),
                                     [](const Texel& t) { return t.object != Texel{}.object; }));
}

namespace {

ReductionRate measure(const Trace& trace, const UnitConfig& config, Semantics semantics,
                      CoverageTest test) {
  using Clock = std::chrono::steady_clock;
  ReductionRate out;
  for (int run = 0; run < 3; ++run) {
    const Clock::time_point start = Clock::now();
    ConservativeMap map(std::uint32_t(config.map_width), std::uint32_t(config.map_height),
                        trace.header.fraction_bits, test);
    for (const Caster& c : trace.all_casters) map.draw(c);
    const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
    out.generation_s = run == 0 ? seconds : std::min(out.generation_s, seconds);
    if (run > 0) continue;
    out.texels = map.covered_texels();
    for (const Fragment& f : trace.all_fragments) out.decided += map.surely_dark(f, semantics);
  }
  return out;
}

}  // namespace

ReductionRates reduction_rates(const Trace& trace, const UnitConfig& config, Semantics semantics) {
  ReductionRates out;
  const std::uint32_t bits = trace.header.fraction_bits;
  for (const Fragment& f : trace.all_fragments) {
    const std::int64_t column = (f.position.x >> bits) + config.map_width / 2;
    const std::int64_t row = (f.position.y >> bits) + config.map_height / 2;
    const bool on_map =
        column >= 0 && row >= 0 && column < config.map_width && row < config.map_height;
    out.judged += on_map && (f.flags & (Fragment::kAverted | Fragment::kOutside)) == 0;
  }
  out.corners = measure(trace, config, semantics, CoverageTest::kCorners);
  out.circle = measure(trace, config, semantics, CoverageTest::kCircle);
  return out;
}

}  // namespace kagesen

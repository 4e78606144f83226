#include "tests/stress/fragments.h"

#include <algorithm>
#include <cmath>

#include "model/reference/contact.h"
#include "model/reference/triangle.h"
#include "tests/stress/builder.h"

namespace kagesen::stress {
namespace {

constexpr std::uint32_t kImageWidth = 64;

Point wide(const LightPoint& p) { return {p.x, p.y, p.z}; }

class Placer {
 public:
  Placer(const Trace& trace, const UnitConfig& config, Dice& dice)
      : trace_(trace), config_(config), dice_(dice), bits_(trace.header.fraction_bits) {}

  Fragment fragment() {
    const std::vector<Caster>& casters = trace_.all_casters;
    const Caster* caster = casters.empty() ? nullptr : &casters[dice_.index(casters)];
    Point p = caster ? spot(*caster) : anywhere();
    // What lies off the map is decided by definition: a few are enough.
    for (int tries = 0; tries < 8 && caster && !on_map(p); ++tries) {
      caster = &casters[dice_.index(casters)];
      p = spot(*caster);
    }
    if (!on_map(p) && !dice_.one_in(20)) p = anywhere();
    Fragment f;
    f.position.x = coordinate(p.x);
    f.position.y = coordinate(p.y);
    f.position.z = depth(caster, f.position);
    f.object = object(caster);
    f.flags = Fragment::kVisible;
    if (dice_.one_in(100)) f.flags |= dice_.one_in(2) ? Fragment::kAverted : Fragment::kOutside;
    return f;
  }

 private:
  std::int64_t texel() const { return std::int64_t{1} << bits_; }
  static std::int32_t coordinate(std::int64_t v) {
    return static_cast<std::int32_t>(std::clamp<std::int64_t>(v, kCoordinateMin, kCoordinateMax));
  }
  bool on_map(Point p) const {
    const std::int64_t x = (p.x >> bits_) + trace_.header.map_width / 2;
    const std::int64_t y = (p.y >> bits_) + trace_.header.map_height / 2;
    return x >= 0 && y >= 0 && x < trace_.header.map_width && y < trace_.header.map_height;
  }

  Point anywhere() {
    const std::int64_t w = trace_.header.map_width, h = trace_.header.map_height;
    return {dice_.in(-(w / 2) * texel(), (w - w / 2) * texel() - 1),
            dice_.in(-(h / 2) * texel(), (h - h / 2) * texel() - 1), 0};
  }

  /// A step to one side: none, a few units, about the contract's radius, or about a texel's part.
  std::int64_t step() {
    const std::int64_t radius = texel() >> config_.fraction_bits;
    switch (dice_.in(0, 5)) {
      case 0:
      case 1:
        return 0;
      case 2:
        return dice_.in(-3, 3);
      case 3:
        return dice_.either(radius) + dice_.in(-2, 2);
      case 4:
        return dice_.in(-2 * radius, 2 * radius);
      default:
        return dice_.in(-texel() / 4, texel() / 4);
    }
  }

  /// Somewhere that has to do with this caster.
  Point spot(const Caster& c) {
    const auto corner = dice_.in(0, 2);
    const Point a = wide(c.vertex[corner]), b = wide(c.vertex[(corner + 1) % 3]),
                o = wide(c.vertex[(corner + 2) % 3]);
    Point p = a;
    switch (dice_.in(0, 7)) {
      case 0:
        break;
      case 1:
        p = between(a, b, dice_.in(0, 16), 16);
        break;
      case 2:
        p = between(a, b, dice_.in(0, 1 << 20), 1 << 20);
        break;
      case 3:
        p = on_border(a, b);
        break;
      case 4:  // the texel corner nearest a point of the edge
        p = between(a, b, dice_.in(0, 16), 16);
        p.x = round_to_texel(p.x);
        p.y = round_to_texel(p.y);
        break;
      case 5: {  // inside
        const Point side = between(a, b, dice_.in(0, 1024), 1024);
        p = between(side, o, dice_.in(0, 1024), 1024);
        break;
      }
      case 6:
        p = between(a, b, dice_.in(-4, 20), 16);  // past the ends, too
        break;
      default:
        return anywhere();
    }
    p.x += step();
    p.y += step();
    return p;
  }

  std::int64_t round_to_texel(std::int64_t v) const {
    return ((v + texel() / 2) >> bits_) * texel();
  }

  /// Where the line from a to b crosses a texel border, to the nearest unit.
  Point on_border(Point a, Point b) {
    const bool across = dice_.one_in(2);
    const std::int64_t from = across ? a.x : a.y, to = across ? b.x : b.y;
    if (from == to) return a;
    const auto [low, high] = std::minmax(from, to);
    const std::int64_t border = dice_.in(low >> bits_, (high >> bits_) + 1) * texel();
    return between(a, b, border - from, to - from < 0 ? -(from - to) : to - from);
  }

  std::uint32_t depth(const Caster* c, const LightPoint& p) {
    const auto clamped = [](double z) {
      return static_cast<std::uint32_t>(std::clamp(z, 0.0, double(kDepthMax)));
    };
    if (!c || dice_.one_in(6)) return static_cast<std::uint32_t>(dice_.in(0, kDepthMax));
    if (dice_.one_in(8)) return c->vertex[dice_.in(0, 2)].z;
    const Weights w = weights_at(*c, p.x, p.y);
    if (w.area() == 0) return c->vertex[0].z;
    const double surface = std::floor(plane_depth(*c, w));
    const double bias = contact_distance(*c, config_, bits_);
    switch (dice_.in(0, 6)) {
      case 0:
        return clamped(surface);
      case 1:
        return clamped(surface + double(dice_.in(-3, 3)));
      case 2:
        return clamped(surface + bias + double(dice_.in(-2, 2)));
      case 3:
        return clamped(surface + bias * dice_.real(-2, 3));
      case 4:
        return clamped(surface + double(dice_.either(dice_.magnitude(23))));
      case 5:
        return clamped(surface + 1 + 2 * bias);
      default:
        return static_cast<std::uint32_t>(
            dice_.in(static_cast<std::int64_t>(clamped(surface)), kDepthMax));
    }
  }

  std::uint32_t object(const Caster* c) {
    if (dice_.one_in(2)) return 0;
    if (c && dice_.one_in(2)) return c->object;
    return static_cast<std::uint32_t>(dice_.index(trace_.header.objects));
  }

  const Trace& trace_;
  const UnitConfig& config_;
  Dice& dice_;
  const std::uint32_t bits_;
};

}  // namespace

void place_fragments(Trace& trace, const UnitConfig& config, std::size_t count, Dice& dice) {
  Placer placer(trace, config, dice);
  for (std::size_t i = 0; i < count; ++i) {
    Fragment f = placer.fragment();
    f.pixel_x = static_cast<std::uint16_t>(i % kImageWidth);
    f.pixel_y = static_cast<std::uint16_t>(i / kImageWidth);
    trace.all_fragments.push_back(f);
  }
  trace.header.image_width = kImageWidth;
  trace.header.image_height = static_cast<std::uint32_t>(count / kImageWidth + 1);
}

}  // namespace kagesen::stress

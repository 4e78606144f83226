// Tessellated regions: shared edges cancel whatever the order, and only the outline remains.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <string>

#include "model/unit/edge_walker.h"
#include "tests/model/unit/frame.h"

namespace kagesen {
namespace {

constexpr int kSide = 16;
constexpr std::uint32_t kObject = 3, kDepth = 5000;

std::int64_t turn(const LightPoint& a, const LightPoint& b, const LightPoint& c) {
  return (std::int64_t{b.x} - a.x) * (c.y - a.y) - (std::int64_t{b.y} - a.y) * (c.x - a.x);
}

/// A convex polygon cut into triangles, in random order and winding.
struct Region {
  std::vector<LightPoint> hull;  // counter-clockwise
  std::vector<Caster> triangles;
};

Region tessellate(unsigned seed, bool flat, std::int32_t grid) {
  std::mt19937 random(seed);
  const auto point = [&] {
    const auto coordinate = [&] {
      const std::int32_t c = static_cast<std::int32_t>(random() % (12u * kTexel)) - 6 * kTexel;
      return c - c % grid;  // a coarse grid puts vertices and edges on texel borders
    };
    return LightPoint{coordinate(), coordinate(), flat ? kDepth : std::uint32_t(random() % 9000)};
  };
  std::vector<LightPoint> points(10);
  for (LightPoint& p : points) p = point();
  const auto less = [](const LightPoint& a, const LightPoint& b) {
    return a.x != b.x ? a.x < b.x : a.y < b.y;
  };
  std::sort(points.begin(), points.end(), less);
  Region region;
  for (int side = 0; side < 2; ++side) {  // monotone chains
    const std::size_t base = region.hull.size();
    for (const LightPoint& p : points) {
      while (region.hull.size() >= base + 2 &&
             turn(region.hull[region.hull.size() - 2], region.hull.back(), p) <= 0)
        region.hull.pop_back();
      region.hull.push_back(p);
    }
    region.hull.pop_back();
    std::reverse(points.begin(), points.end());
  }
  std::vector<std::array<LightPoint, 3>> cut;
  for (std::size_t i = 1; i + 1 < region.hull.size(); ++i)
    cut.push_back({region.hull[0], region.hull[i], region.hull[i + 1]});
  // Points within split a triangle in three.
  for (int tries = 0; tries < 60; ++tries) {
    const LightPoint p = point();
    const std::size_t n = random() % cut.size();
    const auto [a, b, c] = cut[n];
    if (turn(a, b, p) <= 0 || turn(b, c, p) <= 0 || turn(c, a, p) <= 0) continue;
    cut[n] = {a, b, p};
    cut.push_back({b, c, p});
    cut.push_back({c, a, p});
  }
  std::shuffle(cut.begin(), cut.end(), random);
  for (auto t : cut) {
    if (random() % 2) std::swap(t[0], t[1]);
    std::rotate(t.begin(), t.begin() + random() % 3, t.end());
    region.triangles.push_back(
        triangle(t[0], t[1], t[2], kObject, static_cast<std::uint32_t>(region.triangles.size())));
  }
  return region;
}

UnitConfig config_of(int bits, HiddenRemoval removal) {
  UnitConfig config = small_config(kSide);
  config.fraction_bits = config.slope_bits = bits;
  config.hidden_removal = removal;
  config.match_polygon_id = false;  // so that equal words always meet
  return config;
}

using Lines = std::map<std::pair<std::uint32_t, LineRecord>, int>;  // Left counts +1, Right -1

void add(Lines& lines, std::uint32_t texel, LineRecord line) {
  const int sign = line.left ? 1 : -1;
  line.left = false;
  line.polygon = 0;
  lines[{texel, line}] += sign;
}

Lines without_zeros(Lines lines) {
  for (auto it = lines.begin(); it != lines.end();) it = it->second == 0 ? lines.erase(it) : ++it;
  return lines;
}

Lines outline_of(const Region& region, int bits) {
  using unit::Line;
  Lines lines;
  for (std::size_t i = 0; i < region.hull.size(); ++i) {
    const LightPoint &a = region.hull[i], &b = region.hull[(i + 1) % region.hull.size()];
    const LightPoint& third = region.hull[(i + 2) % region.hull.size()];
    const unit::EdgeSetup edge = unit::setup_edge(a, b, third, kMinFractionBits, bits);
    for (unit::EdgeWalker w(edge, kMinFractionBits, bits);; w.step()) {
      const unit::OutlineTexel t = w.texel();
      LineRecord l;
      l.fraction = t.line.fraction;
      l.slope = t.line.slope;
      l.left = t.line.has(Line::kLeft);
      l.cross = t.line.has(Line::kCross);
      l.x_major = t.line.has(Line::kXMajor);
      l.x_positive = t.line.has(Line::kXPositive);
      l.end_here = t.line.has(Line::kEndHere);
      add(lines, static_cast<std::uint32_t>((t.y + kSide / 2) * kSide + t.x + kSide / 2), l);
      if (w.last()) break;
    }
  }
  return without_zeros(lines);
}

Lines held_lines(const MapContents& map) {
  Lines lines;
  for (const TexelEntry& e : map.entries) {
    for (LineRecord l : e.lines) {
      l.start_here = false;
      add(lines, e.texel_y * kSide + e.texel_x, l);
    }
  }
  return lines;
}

/// Does the open inside of the convex outline hold the whole texel? Do they meet at all?
std::pair<bool, bool> covers_and_meets(const Region& region, int x, int y) {
  bool all = true, meets = true;
  for (std::size_t i = 0; i < region.hull.size(); ++i) {
    bool some = false;
    for (int corner = 0; corner < 4; ++corner) {
      const LightPoint p{(x - kSide / 2 + corner % 2) * kTexel,
                         (y - kSide / 2 + corner / 2) * kTexel, 0};
      const bool in = turn(region.hull[i], region.hull[(i + 1) % region.hull.size()], p) > 0;
      all &= in;
      some |= in;
    }
    meets &= some;
  }
  return {all, meets};
}

void expect_outline(const Region& region, int bits, HiddenRemoval removal,
                    const std::string& name) {
  const Outcome out = run({region.triangles, {}}, config_of(bits, removal));
  const Lines held = held_lines(out.contents);
  std::size_t lines = 0;
  for (const TexelEntry& e : out.contents.entries) lines += e.lines.size();
  std::size_t net = 0;
  for (const auto& [key, count] : held) net += static_cast<std::size_t>(std::abs(count));
  ASSERT_EQ(lines, net) << name << ": both sides of an edge are left";
  ASSERT_TRUE(held == outline_of(region, bits)) << name;
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      const std::uint32_t object = out.contents.object[y * kSide + x];
      const auto [covered, meets] = covers_and_meets(region, x, y);
      ASSERT_TRUE(!covered || object == kObject) << name << ": hole at " << x << ',' << y;
      ASSERT_TRUE(meets || object == kNoObject) << name << ": spill at " << x << ',' << y;
    }
  }
}

TEST(SharedEdges, OnlyTheOutlineRemainsWhateverTheOrder) {
  for (unsigned seed = 0; seed < 150; ++seed) {
    for (const int bits : {3, 8, 12}) {
      const std::string name = std::to_string(seed) + " at " + std::to_string(bits);
      // With relief an own covered texel could hide own lines: only without removal is it certain.
      expect_outline(tessellate(seed, false, 1), bits, HiddenRemoval::kOff, name + " relief");
      for (const HiddenRemoval removal :
           {HiddenRemoval::kOff, HiddenRemoval::kCentre, HiddenRemoval::kFarthest})
        expect_outline(tessellate(seed, true, 1), bits, removal, name + " flat");
      if (HasFatalFailure()) return;
    }
  }
}

TEST(SharedEdges, OnTexelBordersToo) {
  for (unsigned seed = 0; seed < 300; ++seed) {
    const Region region = tessellate(seed, true, kTexel / 2);
    if (region.hull.size() < 3) continue;
    expect_outline(region, 8, HiddenRemoval::kOff, std::to_string(seed) + " on borders");
    if (HasFatalFailure()) return;
  }
}

/// With Polygon IDs matched a sliver's own words may stay beside each other; the sum is the same.
TEST(SharedEdges, PolygonIdsLeaveTheSumOfTheLines) {
  for (unsigned seed = 0; seed < 150; ++seed) {
    for (const int bits : {3, 8, 12}) {
      const Region region = tessellate(seed, false, 1);
      UnitConfig config = config_of(bits, HiddenRemoval::kOff);
      config.match_polygon_id = true;
      const Lines held = held_lines(run({region.triangles, {}}, config).contents);
      ASSERT_TRUE(without_zeros(held) == outline_of(region, bits)) << seed << " at " << bits;
      ASSERT_TRUE(bits < 12 || held == without_zeros(held)) << seed;
    }
  }
}

}  // namespace
}  // namespace kagesen

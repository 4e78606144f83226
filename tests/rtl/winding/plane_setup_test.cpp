#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <random>

#include "Vplane_setup_test_dut.h"
#include "model/facets.h"
#include "model/unit/span_filler.h"
#include "model/unit/winding/plane.h"

namespace kagesen {
namespace {

using unit::Int128;

template <typename Port>
void put(Port& port, int& at, int bits, std::int64_t value) {
  for (int i = 0; i < bits; ++i, ++at) {
    const std::uint32_t mask = 1u << (at % 32);
    port[at / 32] = (value >> i & 1) != 0 ? port[at / 32] | mask : port[at / 32] & ~mask;
  }
}
std::int64_t extend(std::uint64_t value, int bits) {
  return static_cast<std::int64_t>(value << (64 - bits)) >> (64 - bits);
}

/// The module, with edges that want products at random.
class Bench {
 public:
  Bench(int texel_bits, std::int64_t tolerance) {
    dut_.edge_valid_i = dut_.keep_i = dut_.clear_i = dut_.ready_i = 0;
    dut_.rst_ni = 1;
    dut_.eval();
    dut_.rst_ni = 0;
    clock();
    dut_.rst_ni = 1;
    dut_.texel_bits_i = static_cast<std::uint8_t>(texel_bits);
    dut_.plane_tolerance_i = static_cast<std::uint32_t>(tolerance);
  }
  /// False if nothing came out.
  bool run(const Caster& c, bool is_plane, bool shares, std::mt19937_64& random) {
    int at = 0;
    for (int i = 2; i >= 0; --i) {
      put(dut_.tri_i, at, 24, c.vertex[i].z);
      put(dut_.tri_i, at, 28, c.vertex[i].y);
      put(dut_.tri_i, at, 28, c.vertex[i].x);
    }
    put(dut_.tri_i, at, 24, c.object);
    put(dut_.tri_i, at, 24, 0);
    put(dut_.tri_i, at, 3, 0);
    put(dut_.tri_i, at, 1, shares);
    put(dut_.tri_i, at, 1, is_plane);
    dut_.tri_valid_i = 1;
    clock();
    dut_.tri_valid_i = 0;
    const unsigned stall = static_cast<unsigned>(random() % 4);
    cycles = 1;
    for (; !dut_.idle_o && !dut_.valid_o && cycles < 2000; ++cycles) {
      if (!dut_.edge_valid_i && random() % 8 < stall) {
        dut_.edge_valid_i = 1;
        dut_.edge_a_i = static_cast<std::uint32_t>(random() & 0xfffffff);
        dut_.edge_b_i = static_cast<std::uint32_t>(random() & 0xfffffff);
      }
      clock();
    }
    return dut_.valid_o != 0;
  }
  void take() {
    dut_.ready_i = 1;
    clock();
    dut_.ready_i = 0;
  }
  /// The base in a texel so far from the lowest vertex's.
  std::int32_t base(std::int64_t dx, std::int64_t dy) const {
    const auto den = static_cast<std::int64_t>(dut_.base_o);
    const Int128 rest = Int128{static_cast<std::int64_t>(dut_.start_rest_o)} +
                        Int128{dx} * static_cast<std::int64_t>(dut_.step_x_rest_o) +
                        Int128{dy} * static_cast<std::int64_t>(dut_.step_y_rest_o);
    const std::int64_t whole = std::int64_t{dut_.start_whole_o} + dx * dut_.step_x_whole_o +
                               dy * dut_.step_y_whole_o + unit::floor_div(rest, den);
    return static_cast<std::int32_t>(extend(static_cast<std::uint64_t>(whole), 31) >> 4);
  }
  std::uint32_t gradient_x() const { return dut_.visit_tri_o >> 13 & 0x1fff; }
  std::uint32_t gradient_y() const { return dut_.visit_tri_o & 0x1fff; }
  unsigned cycles = 0;
  std::uint64_t products = 0;

 private:
  /// One cycle; a product that is there must be right.
  void clock() {
    dut_.eval();
    const bool done = dut_.edge_done_o;
    if (done) {
      EXPECT_EQ(dut_.product_o, std::uint64_t{dut_.edge_a_i} * dut_.edge_b_i);
      ++products;
    }
    dut_.clk_i = 1;
    dut_.eval();
    dut_.clk_i = 0;
    dut_.eval();
    if (done) dut_.edge_valid_i = 0;
  }
  Vplane_setup_test_dut dut_;
};

/// Facets of every size and f, their own planes and shared ones; half of the lone ones are slivers, needles
/// and specks about the bound of what counts as narrow. Fails if a code, a bias, a step, a start or the
/// choice of the plane differs, or if a triangle without area comes out.
TEST(PlaneSetup, PlanesAreTheModels) {
  std::mt19937_64 random(11);
  const auto in = [&](std::int64_t low, std::int64_t high) {
    return std::uniform_int_distribution<std::int64_t>(low, high)(random);
  };
  const std::int64_t limit = std::int64_t{1} << 27;
  int narrow = 0, shared = 0, flat = 0;
  std::uint64_t cycles = 0, count = 0, products = 0;
  for (int round = 0; round < 12000; ++round) {
    const int bits = static_cast<int>(in(16, 26));
    UnitConfig config;
    config.profile = Profile::kWinding;
    config.plane_tolerance = in(0, 100);
    const unit::winding::Widths widths(config, bits);
    const std::int64_t radius = std::int64_t{1} << (bits - 8);
    const auto facet = [&](int kind) {
      Caster c;
      const std::int64_t size = kind == 0 ? std::int64_t{1} << in(3, 27)
                                : kind == 1 ? radius / 2 : std::int64_t{1} << in(bits - 8, 27);
      const std::int64_t depths = std::int64_t{1} << in(0, 24);
      LightPoint centre{std::int32_t(in(-limit, limit - 1)), std::int32_t(in(-limit, limit - 1)), 0};
      for (LightPoint& p : c.vertex) {
        p.x = std::int32_t(std::clamp(centre.x + in(-size, size), -limit, limit - 1));
        p.y = std::int32_t(std::clamp(centre.y + in(-size, size), -limit, limit - 1));
        p.z = std::uint32_t(std::clamp<std::int64_t>((1 << 23) + in(-depths, depths), 0, kDepthMax));
      }
      if (kind == 2) {  // the third vertex beside the edge, about r / 4 off
        const auto& a = c.vertex[0];
        const auto& b = c.vertex[1];
        const std::int64_t t = in(0, 256), off = in(-radius / 2, radius / 2);
        const auto beside = [&](std::int64_t p, std::int64_t q) {
          return std::int32_t(std::clamp(p + (q - p) * t / 256 + (in(0, 1) ? off : 0), -limit, limit - 1));
        };
        c.vertex[2].x = beside(a.x, b.x);
        c.vertex[2].y = beside(a.y, b.y);
      }
      if (kind == 3) {  // two longest edges, equally long
        const std::int64_t length = in(1, limit / 2), off = in(1, radius / 4);
        const auto& a = c.vertex[0];
        const std::int64_t far = a.y < 0 ? a.y + length : a.y - length;
        c.vertex[1].x = std::int32_t(std::clamp(a.x + off, -limit, limit - 1));
        c.vertex[2].x = std::int32_t(std::clamp(a.x - off, -limit, limit - 1));
        c.vertex[1].y = c.vertex[2].y = std::int32_t(far);
        if (in(0, 1)) {
          for (LightPoint& v : c.vertex) std::swap(v.x, v.y);
        }
      } else if (in(0, 9) == 0) {
        c.vertex[2] = {c.vertex[0].x, c.vertex[1].y, c.vertex[2].z};
      }
      if (in(0, 99) == 0) c.vertex[1].x = c.vertex[0].x, c.vertex[2].x = c.vertex[0].x;
      std::rotate(c.vertex, c.vertex + in(0, 2), c.vertex + 3);
      return c;
    };
    const Caster own = facet(static_cast<int>(in(0, 4)) % 4);
    Caster seed = facet(0);
    const bool shares = in(0, 2) == 0 && !is_narrow(seed, std::uint32_t(bits), 8);
    Bench setup(bits, config.plane_tolerance);
    if (shares) {
      ASSERT_FALSE(setup.run(seed, true, false, random));
    }
    const bool out = setup.run(own, false, shares, random);
    const unit::Polygon polygon(own, bits);
    ASSERT_EQ(out, !polygon.degenerate()) << round;
    flat += !out;
    if (!out) continue;
    cycles += setup.cycles;
    ++count;
    products += setup.products;
    shared += shares;
    narrow += !shares && is_narrow(own, std::uint32_t(bits), 8);
    const unit::winding::FacetPlane plane(own, shares ? &seed : nullptr, widths);
    const LightPoint& low = *std::min_element(own.vertex, own.vertex + 3, [](const auto& a, const auto& b) {
      return a.y < b.y || (a.y == b.y && a.x < b.x);
    });
    const std::int32_t x = low.x >> bits, y = low.y >> bits;
    for (int i = 0; i < 5; ++i) {
      const std::int32_t dx = i == 0 ? 0 : std::int32_t(in(-100, 100)), dy = i == 0 ? 0 : std::int32_t(in(-100, 100));
      // Far away, and off the range of coordinates, planes exceed what the model holds.
      if (std::abs((std::int64_t{x} + dx) << bits) > limit || std::abs((std::int64_t{y} + dy) << bits) > limit) continue;
      const auto expected = plane.in(x + dx, y + dy);
      ASSERT_EQ(setup.gradient_x(), expected.gradient_x) << round;
      ASSERT_EQ(setup.gradient_y(), expected.gradient_y) << round;
      ASSERT_EQ(setup.base(dx, dy), expected.base) << round << " " << dx << " " << dy << " shares " << shares;
    }
    setup.take();
  }
  EXPECT_GT(narrow, 1000);
  EXPECT_GT(shared, 1000);
  EXPECT_GT(flat, 50);
  EXPECT_GT(products, 10000u);
  EXPECT_LT(cycles / count, 160u);
  std::printf("%.1f cycles a triangle\n", double(cycles) / double(count));
}

}  // namespace
}  // namespace kagesen

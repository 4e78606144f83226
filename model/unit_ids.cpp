#include "model/unit_ids.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace kagesen {
namespace {

struct Box {
  std::int32_t x0 = std::numeric_limits<std::int32_t>::max(), y0 = x0;
  std::int32_t x1 = std::numeric_limits<std::int32_t>::min(), y1 = x1;

  void add(std::int32_t x, std::int32_t y) {
    x0 = std::min(x0, x);
    y0 = std::min(y0, y);
    x1 = std::max(x1, x);
    y1 = std::max(y1, y);
  }
  bool meets(const Box& o) const { return x0 <= o.x1 && o.x0 <= x1 && y0 <= o.y1 && o.y0 <= y1; }
};

}  // namespace

UnitIds assign_unit_ids(const Trace& trace, std::uint32_t fraction_bits, int id_bits) {
  UnitIds out;
  const std::size_t count = trace.header.objects.size();
  const std::size_t available = std::size_t{1} << id_bits;
  if (count <= available) return out;

  // In texels, borders included: an outline on a border may be stored on either side of it.
  std::vector<Box> boxes(count);
  for (const Caster& c : trace.all_casters) {
    for (const LightPoint& v : c.vertex) {
      const std::int32_t x = v.x >> fraction_bits, y = v.y >> fraction_bits;
      boxes[c.object].add(x - 1, y - 1);
      boxes[c.object].add(x + 1, y + 1);
    }
  }
  for (const Fragment& f : trace.all_fragments) {
    boxes[f.object].add(f.position.x >> fraction_bits, f.position.y >> fraction_bits);
  }

  std::vector<std::uint32_t> order(count);
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return boxes[a].x0 != boxes[b].x0 ? boxes[a].x0 < boxes[b].x0 : a < b;
  });
  out.ids.assign(count, 0);
  std::vector<std::uint32_t> active;  // placed objects whose box reaches the sweep
  std::vector<std::uint32_t> met(available);
  for (const std::uint32_t object : order) {
    const Box& box = boxes[object];
    active.erase(std::remove_if(active.begin(), active.end(),
                                [&](std::uint32_t other) { return boxes[other].x1 < box.x0; }),
                 active.end());
    std::fill(met.begin(), met.end(), 0);
    for (const std::uint32_t other : active) met[out.ids[other]] += boxes[other].meets(box);
    const auto least = std::min_element(met.begin(), met.end());
    out.ids[object] = static_cast<std::uint32_t>(least - met.begin());
    out.sharing += *least != 0;
    active.push_back(object);
  }
  return out;
}

}  // namespace kagesen

#include "tests/stress/shrink.h"

#include <algorithm>
#include <chrono>
#include <utility>
#include <vector>

namespace kagesen::stress {
namespace {

class Shrinker {
 public:
  Shrinker(const Trace& trace, const std::function<bool(const Trace&)>& fails,
           const ShrinkLimits& limits)
      : best_(trace), fails_(fails), limits_(limits) {}

  Trace run(std::uint32_t suspect) {
    Trace alone = best_;
    alone.all_fragments = {best_.all_fragments[suspect]};
    accept(std::move(alone));
    std::size_t size;
    do {
      size = weight();
      drop(&Trace::all_fragments);
      drop(&Trace::all_casters);
      drop_objects();
      shrink_map();
      round_numbers();
    } while (weight() < size && !exhausted());
    return std::move(best_);
  }

 private:
  bool exhausted() const {
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start_;
    return tries_ >= limits_.tries || spent.count() > limits_.seconds;
  }
  std::size_t weight() const {
    return 1000 * (best_.all_fragments.size() + best_.all_casters.size()) + set_bits();
  }
  /// Bits that are set in all coordinates and depths: rounder numbers have fewer.
  std::size_t set_bits() const {
    std::size_t bits = 0;
    const auto count = [&bits](const LightPoint& p) {
      for (const auto v : {static_cast<std::uint32_t>(p.x < 0 ? -p.x : p.x),
                           static_cast<std::uint32_t>(p.y < 0 ? -p.y : p.y), p.z}) {
        bits += static_cast<std::size_t>(__builtin_popcount(v));
      }
    };
    for (const Caster& c : best_.all_casters) {
      for (const LightPoint& v : c.vertex) count(v);
    }
    for (const Fragment& f : best_.all_fragments) count(f.position);
    return bits;
  }

  bool accept(Trace trial) {
    if (exhausted()) return false;
    ++tries_;
    if (!fails_(trial)) return false;
    best_ = std::move(trial);
    return true;
  }

  /// Drops runs of records, long ones first.
  template <class Record>
  void drop(std::vector<Record> Trace::*records) {
    for (std::size_t run = (best_.*records).size(); run > 0; run /= 2) {
      for (std::size_t at = 0; at < (best_.*records).size() && !exhausted();) {
        Trace trial = best_;
        auto& list = trial.*records;
        const std::size_t end = std::min(list.size(), at + run);
        list.erase(list.begin() + static_cast<std::ptrdiff_t>(at),
                   list.begin() + static_cast<std::ptrdiff_t>(end));
        if (!accept(std::move(trial))) at += run;
      }
    }
  }

  void drop_objects() {
    std::vector<bool> used(best_.header.objects.size());
    for (const Caster& c : best_.all_casters) used[c.object] = true;
    for (const Fragment& f : best_.all_fragments) used[f.object] = true;
    std::vector<std::uint32_t> number(used.size());
    Trace trial = best_;
    trial.header.objects.clear();
    for (std::size_t i = 0; i < used.size(); ++i) {
      number[i] = static_cast<std::uint32_t>(trial.header.objects.size());
      if (used[i]) trial.header.objects.push_back(best_.header.objects[i]);
    }
    if (trial.header.objects.size() == used.size()) return;
    for (Caster& c : trial.all_casters) c.object = number[c.object];
    for (Fragment& f : trial.all_fragments) f.object = number[f.object];
    accept(std::move(trial));
  }

  void shrink_map() {
    for (const auto side : {&TraceHeader::map_width, &TraceHeader::map_height}) {
      while (best_.header.*side > 1) {
        Trace trial = best_;
        trial.header.*side = (best_.header.*side + 1) / 2;
        if (!accept(std::move(trial))) break;
      }
    }
  }

  /// Every number of the trace, tried at 0 and then with fewer and fewer low bits cleared.
  void round_numbers() {
    for (std::size_t i = 0; i < best_.all_casters.size() * 3 + best_.all_fragments.size(); ++i) {
      for (int axis = 0; axis < 3 && !exhausted(); ++axis) round_number(i, axis);
    }
  }
  static LightPoint& point(Trace& trace, std::size_t i) {
    const std::size_t vertices = trace.all_casters.size() * 3;
    return i < vertices ? trace.all_casters[i / 3].vertex[i % 3]
                        : trace.all_fragments[i - vertices].position;
  }
  void round_number(std::size_t i, int axis) {
    const auto read = [axis](const LightPoint& p) {
      return axis == 0 ? std::int64_t{p.x} : axis == 1 ? std::int64_t{p.y} : std::int64_t{p.z};
    };
    const auto write = [axis](LightPoint& p, std::int64_t v) {
      (axis == 0 ? p.x : p.y) = static_cast<std::int32_t>(axis == 2 ? (axis == 0 ? p.x : p.y) : v);
      if (axis == 2) p.z = static_cast<std::uint32_t>(v);
    };
    const std::int64_t value = read(point(best_, i));
    std::int64_t last = value;
    for (int bits = kCoordinateBits; bits > 0; bits -= bits > 8 ? 4 : 1) {
      const std::int64_t rounded = value / (std::int64_t{1} << bits) * (std::int64_t{1} << bits);
      if (rounded == value || rounded == last) continue;
      last = rounded;
      Trace trial = best_;
      write(point(trial, i), rounded);
      if (accept(std::move(trial))) return;
    }
  }

  Trace best_;
  const std::function<bool(const Trace&)>& fails_;
  const ShrinkLimits limits_;
  std::size_t tries_ = 0;
  const std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace

Trace shrink(const Trace& trace, std::uint32_t suspect,
             const std::function<bool(const Trace&)>& fails, const ShrinkLimits& limits) {
  return Shrinker(trace, fails, limits).run(suspect);
}

}  // namespace kagesen::stress

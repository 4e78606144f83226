#pragma once
/// An engine that gives the verdicts and buffers it is told to, and keeps a record of its calls.
#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "model/engine.h"

namespace kagesen {

class FakeEngine : public Engine {
 public:
  /// An empty map of the given sides.
  explicit FakeEngine(std::uint32_t width = 8, std::uint32_t height = 8) {
    map.width = width;
    map.height = height;
    map.depth.assign(std::size_t{width} * height, kDepthMax);
    map.object.assign(map.depth.size(), kNoObject);
    map.overflowed.assign(map.depth.size(), 0);
    counted.map_bytes = 5 * map.depth.size();
  }

  std::string name() const override { return "fake"; }
  void begin(const UnitConfig& config, const FrameSetup&) override {
    config_ = config;
    call("begin");
  }
  void announce(const Fragment*, std::size_t count) override { call("announce", count); }
  void draw(const Caster*, std::size_t count) override { call("draw", count); }
  /// Dark in physical semantics, lit in paper semantics.
  void decide(const Fragment*, std::size_t count, Verdict* verdicts) override {
    call("decide", count);
    const bool dark = config_.semantics == Semantics::kPhysical;
    std::fill_n(verdicts, count, dark ? Verdict::kDark : Verdict::kLit);
  }
  MapContents contents() const override { return map; }
  UnitCounters counters() const override { return counted; }

  MapContents map;
  UnitCounters counted;
  std::vector<std::string>* calls = nullptr;  ///< "draw 3 physical", ...

 private:
  void call(const char* what, std::size_t count = 0) {
    if (!calls) return;
    calls->push_back(std::string(what) + (count ? " " + std::to_string(count) : "") +
                     (config_.semantics == Semantics::kPaper ? " paper" : " physical"));
  }
  UnitConfig config_;
};

}  // namespace kagesen

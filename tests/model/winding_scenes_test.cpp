// The winding profile on every built-in scene: no skip and no order of triangles changes a verdict,
// and the contract holds.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "model/engine.h"
#include "model/frame_setup.h"
#include "model/reference/contact.h"
#include "model/reference/reference.h"
#include "traces/raster/capture.h"
#include "traces/scene/scene.h"

namespace kagesen {
namespace {

Trace frame_of(const std::string& scene, double scale) {
  CaptureOptions options;
  options.image_width = 160;
  options.image_height = 90;
  options.map_width = options.map_height = 256;
  options.scale_x = options.scale_y = scale;
  Trace trace;
  capture(make_builtin(scene), options, trace);
  return trace;
}

UnitConfig winding(const Trace& trace, Semantics semantics) {
  UnitConfig config;
  config.profile = Profile::kWinding;
  config.semantics = semantics;
  config.map_width = trace.header.map_width;
  config.map_height = trace.header.map_height;
  return config;
}

std::vector<Verdict> decide(const Trace& trace, const UnitConfig& config) {
  const auto engine = make_golden_engine();
  engine->begin(config, make_frame_setup(trace, config));
  const auto& fragments = trace.all_fragments;
  engine->announce(fragments.data(), fragments.size());
  engine->draw(trace.all_casters.data(), trace.all_casters.size());
  std::vector<Verdict> verdicts(fragments.size());
  engine->decide(fragments.data(), fragments.size(), verdicts.data());
  EXPECT_EQ(engine->counters().overflow_texels, 0u);
  return verdicts;
}

std::uint64_t broken(const Trace& trace, const UnitConfig& config,
                     const std::vector<Verdict>& verdicts) {
  const ExactReference reference(trace.all_casters);
  const std::uint32_t bits = trace.header.fraction_bits;
  const double radius = double(std::int64_t{1} << (bits - std::uint32_t(config.fraction_bits)));
  std::uint64_t count = 0;
  for (std::size_t i = 0; i < verdicts.size(); ++i) {
    const Fragment& f = trace.all_fragments[i];
    if ((f.flags & (Fragment::kAverted | Fragment::kOutside)) != 0) continue;
    const bool dark = verdicts[i] == Verdict::kDark;
    if (dark == reference.dark(f, config.semantics) ||
        reference.boundary_distance(f.position, f.object, config.semantics, radius + 1) <= radius) {
      continue;
    }
    count +=
        dark || clear_of_contact(reference, trace.all_casters, f, config.semantics, config, bits);
  }
  return count;
}

class WindingScenes : public testing::TestWithParam<std::string> {};

TEST_P(WindingScenes, SkipsAndOrderChangeNoVerdictAndTheContractHolds) {
  for (const double scale : {1.0, 16.0}) {
    const Trace trace = frame_of(GetParam(), scale);
    Trace shuffled = trace;
    std::mt19937 random(7);
    std::shuffle(shuffled.all_casters.begin(), shuffled.all_casters.end(), random);
    for (Caster& c : shuffled.all_casters) {
      std::shuffle(std::begin(c.vertex), std::end(c.vertex), random);
    }
    for (const Semantics semantics : {Semantics::kPaper, Semantics::kPhysical}) {
      const UnitConfig all = winding(trace, semantics);
      const std::vector<Verdict> verdicts = decide(trace, all);
      EXPECT_EQ(broken(trace, all, verdicts), 0u) << scale;
      EXPECT_TRUE(decide(shuffled, all) == verdicts) << "shuffled, scale " << scale;
      for (bool UnitConfig::*skip :
           {&UnitConfig::skip_receiver_mask, &UnitConfig::skip_first_test, &UnitConfig::skip_tiles,
            &UnitConfig::skip_edges, &UnitConfig::skip_fragments}) {
        UnitConfig without = all;
        without.*skip = false;
        EXPECT_TRUE(decide(trace, without) == verdicts) << scale;
      }
    }
  }
}

std::vector<std::string> names() {
  std::vector<std::string> out;
  for (const SceneInfo& scene : builtin_scenes()) {
    if (scene.name != "sphere1m") out.push_back(scene.name);  // seconds; kagesen results has it
  }
  return out;
}
INSTANTIATE_TEST_SUITE_P(Scenes, WindingScenes, testing::ValuesIn(names()),
                         [](const auto& info) { return info.param; });

}  // namespace
}  // namespace kagesen

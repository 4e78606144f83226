#include "testbench/mutation/unit_recording.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <stdlib.h>

#include <cstdio>
#include <filesystem>
#include <random>

#include "model/engine.h"
#include "testbench/tools/cache.h"
#include "testbench/tools/process.h"
#include "testbench/tools/rtl_sources.h"
#include "testbench/verilator/package.h"
#include "testbench/verilator/rtl_engine.h"
#include "traces/format/error.h"

namespace kagesen {
namespace {

namespace fs = std::filesystem;

constexpr int kMap = 16;  // texels an axis

struct ShortFrame {
  UnitConfig config;
  FrameSetup setup;
  std::vector<Caster> casters;
  std::vector<Fragment> fragments;
};

/// Triangles of about 5 texels between the light and most of the fragments, about the map's middle.
ShortFrame short_frame(const UnitConfig& config) {
  ShortFrame frame;
  frame.config = config;
  frame.config.map_width = frame.config.map_height = kMap;
  frame.config.slb_buckets = 16;
  std::mt19937 random(1);
  const auto point = [&](int texels, std::uint32_t depth) {
    const int most = texels << kMinFractionBits;
    LightPoint p{};
    p.x = int(random() % unsigned(2 * most)) - most;
    p.y = int(random() % unsigned(2 * most)) - most;
    p.z = depth + random() % 1024;
    return p;
  };
  for (std::uint32_t i = 0; i < 8; ++i) {
    Caster caster;
    for (LightPoint& vertex : caster.vertex) vertex = point(4, 5000 + 2000 * i);
    caster.object = i / 2;
    caster.polygon = i;
    frame.casters.push_back(caster);
  }
  for (std::uint32_t i = 0; i < 96; ++i) {
    Fragment fragment;
    fragment.position = point(i % 8 ? 4 : 7, 3000 + 300 * i);
    fragment.object = 4 + i % 2;
    fragment.flags = i % 16 == 15 ? Fragment::kAverted : 0;
    frame.fragments.push_back(fragment);
  }
  return frame;
}

std::vector<Verdict> run(const ShortFrame& frame, Engine& engine) {
  engine.begin(frame.config, frame.setup);
  engine.announce(frame.fragments.data(), frame.fragments.size());
  engine.draw(frame.casters.data(), frame.casters.size());
  std::vector<Verdict> verdicts(frame.fragments.size());
  engine.decide(frame.fragments.data(), frame.fragments.size(), verdicts.data());
  return verdicts;
}

}  // namespace

Recording record_unit(const UnitConfig& config, std::size_t beats) {
  const fs::path folder = cache_folder() / "recording" / ("unit_" + get_field(config, "profile"));
  fs::create_directories(folder);
  const fs::path package = folder / "shadow_pkg.sv";
  write_file(package, shadow_package(config));
  const std::string bench = source_folder() + "/testbench/verilator/";
  const std::vector<std::string> files = RtlSources(config.profile).of("shadow_unit");
  const std::string log = (folder / "recorder.log").string();
  if (run_process({find_tool("cmake", "cmake"), "-DOUT=" + folder.string(), "-DTARGET=unit",
                   "-DTOP=shadow_unit", "-DPACKAGE=" + package.string(),
                   fmt::format("-DSOURCES={}|{}", fmt::join(files, "|"), ram_file()),
                   "-DINCLUDE=" + common_folder(), "-P", bench + "recorder.cmake"},
                  folder.string(), log)
          .status != 0) {
    throw UserError("recording the unit", "its ports cannot be read", "see " + log);
  }

  RtlOptions options;
  options.kind = BuildKind::kCheck;
  for (const std::string& file : files) {
    options.replaced.push_back({fs::relative(file, source_folder()).string(), read_file(file)});
  }
  options.replaced.push_back(
      {"testbench/verilator/shadow_bench.sv",
       read_file(bench + "shadow_bench.sv") + read_file(folder / "unit_recorder.sv")});
  options.replaced.push_back(
      {"testbench/verilator/recorder.cpp", read_file(bench + "recorder.cpp")});

  Recording recording = read_manifest(folder / "unit.manifest");
  recording.pins = (folder / "unit.pins").string();
  fs::remove(recording.pins);
  setenv("KAGESEN_RECORD", folder.c_str(), 1);
  setenv("KAGESEN_RECORD_BEATS", std::to_string(4 * beats).c_str(),
         1);  // of one instance a quarter
  const ShortFrame frame = short_frame(config);
  RtlEngine engine(options);
  const std::vector<Verdict> verdicts = run(frame, engine);
  std::fflush(nullptr);  // the bench lives on, and so does its file
  unsetenv("KAGESEN_RECORD");
  unsetenv("KAGESEN_RECORD_BEATS");
  if (verdicts != run(frame, *make_golden_engine())) {
    throw UserError("recording the unit", "its verdicts are not golden's", "kagesen check");
  }
  return recording;
}

}  // namespace kagesen

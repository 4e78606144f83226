#include <fmt/format.h>

#include "sim/cli/results/winding_page.h"
#include "sim/report/table.h"
#include "traces/scene/scene.h"

namespace kagesen {
namespace {

constexpr std::uint64_t kRivalBytes = std::uint64_t{4096} * 4096 * 4;  // a 32-bit shadow map
constexpr double kMostWithoutMask = 1.5, kMostWithMask = 1;            // times the paper profile

std::uint64_t paper_profile_bytes(const SceneResults& scene, unsigned scale) {
  const Measurement& m = scene.at(scale, 8);
  return m.map_bytes + m.allocated_bytes;
}

double ratio(std::uint64_t bytes, std::uint64_t to) { return double(bytes) / double(to); }

std::string with_ratio(std::uint64_t bytes, std::uint64_t to) {
  return fmt::format("{} ({:.2f})", bytes_text(bytes), ratio(bytes, to));
}

std::string default_scene_targets(const std::vector<SceneResults>& results) {
  const std::string name = builtin_scenes().front().name;
  for (const SceneResults& scene : results) {
    if (scene.name != name) continue;
    for (const WindingMemory& m : scene.winding.memory) {
      if (m.scale != 1) continue;
      const std::uint64_t paper = paper_profile_bytes(scene, 1);
      const double without = ratio(m.bytes.physical.without_mask, paper);
      const double with = ratio(m.bytes.physical.with_mask, paper);
      return fmt::format(
          "- The default scene, `{}`, at scale 1 in physical semantics: {:.2f} times the paper "
          "profile without the mask (target: at most {}; {}), {:.2f} with it (target: below {}; "
          "{}).\n",
          name, without, kMostWithoutMask, without <= kMostWithoutMask ? "reached" : "**missed**",
          with, kMostWithMask, with < kMostWithMask ? "reached" : "**missed**");
    }
  }
  return "";
}

}  // namespace

std::string memory_section(const std::vector<SceneResults>& results) {
  std::string text = fmt::format(
      "\n### Memory\n\n"
      "All bytes of a frame: the map's buffers and the allocated records, in brackets as a "
      "multiple of the paper profile's with 8 bits. *Mask* is the receiver mask: texels that no "
      "fragment falls into store nothing. A shadow map of 4096 x 4096 texels of 32 bits takes {}. "
      "Again: *map* and *allocated* of `./kagesen run SCENE --scale S --set profile=winding "
      "--set semantics=paper|physical --set skip_receiver_mask=true|false`.\n\n"
      "| scene | scale | paper profile | physical semantics, no mask | with mask | paper "
      "semantics, no mask | with mask |\n"
      "|:--|--:|--:|--:|--:|--:|--:|\n",
      bytes_text(kRivalBytes));
  std::uint64_t largest = 0;
  std::string place;
  for (const SceneResults& scene : results) {
    for (const WindingMemory& m : scene.winding.memory) {
      const std::uint64_t paper = paper_profile_bytes(scene, m.scale);
      text += fmt::format("| {0} | {1} x {1} | {2} |", scene.name, m.scale, bytes_text(paper));
      for (const auto* bytes : {&m.bytes.physical, &m.bytes.paper}) {
        text += fmt::format(" {} | {} |", with_ratio(bytes->without_mask, paper),
                            with_ratio(bytes->with_mask, paper));
        for (const std::uint64_t one : {bytes->without_mask, bytes->with_mask}) {
          if (one <= largest) continue;
          largest = one;
          place = fmt::format("{}, {} x {}", scene.name, m.scale, m.scale);
        }
      }
      text += "\n";
    }
  }
  return text + "\n" + default_scene_targets(results) +
         fmt::format("- The most of all: {} ({}); target: less than {} in every scene; {}.\n",
                     bytes_text(largest), place, bytes_text(kRivalBytes),
                     largest < kRivalBytes ? "reached" : "**missed**");
}

}  // namespace kagesen

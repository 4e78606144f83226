#include <fmt/format.h>

#include <array>

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

/// The table's columns beyond the paper profile.
constexpr std::array kColumns{"physical semantics, no mask", "physical semantics, with mask",
                              "paper semantics, no mask", "paper semantics, with mask"};
std::uint64_t column(const WindingMemory& m, std::size_t i) {
  const WindingMemory::Bytes& bytes = i < 2 ? m.bytes.physical : m.bytes.paper;
  return i % 2 == 0 ? bytes.without_mask : bytes.with_mask;
}

struct Largest {
  std::uint64_t bytes = 0;
  std::string place;
};

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
      "| scene | scale | paper profile | {} |\n"
      "|:--|--:|--:|--:|--:|--:|--:|\n",
      bytes_text(kRivalBytes), fmt::join(kColumns, " | "));
  std::array<Largest, 4> largest;
  for (const SceneResults& scene : results) {
    for (const WindingMemory& m : scene.winding.memory) {
      const std::uint64_t paper = paper_profile_bytes(scene, m.scale);
      text += fmt::format("| {0} | {1} x {1} | {2} |", scene.name, m.scale, bytes_text(paper));
      for (std::size_t i = 0; i < largest.size(); ++i) {
        const std::uint64_t bytes = column(m, i);
        text += fmt::format(" {} |", with_ratio(bytes, paper));
        if (bytes > largest[i].bytes) {
          largest[i] = {bytes, fmt::format("{}, {} x {}", scene.name, m.scale, m.scale)};
        }
      }
      text += "\n";
    }
  }
  text += "\n" + default_scene_targets(results) +
          fmt::format("- The most of any scene (target: less than {}):", bytes_text(kRivalBytes));
  for (std::size_t i = 0; i < largest.size(); ++i) {
    text += fmt::format("{} {} {} ({}; {})", i == 0 ? "" : ",", kColumns[i],
                        bytes_text(largest[i].bytes), largest[i].place,
                        largest[i].bytes < kRivalBytes ? "reached" : "**missed**");
  }
  return text + ".\n";
}

}  // namespace kagesen

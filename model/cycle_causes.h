#pragma once
/// Where cycles go: the causes of docs/rtl.md, in the order of shadow_pkg's Store* and Lane*.
#include <cstddef>
#include <cstdint>

namespace kagesen {

/// Of a cycle of pass 2, a lane.
enum class LaneCause : std::uint8_t {
  kFragment,
  kInput,
  kTexel,
  kTexelPort,
  kSlb,
  kSlbPort,
  kDecision,
  kVerdict,
  kDrain,
};
inline constexpr const char* kLaneCauses[] = {"fragment", "input",    "texel",   "texel_port", "slb",
                                              "slb_port", "decision", "verdict", "drain"};
inline constexpr std::size_t kLaneCauseCount = sizeof kLaneCauses / sizeof *kLaneCauses;

/// Of a cycle of pass 1.
inline constexpr const char* kStoreCauses[] = {"edge", "span",  "other",  "input", "setup",
                                               "walk", "texel", "record", "chain", "write"};

}  // namespace kagesen

#pragma once
/// The golden engine's two profiles.
#include <algorithm>
#include <cstdint>
#include <memory>

#include "model/engine.h"

namespace kagesen {

namespace unit {
class ShadowUnit;
namespace winding {
class ShadowUnit;
}
}  // namespace unit

/// @param unit  its unit, for who also looks inside; empty: one of its own
std::unique_ptr<Engine> make_golden_paper_engine(std::shared_ptr<unit::ShadowUnit> unit = {});
std::unique_ptr<Engine> make_golden_winding_engine(
    std::shared_ptr<unit::winding::ShadowUnit> unit = {});

/// Bits that tell so many values apart.
constexpr int bits_for(std::uint64_t values) {
  int bits = 0;
  while ((std::uint64_t{1} << bits) < values) ++bits;
  return bits;
}
/// Of a texel's index along an axis, as the Verilog is built.
inline int map_bits(const UnitConfig& config) {
  constexpr int kLeast = 10;
  return std::max(kLeast,
                  bits_for(static_cast<std::uint64_t>(std::max(config.map_width, config.map_height))));
}
/// Of an address of the SLB, as the Verilog is built: smaller capacities are registers of the same build.
inline int record_addr_bits(const UnitConfig& c) {
  const UnitConfig least;
  const std::int64_t records =
      c.profile == Profile::kWinding
          ? std::max(c.cluster_records, least.cluster_records)
          : std::max(c.slb_buckets + c.slb_entries, least.slb_buckets + least.slb_entries);
  return bits_for(static_cast<std::uint64_t>(records));
}

}  // namespace kagesen

#pragma once
/// When a fragment entered its lane, and when its verdict was taken.
#include <cstdint>

namespace kagesen {

struct FragmentCycles {
  std::uint64_t accepted = 0, retired = 0;
  bool operator==(const FragmentCycles& o) const {
    return accepted == o.accepted && retired == o.retired;
  }
};

}  // namespace kagesen

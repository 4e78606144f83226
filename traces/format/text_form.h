#pragma once
/// Words of the text form (docs/trace-format.md). Not for use outside this folder.
#include <string_view>

namespace kagesen {

inline constexpr unsigned kTextVersion = 1;
/// Indexed by FragmentMode.
inline constexpr std::string_view kModeNames[] = {"visible", "early-z", "all"};

}  // namespace kagesen

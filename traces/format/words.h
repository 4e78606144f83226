#pragma once
/// Numbers in sentences.
#include <cstddef>
#include <cstdint>
#include <string>

namespace kagesen {

/// 1234567 -> "1,234,567".
inline std::string grouped(std::uint64_t value) {
  std::string digits = std::to_string(value);
  for (std::ptrdiff_t at = std::ptrdiff_t(digits.size()) - 3; at > 0; at -= 3) {
    digits.insert(static_cast<std::size_t>(at), ",");
  }
  return digits;
}

/// "1 texel", "1,234 texels"; for nouns that take an s.
inline std::string counted(std::uint64_t value, const std::string& noun) {
  return grouped(value) + " " + noun + (value == 1 ? "" : "s");
}

}  // namespace kagesen

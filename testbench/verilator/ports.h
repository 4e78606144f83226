#pragma once
/// Bit fields of Verilator's ports, whatever type the port's width gave it.
#include <algorithm>
#include <cstdint>
#include <cstring>
#include <type_traits>

namespace kagesen::bench {

constexpr std::uint64_t low_bits(unsigned width) {
  return width >= 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << width) - 1;
}

/// Up to 64 bits from `lsb` on.
template <typename Port>
inline std::uint64_t field(const Port& port, unsigned lsb, unsigned width) {
  if constexpr (std::is_integral_v<Port>) {
    return static_cast<std::uint64_t>(port) >> lsb & low_bits(width);
  } else {
    std::uint64_t value = 0;
    for (unsigned at = 0; at < width;) {
      const unsigned bit = lsb + at;
      value |= std::uint64_t{port[bit / 32] >> (bit % 32)} << at;
      at += 32 - bit % 32;
    }
    return value & low_bits(width);
  }
}

template <typename Port>
inline void set_field(Port& port, unsigned lsb, unsigned width, std::uint64_t value) {
  if constexpr (std::is_integral_v<Port>) {
    const std::uint64_t mask = low_bits(width) << lsb;
    port = static_cast<Port>((port & ~mask) | (value << lsb & mask));
  } else {
    for (unsigned at = 0; at < width;) {
      const unsigned bit = lsb + at;
      const unsigned count = std::min(32 - bit % 32, width - at);
      const auto mask = static_cast<std::uint32_t>(low_bits(count) << (bit % 32));
      const auto part = static_cast<std::uint32_t>(value >> at << (bit % 32));
      port[bit / 32] = (port[bit / 32] & ~mask) | (part & mask);
      at += count;
    }
  }
}

/// `width` bits to words, and back.
template <unsigned kWidth, typename Port>
inline void get_words(const Port& port, unsigned lsb, std::uint32_t* words) {
  if constexpr (!std::is_integral_v<Port>) {
    if (lsb == 0) {
      std::memcpy(words, &port[0], (kWidth + 31) / 32 * 4);
      if constexpr (kWidth % 32 != 0) {
        words[kWidth / 32] &= static_cast<std::uint32_t>(low_bits(kWidth % 32));
      }
      return;
    }
  }
  for (unsigned at = 0; at < kWidth; at += 32) {
    words[at / 32] =
        static_cast<std::uint32_t>(field(port, lsb + at, kWidth - at < 32 ? kWidth - at : 32));
  }
}

/// @param shared  the port holds other fields too
template <unsigned kWidth, bool kShared, typename Port>
inline void set_words(Port& port, unsigned lsb, const std::uint32_t* words) {
  if constexpr (!std::is_integral_v<Port> && !kShared) {
    std::memcpy(&port[0], words, (kWidth + 31) / 32 * 4);
  } else {
    for (unsigned at = 0; at < kWidth; at += 32) {
      set_field(port, lsb + at, kWidth - at < 32 ? kWidth - at : 32, words[at / 32]);
    }
  }
}

}  // namespace kagesen::bench

#pragma once
/// Bit fields of Verilated ports: scalars and wide words alike, least significant bit first.
#include <cstddef>
#include <cstdint>
#include <vector>

#include "verilated.h"

namespace kagesen::rtl {

/// Bits [low, low + width) of 32-bit words, width <= 64.
template <typename Words>
std::uint64_t get_bits(const Words& words, std::size_t low, std::size_t width) {
  std::uint64_t value = 0;
  for (std::size_t got = 0; got < width;) {
    const std::size_t at = low + got, shift = at % 32;
    value |= (std::uint64_t{words[at / 32]} >> shift) << got;
    got += 32 - shift;
  }
  return width < 64 ? value & ((std::uint64_t{1} << width) - 1) : value;
}

template <typename Words>
void set_bits(Words& words, std::size_t low, std::size_t width, std::uint64_t value) {
  for (std::size_t done = 0; done < width;) {
    const std::size_t at = low + done, shift = at % 32;
    const std::size_t count = 32 - shift < width - done ? 32 - shift : width - done;
    const std::uint64_t mask = ((std::uint64_t{1} << count) - 1) << shift;
    const auto word = std::uint64_t{words[at / 32]};
    words[at / 32] = static_cast<std::uint32_t>((word & ~mask) | ((value << shift) & mask));
    value >>= count;
    done += count;
  }
}

/// A word of any width, as 32-bit words; bits above its width are zero.
using Word = std::vector<std::uint32_t>;

inline Word make_word(std::size_t bits) { return Word((bits + 31) / 32, 0); }

/// A port of any of Verilator's types (8 to 64 bits or VlWide) to a word, and back.
template <std::size_t N>
Word from_port(const VlWide<N>& port) {
  return Word(port.data(), port.data() + N);
}
template <typename Scalar>
Word from_port(const Scalar& port) {
  Word word{static_cast<std::uint32_t>(port)};
  if (sizeof(Scalar) > 4) word.push_back(static_cast<std::uint32_t>(std::uint64_t{port} >> 32));
  return word;
}
template <std::size_t N>
void to_port(VlWide<N>& port, const Word& word) {
  for (std::size_t i = 0; i < N; ++i) port[i] = i < word.size() ? word[i] : 0;
}
template <typename Scalar>
void to_port(Scalar& port, const Word& word) {
  std::uint64_t value = word.empty() ? 0 : word[0];
  if (word.size() > 1) value |= std::uint64_t{word[1]} << 32;
  port = static_cast<Scalar>(value);
}

/// The fields of a packed struct, declared in the order of its declaration (most significant first).
class Layout {
 public:
  struct Field {
    std::size_t low = 0, width = 0;
    template <typename Words>
    std::uint64_t get(const Words& words, std::size_t base = 0) const {
      return get_bits(words, base + low, width);
    }
    template <typename Words>
    void set(Words& words, std::uint64_t value, std::size_t base = 0) const {
      set_bits(words, base + low, width, value);
    }
  };
  explicit Layout(std::size_t bits) : bits_(bits), left_(bits) {}
  Field field(std::size_t width) { return {left_ -= width, width}; }
  std::size_t bits() const { return bits_; }
  std::size_t left() const { return left_; }  ///< bits that no field has taken yet

 private:
  std::size_t bits_, left_;
};

}  // namespace kagesen::rtl

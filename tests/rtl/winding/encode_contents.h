#pragma once
/// The golden unit's buffers after pass 1 as the words of the two memories (rtl/winding/shadow_pkg.sv).
///
/// Records stand at random places, and a cluster's segments may be dealt out to its records unevenly:
/// nothing may depend on either. Fields that mean nothing hold noise.
#include <algorithm>
#include <cstdint>
#include <random>
#include <unordered_set>
#include <vector>

#include "model/unit/winding/shadow_unit.h"
#include "testbench/verilator/memory.h"

namespace kagesen::rtl {

/// Widths of the package that do not follow from the golden unit's.
struct MemoryWidths {
  unsigned map_bits = 10, id_bits = 16, record_address_bits = 22, corner_bits = 8;
  unsigned segments_per_record = 2;
  bool uneven = true;  ///< now and then a record with fewer segments than it has room for
};

class ContentsEncoder {
 public:
  ContentsEncoder(const unit::winding::ShadowUnit& unit, const MemoryWidths& widths, std::uint64_t seed)
      : unit_(unit), w_(widths), g_(unsigned(unit.widths().end_bits)), random_(seed) {
    const auto code = unsigned(unit.widths().gradient_code_bits());
    base_bits_ = unsigned(unit.widths().base_bits());
    code_bits_ = code;
    threshold_bits_ = base_bits_ + 2 * code;
    word_bits_ = std::max(threshold_bits_, 2 + 32 + w_.record_address_bits);
    segment_bits_ = 3 + 4 * (g_ + 1);
  }
  unsigned texel_bits() const { return 2 + w_.id_bits + word_bits_; }
  unsigned tile_bits() const { return 3 + (2 * w_.map_bits - 6) + w_.id_bits + 25 + 25 + 24 + 64; }
  unsigned texel_data_bits() const { return std::max(4 * texel_bits(), tile_bits()); }
  unsigned record_bits() const {
    return threshold_bits_ + w_.id_bits + w_.corner_bits + 3 + 4 + w_.record_address_bits +
           w_.segments_per_record * segment_bits_;
  }

  void encode(Memory& texels, Memory& slb) {
    const auto& buffers = unit_.texels();
    for (std::uint32_t y = 0; y < buffers.height(); y += 8) {
      for (std::uint32_t x = 0; x < buffers.width(); x += 8) {
        const unit::winding::Tile& tile = buffers.tile(x, y);
        const std::uint64_t index = (std::uint64_t{y / 8} << (w_.map_bits - 3)) + x / 8;
        texels.poke((std::uint64_t{1} << (2 * w_.map_bits - 2)) | index, tile_word(tile));
        if (tile.slot == unit::winding::Tile::kUntouched) continue;
        for (std::uint32_t i = 0; i < 16; ++i) {
          Word word = noise(texel_data_bits());
          for (std::uint32_t t = 0; t < 4; ++t) {
            put_texel(word, t * texel_bits(), buffers.texel(tile, (i & 1) * 4 + t, i >> 1), slb);
          }
          texels.poke(std::uint64_t{tile.slot} * 16 + i, word);
        }
      }
    }
  }

 private:
  /// Fields from the most significant bit down.
  struct Writer {
    Word& word;
    std::size_t left;
    void operator()(unsigned width, std::uint64_t value) {
      left -= width;
      set_bits(word, left, width, width < 64 ? value & ((std::uint64_t{1} << width) - 1) : value);
    }
  };
  Word noise(std::size_t bits) {
    Word word = make_word(bits);
    for (auto& part : word) part = static_cast<std::uint32_t>(random_());
    if (bits % 32 != 0) word.back() &= (1u << bits % 32) - 1;
    return word;
  }
  Word tile_word(const unit::winding::Tile& tile) {
    using unit::winding::Tile;
    const auto clamped = [](std::int64_t depth) {
      return static_cast<std::uint64_t>(std::clamp<std::int64_t>(depth, -1, kDepthMax));
    };
    Word word = noise(texel_data_bits());
    Writer put{word, tile_bits()};
    put(1, tile.slot != Tile::kUntouched);
    put(2 * w_.map_bits - 6, tile.slot != Tile::kUntouched ? tile.slot : random_());
    put(1, tile.object == Tile::kSeveral);
    put(1, tile.object != unit::winding::Texel::kNobody);
    put(w_.id_bits, tile.object);
    put(25, clamped(tile.nearest));
    put(25, clamped(tile.farthest));
    return word;
  }
  void put_threshold(Writer& put, const unit::winding::Threshold& t) {
    put(base_bits_, static_cast<std::uint32_t>(t.base));
    put(code_bits_, t.gradient_x);
    put(code_bits_, t.gradient_y);
  }
  void put_texel(Word& word, std::size_t at, const unit::winding::Texel& texel, Memory& slb) {
    Writer put{word, at + texel_bits()};
    put(2, texel.empty() ? 0u : texel.one_plane() ? 1u : texel.has_list() ? 2u : 3u);
    if (texel.empty()) return;
    const bool covered = texel.object != unit::winding::Texel::kNobody;
    put(w_.id_bits, covered ? texel.object : random_());
    put.left = at + (texel.one_plane() ? threshold_bits_ : 2 + 32 + w_.record_address_bits);
    if (texel.one_plane()) return put_threshold(put, texel.cover);
    put(1, covered);
    put(1, random_() & 1);  // no matter in pass 2
    put(32, static_cast<std::uint32_t>(covered ? texel.cover.base : std::int32_t(random_())));
    put(w_.record_address_bits, texel.has_list() ? list(texel.list, slb) : random_());
  }
  std::uint64_t place() {
    for (;;) {
      const std::uint64_t at = random_() & ((std::uint64_t{1} << w_.record_address_bits) - 1);
      if (used_.insert(at).second) return at;
    }
  }
  /// @return the address of the list's first record
  std::uint64_t list(std::uint32_t head, Memory& slb) {
    using unit::winding::Segment;
    const std::uint64_t first = place();
    std::uint64_t at = first;
    for (std::uint32_t c = head; c != unit::winding::SilhouetteBuffer::kNone;) {
      const unit::winding::Cluster& cluster = unit_.slb()[c];
      std::vector<Segment> segments;
      unit_.slb().each_segment(cluster, [&](const Segment& s) {
        segments.push_back(s);
        return true;
      });
      std::size_t done = 0;
      bool begins = true;
      do {
        std::size_t count = std::min<std::size_t>(w_.segments_per_record, segments.size() - done);
        if (w_.uneven && count > 0 && random_() % 8 == 0) count = random_() % count;
        const bool goes_on = done + count < segments.size();
        const bool has_next = goes_on || cluster.next != unit::winding::SilhouetteBuffer::kNone;
        const std::uint64_t next = place();
        Word word = noise(record_bits());
        Writer put{word, record_bits()};
        if (begins) {
          put_threshold(put, cluster.threshold);
          put(w_.id_bits, cluster.object);
          put(w_.corner_bits, static_cast<std::uint32_t>(cluster.corner));
          put(1, cluster.full);
        } else {
          put.left -= threshold_bits_ + w_.id_bits + w_.corner_bits + 1;
        }
        put(4, count);
        put(1, goes_on);
        put(1, has_next);
        put(w_.record_address_bits, has_next ? next : random_());
        for (std::size_t i = 0; i < count; ++i) put_segment(word, i, segments[done + i]);
        slb.poke(at, word);
        at = next;
        done += count;
        begins = false;
      } while (done < segments.size());
      c = cluster.next;
    }
    return first;
  }
  void put_segment(Word& word, std::size_t index, const unit::winding::Segment& s) {
    Writer put{word, (index + 1) * segment_bits_};
    put(1, s.inner());
    put(1, s.crosses_left());
    put(1, s.positive());
    for (const std::int32_t end : {s.x0, s.y0, s.x1, s.y1}) put(g_ + 1, static_cast<std::uint32_t>(end));
  }

  const unit::winding::ShadowUnit& unit_;
  MemoryWidths w_;
  unsigned g_, base_bits_, code_bits_, threshold_bits_, word_bits_, segment_bits_;
  std::mt19937_64 random_;
  std::unordered_set<std::uint64_t> used_;
};

}  // namespace kagesen::rtl

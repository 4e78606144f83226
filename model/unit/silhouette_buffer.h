#pragma once
/// Silhouette Line Buffer (SLB): records of a few lines, hashed by texel, linked from the light
/// outwards.
#include <cstdint>
#include <vector>

#include "model/unit/line.h"

namespace kagesen::unit {

/// What one texel holds of one object: an entry. Its lines fill the record, then continuation
/// records.
struct Record {
  std::uint32_t texel = 0;    ///< index of the texel: the tag
  std::uint32_t object = 0;   ///< unit ID
  std::uint32_t nearest = 0;  ///< least depth of the lines since the entry was last empty
  std::uint32_t next = 0;     ///< next entry of the bucket; of a texel, from the light outwards
  std::uint32_t more = 0;     ///< continuation record of this entry
  std::uint16_t lines = 0;    ///< in this record
  bool vertex = false;
  bool corner_covered = false;  ///< some polygon that crosses the texel holds its corner
};

class SilhouetteBuffer {
 public:
  static constexpr std::uint32_t kNone = 0xffffffffu;

  void clear(std::uint32_t buckets, std::uint32_t capacity, std::uint32_t lines_per_record);

  /// The first entry in the bucket's chain that belongs to the texel, or kNone.
  std::uint32_t first_of(std::uint32_t bucket, std::uint32_t texel) const {
    std::uint32_t at = heads_[bucket];
    while (at != kNone && records_[at].texel != texel) at = records_[at].next;
    return at;
  }
  /// The next entry of the same texel, or kNone.
  std::uint32_t next_of(std::uint32_t at) const {
    const std::uint32_t texel = records_[at].texel;
    do at = records_[at].next;
    while (at != kNone && records_[at].texel != texel);
    return at;
  }
  std::uint32_t find(std::uint32_t bucket, std::uint32_t texel, std::uint32_t object) const {
    std::uint32_t at = first_of(bucket, texel);
    while (at != kNone && records_[at].object != object) at = next_of(at);
    return at;
  }

  /// A new, empty entry, linked behind nearer ones of its texel; kNone when the SLB is full.
  std::uint32_t insert(std::uint32_t bucket, std::uint32_t texel, std::uint32_t object,
                       std::uint32_t nearest);
  /// Removes an entry with its lines.
  void erase(std::uint32_t bucket, std::uint32_t entry);
  /// Moves an entry to where its nearest depth belongs.
  void set_nearest(std::uint32_t bucket, std::uint32_t entry, std::uint32_t nearest);

  /// Appends a line; false when a continuation record is needed and the SLB is full.
  bool append(std::uint32_t entry, const Line& line);
  /// Calls `match(line)` on the lines, oldest first, and removes the first that matches; later ones
  /// move up. @return true if one did.
  template <typename Match>
  bool remove_first(std::uint32_t entry, Match match) {
    for (std::uint32_t at = entry, before = kNone; at != kNone;
         before = at, at = records_[at].more) {
      for (std::uint32_t i = 0; i < records_[at].lines; ++i) {
        if (!match(lines_[std::size_t{at} * lines_per_record_ + i])) continue;
        close_gap(before, at, i);
        return true;
      }
    }
    return false;
  }
  std::uint32_t line_count(std::uint32_t entry) const {
    std::uint32_t count = 0;
    for (std::uint32_t at = entry; at != kNone; at = records_[at].more) count += records_[at].lines;
    return count;
  }
  /// Copies an entry's lines to `out`, replacing it.
  void copy_lines(std::uint32_t entry, std::vector<Line>& out) const;
  /// Records that a texel's chain holds, continuation records included.
  std::uint32_t chain_length(std::uint32_t bucket, std::uint32_t texel) const;

  Record& operator[](std::uint32_t at) { return records_[at]; }
  const Record& operator[](std::uint32_t at) const { return records_[at]; }
  const Line* lines_of(std::uint32_t at) const {
    return &lines_[std::size_t{at} * lines_per_record_];
  }

  std::uint32_t buckets() const { return static_cast<std::uint32_t>(heads_.size()); }
  std::uint32_t head(std::uint32_t bucket) const { return heads_[bucket]; }
  std::uint32_t used() const { return used_; }  ///< records now
  std::uint32_t peak() const { return peak_; }  ///< most records at once

 private:
  std::uint32_t allocate();
  void release(std::uint32_t at);
  void link(std::uint32_t bucket, std::uint32_t at);
  void unlink(std::uint32_t bucket, std::uint32_t at);
  void close_gap(std::uint32_t before, std::uint32_t at, std::uint32_t line);

  std::vector<std::uint32_t> heads_;
  std::vector<Record> records_;
  std::vector<Line> lines_;
  std::uint32_t capacity_ = 0, lines_per_record_ = 3;
  std::uint32_t free_ = kNone;  // released records, linked by `next`
  std::uint32_t used_ = 0, peak_ = 0;
};

}  // namespace kagesen::unit

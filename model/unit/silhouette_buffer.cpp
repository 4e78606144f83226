#include "model/unit/silhouette_buffer.h"

#include <algorithm>

namespace kagesen::unit {

void SilhouetteBuffer::clear(std::uint32_t buckets, std::uint32_t capacity,
                             std::uint32_t lines_per_record) {
  heads_.assign(buckets, kNone);
  records_.clear();
  lines_.clear();
  capacity_ = capacity;
  lines_per_record_ = lines_per_record;
  free_ = kNone;
  used_ = peak_ = 0;
}

std::uint32_t SilhouetteBuffer::allocate() {
  if (used_ == capacity_) return kNone;
  std::uint32_t at = free_;
  if (at != kNone) {
    free_ = records_[at].next;
    records_[at] = Record{};
  } else {
    at = static_cast<std::uint32_t>(records_.size());
    records_.emplace_back();
    lines_.resize(lines_.size() + lines_per_record_);
  }
  records_[at].next = records_[at].more = kNone;
  peak_ = std::max(peak_, ++used_);
  return at;
}

void SilhouetteBuffer::release(std::uint32_t at) {
  records_[at].next = free_;
  free_ = at;
  --used_;
}

void SilhouetteBuffer::link(std::uint32_t bucket, std::uint32_t at) {
  const Record& entry = records_[at];
  std::uint32_t* place = &heads_[bucket];
  std::uint32_t* behind_last = nullptr;
  for (; *place != kNone; place = &records_[*place].next) {
    const Record& other = records_[*place];
    if (other.texel != entry.texel) continue;
    if (other.nearest > entry.nearest) break;
    behind_last = &records_[*place].next;
  }
  if (*place == kNone) {
    // A texel's first one behind the bucket's first.
    std::uint32_t& head = heads_[bucket];
    place = behind_last != nullptr ? behind_last : head != kNone ? &records_[head].next : &head;
  }
  records_[at].next = *place;
  *place = at;
}

void SilhouetteBuffer::unlink(std::uint32_t bucket, std::uint32_t at) {
  std::uint32_t* place = &heads_[bucket];
  while (*place != at) place = &records_[*place].next;
  *place = records_[at].next;
}

std::uint32_t SilhouetteBuffer::insert(std::uint32_t bucket, std::uint32_t texel,
                                       std::uint32_t object, std::uint32_t nearest) {
  const std::uint32_t at = allocate();
  if (at == kNone) return kNone;
  records_[at].texel = texel;
  records_[at].object = object;
  records_[at].nearest = nearest;
  link(bucket, at);
  return at;
}

void SilhouetteBuffer::erase(std::uint32_t bucket, std::uint32_t entry) {
  unlink(bucket, entry);
  for (std::uint32_t at = entry; at != kNone;) {
    const std::uint32_t more = records_[at].more;
    release(at);
    at = more;
  }
}

void SilhouetteBuffer::set_nearest(std::uint32_t bucket, std::uint32_t entry,
                                   std::uint32_t nearest) {
  const std::uint32_t behind = next_of(entry);
  const bool stays = first_of(bucket, records_[entry].texel) == entry &&
                     (behind == kNone || nearest <= records_[behind].nearest);
  if (stays) {
    records_[entry].nearest = nearest;
    return;
  }
  unlink(bucket, entry);
  records_[entry].nearest = nearest;
  link(bucket, entry);
}

bool SilhouetteBuffer::append(std::uint32_t entry, const Line& line) {
  std::uint32_t at = entry;
  while (records_[at].lines == lines_per_record_) {
    if (records_[at].more == kNone) {
      const std::uint32_t more = allocate();
      if (more == kNone) return false;
      records_[more].texel = records_[entry].texel;
      records_[more].object = records_[entry].object;
      records_[at].more = more;
    }
    at = records_[at].more;
  }
  lines_[std::size_t{at} * lines_per_record_ + records_[at].lines++] = line;
  return true;
}

/// @param before  the record that links to `at`, kNone if `at` is the entry itself
void SilhouetteBuffer::close_gap(std::uint32_t before, std::uint32_t at, std::uint32_t line) {
  for (;;) {
    Line* lines = &lines_[std::size_t{at} * lines_per_record_];
    std::copy(lines + line + 1, lines + records_[at].lines, lines + line);
    const std::uint32_t more = records_[at].more;
    if (more == kNone) break;
    lines[lines_per_record_ - 1] = lines_[std::size_t{more} * lines_per_record_];
    before = at;
    at = more;
    line = 0;
  }
  if (--records_[at].lines == 0 && before != kNone) {
    records_[before].more = kNone;
    release(at);
  }
}

void SilhouetteBuffer::copy_lines(std::uint32_t entry, std::vector<Line>& out) const {
  out.clear();
  for (std::uint32_t at = entry; at != kNone; at = records_[at].more) {
    out.insert(out.end(), lines_of(at), lines_of(at) + records_[at].lines);
  }
}

std::uint32_t SilhouetteBuffer::chain_length(std::uint32_t bucket, std::uint32_t texel) const {
  std::uint32_t length = 0;
  for (std::uint32_t at = first_of(bucket, texel); at != kNone; at = next_of(at)) {
    for (std::uint32_t r = at; r != kNone; r = records_[r].more) ++length;
  }
  return length;
}

}  // namespace kagesen::unit

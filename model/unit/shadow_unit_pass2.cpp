#include "model/unit/address_generator.h"
#include "model/unit/shadow_unit.h"

namespace kagesen::unit {

void ShadowUnit::decide(const Fragment* fragments, std::size_t count, Verdict* verdicts) {
  Tally tally;
  for (std::size_t i = 0; i < count; ++i) verdicts[i] = decide_one(fragments[i], tally, nullptr);
  this->count(tally, count);
}

Verdict ShadowUnit::decide(const Fragment& fragment, FragmentTrail& trail) {
  Tally tally;
  const Verdict verdict = decide_one(fragment, tally, &trail);
  count(tally, 1);
  return verdict;
}

void ShadowUnit::count(const Tally& tally, std::size_t fragments) {
  counters_.fragments += fragments;
  counters_.averted += tally.averted;
  counters_.outside += tally.outside;
  counters_.dark_by_buffer += tally.dark_by_buffer;
  counters_.dark_by_lines += tally.dark_by_lines;
  counters_.lit +=
      fragments - tally.averted - tally.outside - tally.dark_by_buffer - tally.dark_by_lines;
}

/// Table 4. A source (the shadow buffer, or an entry) of the fragment's own ID is passed over, or,
/// as printed, decides "lit" at once when it is the ID buffer's.
inline Verdict ShadowUnit::decide_one(const Fragment& fragment, Tally& tally,
                                      FragmentTrail* trail) {
  const std::int32_t x = (fragment.position.x >> bits_) + centre_x_;
  const std::int32_t y = (fragment.position.y >> bits_) + centre_y_;
  if ((fragment.flags & (Fragment::kAverted | Fragment::kOutside)) != 0 || !texels_.holds(x, y)) {
    const bool averted = (fragment.flags & Fragment::kAverted) != 0;
    ++(averted ? tally.averted : tally.outside);
    return averted ? Verdict::kDark : Verdict::kLit;
  }
  if (trail != nullptr) {
    trail->reads_texel = true;
    trail->x = static_cast<std::uint32_t>(x);
    trail->y = static_cast<std::uint32_t>(y);
  }
  const std::uint32_t index = texels_.index(x, y);
  const Texel texel = texels_[index];
  const std::uint32_t depth = fragment.position.z >> depth_shift_;
  const std::uint32_t object = unit_id(fragment.object);
  const bool own = texel.id() == object;
  if (!own && depth > texel.depth) {
    ++tally.dark_by_buffer;
    return Verdict::kDark;
  }
  if (!texel.edge() || (own && config_.own_id_rule == OwnIdRule::kLiteral)) return Verdict::kLit;
  const std::int64_t mask = (std::int64_t{1} << bits_) - 1;
  const SubTexel point{(fragment.position.x & mask) >> position_shift_,
                       (fragment.position.y & mask) >> position_shift_, bits_ - position_shift_};
  const Verdict verdict = trail != nullptr
                              ? walk_chain(index, object, depth, point, *trail)
                              : decide_by_lines(index, object, depth, point);
  tally.dark_by_lines += verdict == Verdict::kDark;
  return verdict;
}

Verdict ShadowUnit::decide_by_lines(std::uint32_t texel, std::uint32_t object, std::uint32_t depth,
                                    const SubTexel& point) {
  ++counters_.slb_lookups;
  const std::uint32_t bucket = bucket_at(texel);
  for (std::uint32_t at = slb_.first_of(bucket, texel); at != SilhouetteBuffer::kNone;
       at = slb_.next_of(at)) {
    const Record& entry = slb_[at];
    if (depth <= entry.nearest) break;  // entries are linked from the light outwards
    ++counters_.entries_read;
    if (entry.object == object) continue;
    bool inside;
    if (entry.more == SilhouetteBuffer::kNone) {
      counters_.lines_read += entry.lines;
      inside = decision_.inside(slb_.lines_of(at), entry.lines, entry.vertex, point);
    } else {
      Combination& combination = combination_of(at);
      counters_.lines_read += combination.lines().size();
      inside = combination.inside(decision_, point);
    }
    if (inside) return Verdict::kDark;
  }
  return Verdict::kLit;
}

/// The same record by record, as shadow_lane.sv goes along the bucket's chain.
Verdict ShadowUnit::walk_chain(std::uint32_t texel, std::uint32_t object, std::uint32_t depth,
                               const SubTexel& point, FragmentTrail& trail) {
  ++counters_.slb_lookups;
  trail.bucket = bucket_at(texel);
  std::uint32_t number = 0;
  for (std::uint32_t at = slb_.head(trail.bucket); at != SilhouetteBuffer::kNone;
       at = slb_[at].next, ++number) {
    const Record& entry = slb_[at];
    const bool asks = entry.texel == texel && depth > entry.nearest;
    counters_.entries_read += asks;
    if (!asks || entry.object == object) {
      trail.places.push_back({number, 0});
      if (entry.texel == texel && !asks) break;  // entries are linked from the light outwards
      continue;
    }
    Combination& combination = combination_of(at);
    counters_.lines_read += combination.lines().size();
    const auto lines_per_record = static_cast<std::uint32_t>(config_.lines_per_entry);
    const bool inside =
        combination.walk(decision_, point, lines_per_record, [&](std::uint32_t record) {
          trail.places.push_back({number, record});
        });
    if (inside) return Verdict::kDark;
  }
  return Verdict::kLit;
}

Combination& ShadowUnit::combination_of(std::uint32_t entry) {
  const auto found = combinations_.find(entry);
  if (found != combinations_.end()) return found->second;
  std::vector<Line> lines;
  slb_.copy_lines(entry, lines);
  return combinations_.emplace(entry, Combination(decision_, std::move(lines), slb_[entry].vertex))
      .first->second;
}

}  // namespace kagesen::unit

#include "model/reference/cause.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "model/unit/edge_walker.h"

namespace kagesen {
namespace {

using unit::Line;

Line as_line(const LineRecord& record) {
  Line line;
  line.fraction = static_cast<std::uint16_t>(record.fraction);
  line.slope = static_cast<std::uint16_t>(record.slope);
  line.polygon = record.polygon;
  line.flags = static_cast<std::uint8_t>(
      (record.left ? Line::kLeft : 0) | (record.cross ? Line::kCross : 0) |
      (record.x_major ? Line::kXMajor : 0) | (record.x_positive ? Line::kXPositive : 0) |
      (record.start_here ? Line::kStartHere : 0) | (record.end_here ? Line::kEndHere : 0));
  return line;
}

std::uint64_t word(const Line& line) {
  return std::uint64_t{line.fraction} << 24 | std::uint64_t{line.slope} << 8 | line.flags;
}

/// Is the point on the side of the exact line that the stored line claims as inside?
bool holds_exactly(const Line& line, const LightPoint& from, const LightPoint& to,
                   const LightPoint& p) {
  const std::int64_t turn = (std::int64_t{to.x} - from.x) * (std::int64_t{p.y} - from.y) -
                            (std::int64_t{to.y} - from.y) * (std::int64_t{p.x} - from.x);
  return line.has(Line::kLeft) ? turn <= 0 : turn >= 0;
}

}  // namespace

CauseFinder::CauseFinder(const Trace& trace, const UnitConfig& config, const FrameSetup& setup,
                         const MapContents& contents, const ExactReference& reference)
    : trace_(trace),
      config_(config),
      setup_(setup),
      contents_(contents),
      reference_(reference),
      decision_(config),
      objects_of_id_() {
  if (setup.unit_ids.empty()) return;
  objects_of_id_.resize(std::size_t{1} << config.id_bits);
  for (std::uint32_t object = 0; object < setup.unit_ids.size(); ++object) {
    objects_of_id_[setup.unit_ids[object]].push_back(object);
  }
}

std::uint32_t CauseFinder::unit_id(std::uint32_t object) const {
  return object < setup_.unit_ids.size() ? setup_.unit_ids[object]
                                         : object & ((1u << config_.id_bits) - 1);
}

std::pair<const TexelEntry*, const TexelEntry*> CauseFinder::entries_at(std::uint32_t texel) const {
  const auto index = [this](const TexelEntry& e) {
    return e.texel_y * contents_.width + e.texel_x;
  };
  const TexelEntry* begin = contents_.entries.data();
  const TexelEntry* end = begin + contents_.entries.size();
  const TexelEntry* first = std::lower_bound(
      begin, end, texel, [&](const TexelEntry& e, std::uint32_t t) { return index(e) < t; });
  const TexelEntry* last = first;
  while (last != end && index(*last) == texel) ++last;
  return {first, last};
}

const TexelEntry* CauseFinder::entry_of(const Place& at, std::uint32_t id) const {
  const auto [first, last] = entries_at(at.index);
  const TexelEntry* found =
      std::find_if(first, last, [&](const TexelEntry& e) { return e.object == id; });
  return found == last ? nullptr : found;
}

unit::Combination& CauseFinder::combination_of(const TexelEntry& entry) const {
  const auto found = combinations_.find(&entry);
  if (found != combinations_.end()) return found->second;
  std::vector<Line> lines;
  for (const LineRecord& record : entry.lines) lines.push_back(as_line(record));
  unit::Combination made(decision_, std::move(lines), entry.vertex);
  return combinations_.emplace(&entry, std::move(made)).first->second;
}

bool CauseFinder::covered(const Fragment& f, std::uint32_t id) const {
  if (objects_of_id_.empty()) return reference_.covered_by(f.position.x, f.position.y, id);
  const std::vector<std::uint32_t>& objects = objects_of_id_[id];
  return std::any_of(objects.begin(), objects.end(), [&](std::uint32_t object) {
    return reference_.covered_by(f.position.x, f.position.y, object);
  });
}

Cause CauseFinder::find(const Fragment& f, bool exact_dark) const {
  const int bits = static_cast<int>(setup_.fraction_bits);
  Place at;
  at.x = (f.position.x >> bits) + static_cast<std::int32_t>(contents_.width / 2);
  at.y = (f.position.y >> bits) + static_cast<std::int32_t>(contents_.height / 2);
  at.index = static_cast<std::uint32_t>(at.y) * contents_.width + static_cast<std::uint32_t>(at.x);
  at.depth = f.position.z >> (kDepthBits - config_.depth_bits);
  at.id = unit_id(f.object);
  const int kept = config_.position_bits == 0
                       ? bits
                       : std::clamp(static_cast<int>(config_.position_bits),
                                    static_cast<int>(config_.fraction_bits), bits);
  const std::int64_t mask = (std::int64_t{1} << bits) - 1;
  at.point = {(f.position.x & mask) >> (bits - kept), (f.position.y & mask) >> (bits - kept), kept};
  if (contents_.overflowed[at.index]) return Cause::kCapacity;
  return exact_dark ? false_lit(f, at) : false_dark(f, at);
}

Cause CauseFinder::false_dark(const Fragment& f, const Place& at) const {
  const std::uint32_t id = contents_.object[at.index];
  if (id != at.id && at.depth > contents_.depth[at.index]) {
    // The buffers: this texel is said to be wholly covered.
    if (covered(f, id) || config_.depth_writes == DepthWrites::kAll) return Cause::kDepth;
    // It is not: some of its outline here must have cancelled by rounding.
    return outline_of(at, id).expected.empty() ? Cause::kOther : Cause::kCancelling;
  }
  const auto [first, last] = entries_at(at.index);
  for (const TexelEntry* e = first; e != last; ++e) {
    if (e->object == at.id || at.depth <= e->nearest ||
        !combination_of(*e).inside(decision_, at.point))
      continue;
    return covered(f, e->object) ? Cause::kDepth : outline(f, at, *e, false);
  }
  return Cause::kOther;  // no source said dark: the verdict is not this unit's
}

Cause CauseFinder::false_lit(const Fragment& f, const Place& at) const {
  if (config_.own_id_rule == OwnIdRule::kLiteral && contents_.object[at.index] == at.id)
    return Cause::kIdRule;
  std::vector<std::uint32_t> casters, objects;
  reference_.casters_in(f.position.x, f.position.y, f.position.x, f.position.y, casters);
  for (const std::uint32_t c : casters) objects.push_back(trace_.all_casters[c].object);
  std::sort(objects.begin(), objects.end());
  objects.erase(std::unique(objects.begin(), objects.end()), objects.end());
  Cause cause = Cause::kOther;
  for (const std::uint32_t object : objects) {
    if (object == f.object ||
        !reference_.covered_by(f.position.x, f.position.y, object, f.position.z))
      continue;
    // Of several missed objects the one that misses for an outline's sake tells the most.
    const Cause found = missed_object(f, at, object);
    if (cause == Cause::kOther || found < cause) cause = found;
  }
  return cause;
}

Cause CauseFinder::missed_object(const Fragment& f, const Place& at, std::uint32_t object) const {
  const std::uint32_t id = unit_id(object);
  if (id == at.id) return Cause::kIdRule;
  if (const TexelEntry* entry = entry_of(at, id)) {
    if (at.depth <= entry->nearest) return Cause::kDepth;
    return outline(f, at, *entry, true);
  }
  const std::uint32_t in_buffer = contents_.object[at.index];
  if (in_buffer == id) return Cause::kDepth;
  const Outline& outline = outline_of(at, id);
  if (!outline.expected.empty()) {
    return removed_as_hidden(at, outline) ? Cause::kHiddenRemoval : Cause::kCancelling;
  }
  // It covers the whole texel, and something nearer took its place in the buffers, or nothing did.
  if (in_buffer == kNoObject) return outline.crossed ? Cause::kCancelling : Cause::kOther;
  return in_buffer == at.id ? Cause::kIdRule : Cause::kDepth;
}

/// Lines may be gone as hidden only where what covers the texel is nearer than they are.
bool CauseFinder::removed_as_hidden(const Place& at, const Outline& outline) const {
  return config_.hidden_removal != HiddenRemoval::kOff &&
         std::any_of(outline.expected.begin(), outline.expected.end(), [&](const OutlineLine& l) {
           return contents_.depth[at.index] < l.nearest >> (kDepthBits - config_.depth_bits);
         });
}

void CauseFinder::find_outline(const Place& at, std::uint32_t id, Outline& out) const {
  const int bits = static_cast<int>(setup_.fraction_bits);
  const std::int32_t texel_x = at.x - static_cast<std::int32_t>(contents_.width / 2);
  const std::int32_t texel_y = at.y - static_cast<std::int32_t>(contents_.height / 2);
  const std::int32_t size = 1 << bits;
  const std::int32_t x0 = texel_x * size, y0 = texel_y * size;
  std::vector<std::uint32_t> casters;
  reference_.casters_in(x0, y0, x0 + size, y0 + size, casters);
  std::vector<OutlineLine> lines;
  for (const std::uint32_t index : casters) {
    Caster c = trace_.all_casters[index];
    if (unit_id(c.object) != id) continue;
    const std::int64_t area = (std::int64_t{c.vertex[1].x} - c.vertex[0].x) *
                                  (std::int64_t{c.vertex[2].y} - c.vertex[0].y) -
                              (std::int64_t{c.vertex[1].y} - c.vertex[0].y) *
                                  (std::int64_t{c.vertex[2].x} - c.vertex[0].x);
    if (area == 0) continue;
    for (int i = 0; i < 3; ++i) {
      LightPoint a = c.vertex[i], b = c.vertex[(i + 1) % 3];
      if (a.x == b.x && a.y == b.y) continue;
      if (b.y < a.y || (b.y == a.y && b.x < a.x)) std::swap(a, b);
      const auto edge =
          unit::setup_edge(a, b, c.vertex[(i + 2) % 3], bits, static_cast<int>(config_.slope_bits));
      for (unit::EdgeWalker walker(edge, bits, static_cast<int>(config_.fraction_bits));;
           walker.step()) {
        const unit::OutlineTexel texel = walker.texel();
        if (texel.x == texel_x && texel.y == texel_y) {
          lines.push_back({texel.line, a, b, texel.nearest});
          break;
        }
        if (walker.last()) break;
      }
    }
  }
  // Cancel by equal ends and opposite sides.
  const auto ends = [](const OutlineLine& l) {
    return std::tie(l.from.x, l.from.y, l.to.x, l.to.y);
  };
  out.crossed = !lines.empty();
  std::vector<OutlineLine>& kept = out.expected;
  for (const OutlineLine& line : lines) {
    const auto partner = std::find_if(kept.begin(), kept.end(), [&](const OutlineLine& other) {
      return ends(other) == ends(line) && other.line.has(Line::kLeft) != line.line.has(Line::kLeft);
    });
    if (partner != kept.end()) {
      kept.erase(partner);
    } else {
      kept.push_back(line);
    }
  }
}

const CauseFinder::Outline& CauseFinder::outline_of(const Place& at, std::uint32_t id) const {
  const auto [it, fresh] = outlines_.try_emplace(std::uint64_t{at.index} << 32 | id);
  Outline& out = it->second;
  if (!fresh) return out;
  find_outline(at, id, out);
  const TexelEntry* entry = entry_of(at, id);
  if (entry == nullptr || entry->lines.size() != out.expected.size()) return out;
  std::vector<OutlineLine> rest = out.expected;
  for (const LineRecord& record : entry->lines) {
    const std::uint64_t stored = word(as_line(record));
    const auto found = std::find_if(rest.begin(), rest.end(),
                                    [&](const OutlineLine& l) { return word(l.line) == stored; });
    if (found == rest.end()) return out;
    out.match.push_back(*found);
    rest.erase(found);
  }
  out.equal = true;
  return out;
}

Cause CauseFinder::outline(const Fragment& f, const Place& at, const TexelEntry& entry,
                           bool covered) const {
  const Outline& exact = outline_of(at, entry.object);
  if (!exact.equal) {
    const bool fewer = entry.lines.size() < exact.expected.size();
    return fewer && removed_as_hidden(at, exact) ? Cause::kHiddenRemoval : Cause::kCancelling;
  }
  unit::Combination& combination = combination_of(entry);
  const auto holds = [&](std::uint32_t i) {
    return holds_exactly(combination.lines()[i], exact.match[i].from, exact.match[i].to,
                         f.position);
  };
  if (combination.inside_if(holds) != covered) return Cause::kCombination;
  for (std::uint32_t i = 0; i < exact.match.size(); ++i) {
    const bool misled = decision_.contains(combination.lines()[i], at.point) != holds(i);
    if (misled && !within_bound(exact.match[i], f, at)) return Cause::kOther;
  }
  return Cause::kQuantisation;
}

/// Is the fragment no farther from the exact edge, along the minor axis, than rounding of the
/// stored fields may have moved the line? Half a unit of Fraction and of Slope, a whole one
/// where 1.0 saturated, and what was cut off Mx and My.
bool CauseFinder::within_bound(const OutlineLine& edge, const Fragment& f, const Place& at) const {
  const Line& line = edge.line;
  const double texel = std::ldexp(1.0, static_cast<int>(setup_.fraction_bits));
  const double mirror = line.has(Line::kXPositive) ? 1 : -1;
  const bool x_major = line.has(Line::kXMajor);
  const auto major = [&](const LightPoint& p) { return x_major ? mirror * p.x : double(p.y); };
  const auto minor = [&](const LightPoint& p) { return x_major ? double(p.y) : mirror * p.x; };
  const double slope = (minor(edge.to) - minor(edge.from)) / (major(edge.to) - major(edge.from));
  const double on_edge = minor(edge.from) + slope * (major(f.position) - major(edge.from));
  const double off = std::abs(minor(f.position) - on_edge) / texel;
  const auto rounding = [](std::uint32_t field, std::int64_t bits) {
    const bool largest = field + 1 == 1u << bits;
    return std::ldexp(largest ? 1.0 : 0.5, -static_cast<int>(bits));
  };
  const double cut = std::ldexp(1.0 + slope, -at.point.bits);
  return off <= rounding(line.fraction, config_.fraction_bits) +
                    rounding(line.slope, config_.slope_bits) + cut;
}

}  // namespace kagesen

#pragma once
/// The texel that a visit works on, as it was taken and as it becomes.
/// Twin: rtl/winding/list_texel.sv.
#include "model/unit/winding/plane.h"
#include "sim/systemc/winding/list_step.h"

namespace kagesen::tlm_model::winding {

class ListTexel : public TexelState {
 public:
  bool changed = false;

  void reset(const UnitConfig& config) {
    const unit::winding::Widths widths(config, kMaxFractionBits);
    base_bits_ = static_cast<unsigned>(widths.base_bits());
    code_bits_ = static_cast<unsigned>(widths.gradient_code_bits());
  }
  void load(const TexelState& texel, const ListVisit& visit) {
    TexelState::operator=(texel);
    bare = bare && kind == kList;
    changed = false;
    mark_ = mark_of(visit);
  }
  /// It has no cluster of the visit's plane.
  bool unmarked() const { return !covered && (marks & mark_) == 0; }

  /// Its plane is a cluster now, the list's first.
  void open(WordAddress record) {
    kind = kList;
    covered = changed = true;
    first = record;
  }
  /// A cluster of the visit's plane comes first.
  void insert(WordAddress record, bool is_bare) {
    if (kind == kEmpty) {
      covered = false;
      marks = mark_;
    } else if (!covered) {
      marks |= mark_;
    }
    bare = bare || is_bare;
    kind = kList;
    first = record;
    changed = true;
  }
  /// A cover: is it the nearest?
  void note(bool nearest) {
    covered = covered || nearest;
    changed = changed || nearest;
  }
  /// The cluster of the visit's plane has lost its last segment.
  void lay_bare() {
    changed = changed || !bare;
    bare = true;
  }
  void become(Kind now) {
    kind = now;
    changed = true;
  }

 private:
  /// The bits of a plane and its object, in groups of five.
  std::uint32_t mark_of(const ListVisit& visit) const {
    const auto low = [](std::uint64_t value, unsigned bits) {
      return value & ((std::uint64_t{1} << bits) - 1);
    };
    const unit::winding::Threshold& t = visit.texel.threshold;
    unsigned __int128 plane = low(static_cast<std::uint32_t>(t.base), base_bits_);
    plane = plane << code_bits_ | low(t.gradient_x, code_bits_);
    plane = plane << code_bits_ | low(t.gradient_y, code_bits_);
    unsigned number = 0;
    for (; plane != 0; plane >>= kMarkBits) number ^= static_cast<unsigned>(plane);
    for (std::uint32_t rest = visit.object; rest != 0; rest >>= kMarkBits) number ^= rest;
    return 1u << (number & ((1u << kMarkBits) - 1));
  }

  static constexpr unsigned kMarkBits = 5;  // a mark is one of 32
  unsigned base_bits_ = 0, code_bits_ = 0;  // of planes
  std::uint32_t mark_ = 0;                  // of the visit's plane
};

}  // namespace kagesen::tlm_model::winding

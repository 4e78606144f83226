#pragma once
/// Holds a unit's verdicts against the exact ones: how many are wrong, by how much, and why.
#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "model/engine.h"
#include "model/reference/reference.h"

namespace kagesen {

/// The semantics that a run's own verdicts are meant in, and in which it is held beside plain maps.
inline Semantics main_semantics(const UnitConfig& config) {
  return config.profile == Profile::kWinding ? config.semantics : Semantics::kPaper;
}

/// Why a fragment is wrong. Exactly one holds for each; kOther is a bug until explained. The
/// winding profile knows kQuantisation, kDepth, kCapacity and kOther (winding_cause.h).
enum class Cause : std::uint8_t {
  kNone,
  kQuantisation,   ///< right with the unrounded lines in place of the stored ones
  kIdRule,         ///< a source was passed over, or hidden in the buffers, because of its ID
  kDepth,          ///< inside the right outline, but the stored depth misleads
  kCombination,    ///< every line right, their AND/OR wrong
  kCancelling,     ///< lines that cancelled, or survived, by rounded equality
  kHiddenRemoval,  ///< lines removed as hidden that were not
  kCapacity,       ///< an overflowed texel
  kOther,
};
inline constexpr std::size_t kCauseCount = 9;
const char* cause_name(Cause cause);  ///< as in report.json: "quantisation", "id_rule", ...

struct ErrorFigures {
  std::uint64_t judged = 0;  ///< fragments that are neither averted nor outside the map's frustum
  std::uint64_t wrong = 0, false_lit = 0, false_dark = 0;
  std::uint64_t band = 0, band_wrong = 0;  ///< fragments within one texel of a true edge
  double displacement_mean = 0, displacement_p99 = 0,
         displacement_max = 0;       ///< texels, of wrong ones
  bool displacement_capped = false;  ///< some lie farther than the search went (8 texels)
  /// Wrong, farther than 2^-fraction_bits texel from a boundary, and clear of contact: in the paper
  /// profile by 4 depth units, in the winding profile by its contract (contact.h).
  std::uint64_t beyond_bound = 0;
  std::array<std::uint64_t, kCauseCount> causes{};
  double rate() const { return judged ? double(wrong) / double(judged) : 0; }
  double band_rate() const { return band ? double(band_wrong) / double(band) : 0; }
};

struct EquivalentResolution {
  std::uint64_t side = 0;  ///< of the smallest plain map with no more errors in the band
  bool at_least = false;   ///< true: even the largest side tried had more
};

/// A plain map of the same semantics on the same fragments. `bias`: depth units, in physical
/// semantics alone, where it is the constant with which the map errs least on this frame.
struct PlainFigures {
  std::uint64_t side = 0, bytes = 0, wrong = 0, band_wrong = 0, bias = 0;
};

/// One run of the unit over a frame.
struct UnitRun {
  const Engine& engine;                  ///< after its pass 2; its buffers tell the causes
  const std::vector<Verdict>& verdicts;  ///< a fragment each
};

/// `paper` is about the verdicts held against paper semantics, `physical` about those held against
/// physical semantics. They are the same in the paper profile; in the winding profile they are of
/// two runs, each set to its semantics.
struct Judgement {
  std::vector<std::uint8_t> exact_paper, exact_physical;  ///< a fragment each, 1 = dark
  std::vector<Cause> cause_paper, cause_physical;         ///< a fragment each
  ErrorFigures paper, physical;
  EquivalentResolution equivalent_resolution;        ///< main_semantics()
  EquivalentResolution other_equivalent_resolution;  ///< of the other semantics, where asked for
  PlainFigures plain_same_side, plain_equal_bytes;   ///< main_semantics()

  const ErrorFigures& figures_in(Semantics semantics) const {
    return semantics == Semantics::kPaper ? paper : physical;
  }
  const std::vector<Cause>& causes_in(Semantics semantics) const {
    return semantics == Semantics::kPaper ? cause_paper : cause_physical;
  }
};

/// What is exact about a frame whatever the unit's verdicts are. The first judgement that is given
/// it fills it; later ones, of the same trace and the same map, find it done.
struct ExactFrame {
  std::unique_ptr<const ExactReference> reference;  ///< null until filled; refers to the casters
  std::vector<std::uint8_t> paper, physical;        ///< a fragment each, 1 = dark
  std::vector<std::uint8_t> judged;                 ///< 1 = neither averted nor off the map
  std::vector<std::uint8_t> in_band_paper, in_band_physical;  ///< 1 = within a texel of an edge
};

struct JudgeOptions {
  std::uint64_t largest_plain_side = 1u << 18;
  bool equivalent_resolution = true;
  bool other_equivalent_resolution = false;  ///< in the other semantics too
  std::shared_ptr<ExactFrame> exact;         ///< may be empty
  std::function<void(const std::string& stage, double done)> progress;  ///< may be empty
};

/// @param paper, physical  what is held against each semantics; the same twice in the paper profile
Judgement judge(const Trace& trace, const UnitConfig& config, const FrameSetup& setup,
                const UnitRun& paper, const UnitRun& physical, const JudgeOptions& options = {});

}  // namespace kagesen

#include "model/reference/beside_plain.h"

#include <algorithm>
#include <cmath>

#include "model/rivals/plain_map.h"

namespace kagesen {
namespace {

constexpr std::size_t kBandSamples = 50000;

/// An even sample of the band.
std::vector<std::size_t> band_sample(const std::vector<std::uint8_t>& in_band) {
  std::vector<std::size_t> band, sample;
  for (std::size_t i = 0; i < in_band.size(); ++i) {
    if (in_band[i]) band.push_back(i);
  }
  const std::size_t stride = (band.size() + kBandSamples - 1) / kBandSamples;
  for (std::size_t n = 0; n < band.size(); n += stride) sample.push_back(band[n]);
  return sample;
}

/// A fragment as a plain map sees it.
struct Sample {
  std::int64_t lead;  ///< of the map's surface towards the light, depth units; none: 0
  bool dark;          ///< exactly
};

Sample seen(const DepthSample& in_map, const Fragment& f, bool dark) {
  return {in_map.hit() ? std::int64_t{f.position.z} - in_map.depth : 0, dark};
}

struct BestBias {
  std::uint32_t bias = 0;
  std::uint64_t wrong = 0;
};

/// Physical semantics, where a lead above the bias is dark: the least of the constants with which
/// the fewest verdicts are wrong. Without any bias surfaces shadow themselves, and the unit would
/// be held against a map that nobody would use.
BestBias best_bias(std::vector<Sample> samples) {
  std::sort(samples.begin(), samples.end(),
            [](const Sample& a, const Sample& b) { return a.lead < b.lead; });
  std::uint64_t wrong = 0;
  for (const Sample& s : samples) wrong += !s.dark;  // were all called dark
  BestBias best;
  std::size_t at = 0;
  for (std::int64_t bias = 0;; bias = samples[at].lead) {
    for (; at < samples.size() && samples[at].lead <= bias; ++at) {
      samples[at].dark ? ++wrong : --wrong;
    }
    if (bias == 0 || wrong < best.wrong) best = {static_cast<std::uint32_t>(bias), wrong};
    if (at == samples.size()) return best;
  }
}

double bytes_a_texel(const UnitConfig& config) {
  return double(config.depth_bits + config.id_bits) / 8;
}

}  // namespace

double grow_to_bytes(const UnitConfig& config, std::uint64_t bytes) {
  return std::sqrt(double(bytes) /
                   (bytes_a_texel(config) * double(config.map_width) * double(config.map_height)));
}

PlainFigures plain_map_figures(const PlainComparison& frame, double grow) {
  const UnitConfig& config = frame.config;
  const auto side_of = [grow](std::int64_t side) {
    return static_cast<std::uint32_t>(std::max(1.0, std::floor(double(side) * grow)));
  };
  const std::uint32_t width = side_of(config.map_width), height = side_of(config.map_height);
  PlainMap map(width, height, static_cast<std::uint32_t>(config.map_width),
               static_cast<std::uint32_t>(config.map_height), frame.setup.fraction_bits);
  for (const Caster& caster : frame.trace.all_casters) map.draw(caster);
  PlainFigures p;
  p.side = width;
  p.bytes = static_cast<std::uint64_t>(bytes_a_texel(config) * width * height);
  const std::vector<Fragment>& fragments = frame.trace.all_fragments;
  if (frame.semantics == Semantics::kPhysical) {
    std::vector<Sample> samples;
    for (std::size_t i = 0; i < fragments.size(); ++i) {
      if (frame.judged[i])
        samples.push_back(seen(map.sample(fragments[i]), fragments[i], frame.exact[i] != 0));
    }
    p.bias = best_bias(std::move(samples)).bias;
  }
  const auto bias = static_cast<std::uint32_t>(p.bias);
  for (std::size_t i = 0; i < fragments.size(); ++i) {
    if (!frame.judged[i]) continue;
    const bool dark = map.decide(fragments[i], frame.semantics, bias) == Verdict::kDark;
    if (dark == (frame.exact[i] != 0)) continue;
    ++p.wrong;
    p.band_wrong += frame.in_band[i];
  }
  return p;
}

EquivalentResolution equivalent_resolution(const PlainComparison& frame,
                                           const JudgeOptions& options) {
  const std::vector<std::size_t> sample = band_sample(frame.in_band);
  if (sample.empty()) return {1, false};  // any map is as good
  std::uint64_t allowed = 0;
  for (const std::size_t i : sample) {
    allowed += (frame.verdicts[i] == Verdict::kDark) != (frame.exact[i] != 0);
  }
  const auto good = [&](std::uint64_t side) {
    std::uint64_t wrong = 0;
    std::vector<Sample> samples;
    for (const std::size_t i : sample) {
      const Fragment& f = frame.trace.all_fragments[i];
      const DepthSample in_map = plain_map_sample(
          frame.reference, f, side, static_cast<std::uint32_t>(frame.config.map_width),
          static_cast<std::uint32_t>(frame.config.map_height), frame.setup.fraction_bits);
      if (frame.semantics == Semantics::kPhysical) {
        samples.push_back(seen(in_map, f, frame.exact[i] != 0));
        continue;
      }
      const Verdict v = PlainMap::decide(in_map, f, frame.semantics);
      wrong += (v == Verdict::kDark) != (frame.exact[i] != 0);
      if (wrong > allowed) return false;
    }
    return wrong + best_bias(std::move(samples)).wrong <= allowed;
  };
  std::uint64_t high = 1;
  while (high < options.largest_plain_side && !good(high)) {
    if (options.progress)
      options.progress("equivalent resolution", double(high) / double(options.largest_plain_side));
    high *= 2;
  }
  if (high >= options.largest_plain_side && !good(high)) return {high, true};
  std::uint64_t low = high / 2;
  for (int i = 0; i < 5 && high - low > 1; ++i) {
    const std::uint64_t middle = low + (high - low) / 2;
    (good(middle) ? high : low) = middle;
  }
  return {high, false};
}

}  // namespace kagesen

// SLB contents against the records of an independent implementation, field for field.
#include <gtest/gtest.h>

#include <map>
#include <string>
#include <tuple>

#include "tests/model/unit/frame.h"
#include "tests/model/vectors.h"

namespace kagesen {
namespace {

struct Vector {
  const char* scene;
  int scale, bits;
  std::size_t extra_entries;  ///< texels that only we hold
};

void PrintTo(const Vector& v, std::ostream* out) {
  *out << v.scene << " scale " << v.scale << " bits " << v.bits;
}

class SlbVectorFiles : public testing::TestWithParam<Vector> {};

using Key = std::tuple<std::uint32_t, std::uint32_t>;

std::map<Key, std::vector<TexelEntry>> by_texel(const std::vector<TexelEntry>& entries) {
  std::map<Key, std::vector<TexelEntry>> out;
  for (TexelEntry e : entries) {
    for (LineRecord& line : e.lines) line.start_here = false;  // the files do not have it
    out[{e.texel_y, e.texel_x}].push_back(e);
  }
  return out;
}

TEST_P(SlbVectorFiles, AgreeFieldForField) {
  const Vector vector = GetParam();
  const ExactVectors exact = read_exact_vectors(vector.scene, vector.scale);
  const auto expected = by_texel(read_slb_vectors(vector.scene, vector.scale, vector.bits).entries);
  UnitConfig config;
  config.fraction_bits = config.slope_bits = vector.bits;
  FrameSetup setup;
  setup.fraction_bits = exact.trace.header.fraction_bits;
  const Outcome out = run({exact.trace.all_casters, {}}, config, setup);
  const auto held = by_texel(out.contents.entries);

  std::size_t extra = 0, wrong = 0;
  for (const auto& [texel, entries] : held) {
    const auto it = expected.find(texel);
    if (it == expected.end()) {
      ++extra;
    } else {
      wrong += !(it->second == entries);
    }
  }
  EXPECT_EQ(wrong, 0u);
  EXPECT_EQ(extra, vector.extra_entries);
  EXPECT_EQ(held.size(), expected.size() + extra) << "texels are missing";
  EXPECT_EQ(out.counters.overflow_lines, 0u);
}

// An emptied entry whose corner no polygon covers is not marked covered here; the
// independent implementation marks it, which hides two texels of the torus at 4 bits.
INSTANTIATE_TEST_SUITE_P(Files, SlbVectorFiles,
                         testing::Values(Vector{"glyphs", 1, 4, 0}, Vector{"glyphs", 1, 8, 0},
                                         Vector{"glyphs", 16, 4, 0}, Vector{"glyphs", 16, 8, 0},
                                         Vector{"torus", 1, 4, 2}, Vector{"torus", 1, 8, 0},
                                         Vector{"torus", 16, 4, 0}, Vector{"torus", 16, 8, 0}));

}  // namespace
}  // namespace kagesen

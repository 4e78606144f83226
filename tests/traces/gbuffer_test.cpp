// Does a G-buffer give back the fragments it was made from, and a bad one a clear word?
#include "traces/raster/gbuffer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>

#include "tests/traces/raster_support.h"
#include "traces/raster/gbuffer_file.h"

namespace kagesen {
namespace {

class GBuffer : public testing::Test {
 protected:
  GBuffer() : scene_(make_builtin("solids")) {
    write_gbuffer(scene_, small_options(), directory_.file("good.exr"));
  }
  Trace read(const std::string& name) {
    Trace trace;
    capture_gbuffer(scene_, directory_.file(name), CaptureOptions{}, trace);
    return trace;
  }
  std::string error(const std::string& name) {
    return user_error([&] { read(name); });
  }
  GBufferFile good() const { return read_gbuffer_file(directory_.file("good.exr")); }

  const Scene scene_;
  const TemporaryDirectory directory_;
};

/// Compares by pixel, for the order differs: triangles there, tiles here.
/// @param least_shade  positions of darker fragments are not compared: their depth is steep
void expect_alike(const Trace& expected, const Trace& actual, double depth_slack,
                  int least_shade = 0) {
  std::map<std::pair<int, int>, Fragment> at;
  for (const Fragment& f : expected.all_fragments) at[{f.pixel_x, f.pixel_y}] = f;
  ASSERT_EQ(actual.all_fragments.size(), at.size());
  for (const Fragment& f : actual.all_fragments) {
    ASSERT_EQ(at.count({f.pixel_x, f.pixel_y}), 1u);
    const Fragment& e = at[{f.pixel_x, f.pixel_y}];
    ASSERT_EQ(f.object, e.object);
    ASSERT_EQ(f.flags & Fragment::kAverted, e.flags & Fragment::kAverted);
    ASSERT_EQ(f.flags & Fragment::kVisible, Fragment::kVisible);
    ASSERT_NEAR(f.shade, e.shade, 1);
    if (e.flags & Fragment::kOutside || e.shade < least_shade) continue;
    ASSERT_NEAR(f.position.x, e.position.x, 16);
    ASSERT_NEAR(f.position.y, e.position.y, 16);
    ASSERT_NEAR(double(f.position.z), double(e.position.z), depth_slack);
  }
}

TEST_F(GBuffer, RoundTrip) {
  const Trace expected = captured(scene_, small_options()), actual = read("good.exr");
  EXPECT_EQ(keys(expected.all_casters), keys(actual.all_casters));
  EXPECT_EQ(actual.header.image_width, 320u);
  EXPECT_EQ(actual.header.image_height, 180u);
  EXPECT_TRUE(actual.header.warnings.empty());
  expect_alike(expected, actual, 64);
}

TEST_F(GBuffer, PolygonAndNormalAreOptional) {
  GBufferFile file = good();
  file.polygon.clear();
  write_gbuffer_file(directory_.file("no_polygon.exr"), file);
  expect_alike(captured(scene_, small_options()), read("no_polygon.exr"), 64, 64);
  for (auto& axis : file.normal) axis.clear();
  write_gbuffer_file(directory_.file("bare.exr"), file);
  const Trace bare = read("bare.exr");
  EXPECT_EQ(bare.all_fragments.size(), captured(scene_, small_options()).all_fragments.size());
  for (const Fragment& f : bare.all_fragments) EXPECT_EQ(f.flags & Fragment::kAverted, 0);
}

TEST_F(GBuffer, BackgroundAndSpoiltPixelsAreLeftOut) {
  GBufferFile file = good();
  const float nan = std::numeric_limits<float>::quiet_NaN();
  std::size_t seen = 0;
  int spoilt = 0;
  for (std::size_t i = 0; i < file.id.size(); ++i) {
    if (file.id[i] < 0) continue;
    ++seen;
    if (spoilt == 0) file.position[1][i] = nan;
    if (spoilt == 1) file.position[2][i] = std::numeric_limits<float>::infinity();
    if (spoilt == 2) file.id[i] = 0.5f;
    if (spoilt == 3) file.id[i] = nan;
    if (spoilt == 4) file.id[i] = -7;
    ++spoilt;
  }
  write_gbuffer_file(directory_.file("spoilt.exr"), file);
  const Trace trace = read("spoilt.exr");
  EXPECT_EQ(trace.all_fragments.size(), seen - 5);
  ASSERT_EQ(trace.header.warnings.size(), 2u);
  EXPECT_EQ(trace.header.warnings[0], "left out 2 pixels whose position is not finite");
  EXPECT_EQ(trace.header.warnings[1], "left out 1 pixel whose ID is no whole number");
}

TEST_F(GBuffer, WildPolygonNumbersAreNotTrusted) {
  GBufferFile file = good();
  for (std::size_t i = 0; i < file.polygon.size(); ++i) {
    file.polygon[i] = i % 3 == 0 ? 1e9f : i % 3 == 1 ? 4.1e9f : 0.0f;
  }
  write_gbuffer_file(directory_.file("wild.exr"), file);
  expect_alike(captured(scene_, small_options()), read("wild.exr"), 64, 64);
}

TEST_F(GBuffer, AnIdBeyondTheSceneIsRefusedWithItsPixel) {
  GBufferFile file = good();
  file.id[320 * 5 + 7] = 99;
  write_gbuffer_file(directory_.file("id.exr"), file);
  const std::string what = error("id.exr");
  EXPECT_NE(what.find("id.exr: pixel 7, 5: object ID 99, but scene 'solids' has 9"),
            std::string::npos)
      << what;
}

TEST_F(GBuffer, MissingChannelsAreNamedAndTheFoundOnesListed) {
  GBufferFile file = good();
  file.id.clear();
  write_gbuffer_file(directory_.file("a.exr"), file);
  EXPECT_NE(error("a.exr").find("no id channel; found: "), std::string::npos);
  EXPECT_NE(error("a.exr").find("position.x"), std::string::npos);
  file = good();
  file.position[2].clear();
  write_gbuffer_file(directory_.file("b.exr"), file);
  EXPECT_NE(error("b.exr").find("no position.x/y/z (or P.X/Y/Z) channel"), std::string::npos);
}

TEST_F(GBuffer, BadFiles) {
  directory_.write("noise.exr", "this is no image");
  directory_.write("empty.exr", "");
  for (const char* name : {"noise.exr", "empty.exr", "gone.exr", "."}) {
    const std::string what = error(name);
    EXPECT_NE(what, "") << name;
    EXPECT_EQ(what.find('\n'), std::string::npos) << what;
  }
  std::ifstream in(directory_.file("good.exr"), std::ios::binary);
  const std::string bytes((std::istreambuf_iterator<char>(in)), {});
  for (const std::size_t size : {std::size_t{20}, std::size_t{400}, bytes.size() / 2}) {
    directory_.write("cut.exr", bytes.substr(0, size));
    EXPECT_NE(error("cut.exr"), "") << size;
  }
}

TEST_F(GBuffer, UnwritablePathLeavesNothingBehind) {
  const std::string what = user_error(
      [&] { write_gbuffer(scene_, small_options(), directory_.file("no/such/dir.exr")); });
  EXPECT_NE(what.find("cannot be written"), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(directory_.file("good.exr.part")));
}

}  // namespace
}  // namespace kagesen

#include "testbench/verilator/package.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

namespace kagesen {
namespace {

std::string file_text(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

/// The value that the package gives a parameter.
std::string parameter(const UnitConfig& config, const std::string& name) {
  const std::string text = shadow_package(config);
  std::size_t at = text.find("localparam int unsigned " + name + " ");
  if (at == std::string::npos) return "none";
  at = text.find_first_not_of(" =", text.find('=', at));
  return text.substr(at, text.find(';', at) - at);
}

UnitConfig with(Profile profile) {
  UnitConfig config;
  config.profile = profile;
  return config;
}

TEST(Package, CommittedOnesAreTheDefaultConfigurations) {
  const std::string rtl = KAGESEN_RTL_FOLDER;
  EXPECT_EQ(file_text(rtl + "/paper/shadow_pkg.sv"), shadow_package(with(Profile::kPaper)));
  EXPECT_EQ(file_text(rtl + "/winding/shadow_pkg.sv"), shadow_package(with(Profile::kWinding)));
}

TEST(Package, EveryBuildKeyReachesItsParameter) {
  const struct {
    Profile profile;
    const char *key, *value, *name, *expected;
  } cases[] = {
      {Profile::kPaper, "fraction_bits", "5", "FractionBits", "5"},
      {Profile::kPaper, "slope_bits", "4", "SlopeBits", "4"},
      {Profile::kPaper, "depth_bits", "16", "DepthBits", "16"},
      {Profile::kPaper, "id_bits", "9", "IdBits", "9"},
      {Profile::kPaper, "polygon_id_bits", "6", "PolygonBits", "6"},
      {Profile::kPaper, "position_bits", "12", "PositionBits", "12"},
      {Profile::kPaper, "position_bits", "3", "PositionBits", "8"},  // Fraction's bits at least
      {Profile::kPaper, "lines_per_entry", "7", "LinesPerRecord", "7"},
      {Profile::kPaper, "lanes", "2", "Lanes", "2"},
      {Profile::kPaper, "fragment_slots", "16", "FragmentsInFlight", "16"},
      {Profile::kPaper, "visit_fifo_depth", "8", "VisitFifoDepth", "8"},
      {Profile::kPaper, "texel_lines", "128", "TexelLines", "128"},
      {Profile::kPaper, "record_lines", "32", "RecordLines", "32"},
      {Profile::kPaper, "slb_entries", "600000", "RecordAddrBits", "20"},
      {Profile::kPaper, "map_width", "1025", "MapBits", "11"},
      {Profile::kPaper, "map_height", "4096", "MapBits", "12"},
      {Profile::kWinding, "fraction_bits", "12", "GradientBits", "10"},
      {Profile::kWinding, "fraction_bits", "10", "GradientBits", "9"},
      {Profile::kWinding, "gradient_bits", "3", "GradientBits", "7"},
      {Profile::kWinding, "end_guard_bits", "2", "EndGuardBits", "2"},
      {Profile::kWinding, "plane_step_bits", "0", "PlaneStepBits", "0"},
      {Profile::kWinding, "corner_bits", "3", "CornerBits", "3"},
      {Profile::kWinding, "segments_per_record", "5", "SegmentsPerRecord", "5"},
      {Profile::kWinding, "cluster_records", "16777216", "RecordAddrBits", "24"},
  };
  for (const auto& c : cases) {
    UnitConfig config = with(c.profile);
    set_field(config, c.key, c.value);
    EXPECT_EQ(parameter(config, c.name), c.expected) << c.key << "=" << c.value;
  }
}

TEST(Package, RegistersShareABuild) {
  for (const Profile profile : {Profile::kPaper, Profile::kWinding}) {
    const std::string text = shadow_package(with(profile));
    for (const auto& [key, value] :
         std::initializer_list<std::pair<const char*, const char*>>{{"slb_entries", "5"},
                                                                    {"slb_buckets", "1"},
                                                                    {"link_depth", "2"},
                                                                    {"cluster_records", "9"},
                                                                    {"chain_records", "3"},
                                                                    {"map_width", "1"},
                                                                    {"hidden_removal", "off"},
                                                                    {"own_id_rule", "literal"},
                                                                    {"semantics", "paper"},
                                                                    {"skip_tiles", "false"},
                                                                    {"plane_tolerance", "0"},
                                                                    {"memory_latency", "3"}}) {
      UnitConfig config = with(profile);
      set_field(config, key, value);
      EXPECT_EQ(shadow_package(config), text) << key;
    }
  }
}

TEST(Package, EveryBuildHasOneProfilesSources) {
  for (const SourceText& source : rtl_sources(Profile::kPaper)) {
    EXPECT_EQ(source.path.find("rtl/winding"), std::string::npos) << source.path;
    EXPECT_EQ(source.path.find("shadow_pkg"), std::string::npos) << source.path;
  }
  EXPECT_EQ(file_text(std::string(KAGESEN_RTL_FOLDER) + "/common/fifo.sv"),
            embedded_source("rtl/common/fifo.sv"));
}

}  // namespace
}  // namespace kagesen

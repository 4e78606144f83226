#include "model/unit/config.h"

#include <gtest/gtest.h>

#include <string>

#include "traces/format/error.h"

namespace kagesen {
namespace {

std::string message(const std::string& key, const std::string& value) {
  UnitConfig config;
  try {
    set_field(config, key, value);
  } catch (const UserError& e) {
    return e.what();
  }
  return "accepted";
}

TEST(Config, TheWindingProfileTakesUpToTwelveFractionBits) {
  UnitConfig config;
  config.fraction_bits = 13;
  EXPECT_NO_THROW(check_fields(config));
  config.profile = Profile::kWinding;
  EXPECT_THROW(check_fields(config), UserError);
  config.fraction_bits = 12;
  EXPECT_NO_THROW(check_fields(config));
}

TEST(Config, EveryKeyGoesThereAndBackAndTouchesNoOther) {
  ASSERT_EQ(config_fields().size(), 55u);
  for (const ConfigField& field : config_fields()) {
    EXPECT_FALSE(field.help.empty()) << field.key;
    std::vector<std::string> values = field.choices;
    if (values.empty()) values = {std::to_string(field.minimum), std::to_string(field.maximum)};
    for (const std::string& value : values) {
      UnitConfig config;
      set_field(config, field.key, value);
      EXPECT_EQ(get_field(config, field.key), value) << field.key;
      for (const ConfigField& other : config_fields()) {
        if (other.key == field.key) continue;
        EXPECT_EQ(get_field(config, other.key), get_field(UnitConfig{}, other.key))
            << field.key << " changed " << other.key;
      }
    }
  }
}

TEST(Config, KeysReachTheirMembers) {
  UnitConfig c;
  set_field(c, "map_width", "7");
  set_field(c, "map_height", "9");
  set_field(c, "slope_bits", "3");
  set_field(c, "fraction_bits", "5");
  set_field(c, "own_id_rule", "literal");
  set_field(c, "vertex_rule", "per_entry");
  set_field(c, "table7", "printed");
  set_field(c, "depth_writes", "all");
  set_field(c, "hidden_removal", "farthest");
  set_field(c, "match_polygon_id", "false");
  EXPECT_EQ(c.map_width, 7);
  EXPECT_EQ(c.map_height, 9);
  EXPECT_EQ(c.slope_bits, 3);
  EXPECT_EQ(c.fraction_bits, 5);
  EXPECT_EQ(c.own_id_rule, OwnIdRule::kLiteral);
  EXPECT_EQ(c.vertex_rule, VertexRule::kPerEntry);
  EXPECT_EQ(c.table7, Table7::kPrinted);
  EXPECT_EQ(c.depth_writes, DepthWrites::kAll);
  EXPECT_EQ(c.hidden_removal, HiddenRemoval::kFarthest);
  EXPECT_FALSE(c.match_polygon_id);
}

TEST(Config, DefaultsLieWithinTheirLimits) {
  for (const ConfigField& field : config_fields()) {
    const std::string value = get_field(UnitConfig{}, field.key);
    EXPECT_EQ(message(field.key, value), "accepted") << field.key;
  }
}

TEST(Config, RefusesWhatIsOutOfRangeAndNamesTheNearestValue) {
  for (const ConfigField& field : config_fields()) {
    if (!field.choices.empty()) continue;
    const std::string below = message(field.key, std::to_string(field.minimum - 1));
    const std::string above = message(field.key, std::to_string(field.maximum + 1));
    EXPECT_NE(below.find("valid value is " + std::to_string(field.minimum)), std::string::npos)
        << below;
    EXPECT_NE(above.find("valid value is " + std::to_string(field.maximum)), std::string::npos)
        << above;
    EXPECT_EQ(below.find(field.key), 0u) << below;
  }
}

TEST(Config, RefusesWhatIsNoPowerOfTwo) {
  EXPECT_NE(message("slb_buckets", "17").find("is 16"), std::string::npos);
  EXPECT_NE(message("slb_buckets", "31").find("is 32"), std::string::npos);
  EXPECT_NE(message("slb_buckets", "4194305").find("is 4194304"), std::string::npos);
  EXPECT_EQ(message("slb_buckets", "64"), "accepted");
}

TEST(Config, NamesTheNearestKeyAndTheNearestChoice) {
  EXPECT_NE(message("slop_bits", "8").find("'slope_bits'"), std::string::npos);
  EXPECT_NE(message("hiden_removal", "off").find("'hidden_removal'"), std::string::npos);
  EXPECT_NE(message("hidden_removal", "center").find("'centre'"), std::string::npos);
  EXPECT_NE(message("match_polygon_id", "tru").find("'true'"), std::string::npos);
  EXPECT_THROW(get_field(UnitConfig{}, "nothing"), UserError);
}

TEST(Config, RefusesWhatIsNoInteger) {
  for (const char* text : {"", "x", "8x", "8.5", "0x8", "99999999999999999999"}) {
    EXPECT_NE(message("slope_bits", text).find("give one from 1 to 15"), std::string::npos) << text;
  }
  EXPECT_NE(message("map_width", "-1").find("is 1"), std::string::npos);
}

TEST(Config, ARefusedValueChangesNothing) {
  UnitConfig config;
  EXPECT_THROW(set_field(config, "slope_bits", "99"), UserError);
  EXPECT_THROW(set_field(config, "table7", "both"), UserError);
  EXPECT_EQ(config.slope_bits, UnitConfig{}.slope_bits);
  EXPECT_EQ(config.table7, UnitConfig{}.table7);
}

}  // namespace
}  // namespace kagesen

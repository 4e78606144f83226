/// The parts of a report on hand-made results.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "sim/report/font.h"
#include "sim/report/json.h"
#include "sim/report/outputs.h"
#include "sim/report/pictures.h"
#include "sim/report/table.h"
#include "sim/report/verdicts.h"
#include "tests/sim/tiny_run.h"
#include "traces/format/error.h"

namespace kagesen {
namespace {

namespace fs = std::filesystem;

class OutputsTest : public ::testing::Test {
 protected:
  void SetUp() override {
    std::string name = (fs::temp_directory_path() / "kagesen-report-XXXXXX").string();
    ASSERT_NE(mkdtemp(name.data()), nullptr);
    folder_ = name;
  }
  void TearDown() override { fs::remove_all(folder_); }
  std::string path(const char* name) const { return (folder_ / name).string(); }
  fs::path folder_;
};

TEST_F(OutputsTest, NothingUntilCommit) {
  {
    Outputs outputs;
    outputs.make_folder(path("x/y"));
    outputs.open(path("x/y/a")) << "text";
    outputs.write(path("b"), "bytes");
    EXPECT_FALSE(fs::exists(path("x/y/a")));
    EXPECT_FALSE(fs::exists(path("b")));
  }
  EXPECT_TRUE(fs::is_empty(folder_));  // parts and folders went with it
}

TEST_F(OutputsTest, CommitReplaces) {
  std::ofstream(path("b")) << "old and longer";
  Outputs outputs;
  outputs.make_folder(path("x"));
  outputs.open(path("x/a")) << std::string(200000, 'z');
  outputs.write(path("b"), "new");
  outputs.commit();
  EXPECT_EQ(fs::file_size(path("x/a")), 200000u);
  EXPECT_EQ(fs::file_size(path("b")), 3u);
  EXPECT_FALSE(fs::exists(path("b.part")));
  EXPECT_EQ(outputs.names(), (std::vector<std::string>{path("x/a"), path("b")}));
}

TEST_F(OutputsTest, KeepsFoldersThatWereThere) {
  fs::create_directory(path("x"));
  { Outputs().make_folder(path("x/y")); }
  EXPECT_TRUE(fs::exists(path("x")));
  EXPECT_FALSE(fs::exists(path("x/y")));
}

TEST_F(OutputsTest, RefusesFoldersAndFullDevices) {
  Outputs outputs;
  EXPECT_THROW(outputs.open(folder_.string()), UserError);
  EXPECT_THROW(outputs.open(path("none/a")), UserError);
  EXPECT_THROW(outputs.write("/dev/full", "x"), UserError);
  EXPECT_TRUE(fs::exists("/dev/full"));
}

TEST_F(OutputsTest, RefusesOneFileTwice) {
  fs::create_directory(path("x"));
  fs::create_directory_symlink(path("x"), path("link"));
  Outputs outputs;
  outputs.reserve(path("x/picture"), "--out");
  outputs.open(path("x/a"), "--out");
  EXPECT_THROW(outputs.open(path("x/a"), "--out"), UserError);
  EXPECT_THROW(outputs.open(path("x/../x/./a"), "--json"), UserError);
  EXPECT_THROW(outputs.open(path("link/a"), "--json"), UserError);
  EXPECT_THROW(outputs.open(path("x/picture"), "--json"), UserError);
  EXPECT_NO_THROW(outputs.open(path("x/picture"), "--out"));
  EXPECT_NO_THROW(outputs.open("/dev/null", "--json"));
  EXPECT_NO_THROW(outputs.open("/dev/null", "--verdicts"));
}

TEST_F(OutputsTest, CommitThatFailsHalfWayLeavesNoNewFile) {
  std::ofstream(path("old")) << "old";
  {
    Outputs outputs;
    outputs.write(path("new"), "text");
    outputs.write(path("old"), "text");
    outputs.write(path("refused"), "text");
    fs::create_directory(path("refused"));
    EXPECT_THROW(outputs.commit(), UserError);
  }
  EXPECT_FALSE(fs::exists(path("new")));
  EXPECT_TRUE(fs::exists(path("old")));
  EXPECT_FALSE(fs::exists(path("refused.part")));
}

TEST(Json, LeavesOutWhatIsUnknown) {
  Tiny tiny;
  EXPECT_FALSE(report_json(tiny.trace, tiny.result).contains("error"));
  tiny.judge();
  const auto json = report_json(tiny.trace, tiny.result);
  EXPECT_FALSE(json["error"].contains("equivalent_resolution"));
  EXPECT_FALSE(json["error"].contains("plain"));
  EXPECT_TRUE(json["error"]["paper"].contains("displacement_texels"));
  EXPECT_EQ(json["error"]["physical"]["displacement_texels"]["max"], 0);
  EXPECT_EQ(json["verdict"]["dark"], 4);
  EXPECT_EQ(json["input"]["triangles"], 14);
  EXPECT_EQ(json["input"]["closed_objects"], 1);
  EXPECT_EQ(json["input"]["objects_drawn"]["light_facing"], 1);
  EXPECT_EQ(json["input"]["objects_drawn"]["all"], 0);
  EXPECT_EQ(json["input"]["objects_drawn"]["receivers"], 1);
  EXPECT_FALSE(json.contains("skips"));
  EXPECT_TRUE(json["config"]["match_polygon_id"].is_boolean());
  EXPECT_TRUE(json["config"]["slope_bits"].is_number_integer());
}

TEST(Pictures, MaskAndColours) {
  Tiny tiny;
  EXPECT_EQ(mask_values(tiny.trace, tiny.result.verdicts),
            (std::vector<std::uint8_t>{128, 255, 255, 255, 0, 0, 0, 0}));
  const Canvas shaded = shaded_picture(tiny.trace, tiny.result.verdicts);
  EXPECT_EQ(shaded.width(), 4);
  EXPECT_EQ(shaded.height(), 2);
  EXPECT_GT(shaded.get(1, 0).r, shaded.get(0, 1).r);
  tiny.judge();
  const Canvas errors = error_picture(tiny.trace, tiny.result, /*legend=*/false);
  EXPECT_EQ(errors.height(), 2);
  EXPECT_NE(errors.get(3, 1).r, errors.get(3, 1).b);  // coloured
  EXPECT_EQ(errors.get(0, 1).r, errors.get(0, 1).b);  // grey
}

TEST(Pictures, SmallMapsAreEnlarged) {
  const Tiny tiny;
  const Canvas lines = lines_picture(tiny.result);
  EXPECT_EQ(lines.width(), 512);
  const Rgb with_lines = lines.get(300, 10), depth_only = lines.get(10, 10);
  EXPECT_GT(with_lines.r, with_lines.b);
  EXPECT_LE(depth_only.r, depth_only.b);
}

TEST(Pictures, FontHasEveryLetterOfALegend) {
  for (const char letter : std::string("abcdefghijklmnopqrstuvwxyzABCXYZ0123456789.,:+-/%()=<>_")) {
    int set = 0;
    for (int row = 0; row < kGlyphHeight; ++row) {
      for (int column = 0; column < kGlyphWidth; ++column) set += glyph_bit(letter, column, row);
    }
    EXPECT_GT(set, 0) << letter;
  }
  EXPECT_FALSE(glyph_bit(' ', 0, 0));
}

TEST(Verdicts, OneLineAFragment) {
  Tiny tiny;
  tiny.judge();
  std::ostringstream text;
  write_verdicts(tiny.trace, tiny.result, text);
  EXPECT_NE(text.str().find("\n0 1 0 0 0 0 none none\n"), std::string::npos) << text.str();
  EXPECT_NE(text.str().find("\n6 3 1 1 0 0 quantisation none\n"), std::string::npos) << text.str();
}

TEST(Table, Numbers) {
  EXPECT_EQ(grouped(0), "0");
  EXPECT_EQ(grouped(999), "999");
  EXPECT_EQ(grouped(1000), "1,000");
  EXPECT_EQ(grouped(1234567), "1,234,567");
  EXPECT_EQ(bytes_text(1023), "1023 B");
  EXPECT_EQ(bytes_text(32154), "31.4 KiB");
  EXPECT_EQ(bytes_text(4u << 20), "4.0 MiB");
  EXPECT_EQ(one_in(0, 10), "none");
  EXPECT_EQ(one_in(62, 640604), "1 in 10,332");
  EXPECT_EQ(one_in(5, 100), "1 in 20");
  EXPECT_EQ(one_in(6, 100), "6.0 %");
  EXPECT_EQ(one_in(3, 8), "37.5 %");
  EXPECT_EQ(counted(1, "texel"), "1 texel");
  EXPECT_EQ(counted(0, "texel"), "0 texels");
  EXPECT_EQ(counted(1234, "texel"), "1,234 texels");
}

TEST(Table, MarksWhatLiesBeyondTheSearch) {
  Tiny tiny;
  tiny.judge();
  ErrorFigures& paper = tiny.result.judgement->paper;
  paper.displacement_mean = 2;
  paper.displacement_p99 = paper.displacement_max = 8;
  EXPECT_NE(report_table(tiny.trace, tiny.result, {}).find("2.0000 / 8.0000 / 8.0000"),
            std::string::npos);
  paper.displacement_capped = true;
  EXPECT_NE(report_table(tiny.trace, tiny.result, {}).find("2.0000 / >8.0000 / >8.0000"),
            std::string::npos);
}

}  // namespace
}  // namespace kagesen

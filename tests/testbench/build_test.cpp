#include "testbench/verilator/build.h"

#include <dlfcn.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "traces/format/error.h"

namespace kagesen {
namespace {

namespace fs = std::filesystem;

/// Adds and asserts, on a clock.
BuildRecipe tiny(const std::string& sum) {
  BuildRecipe recipe;
  recipe.top = "tiny";
  recipe.sources = {{"rtl/adder.sv",
                     "module adder(input logic [6:0] a_i, output logic [6:0] b_o);\n"
                     "  assign b_o = " +
                         sum + ";\nendmodule\n"},
                    {"rtl/tiny.sv",
                     "module tiny(input logic [6:0] a_i, output logic [6:0] b_o);\n"
                     "  adder adder(.a_i, .b_o);\nendmodule\n"},
                    {"call.cpp",
                     "#include \"Vtiny.h\"\n#include \"port_widths.h\"\n"
                     "extern \"C\" __attribute__((visibility(\"default\"))) int call(int a) {\n"
                     "  Vtiny top;\n  top.a_i = a;\n  top.eval();\n"
                     "  return top.b_o + 1000 * kagesen::bench::widths::b_o;\n}\n"}};
  recipe.verilator = {"--no-assert"};
  recipe.compiler = {"-O1"};
  return recipe;
}

class Cache : public testing::Test {
 protected:
  void SetUp() override {
    folder = fs::temp_directory_path() / ("kagesen_build_test." + std::to_string(getpid()));
    fs::remove_all(folder);
  }
  void TearDown() override { fs::remove_all(folder); }
  fs::path folder;
};

TEST_F(Cache, BuildsOnceAndKnowsThePortsWidths) {
  const std::string first = built_object(tiny("a_i + 7'd5"), folder);
  void* library = dlopen(first.c_str(), RTLD_NOW | RTLD_LOCAL);
  ASSERT_NE(library, nullptr) << dlerror();
  const auto call = reinterpret_cast<int (*)(int)>(dlsym(library, "call"));
  ASSERT_NE(call, nullptr);
  EXPECT_EQ(call(120), 7000 + 125);
  EXPECT_EQ(call(124), 7000 + 1);

  const auto written = fs::last_write_time(first);
  EXPECT_EQ(built_object(tiny("a_i + 7'd5"), folder), first);
  EXPECT_EQ(fs::last_write_time(first), written);
  EXPECT_NE(built_object(tiny("a_i + 7'd6"), folder), first);
}

TEST_F(Cache, AFailingBuildNamesItsLogAndLeavesNothingElse) {
  try {
    built_object(tiny("a_i +"), folder);
    FAIL() << "was built";
  } catch (const UserError& error) {
    const std::string text = error.what();
    EXPECT_EQ(text.find('\n'), std::string::npos);
    const std::size_t at = text.find("see ");
    ASSERT_NE(at, std::string::npos) << text;
    std::ifstream log(text.substr(at + 4));
    const std::string words((std::istreambuf_iterator<char>(log)), {});
    EXPECT_NE(words.find("syntax error"), std::string::npos) << words;
  }
  for (const auto& entry : fs::directory_iterator(folder)) {
    EXPECT_TRUE(entry.path().extension() == ".log" || entry.path().extension() == ".lock")
        << entry.path();
  }
}

}  // namespace
}  // namespace kagesen

/// What a good run prints and leaves behind.
#include <OpenImageIO/imageio.h>

#include <nlohmann/json.hpp>

#include "tests/sim/program.h"

namespace kagesen {
namespace {

using Json = nlohmann::json;

class CliRun : public ProgramTest {
 protected:
  /// The report of a run that prints nothing else.
  Json report(std::vector<std::string> arguments) const {
    arguments.insert(arguments.end(), {"--json", "-", "--no-images"});
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    return Json::parse(outcome.out);
  }
  void expect_image(const std::string& name, int width, int height, int channels) const {
    const auto image = OIIO::ImageInput::open(path(name));
    ASSERT_NE(image, nullptr) << name;
    EXPECT_EQ(image->spec().width, width) << name;
    if (height > 0) {
      EXPECT_EQ(image->spec().height, height) << name;
    }
    EXPECT_EQ(image->spec().nchannels, channels) << name;
  }
};

Json without_times(Json report) {
  report.erase("time_s");
  report.erase("stages_s");
  return report;
}

TEST_F(CliRun, WritesEverything) {
  const Outcome outcome =
      run(small({"run", "--out", "a b/c", "--json", "r.json", "--verdicts", "v"}));
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  for (const char* words : {"solids", "Silhouette line buffer", "Verdicts", "exact reference",
                            "plain shadow map", "Time", "Written", "a b/c/errors.png"}) {
    EXPECT_NE(outcome.out.find(words), std::string::npos) << words;
  }
  std::istringstream lines(outcome.out);
  for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 100u) << line;

  expect_image("a b/c/shaded.png", 160, 90, 3);
  expect_image("a b/c/mask.png", 160, 90, 1);
  expect_image("a b/c/errors.png", 160, 0, 3);
  expect_image("a b/c/lines.png", 512, 0, 3);
  expect_image("a b/c/frame.exr", 160, 90, 9);
  expect_image("a b/c/map.exr", 128, 128, 5);
  EXPECT_EQ(read_file(path("r.json")), read_file(path("a b/c/report.json")));

  const Json report = Json::parse(read_file(path("r.json")));
  std::ifstream verdicts(path("v"));
  std::string line;
  std::getline(verdicts, line);
  EXPECT_EQ(line, "index px py verdict exact_paper exact_physical cause_paper cause_physical");
  std::size_t count = 0, dark = 0, wrong = 0;
  while (std::getline(verdicts, line)) {
    std::istringstream words(line);
    std::size_t index, px, py, verdict, paper, physical;
    std::string cause_paper, cause_physical;
    words >> index >> px >> py >> verdict >> paper >> physical >> cause_paper >> cause_physical;
    ASSERT_TRUE(words) << line;
    ASSERT_EQ(index, count++);
    ASSERT_LT(px, 160u);
    ASSERT_LT(py, 90u);
    ASSERT_EQ(verdict != paper, cause_paper != "none") << line;
    ASSERT_EQ(verdict != physical, cause_physical != "none") << line;
    dark += verdict;
    wrong += verdict != paper;
  }
  EXPECT_EQ(count, report["verdict"]["fragments"]);
  EXPECT_EQ(dark, report["verdict"]["dark"]);
  EXPECT_EQ(wrong, report["error"]["paper"]["wrong"]);
}

TEST_F(CliRun, StableKeys) {
  const Json r = report(small({"run", "torus"}));
  EXPECT_EQ(r.at("schema_version"), 1);
  for (const char* key : {"name", "sha256", "triangles", "fragments", "objects"}) {
    EXPECT_TRUE(r.at("input").contains(key)) << key;
  }
  EXPECT_EQ(r.at("input").at("name"), "torus");
  EXPECT_EQ(r.at("input").at("sha256").get<std::string>().size(), 64u);
  EXPECT_EQ(r.at("config").at("map_width"), 128);
  EXPECT_EQ(r.at("engine"), "systemc");
  const std::uint64_t dark = r.at("verdict").at("dark"), lit = r.at("verdict").at("lit");
  EXPECT_EQ(dark + lit, r.at("verdict").at("fragments"));
  EXPECT_GT(dark, 0u);
  EXPECT_GT(lit, 0u);
  for (const char* semantics : {"paper", "physical"}) {
    const Json& e = r.at("error").at(semantics);
    const std::uint64_t false_lit = e.at("false_lit"), false_dark = e.at("false_dark");
    EXPECT_EQ(false_lit + false_dark, e.at("wrong"));
    std::uint64_t causes = 0;
    for (const auto& [name, count] : e.at("causes").items()) causes += count.get<std::uint64_t>();
    EXPECT_EQ(causes, e.at("wrong"));
    EXPECT_EQ(e.at("causes").at("other"), 0);
    EXPECT_TRUE(e.contains("rate") && e.contains("band_rate") && e.contains("beyond_bound"));
    if (e.at("wrong") == 0) {
      EXPECT_EQ(e.at("displacement_texels").at("max"), 0);
    }
    if (e.at("wrong") != 0) {
      EXPECT_LE(e.at("displacement_texels").at("mean"), e.at("displacement_texels").at("max"));
      EXPECT_LE(e.at("displacement_texels").at("p99"), e.at("displacement_texels").at("max"));
    }
  }
  EXPECT_TRUE(r.at("error").at("equivalent_resolution").contains("side"));
  EXPECT_TRUE(r.at("error").at("equivalent_resolution").contains("at_least"));
  std::uint64_t texels = 0;
  for (const Json& count : r.at("slb").at("chain_histogram")) texels += count.get<std::uint64_t>();
  EXPECT_EQ(texels, r.at("slb").at("texels"));
  for (const char* key :
       {"lines", "payload_bytes", "allocated_bytes", "entries", "max_chain", "overflow"}) {
    EXPECT_TRUE(r.at("slb").contains(key)) << key;
  }
  EXPECT_EQ(r.at("map").at("width"), 128);
  EXPECT_GT(r.at("map").at("bytes"), 0);
  EXPECT_GT(r.at("time_s"), 0);
}

TEST_F(CliRun, TheWindingProfileSaysWhatItSkippedAndIsJudgedInBothSemantics) {
  const Json r = report(small({"run", "torus", "--set", "profile=winding"}));
  EXPECT_EQ(r.at("config").at("semantics"), "physical");
  EXPECT_EQ(r.at("skips").size(), 10u);
  for (const char* stage : {"announce", "pass1", "pass2", "other_semantics", "reference"}) {
    EXPECT_TRUE(r.at("stages_s").contains(stage)) << stage;
  }
  for (const char* semantics : {"paper", "physical"}) {
    const Json& e = r.at("error").at(semantics);
    EXPECT_GT(e.at("judged"), 0);
    for (const char* cause : {"id_rule", "combination", "cancelling", "hidden_removal"}) {
      EXPECT_EQ(e.at("causes").at(cause), 0) << cause;
    }
  }
}

TEST_F(CliRun, WhatWasNotComputedIsAbsent) {
  const Outcome outcome = run(small({"run", "--no-reference", "--verdicts", "v"}));
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_FALSE(Json::parse(read_file(path("out/report.json"))).contains("error"));
  EXPECT_FALSE(std::filesystem::exists(path("out/errors.png")));
  expect_image("out/frame.exr", 160, 90, 5);
  EXPECT_NE(read_file(path("v")).find(" - - - -\n"), std::string::npos);
}

TEST_F(CliRun, TraceEqualsItsScene) {
  const std::vector<std::string> options{"--scale", "4", "--mode", "all"};
  std::vector<std::string> capture = small({"trace", "capture", "torus", "a.trace"});
  capture.insert(capture.end(), options.begin(), options.end());
  ASSERT_EQ(run(capture).status, 0);
  std::vector<std::string> scene = small({"run", "torus"});
  scene.insert(scene.end(), options.begin(), options.end());
  const Json expected = without_times(report(scene));
  EXPECT_EQ(without_times(report({"run", "a.trace"})), expected);

  // The same again by way of plain text.
  ASSERT_EQ(run({"trace", "dump", "a.trace", "a.txt"}).status, 0);
  ASSERT_EQ(run({"trace", "make", "a.txt", "b.trace"}).status, 0);
  EXPECT_EQ(without_times(report({"run", "b.trace"})), expected);
  EXPECT_EQ(run({"trace", "dump", "a.trace"}).out, read_file(path("a.txt")));
  EXPECT_EQ(run({"trace", "dump", "a.trace", "-"}).out, read_file(path("a.txt")));

  const Outcome info = run({"trace", "info", "a.trace"});
  EXPECT_EQ(info.status, 0);
  for (const char* words : {"torus", "128 x 128", "160 x 90", "all", "scale 4 x 4"}) {
    EXPECT_NE(info.out.find(words), std::string::npos) << info.out;
  }
  EXPECT_NE(run({"trace", "verify", "a.trace"}).out.find("whole"), std::string::npos);
}

TEST_F(CliRun, TraceReadAtAnotherScale) {
  ASSERT_EQ(run(small({"trace", "capture", "solids", "a.trace"})).status, 0);
  const Json one = report({"run", "a.trace"}), four = report({"run", "a.trace", "--scale", "4"});
  EXPECT_EQ(four.at("input").at("fraction_bits"),
            one.at("input").at("fraction_bits").get<int>() + 2);
  EXPECT_EQ(four.at("input").at("scale"), (Json{4.0, 4.0}));
  EXPECT_EQ(four.at("verdict").at("fragments"), one.at("verdict").at("fragments"));
  EXPECT_LT(four.at("slb").at("texels"), one.at("slb").at("texels"));
}

TEST_F(CliRun, GBufferEqualsTheCamera) {
  ASSERT_EQ(run({"gbuffer", "solids", "g.exr", "--image", "160x90"}).status, 0);
  const Json camera = report(small({"run", "solids"}));
  const Json gbuffer = report({"run", "solids", "--gbuffer", "g.exr", "--map", "128"});
  EXPECT_EQ(gbuffer.at("slb"), camera.at("slb"));
  EXPECT_EQ(gbuffer.at("verdict").at("fragments"), camera.at("verdict").at("fragments"));
}

TEST_F(CliRun, CameraAndLight) {
  const Json spot = report(small(
      {"run", "solids", "--light-kind", "spot", "--light-position", "3,12,2", "--spread", "60"}));
  EXPECT_NE(spot.at("input").at("light").get<std::string>().find("spot"), std::string::npos);
  const Json moved = report(small({"run", "solids", "--camera-eye", "0,20,1", "--fov", "30"}));
  EXPECT_NE(moved.at("verdict"), spot.at("verdict"));
}

TEST_F(CliRun, RaysAgree) {
  const Json exact = report(small({"run", "solids", "--scene-exact"})).at("scene_exact");
  EXPECT_GT(exact.at("unit").at("judged"), 1000);
  EXPECT_LE(exact.at("trace").at("physical").at("wrong"), 5);
}

TEST_F(CliRun, FrameWithNothingToJudge) {
  const Json away =
      report(small({"run", "solids", "--camera-eye", "0,90,0", "--camera-target", "0,180,1"}));
  EXPECT_EQ(away.at("verdict").at("fragments"), 0);
  EXPECT_NE(away.at("warnings").dump().find("sees nothing"), std::string::npos);
  EXPECT_EQ(away.at("error").at("paper").at("displacement_texels").at("max"), 0);

  const Json below = report(small({"run", "solids", "--light-direction", "0,1,0", "--camera-eye",
                                   "0,90,0.1", "--camera-target", "0,0,0", "--fov", "2"}));
  EXPECT_NE(below.at("warnings").dump().find("nothing to judge"), std::string::npos);
  EXPECT_NE(run(small({"run", "solids", "--camera-eye", "0,90,0", "--camera-target", "0,180,1"}))
                .out.find("sees nothing"),
            std::string::npos);
}

TEST_F(CliRun, SmallestMap) {
  const Json tiny = report({"run", "solids", "--image", "160x90", "--map", "1"});
  EXPECT_EQ(tiny.at("map").at("width"), 1);
  EXPECT_EQ(tiny.at("error").at("paper").at("causes").at("other"), 0);
}

TEST_F(CliRun, ConfigurationRoundTrip) {
  const Outcome defaults = run({"config"});
  ASSERT_EQ(defaults.status, 0);
  write_file(path("all.toml"), defaults.out);
  EXPECT_EQ(run({"config", "--config", "all.toml"}).out, defaults.out);

  write_file(path("some.toml"), "slope_bits = 4 # fewer\ntable7 = \"printed\"\n");
  const std::vector<std::string> settings{"--config",        "some.toml", "--set",
                                          "fraction_bits=5", "--set",     "slope_bits=6"};
  std::vector<std::string> printing{"config"}, running = small({"run"});
  printing.insert(printing.end(), settings.begin(), settings.end());
  running.insert(running.end(), settings.begin(), settings.end());
  write_file(path("effective.toml"), run(printing).out);
  const Json config = report(running).at("config");
  EXPECT_EQ(config.at("slope_bits"), 6);
  EXPECT_EQ(config.at("fraction_bits"), 5);
  EXPECT_EQ(config.at("table7"), "printed");
  EXPECT_EQ(report(small({"run", "--config", "effective.toml"})).at("config"), config);
  write_file(path("empty.toml"), "");
  EXPECT_EQ(run({"config", "--config", "empty.toml"}).out, defaults.out);
}

TEST_F(CliRun, HelpVersionScenes) {
  EXPECT_EQ(run({"--version"}).out.rfind("kagesen ", 0), 0u);
  for (const char* command : {"run", "scenes", "config", "trace", "gbuffer", "results", "stress", "numerics"}) {
    const Outcome help = run({command, "--help"});
    EXPECT_EQ(help.status, 0);
    EXPECT_NE(help.out.find(command), std::string::npos);
    EXPECT_NE(run({"--help"}).out.find(command), std::string::npos);
  }
  EXPECT_EQ(run({"scenes"}).out.rfind("solids", 0), 0u);
}

}  // namespace
}  // namespace kagesen

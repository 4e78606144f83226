/// Every way to use the program wrongly: one line, exit status 2, nothing left behind.
#include "tests/sim/program.h"

namespace kagesen {
namespace {

using CliErrors = ProgramTest;

TEST_F(CliErrors, CommandLine) {
  expect_refusal({}, {"subcommand", "run"});
  expect_refusal({"rnu"}, {"'rnu'", "did you mean 'run'?"});
  expect_refusal({"run", "--scael", "4"}, {"--scael", "did you mean '--scale'?"});
  expect_refusal({"run", "--image"}, {"--image"});
  expect_refusal({"run", "solids", "torus"}, {"'torus'"});
  expect_refusal({"trace"}, {"subcommand"});
  expect_refusal({"trace", "verfy", "x"}, {"did you mean 'verify'?"});
  expect_refusal({"trace", "info"}, {"FILE"});
  expect_refusal({"trace", "capture", "solids"}, {"OUTPUT"});
  expect_refusal({"gbuffer", "solids"}, {"OUTPUT"});
}

TEST_F(CliErrors, OptionValues) {
  for (const char* scale : {"0", "1025", "x", "4x", "1x2x3", "nan", "-1", ""}) {
    if (*scale) expect_refusal({"run", "--scale", scale}, {"--scale"});
  }
  for (const char* size : {"0", "160x0", "160x", "-1x5", "16385", "1.5"}) {
    expect_refusal({"run", "--image", size}, {"--image"});
  }
  for (const char* size : {"0", "4097", "64x4097"}) {
    expect_refusal({"run", "--map", size}, {"--map", "4096"});
  }
  expect_refusal({"run", "--mode", "earlyz"}, {"--mode", "did you mean 'early-z'?"});
  expect_refusal({"run", "--engine", "goldn"}, {"--engine", "did you mean 'golden'?"});
  expect_refusal({"run", "--fov", "180"}, {"--fov"});
  expect_refusal({"run", "--camera-eye", "1,2"}, {"--camera-eye"});
  expect_refusal({"run", "--camera-eye", "1,2,inf"}, {"--camera-eye"});
  expect_refusal({"run", "--camera-eye", "0,0,0", "--camera-target", "0,0,0"}, {"--camera-eye"});
  expect_refusal({"run", "--light-direction", "0,0,0"}, {"--light-direction"});
  expect_refusal({"run", "--light-kind", "spott"}, {"did you mean 'spot'?"});
  expect_refusal({"run", "--light-kind", "spot"}, {"--light-position"});
  expect_refusal({"run", "--spread", "40"}, {"--spread"});
  expect_refusal({"run", "solids", "--ids", "file"}, {"--ids"});
}

TEST_F(CliErrors, Configuration) {
  expect_refusal({"run", "--set", "slop_bits=4"}, {"slop_bits", "slope_bits"});
  expect_refusal({"run", "--set", "slope_bits=0"}, {"slope_bits", "nearest valid value is 1"});
  expect_refusal({"run", "--set", "slope_bits"}, {"KEY=VALUE"});
  expect_refusal({"run", "--set", "slope_bits=four"}, {"slope_bits"});
  expect_refusal({"run", "--set", "map_width=0"}, {"map_width", "1"});
  expect_refusal({"run", "--set", "map_width=4097"}, {"map_width", "4096"});
  expect_refusal({"run", "--set", "slb_buckets=1000"}, {"slb_buckets", "1024"});
  expect_refusal({"run", "--set", "table7=corected"}, {"table7", "corrected"});
  expect_refusal({"config", "--config", "none.toml"}, {"none.toml"});
  expect_refusal({"config", "--config", "."}, {"cannot read"});

  write_file(path("syntax.toml"), "slope_bits = 4\nfraction_bits = = 4\n");
  expect_refusal({"config", "--config", "syntax.toml"}, {"syntax.toml:2"});
  write_file(path("key.toml"), "# a comment\n\nfraction_bit = 4\n");
  expect_refusal({"config", "--config", "key.toml"}, {"key.toml:3", "fraction_bits"});
  write_file(path("range.toml"), "slope_bits = 4\nfraction_bits = 99\n");
  expect_refusal({"config", "--config", "range.toml"}, {"range.toml:2", "fraction_bits"});
  write_file(path("kind.toml"), "slope_bits = 4.5\n");
  expect_refusal({"config", "--config", "kind.toml"},
                 {"kind.toml:1", "slope_bits: takes a whole", "1 to "});
  write_file(path("text.toml"), "slope_bits = \"4\"\n");
  expect_refusal({"config", "--config", "text.toml"}, {"text.toml:1", "slope_bits: takes a whole"});
  write_file(path("word.toml"), "table7 = 7\n");
  expect_refusal({"config", "--config", "word.toml"}, {"word.toml", "corrected", "printed"});
  write_file(path("flag.toml"), "match_polygon_id = 1\n");
  expect_refusal({"config", "--config", "flag.toml"}, {"flag.toml:1", "true", "false"});
  write_file(path("table.toml"), "[slope_bits]\nvalue = 4\n");
  expect_refusal({"config", "--config", "table.toml"}, {"table.toml:1", "slope_bits"});
  write_file(path("twice.toml"), "slope_bits = 4\nslope_bits = 4\n");
  expect_refusal({"config", "--config", "twice.toml"}, {"twice.toml:2"});
}

TEST_F(CliErrors, Input) {
  expect_refusal({"run", "none.obj"}, {"none.obj"});
  expect_refusal({"run", "solid"}, {"solid", "solids"});
  expect_refusal({"run", "."}, {"folder"});
  expect_refusal({"results", "--scenes", "solid"}, {"--scenes", "'solids'"});
  expect_refusal({"trace", "info", "none.trace"}, {"none.trace"});
  expect_refusal({"trace", "make", "none.txt", "a.trace"}, {"none.txt"});
  expect_refusal({"run", "--gbuffer", "none.exr"}, {"none.exr"});

  write_file(path("empty.obj"), "");
  expect_refusal({"run", "empty.obj"}, {"empty.obj"});
  write_file(path("nothing.obj"), "# no faces\nv 0 0 0\n");
  expect_refusal({"run", "nothing.obj"}, {"nothing.obj"});
  write_file(path("nan.obj"), "v 0 0 0\nv 1 0 nan\nv 0 1 0\nf 1 2 3\n");
  expect_refusal({"run", "nan.obj"}, {"nan.obj"});
  write_file(path("index.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n");
  expect_refusal({"run", "index.obj"}, {"index.obj"});
  write_file(path("words.ply"), "this is not a mesh\n");
  expect_refusal({"run", "words.ply"}, {"words.ply"});
  write_file(path("hand.txt"), "this is not a trace\n");
  expect_refusal({"trace", "make", "hand.txt", "a.trace"}, {"hand.txt"});
  EXPECT_FALSE(std::filesystem::exists(path("a.trace")));
}

TEST_F(CliErrors, Traces) {
  ASSERT_EQ(run(small({"trace", "capture", "solids", "a.trace"})).status, 0);
  const std::string good = read_file(path("a.trace"));
  expect_refusal({"run", "a.trace", "--camera-eye", "1,2,3"}, {"--camera-eye", "a.trace"});
  expect_refusal({"run", "a.trace", "--image", "64x64"}, {"--image", "a.trace"});
  expect_refusal({"run", "a.trace", "--set", "map_width=64"}, {"map_width", "128"});
  expect_refusal({"run", "a.trace", "--scene-exact"}, {"--scene-exact", "trace"});
  expect_refusal({"run", "a.trace", "--scale", "3"}, {"--scale", "power of two"});
  expect_refusal({"run", "a.trace", "--scale", "2x4"}, {"--scale", "power of two"});
  expect_refusal({"trace", "capture", "a.trace", "b.trace"}, {"a.trace"});
  expect_refusal({"gbuffer", "a.trace", "b.exr"}, {"a.trace"});
  expect_refusal({"trace", "capture", "solids", "none/b.trace"}, {"none/b.trace"});

  std::string damaged = good;
  damaged[good.size() / 2] ^= 0x10;
  write_file(path("damaged.trace"), damaged);
  write_file(path("short.trace"), good.substr(0, good.size() - 7));
  for (const char* name : {"damaged.trace", "short.trace"}) {
    expect_refusal({"run", name}, {name});
    expect_refusal({"trace", "verify", name}, {name});
    expect_refusal({"trace", "info", name}, {name});
    expect_refusal({"trace", "dump", name, "dump.txt"}, {name});
    EXPECT_FALSE(std::filesystem::exists(path("dump.txt")));
  }
}

TEST_F(CliErrors, GBufferOptions) {
  for (const char* option : {"--image", "--mode"}) {
    const std::string value = option == std::string("--image") ? "64x64" : "all";
    expect_refusal({"run", "--gbuffer", "g.exr", option, value}, {option, "--gbuffer"});
    expect_refusal({"trace", "capture", "solids", "a.trace", "--gbuffer", "g.exr", option, value},
                   {option, "--gbuffer"});
  }
  for (const char* option : {"--mode", "--map", "--scale", "--gbuffer"}) {
    expect_refusal({"gbuffer", "solids", "g.exr", option, "1"}, {option});
  }
  EXPECT_EQ(run({"gbuffer", "--help"}).out.find("default: the first"), std::string::npos);
}

TEST_F(CliErrors, TraceFiles) {
  ASSERT_EQ(run(small({"trace", "capture", "solids", "a.trace"})).status, 0);
  const std::string good = read_file(path("a.trace"));
  write_file(path("hand"), "end\n");
  expect_refusal({"trace", "dump", "a.trace", "./a.trace"}, {"a.trace", "same file"});
  expect_refusal({"trace", "make", "hand", "./hand"}, {"hand", "same file"});
  EXPECT_EQ(read_file(path("a.trace")), good);
  EXPECT_EQ(read_file(path("hand")), "end\n");
  expect_refusal({"trace", "make", "-", "b.trace"}, {"standard input", "nothing to read"});
  expect_refusal({"trace", "make", "hand", "-"}, {"needs a file"});
  expect_refusal({"trace", "capture", "solids", "-"}, {"needs a file"});
  expect_refusal({"trace", "dump", "a.trace", "/dev/full"}, {"/dev/full", "No space left"});
  EXPECT_FALSE(std::filesystem::exists(path("b.trace")));
}

TEST_F(CliErrors, Places) {
  write_file(path("file"), "");
  expect_refusal(small({"run", "--out", "file"}), {"file"});
  expect_refusal(small({"run", "--out", "file/deeper"}), {"file/deeper"});
  expect_refusal(small({"run", "--out", "/proc/none"}), {"/proc/none"});
  expect_refusal(small({"run", "--json", "none/report"}), {"none/report"});
  expect_refusal(small({"run", "--json", "."}), {"folder"});
  expect_refusal(small({"run", "--json", "/dev/full"}), {"/dev/full", "No space left"});
  expect_refusal(small({"run", "--verdicts", "/dev/full"}), {"/dev/full", "No space left"});
}

TEST_F(CliErrors, OneFileForTwoOutputs) {
  expect_refusal({"run", "--out", "o", "--json", "o/report.json"}, {"--json", "--out"});
  expect_refusal({"run", "--out", "o", "--verdicts", "./o/mask.png"}, {"--verdicts", "--out"});
  expect_refusal({"run", "--out", "o", "--json", "same", "--verdicts", "same"},
                 {"--json", "--verdicts", "same"});
  EXPECT_FALSE(std::filesystem::exists(path("o")));
  EXPECT_FALSE(std::filesystem::exists(path("same")));
  write_file(path("a.obj"), "v 0 0 0\nv 1 0 0\nv 0 0 1\nf 1 2 3\n");
  const std::string before = read_file(path("a.obj"));
  expect_refusal({"run", "a.obj", "--json", "./a.obj"}, {"--json", "INPUT"});
  EXPECT_EQ(read_file(path("a.obj")), before);
}

TEST_F(CliErrors, DiskThatFillsUp) {
  Limits limits;
  limits.file_bytes = 3000;
  const Outcome outcome = run(small({"run", "--verdicts", "v.txt"}), limits);
  EXPECT_EQ(outcome.status, 2);
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  EXPECT_NE(outcome.err.find("cannot write"), std::string::npos) << outcome.err;
  EXPECT_EQ(left_behind(), std::vector<std::string>{});
  EXPECT_FALSE(std::filesystem::exists(path("v.txt")));

  EXPECT_EQ(run(small({"trace", "capture", "solids", "a.trace"}), limits).status, 2);
  EXPECT_FALSE(std::filesystem::exists(path("a.trace")));
  EXPECT_EQ(left_behind(), std::vector<std::string>{});

  ASSERT_EQ(run(small({"trace", "capture", "solids", "a.trace"})).status, 0);
  const Outcome dump = run({"trace", "dump", "a.trace", "a.txt"}, limits);
  EXPECT_EQ(dump.status, 2);
  EXPECT_NE(dump.err.find("a.txt: cannot write"), std::string::npos) << dump.err;
  EXPECT_EQ(left_behind(), std::vector<std::string>{});
}

TEST_F(CliErrors, InterruptLeavesNothing) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    Limits limits;
    limits.meanwhile = [&](pid_t child) {
      // The verdicts' part is the last to be opened before the work begins.
      for (int i = 0; i < 2000 && !std::filesystem::exists(path("v.txt.part")); ++i) {
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
      }
      kill(child, signal);
    };
    const Outcome outcome =
        run({"run", "sphere1m", "--out", "new/out", "--verdicts", "v.txt"}, limits);
    EXPECT_EQ(outcome.status, 128 + signal);
    EXPECT_FALSE(std::filesystem::exists(path("v.txt.part")));
    EXPECT_FALSE(std::filesystem::exists(path("new")));
  }
}

}  // namespace
}  // namespace kagesen

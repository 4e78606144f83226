/// The text form of a trace: exact both ways, forgiving to hands, clear about mistakes.
#include "tests/traces/trace_generators.h"
#include "tests/traces/trace_samples.h"

namespace kagesen {
namespace {

std::string refusal_of(const std::string& text) {
  return refusal([&] { read_text(text); });
}

TEST(TraceText, AnyTraceComesBack) {
  EXPECT_TRUE(rc::check([] {
    const Trace trace = any_trace();
    RC_ASSERT(equal(read_text(dumped(trace)), trace));
  }));
}

TEST(TraceText, BinaryAndTextHoldTheSame) {
  const Trace trace = small_trace();
  EXPECT_EQ(dumped(read_bytes(written(trace))), dumped(trace));
  EXPECT_EQ(written(read_text(dumped(trace))), written(trace));
}

TEST(TraceText, EveryLineOfADumpIsNeeded) {
  const std::string whole = dumped(small_trace());
  for (std::size_t size = 1; size < whole.size() - 1; ++size) {
    const std::string message = refusal_of(whole.substr(0, size));
    EXPECT_EQ(message.find("text line "), 0u) << size << ": " << message;
  }
}

TEST(TraceText, OmittedLinesTakeTheirDefaults) {
  const Trace trace = read_text(
      "# two triangles by hand\n"
      "map 64 32   # small\r\n"
      "\n"
      "caster 0 0 10  5 0 10  0 5 10  2 0\n"
      "fragment 1 2 3 4 5 0 255 2");
  TraceHeader expected;
  expected.map_width = 64;
  expected.map_height = 32;
  expected.objects = {
      {"object0", 0, false, true}, {"object1", 0, false, true}, {"object2", 0, false, true}};
  EXPECT_TRUE(equal(trace.header, expected));
  ASSERT_EQ(trace.all_casters.size(), 1u);
  EXPECT_EQ(trace.all_casters[0].vertex[1].x, 5);
  ASSERT_EQ(trace.all_fragments.size(), 1u);
  EXPECT_EQ(trace.all_fragments[0].position.z, 5u);
}

TEST(TraceText, AnEmptyTextIsAnEmptyTrace) {
  EXPECT_TRUE(equal(read_text(""), Trace()));
  EXPECT_TRUE(equal(read_text("# nothing\n"), Trace()));
}

TEST(TraceText, ManyRecordsComeInOrder) {
  Trace trace;
  trace.header = small_trace().header;
  for (std::uint32_t i = 0; i < 20000; ++i) {
    trace.all_casters.push_back({{{1, 2, i}, {3, 4, 5}, {6, 7, 8}}, 1, i});
    trace.all_fragments.push_back({{1, 2, i}, 0, 1, 2, 3, 4});
  }
  EXPECT_TRUE(equal(read_text(dumped(trace)), trace));
}

TEST(TraceText, MistakesNameTheLineAndTheMend) {
  const std::string objects = "object 0 closed caster 12 cube\nobject 1 open receiver 2 floor\n";
  const std::string caster = "caster 0 0 0 1 0 0 0 1 0 0 0\n";
  const struct {
    std::string text, message;
  } cases[] = {
      {"map 64\n", "text line 1: a number is missing; see docs/trace-format.md"},
      {"\nmap 64 0\n", "text line 2: map height 0 is out of range (1 to 4096); correct the line"},
      {"map 64 64 64\n", "text line 1: more words than the line takes; remove them"},
      {"map 64 -1\n", "text line 1: `-1` is not the number expected here; correct it"},
      {"map 64 99999999999\n", "text line 1: `99999999999` is out of range; correct the number"},
      {"map 64 64\nmap 64 64\n", "text line 2: given twice; remove one"},
      {"scale 1 nan\n", "text line 1: scale y nan is out of range (1 to 1024)"},
      {"mode early\n", "text line 1: `early` stands where visible, early-z or all belongs"},
      {"colour red\n", "text line 1: unknown word `colour`; see docs/trace-format.md"},
      {"light a\\b\n", "text line 1: a backslash that begins no escape; write \\\\ for"},
      {"seed 1\nkagesen-trace 1\n", "text line 2: the version is not the first line; move it up"},
      {"kagesen-trace 2\n", "text line 1: an unknown version of the text form; use the kagesen"},
      {"kagesen-trace 1\nseed 1\n", "text line 2: the text stops without its end line"},
      {"end\nseed 1\n", "text line 2: a line after `end`; remove it"},
      {"object 1 open caster 1 a\n", "text line 1: object 1 where 0 comes next; number the"},
      {objects + caster + "seed 1\n", "text line 4: `seed` after the first record; move it up"},
      {objects + "caster 0 0 0 1 0 0 0 1 0 1 0\n", "text line 3: object 1 is a receiver"},
      {objects + "fragment 0 0 0 0 0 2 0 0\n", "text line 3: object 2 does not exist"},
      {objects + "fragment 0 0 0 0 0 0 0 8\n", "text line 3: flags 8 is out of range (0 to 7)"},
      {objects + "fragment 0 0 0 0 0 0 0 0\n" + caster,
       "text line 4: a caster after the first fragment; move it up"},
      {"fragment 0 0 0 0 16777216 0 0 0\n", "text line 1: depth 16777216 is out of range"},
      {"fragment 0 0 0 0 0 4096 0 0\n", "text line 1: object 4096 without any `object` line"},
      {std::string(600000, 'x'), "text line 1: the line is longer than"},
  };
  for (const auto& c : cases) {
    const std::string message = refusal_of(c.text);
    EXPECT_EQ(message.find(c.message), 0u) << message << "\nexpected " << c.message;
  }
}

TEST(TraceText, TheExampleOfTheDocumentationIsRead) {
  const std::string page = file_bytes(KAGESEN_TEST_DATA "/../../docs/trace-format.md");
  const std::size_t start = page.find("\nkagesen-trace 1\n") + 1;
  const Trace trace = read_text(page.substr(start, page.find("```", start) - start));
  EXPECT_EQ(trace.header.objects.at(1).name, "a triangle");
  EXPECT_EQ(trace.all_casters.size(), 1u);
  EXPECT_EQ(trace.all_fragments.size(), 2u);
}

TEST(TraceText, AFullDiskIsNoticed) {
  std::ofstream full("/dev/full");
  const std::string message = refusal([&] {
    TextDump dump(full);
    push(small_trace(), dump);
  });
  EXPECT_EQ(message.find("text of the trace: writing failed"), 0u) << message;
}

}  // namespace
}  // namespace kagesen

#include <fmt/format.h>

#include <fstream>
#include <iostream>
#include <memory>

#include "sim/cli/commands.h"
#include "sim/cli/input.h"
#include "sim/cli/progress.h"
#include "sim/report/outputs.h"
#include "sim/report/table.h"
#include "traces/format/error.h"
#include "traces/format/trace_file.h"

namespace kagesen {
namespace {

struct CaptureArguments {
  InputOptions input;
  SettingsOptions settings;
  std::string output;
};
struct Files {
  std::string input, output;
};

/// Reads every byte and keeps only the header.
struct Checker : TraceSink {
  TraceHeader header;
  void begin(const TraceHeader& h) override { header = h; }
  void casters(const Caster*, std::size_t) override {}
  void fragments(const Fragment*, std::size_t) override {}
  void end() override {}
};

const char* mode_name(FragmentMode mode) {
  switch (mode) {
    case FragmentMode::kVisible:
      return "visible";
    case FragmentMode::kEarlyZ:
      return "early-z";
    case FragmentMode::kAll:
      return "all";
  }
  return "";
}

/// A trace is checked and renamed when it is whole, which needs a file.
void check_output(const std::string& input, const std::string& output) {
  if (output == "-") {
    throw UserError("OUTPUT -", "a trace needs a file, not standard output", "name one");
  }
  Outputs names;
  if (input != "-") names.reserve_input(input, "input");
  names.reserve(output, "OUTPUT");
}

void capture_trace(const CaptureArguments& arguments) {
  check_output(arguments.input.name, arguments.output);
  check_output(arguments.input.gbuffer, arguments.output);
  Progress progress(true);
  Settings settings = load_settings(arguments.settings);
  const Source source = resolve_input(arguments.input);
  const Scene* scene = std::get_if<Scene>(&source);
  if (!scene) {
    throw UserError(arguments.input.name, "is a trace already", "name a mesh or a built-in scene");
  }
  CaptureOptions capture = capture_options(arguments.input, settings);
  capture.progress = progress.callback();
  PartGuard guard(arguments.output + ".part");
  TraceWriter writer(arguments.output);
  capture_into(*scene, arguments.input, capture, writer);
}

void print_info(const std::string& path) {
  Checker checker;
  const TraceTotals totals = read_trace(path, checker);
  const TraceHeader& header = checker.header;
  const auto row = [](const char* label, const std::string& text) {
    std::cout << fmt::format("{:<14}{}\n", label, text);
  };
  row("source", header.source);
  row("sha256", header.source_sha256);
  row("light", header.light);
  row("map",
      fmt::format("{} x {} texels, {}, scale {:g} x {:g}", header.map_width, header.map_height,
                  counted(header.fraction_bits, "fraction bit"), header.scale_x, header.scale_y));
  row("image", fmt::format("{} x {}, {} fragments", header.image_width, header.image_height,
                           mode_name(header.mode)));
  row("casters", grouped(totals.casters));
  row("fragments", grouped(totals.fragments));
  row("file", fmt::format("{} in {}, {} uncompressed", bytes_text(totals.file_bytes),
                          counted(totals.chunks, "chunk"), bytes_text(totals.raw_bytes)));
  for (const std::string& warning : header.warnings) row("warning", warning);
  row("objects", grouped(header.objects.size()));
  for (const ObjectInfo& object : header.objects) {
    row("", fmt::format("{}: {}, {}{}", object.name, counted(object.triangles, "triangle"),
                        object.closed ? "closed" : "open", object.caster ? "" : ", receives only"));
  }
}

void verify(const std::string& path) {
  Checker checker;
  const TraceTotals totals = read_trace(path, checker);
  std::cout << fmt::format("{}: whole; {}, {}, {}\n", path, counted(totals.casters, "caster"),
                           counted(totals.fragments, "fragment"), counted(totals.chunks, "chunk"));
}

void dump(const Files& files) {
  Outputs outputs;
  const bool to_file = !files.output.empty() && files.output != "-";
  outputs.reserve_input(files.input, "FILE");
  // Damage at the end of a trace must not leave half a dump behind.
  TextDump text(to_file ? outputs.open(files.output, "OUTPUT") : std::cout);
  try {
    read_trace(files.input, text);
  } catch (const UserError&) {
    outputs.check();  // knows which file was refused, and why
    throw;
  }
  outputs.commit();
}

/// Something to read must be there before the output is begun.
void check_not_empty(std::istream& in, const std::string& name) {
  if (in && in.peek() != std::istream::traits_type::eof()) return;
  throw UserError(name, "there is nothing to read", "check the name");
}

void make(const Files& files) {
  check_output(files.input, files.output);
  PartGuard guard(files.output + ".part");
  if (files.input == "-") {
    check_not_empty(std::cin, "standard input");
    TraceWriter writer(files.output);
    read_trace_text(std::cin, "standard input", writer);
    return;
  }
  std::ifstream in(files.input);
  check_not_empty(in, files.input);
  TraceWriter writer(files.output);
  read_trace_text(in, files.input, writer);
}

}  // namespace

void add_trace(CLI::App& app) {
  CLI::App& trace = *app.add_subcommand(
      "trace", "Captures, inspects and converts trace files (docs/trace-format.md)");
  trace.require_subcommand(1);

  auto capture = std::make_shared<CaptureArguments>();
  CLI::App& capturing = *trace.add_subcommand("capture", "Captures a scene into a trace file");
  add_input_options(capturing, capture->input, InputUse::kTrace);
  capturing.add_option("OUTPUT", capture->output, "The trace file to write")->required();
  add_settings_options(capturing, capture->settings);
  capturing.callback([capture] { capture_trace(*capture); });

  auto files = std::make_shared<Files>();
  const auto add = [&](const char* name, const char* help) -> CLI::App& {
    CLI::App& command = *trace.add_subcommand(name, help);
    command.add_option("FILE", files->input, "The file to read")->required();
    return command;
  };
  add("info", "Says what a trace holds").callback([files] { print_info(files->input); });
  add("verify", "Checks every byte of a trace").callback([files] { verify(files->input); });
  CLI::App& dumping = add("dump", "Prints a trace as plain text");
  dumping.add_option("OUTPUT", files->output, "Where to; - or nothing: standard output");
  dumping.callback([files] { dump(*files); });
  CLI::App& making = add("make", "Makes a trace of such text, as dumped or written by hand");
  making.add_option("OUTPUT", files->output, "The trace file to write")->required();
  making.callback([files] { make(*files); });
}

}  // namespace kagesen

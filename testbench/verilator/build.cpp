#include "testbench/verilator/build.h"

#include <dlfcn.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sys/file.h>
#include <unistd.h>
#include <xxhash.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <regex>
#include <sstream>
#include <thread>

#include "testbench/verilator/package.h"
#include "traces/format/error.h"

namespace kagesen {
namespace {

namespace fs = std::filesystem;

std::string read_file(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

void write_file(const fs::path& path, const std::string& text) {
  fs::create_directories(path.parent_path());
  std::ofstream out(path, std::ios::binary);
  if (!(out << text).flush()) {
    throw UserError(path.string(), "cannot write", "make room, or set KAGESEN_CACHE elsewhere");
  }
}

std::string quoted(const std::string& word) {
  std::string out = "'";
  for (const char c : word) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return out + "'";
}

/// Holds the lock file of a build; others wait.
class Lock {
 public:
  explicit Lock(const std::string& path) : file_(open(path.c_str(), O_CREAT | O_RDWR, 0666)) {
    if (file_ < 0 || flock(file_, LOCK_EX) != 0) {
      throw UserError(path, "cannot lock", "check the permissions of its folder");
    }
  }
  ~Lock() { close(file_); }
  Lock(const Lock&) = delete;
  Lock& operator=(const Lock&) = delete;

 private:
  int file_;
};

/// clang's code for a Verilated model runs a third faster than g++'s, and compiles quicker.
std::string model_compiler() {
  const char* path = std::getenv("PATH");
  std::istringstream folders(path ? path : "");
  for (std::string folder; std::getline(folders, folder, ':');) {
    if (access((folder + "/clang++").c_str(), X_OK) == 0) return "clang++";
  }
  return "g++";
}

bool ends_with(const std::string& text, const std::string& end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

/// The build in a folder of its own: one shell command after the other, all output to one log.
class Build {
 public:
  Build(const BuildRecipe& recipe, const fs::path& folder, const fs::path& log)
      : recipe_(recipe), folder_(folder), log_(log) {
    fs::remove_all(folder_);
  }
  ~Build() {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
  }
  Build(const Build&) = delete;
  Build& operator=(const Build&) = delete;

  void run() {
    for (const SourceText& s : recipe_.sources) write_file(folder_ / s.path, s.text);
    verilate();
    write_file(folder_ / "port_widths.h", port_widths());
    write_file(folder_ / "Makefile", makefile());
    const unsigned jobs = std::max(1u, std::thread::hardware_concurrency());
    command(fmt::format("make -j{} unit.so", jobs));
  }

 private:
  void command(const std::string& line) {
    {
      std::ofstream log(log_, std::ios::app);
      log << "$ " << line << "\n";
    }
    const std::string whole = fmt::format("cd {} && ( {} ) >> {} 2>&1", quoted(folder_.string()),
                                          line, quoted(fs::absolute(log_).string()));
    if (std::system(whole.c_str()) != 0) {
      throw UserError("RTL build", "'" + line.substr(0, line.find(' ')) + "' failed",
                      "see " + log_.string());
    }
  }

  void verilate() {
    std::string line = fmt::format("verilator --cc -Mdir obj --prefix V{0} --top-module {0} {1}",
                                   recipe_.top, fmt::join(recipe_.verilator, " "));
    std::vector<std::string> folders;
    std::string files;
    for (const SourceText& s : recipe_.sources) {
      const std::string folder = fs::path(s.path).parent_path().string();
      const bool header = ends_with(s.path, ".svh");
      const bool module = ends_with(s.path, ".sv");
      if (ends_with(s.path, "shadow_pkg.sv")) {
        files = s.path + " " + files;  // first
      } else if (ends_with(s.path, ".vlt")) {
        files = s.path + " " + files;
      } else if (module && fs::path(s.path).stem() == recipe_.top) {
        files += s.path;
      } else if ((module || header) &&
                 std::find(folders.begin(), folders.end(), folder) == folders.end()) {
        folders.push_back(folder);
      }
    }
    for (const std::string& folder : folders) line += fmt::format(" -y {0} -I{0}", folder);
    command(line + " " + files);
  }

  /// The widths of the top's ports, which C++ cannot tell from their types.
  std::string port_widths() const {
    const std::string header = read_file(folder_ / "obj" / ("V" + recipe_.top + ".h"));
    static const std::regex port(R"(VL_(?:IN|OUT)(?:8|16|64|W)?\(&(\w+),(\d+),(\d+))");
    std::string text = "#pragma once\nnamespace kagesen::bench::widths {\n";
    for (std::sregex_iterator at(header.begin(), header.end(), port), end; at != end; ++at) {
      text += fmt::format("inline constexpr unsigned {} = {};\n", (*at)[1].str(),
                          std::stoi((*at)[2].str()) - std::stoi((*at)[3].str()) + 1);
    }
    return text + "}  // namespace kagesen::bench::widths\n";
  }

  std::string makefile() const {
    std::string own;
    for (const SourceText& s : recipe_.sources) {
      if (ends_with(s.path, ".cpp")) own += " " + s.path;
    }
    const bool traces = has("--trace-fst"), covers = has("--coverage");
    return fmt::format(R"(RUNTIME := $(shell verilator --getenv VERILATOR_ROOT)/include
CXX := $(shell command -v ccache) {compiler}
FLAGS := -std=c++17 -fPIC -fvisibility=hidden {unique} -w {flags} \
  -DVM_TRACE={trace} -DVM_TRACE_FST={trace} -DVM_TRACE_VCD=0 -DVM_COVERAGE={cover} -DVM_SC=0 \
  -DKAGESEN_TRACE={trace} -DKAGESEN_COVERAGE={cover} -I. -Iobj -I$(RUNTIME) -I$(RUNTIME)/vltstd
MODEL := $(wildcard obj/*.cpp)
OWN := {own}
COMMON := verilated.cpp verilated_threads.cpp {common}
OBJECTS := $(MODEL:.cpp=.o) $(OWN:.cpp=.o) $(COMMON:.cpp=.o)
unit.so: $(OBJECTS)
	{compiler} -shared -Wl,-Bsymbolic -o $@ $(OBJECTS) -lz -lpthread -latomic
# What runs once need not be quick.
$(filter %__Slow.o,$(MODEL:.cpp=.o)): %.o: %.cpp
	$(CXX) $(FLAGS) -O0 -c -o $@ $<
$(filter-out %__Slow.o,$(MODEL:.cpp=.o)) $(OWN:.cpp=.o): %.o: %.cpp
	$(CXX) $(FLAGS) -c -o $@ $<
$(COMMON:.cpp=.o): %.o: $(RUNTIME)/%.cpp
	$(CXX) $(FLAGS) -c -o $@ $<
)",
                       fmt::arg("compiler", model_compiler()),
                       // or the statics of two models were one
                       fmt::arg("unique", model_compiler() == "g++" ? "-fno-gnu-unique" : ""),
                       fmt::arg("flags", fmt::format("{}", fmt::join(recipe_.compiler, " "))),
                       fmt::arg("trace", int(traces)), fmt::arg("cover", int(covers)),
                       fmt::arg("own", own),
                       fmt::arg("common", std::string(traces ? "verilated_fst_c.cpp " : "") +
                                              (covers ? "verilated_cov.cpp" : "")));
  }

  bool has(const std::string& option) const {
    return std::find(recipe_.verilator.begin(), recipe_.verilator.end(), option) !=
           recipe_.verilator.end();
  }

  const BuildRecipe& recipe_;
  fs::path folder_, log_;
};

}  // namespace

BuildRecipe bench_recipe(const UnitConfig& config, BuildKind kind) {
  BuildRecipe recipe;
  recipe.top = "shadow_bench";
  recipe.sources = rtl_sources(config.profile);
  recipe.sources.push_back({"rtl/shadow_pkg.sv", shadow_package(config)});
  for (const SourceText& source : embedded_sources()) {
    if (source.path.compare(0, 4, "rtl/") != 0) recipe.sources.push_back(source);
  }
  if (kind == BuildKind::kFast) {
    recipe.verilator = {"-O3", "--x-assign fast", "--x-initial fast", "--no-assert"};
  } else {
    recipe.verilator = {"-O3", "--x-assign unique", "--x-initial unique", "--assert"};
  }
  // Lint is a matter of its own tests.
  recipe.verilator.insert(recipe.verilator.end(), {"-Wno-lint", "-Wno-style", "-Wno-fatal"});
  if (kind == BuildKind::kTrace) recipe.verilator.push_back("--trace-fst");
  if (kind == BuildKind::kCoverage) recipe.verilator.push_back("--coverage");
  recipe.compiler = {"-O2",
                     "-march=native",
                     "-DVL_USER_STOP",
                     "-DVL_USER_FATAL",
                     "-DVL_PRINTF=kagesen_print",
                     "-include testbench/verilator/print.h",
                     fmt::format("-DKAGESEN_WINDING={}", int(config.profile == Profile::kWinding)),
                     fmt::format("-DKAGESEN_TEXEL_BITS={}", PackageWidths(config).texel_bits)};
  return recipe;
}

std::string hash_of(const BuildRecipe& recipe) {
  std::string all =
      recipe.top + fmt::format("\n{}\n{} {}\n", fmt::join(recipe.verilator, " "),
                               model_compiler(), fmt::join(recipe.compiler, " "));
  for (const SourceText& s : recipe.sources) {
    all += fmt::format("{} {}\n", s.path, s.text.size()) + s.text;
  }
  return fmt::format("{:016x}", XXH3_64bits(all.data(), all.size()));
}

std::string build_cache_folder() {
  if (const char* set = std::getenv("KAGESEN_CACHE"); set != nullptr && *set != 0) return set;
  const fs::path own = KAGESEN_BUILD_FOLDER;
  std::error_code ignored;
  if (fs::is_directory(own, ignored) && access(own.c_str(), W_OK) == 0) return own / "rtl-cache";
  const char* home = std::getenv("HOME");
  return fs::path(home ? home : "/tmp") / ".cache" / "kagesen";
}

std::string built_object(const BuildRecipe& recipe, const std::string& cache_folder) {
  const fs::path cache = cache_folder;
  std::error_code error;
  fs::create_directories(cache, error);
  if (error) throw UserError(cache_folder, error.message(), "set KAGESEN_CACHE elsewhere");
  const std::string hash = hash_of(recipe);
  const fs::path object = cache / (hash + ".so"), log = cache / (hash + ".log");
  if (fs::exists(object)) return object.string();
  const Lock lock((cache / (hash + ".lock")).string());
  if (fs::exists(object)) return object.string();  // another process built it meanwhile

  std::cerr << fmt::format("kagesen: building the RTL's model {} (about a minute, once)\n", hash);
  const auto start = std::chrono::steady_clock::now();
  const fs::path folder = fs::absolute(cache) / fmt::format("{}.{}", hash, getpid());
  fs::remove(log);
  Build build(recipe, folder, log);
  build.run();
  fs::rename(folder / "unit.so", object);
  const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
  std::cerr << fmt::format("kagesen: built {} in {:.0f} s\n", hash, spent.count());
  return object.string();
}

std::unique_ptr<bench::Bench> make_bench(const UnitConfig& config, BuildKind kind,
                                         const std::vector<SourceText>& replaced) {
  BuildRecipe recipe = bench_recipe(config, kind);
  for (const SourceText& source : replaced) {
    const auto same = std::find_if(recipe.sources.begin(), recipe.sources.end(),
                                   [&](const SourceText& s) { return s.path == source.path; });
    if (same != recipe.sources.end()) {
      same->text = source.text;
    } else {
      recipe.sources.push_back(source);
    }
  }
  const std::string object = built_object(recipe, build_cache_folder());
  void* library = dlopen(object.c_str(), RTLD_NOW | RTLD_LOCAL);  // stays: benches come and go
  const auto make =
      library ? reinterpret_cast<bench::MakeBench>(dlsym(library, bench::kMakeBenchName)) : nullptr;
  if (make == nullptr) {
    throw UserError(object, std::string("cannot load: ") + dlerror(), "remove it and try again");
  }
  return std::unique_ptr<bench::Bench>(make());
}

}  // namespace kagesen

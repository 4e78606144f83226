#include "testbench/tools/rtl_sources.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <regex>
#include <set>

#include "testbench/tools/cache.h"
#include "traces/format/error.h"

namespace kagesen {
namespace {

namespace fs = std::filesystem;

std::string without_comments(const std::string& text) {
  std::string kept;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const std::string two = text.substr(i, 2);
    if (two == "//") {
      i = std::min(text.find('\n', i), text.size());
    } else if (two == "/*") {
      i = std::min(text.find("*/", i + 2), text.size() - 2) + 2;
    }
    if (i < text.size()) kept += text[i];
  }
  return kept;
}

std::set<std::string> words_of(const std::string& text) {
  static const std::regex word("[A-Za-z_][A-Za-z_0-9]*");
  return {std::sregex_token_iterator(text.begin(), text.end(), word), {}};
}

}  // namespace

std::string source_folder() { return KAGESEN_SOURCE; }
std::string common_folder() { return source_folder() + "/rtl/common"; }
std::string ram_file() { return common_folder() + "/ram_1r1w.sv"; }
std::string rtl_folder(Profile profile) {
  return source_folder() + (profile == Profile::kPaper ? "/rtl/paper" : "/rtl/winding");
}

RtlSources::RtlSources(Profile profile) {
  for (const std::string& folder : {common_folder(), rtl_folder(profile)}) {
    for (const auto& entry : fs::directory_iterator(folder)) {
      if (entry.path().extension() == ".sv") add_file(entry.path().string());
    }
  }
}

void RtlSources::add_file(const std::string& path) {
  static const std::regex header(R"((?:^|\n)\s*module\s+([A-Za-z_]\w*))");
  const std::string text = without_comments(read_file(path));
  for (std::sregex_iterator found(text.begin(), text.end(), header), end; found != end; ++found) {
    files_[(*found)[1]] = path;
  }
}

std::string with_package_sets(std::string package, const std::vector<std::string>& sets) {
  for (const std::string& set : sets) {
    const std::size_t equals = set.find('=');
    const std::regex constant("(localparam int unsigned " + set.substr(0, equals) + " *= )[^;]*;");
    if (equals == std::string::npos || !std::regex_search(package, constant)) {
      throw UserError(set, "names no constant of the package", "write NAME=VALUE");
    }
    package = std::regex_replace(package, constant, "$01" + set.substr(equals + 1) + ";");
  }
  return package;
}

std::vector<std::string> RtlSources::modules() const {
  std::vector<std::string> names;
  for (const auto& [module, file] : files_) names.push_back(module);
  return names;
}

std::vector<std::string> RtlSources::of(const std::string& top) const {
  const auto found = files_.find(top);
  if (found == files_.end()) {
    throw UserError("module " + top, "is not in the RTL of this profile",
                    fmt::format("choose one of {}", fmt::join(modules(), ", ")));
  }
  std::vector<std::string> order;
  std::set<std::string> seen{ram_file()};
  const std::function<void(const std::string&)> visit = [&](const std::string& file) {
    if (!seen.insert(file).second) return;
    for (const std::string& word : words_of(without_comments(read_file(file)))) {
      const auto module = files_.find(word);
      if (module != files_.end()) visit(module->second);
    }
    order.push_back(file);
  };
  visit(found->second);
  return order;
}

}  // namespace kagesen

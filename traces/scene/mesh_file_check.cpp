#include "traces/scene/mesh_file_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string_view>
#include <vector>

#include "traces/format/error.h"
#include "traces/scene/gltf_check.h"

namespace kagesen {
namespace {

constexpr const char* kExportAgain = "export the mesh again";

std::string read_whole(const std::string& path) {
  std::error_code error;
  if (!std::filesystem::exists(path, error))
    throw UserError(path, "no such file", "check the name");
  if (std::filesystem::is_directory(path, error)) {
    throw UserError(path, "it is a directory", "name a mesh file in it");
  }
  std::ifstream in(path, std::ios::binary);
  std::ostringstream text;
  if (!in || !(text << in.rdbuf()).good()) {
    if (in && std::filesystem::file_size(path, error) == 0) {
      throw UserError(path, "it is empty", kExportAgain);
    }
    throw UserError(path, "cannot be read", "check the permissions");
  }
  return text.str();
}

/// Takes lines off a text, joining those that end in a backslash.
class Lines {
 public:
  explicit Lines(std::string_view text) : rest_(text) {}
  bool next(std::string& line) {
    if (rest_.empty()) return false;
    line.clear();
    number_ = next_number_;
    bool more = true;
    while (more && !rest_.empty()) {
      const std::size_t end = std::min(rest_.find('\n'), rest_.size());
      std::string_view piece = rest_.substr(0, end);
      rest_.remove_prefix(std::min(end + 1, rest_.size()));
      ++next_number_;
      if (!piece.empty() && piece.back() == '\r') piece.remove_suffix(1);
      more = !piece.empty() && piece.back() == '\\';
      if (more) piece.remove_suffix(1);
      line += piece;
      if (more) line += ' ';
    }
    return true;
  }
  std::size_t number() const { return number_; }

 private:
  std::string_view rest_;
  std::size_t number_ = 0, next_number_ = 1;
};

/// Three finite numbers after a "v".
bool three_numbers(const char* at) {
  for (int i = 0; i < 3; ++i) {
    char* end = nullptr;
    const double value = std::strtod(at, &end);
    if (end == at || !std::isfinite(value) || std::abs(value) > 3.4e38) return false;
    at = end;
  }
  return true;
}

void check_obj(const std::string& path, const std::string& text) {
  struct Reference {
    long index;
    std::size_t line;
  };
  Reference largest{0, 0};
  long vertices = 0;
  Lines lines(text);
  std::string line;
  while (lines.next(line)) {
    std::size_t start = line.find_first_not_of(" \t");
    if (start == std::string::npos || start + 1 >= line.size()) continue;
    if (!std::isspace(static_cast<unsigned char>(line[start + 1]))) continue;
    const auto where = [&] { return fmt::format("{}:{}", path, lines.number()); };
    if (line[start] == 'v') {
      ++vertices;
      if (!three_numbers(line.c_str() + start + 1)) {
        throw UserError(where(), "a vertex without three finite numbers", kExportAgain);
      }
    } else if (line[start] == 'f') {
      const char* at = line.c_str() + start + 1;
      for (;;) {
        while (std::isspace(static_cast<unsigned char>(*at))) ++at;
        if (*at == '\0' || *at == '#') break;
        char* end = nullptr;
        const long index = std::strtol(at, &end, 10);
        if (end == at) throw UserError(where(), "a face index that is no number", kExportAgain);
        if (index == 0) {
          throw UserError(where(), "face index 0, but OBJ counts from 1", kExportAgain);
        }
        if (index < 0 && -index > vertices) {
          throw UserError(where(),
                          fmt::format("face index {} with {} vertices before it", index, vertices),
                          kExportAgain);
        }
        if (index > largest.index) largest = {index, lines.number()};
        at = end;
        while (*at != '\0' && !std::isspace(static_cast<unsigned char>(*at))) ++at;
      }
    }
  }
  if (largest.index > vertices) {
    throw UserError(fmt::format("{}:{}", path, largest.line),
                    fmt::format("face index {} of {} vertices", largest.index, vertices),
                    kExportAgain);
  }
}

struct PlyProperty {
  std::size_t count_bytes = 0;  ///< of a list's count; 0: a single value
  std::size_t value_bytes = 0;
};
struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;
};

std::size_t ply_type_bytes(const std::string& type) {
  for (const char* name : {"char", "uchar", "int8", "uint8"}) {
    if (type == name) return 1;
  }
  for (const char* name : {"short", "ushort", "int16", "uint16"}) {
    if (type == name) return 2;
  }
  for (const char* name : {"int", "uint", "int32", "uint32", "float", "float32"}) {
    if (type == name) return 4;
  }
  return type == "double" || type == "float64" ? 8 : 0;
}

/// Walks over binary elements. Returns false where the data end too early.
bool walk_binary_ply(const std::vector<PlyElement>& elements, std::string_view data, bool big) {
  std::size_t at = 0;
  for (const PlyElement& element : elements) {
    for (std::uint64_t i = 0; i < element.count; ++i) {
      if (element.properties.empty()) break;
      for (const PlyProperty& property : element.properties) {
        std::uint64_t values = 1;
        if (property.count_bytes > 0) {
          if (property.count_bytes > data.size() - at) return false;
          values = 0;
          for (std::size_t b = 0; b < property.count_bytes; ++b) {
            const std::size_t shift = 8 * (big ? property.count_bytes - 1 - b : b);
            values |= std::uint64_t{static_cast<unsigned char>(data[at + b])} << shift;
          }
          at += property.count_bytes;
        }
        if (values > (data.size() - at) / property.value_bytes) return false;
        at += values * property.value_bytes;
      }
    }
  }
  return true;
}

void check_ply(const std::string& path, const std::string& text) {
  const auto bad = [&](const std::string& what) { throw UserError(path, what, kExportAgain); };
  if (text.compare(0, 3, "ply") != 0) bad("not a PLY file: it does not begin with 'ply'");
  std::vector<PlyElement> elements;
  std::string format, line;
  std::size_t at = 0;
  for (;;) {
    const std::size_t end = text.find('\n', at);
    if (end == std::string::npos) bad("its header has no 'end_header'");
    line = text.substr(at, end - at);
    at = end + 1;
    std::istringstream words(line);
    std::string word;
    words >> word;
    if (word == "end_header") break;
    if (word == "format") words >> format;
    if (word == "element") {
      elements.emplace_back();
      words >> elements.back().name >> elements.back().count;
      if (!words) bad("header line '" + line.substr(0, 60) + "' has no count");
    } else if (word == "property") {
      std::string type, count_type;
      words >> type;
      if (type == "list") words >> count_type >> type;
      const PlyProperty property{count_type.empty() ? 0 : ply_type_bytes(count_type),
                                 ply_type_bytes(type)};
      if (elements.empty() || property.value_bytes == 0 ||
          (!count_type.empty() && property.count_bytes == 0)) {
        bad("header line '" + line.substr(0, 60) + "' is not understood");
      }
      elements.back().properties.push_back(property);
    }
  }
  const std::string_view data = std::string_view(text).substr(at);
  if (format == "ascii") {
    std::uint64_t expected = 0, found = 0;
    for (const PlyElement& element : elements) expected += element.count;
    bool blank = true;
    for (const char c : data) {
      if (c == '\n') {
        found += blank ? 0 : 1;
        blank = true;
      } else if (!std::isspace(static_cast<unsigned char>(c))) {
        blank = false;
      }
    }
    found += blank ? 0 : 1;
    if (found < expected) {
      bad(fmt::format("it ends early: {} of {} data lines are there", found, expected));
    }
  } else if (format == "binary_little_endian" || format == "binary_big_endian") {
    if (!walk_binary_ply(elements, data, format == "binary_big_endian")) bad("it ends early");
  } else {
    bad("unknown PLY format '" + format + "'");
  }
}

}  // namespace

std::string check_mesh_file(const std::string& path) {
  const std::string text = read_whole(path);
  std::string extension = std::filesystem::path(path).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (!extension.empty()) extension.erase(0, 1);
  if (extension == "obj") {
    check_obj(path, text);
  } else if (extension == "ply") {
    check_ply(path, text);
  } else if (extension == "glb" || extension == "gltf") {
    check_gltf(path, text, extension == "glb");
  } else {
    throw UserError(path, "not a kind of mesh that is read here", "use .obj, .ply, .gltf or .glb");
  }
  return extension;
}

}  // namespace kagesen

#include "traces/scene/gltf_check.h"

#include <fmt/format.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <string_view>

#include "traces/format/error.h"

namespace kagesen {
namespace {

using nlohmann::json;
constexpr const char* kExportAgain = "export the mesh again";

std::uint32_t little_endian(std::string_view bytes, std::size_t at, std::size_t count) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < count; ++i) {
    value |= std::uint32_t{static_cast<unsigned char>(bytes[at + i])} << (8 * i);
  }
  return value;
}

std::string from_base64(std::string_view text) {
  std::string out;
  std::uint32_t bits = 0;
  int have = 0;
  for (const char c : text) {
    int value = -1;
    if (c >= 'A' && c <= 'Z') value = c - 'A';
    if (c >= 'a' && c <= 'z') value = c - 'a' + 26;
    if (c >= '0' && c <= '9') value = c - '0' + 52;
    if (c == '+') value = 62;
    if (c == '/') value = 63;
    if (value < 0) continue;
    bits = bits << 6 | static_cast<std::uint32_t>(value);
    have += 6;
    if (have >= 8) out += static_cast<char>(bits >> (have -= 8) & 0xff);
  }
  return out;
}

class GltfChecker {
 public:
  GltfChecker(const std::string& path, const std::string& bytes, bool binary) : path_(path) {
    std::string_view text = bytes;
    if (binary) text = split_chunks(bytes);
    file_ = json::parse(text, nullptr, /*allow_exceptions=*/false);
    if (!file_.is_object()) throw UserError(path_, "its JSON is damaged", kExportAgain);
  }

  void check() {
    const json& meshes = file_.value("meshes", json::array());
    for (std::size_t m = 0; m < meshes.size(); ++m) {
      const json& primitives = meshes[m].value("primitives", json::array());
      for (std::size_t p = 0; p < primitives.size(); ++p) {
        check_primitive(primitives[p], fmt::format("{}: mesh {}, primitive {}", path_, m, p));
      }
    }
  }

 private:
  std::string_view split_chunks(const std::string& bytes) {
    if (bytes.size() < 20 || bytes.compare(0, 4, "glTF") != 0) {
      throw UserError(path_, "not a GLB file: it does not begin with 'glTF'", kExportAgain);
    }
    const std::uint32_t version = little_endian(bytes, 4, 4), total = little_endian(bytes, 8, 4);
    if (version != 2) {
      throw UserError(path_, fmt::format("GLB version {}", version), "export as glTF 2.0");
    }
    const std::uint32_t text = little_endian(bytes, 12, 4);
    if (total > bytes.size() || text > bytes.size() - 20) {
      throw UserError(path_,
                      fmt::format("it ends early: {} of {} bytes are there", bytes.size(), total),
                      kExportAgain);
    }
    if (bytes.size() - 20 - text >= 8) buffers_[0] = bytes.substr(28 + text);
    return std::string_view(bytes).substr(20, text);
  }

  void check_primitive(const json& primitive, const std::string& where) {
    if (!primitive.contains("indices")) return;
    const json& vertices = accessor(primitive.at("attributes").at("POSITION"), where);
    const json& indices = accessor(primitive.at("indices"), where);
    if (!indices.contains("bufferView")) return;  // compressed: Assimp says what it cannot read
    const auto limit = vertices.at("count").get<std::uint64_t>();
    const auto count = indices.at("count").get<std::uint64_t>();
    const int type = indices.at("componentType").get<int>();
    const std::uint64_t bytes = type == 5121 ? 1 : type == 5123 ? 2 : 4;
    const json& view = file_.at("bufferViews").at(indices.at("bufferView").get<std::size_t>());
    const std::string& data = buffer(view.at("buffer").get<std::size_t>());
    const std::uint64_t start =
        view.value("byteOffset", std::uint64_t{0}) + indices.value("byteOffset", std::uint64_t{0});
    if (start > data.size() || count > (data.size() - start) / bytes) {
      throw UserError(where, "its indices reach beyond their buffer", kExportAgain);
    }
    for (std::uint64_t i = 0; i < count; ++i) {
      const std::uint32_t index = little_endian(data, start + i * bytes, bytes);
      if (index >= limit) {
        throw UserError(where, fmt::format("index {} of {} vertices", index, limit), kExportAgain);
      }
    }
  }

  const json& accessor(const json& number, const std::string& where) {
    const json& all = file_.at("accessors");
    const auto i = number.get<std::size_t>();
    if (i >= all.size()) {
      throw UserError(where, fmt::format("accessor {} of {}", i, all.size()), kExportAgain);
    }
    return all[i];
  }

  const std::string& buffer(std::size_t number) {
    const auto found = buffers_.find(number);
    if (found != buffers_.end()) return found->second;
    const auto uri = file_.at("buffers").at(number).at("uri").get<std::string>();
    std::string& data = buffers_[number];
    if (uri.compare(0, 5, "data:") == 0) {
      const std::size_t comma = uri.find(',');
      if (comma != std::string::npos) data = from_base64(std::string_view(uri).substr(comma + 1));
      return data;
    }
    std::ifstream in(std::filesystem::path(path_).parent_path() / uri, std::ios::binary);
    if (!in) throw UserError(path_, "its buffer '" + uri + "' cannot be read", "put it beside it");
    data.assign(std::istreambuf_iterator<char>(in), {});
    return data;
  }

  const std::string& path_;
  json file_;
  std::map<std::size_t, std::string> buffers_;
};

}  // namespace

void check_gltf(const std::string& path, const std::string& bytes, bool binary) {
  try {
    GltfChecker(path, bytes, binary).check();
  } catch (const json::exception&) {
    throw UserError(path, "its JSON lacks a part, or has one of another type", kExportAgain);
  }
}

}  // namespace kagesen

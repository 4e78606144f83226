#include "traces/raster/gbuffer_file.h"

#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <memory>

#include "traces/format/error.h"
#include "traces/raster/checks.h"

namespace kagesen {
namespace {

constexpr const char* kMend = "render it again with position and ID channels as EXR";

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

bool ends_with_name(const std::string& channel, const std::string& name) {
  if (channel.size() < name.size()) return false;
  const std::size_t start = channel.size() - name.size();
  return channel.compare(start, name.size(), name) == 0 &&
         (start == 0 || channel[start - 1] == '.');
}

int find_channel(const OIIO::ImageSpec& spec, const std::vector<std::string>& names) {
  for (const std::string& name : names) {
    for (int c = 0; c < spec.nchannels; ++c) {
      if (ends_with_name(lower(spec.channelnames[static_cast<std::size_t>(c)]), name)) return c;
    }
  }
  return -1;
}

/// The three channels of a vector, or -1 in the first.
std::array<int, 3> find_vector(const OIIO::ImageSpec& spec, const std::vector<std::string>& names) {
  for (const std::string& name : names) {
    const std::array<int, 3> found{find_channel(spec, {name + ".x"}),
                                   find_channel(spec, {name + ".y"}),
                                   find_channel(spec, {name + ".z"})};
    if (found[0] >= 0 && found[1] >= 0 && found[2] >= 0) return found;
  }
  return {-1, -1, -1};
}

class Reader {
 public:
  explicit Reader(const std::string& path) : path_(path) {
    std::error_code error;
    if (!std::filesystem::exists(path, error)) {
      throw UserError(path, "no such file", "check the name");
    }
    if (std::filesystem::is_directory(path, error)) {
      throw UserError(path, "it is a directory", "name an EXR file in it");
    }
    input_ = OIIO::ImageInput::open(path);
    if (!input_) refuse(OIIO::geterror());
    const OIIO::ImageSpec& s = spec();
    if (s.deep) throw UserError(path, "a deep image", "flatten it");
    if (s.width < 1 || s.height < 1 || s.depth > 1 || s.width > static_cast<int>(kMaxImageSide) ||
        s.height > static_cast<int>(kMaxImageSide)) {
      throw UserError(path, fmt::format("an image of {} x {} pixels", s.width, s.height),
                      fmt::format("give 1 to {} a side", kMaxImageSide));
    }
  }

  const OIIO::ImageSpec& spec() const { return input_->spec(); }

  std::vector<float> channel(int c) {
    std::vector<float> values(static_cast<std::size_t>(spec().width) *
                              static_cast<std::size_t>(spec().height));
    // Integers are read as such: OpenImageIO would scale them to 0..1.
    if (spec().channelformat(c) == OIIO::TypeDesc::UINT32) {
      std::vector<std::uint32_t> whole(values.size());
      read(c, OIIO::TypeDesc::UINT32, whole.data());
      std::transform(whole.begin(), whole.end(), values.begin(), [](std::uint32_t v) {
        return static_cast<float>(static_cast<std::int32_t>(v));
      });
    } else {
      read(c, OIIO::TypeDesc::FLOAT, values.data());
    }
    return values;
  }

  std::string channel_list() const {
    std::string list;
    for (const std::string& name : spec().channelnames) list += (list.empty() ? "" : ", ") + name;
    return list;
  }

 private:
  void read(int c, OIIO::TypeDesc type, void* data) {
    if (!input_->read_image(0, 0, c, c + 1, type, data)) refuse(input_->geterror());
  }
  [[noreturn]] void refuse(std::string why) const {
    why = why.substr(0, why.find_first_of("\r\n"));
    throw UserError(path_, "cannot be read as an image: " + (why.empty() ? "damaged" : why), kMend);
  }

  const std::string& path_;
  std::unique_ptr<OIIO::ImageInput> input_;
};

}  // namespace

GBufferFile read_gbuffer_file(const std::string& path) {
  Reader reader(path);
  const OIIO::ImageSpec& spec = reader.spec();
  const auto position = find_vector(spec, {"position", "worldposition", "p"});
  const int id = find_channel(spec, {"id", "object_id", "objectid", "id.x", "object_id.x",
                                     "objectid.x", "id.r", "object_id.r", "objectid.r"});
  if (position[0] < 0 || id < 0) {
    throw UserError(
        path,
        fmt::format("it has no {} channel; found: {}",
                    position[0] < 0 ? "position.x/y/z (or P.X/Y/Z)" : "id", reader.channel_list()),
        kMend);
  }
  GBufferFile file;
  file.width = static_cast<std::uint32_t>(spec.width);
  file.height = static_cast<std::uint32_t>(spec.height);
  const auto normal = find_vector(spec, {"normal", "worldnormal", "n"});
  const int polygon = find_channel(spec, {"polygon"});
  for (std::size_t i = 0; i < 3; ++i) {
    file.position[i] = reader.channel(position[i]);
    if (normal[0] >= 0) file.normal[i] = reader.channel(normal[i]);
  }
  file.id = reader.channel(id);
  if (polygon >= 0) file.polygon = reader.channel(polygon);
  return file;
}

void write_gbuffer_file(const std::string& path, const GBufferFile& file) {
  struct Named {
    const char* name;
    const std::vector<float>* values;
  };
  std::vector<Named> channels;
  for (const Named& c :
       {Named{"id", &file.id}, Named{"normal.x", &file.normal[0]},
        Named{"normal.y", &file.normal[1]}, Named{"normal.z", &file.normal[2]},
        Named{"polygon", &file.polygon}, Named{"position.x", &file.position[0]},
        Named{"position.y", &file.position[1]}, Named{"position.z", &file.position[2]}}) {
    if (!c.values->empty()) channels.push_back(c);
  }
  OIIO::ImageSpec spec(static_cast<int>(file.width), static_cast<int>(file.height),
                       static_cast<int>(channels.size()), OIIO::TypeDesc::FLOAT);
  spec.channelnames.clear();
  for (const Named& c : channels) spec.channelnames.push_back(c.name);
  spec.attribute("compression", "zip");
  std::vector<float> pixels(static_cast<std::size_t>(file.width) * file.height * channels.size());
  for (std::size_t c = 0; c < channels.size(); ++c) {
    for (std::size_t i = 0; i < channels[c].values->size(); ++i) {
      pixels[i * channels.size() + c] = (*channels[c].values)[i];
    }
  }

  const std::string part = path + ".part";
  const auto output = OIIO::ImageOutput::create("exr");
  const bool written = output && output->open(part, spec) &&
                       output->write_image(OIIO::TypeDesc::FLOAT, pixels.data()) && output->close();
  std::error_code error;
  if (written) std::filesystem::rename(part, path, error);
  if (!written || error) {
    std::string why = error ? error.message() : output ? output->geterror() : "no EXR support";
    why = why.substr(0, why.find_first_of("\r\n"));
    std::filesystem::remove(part, error);
    throw UserError(path, "cannot be written: " + why, "check the directory and the disk");
  }
}

}  // namespace kagesen

#include "sim/report/encode.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <stdexcept>

namespace kagesen {
namespace {

/// PNG rows unfiltered: flat colours repeat, and filters only hide that from the compressor.
constexpr int kNoFilter = 0x08;

/// Encodes interleaved pixels of `type` into memory.
std::string encode(const char* name, OIIO::ImageSpec spec, OIIO::TypeDesc type,
                   const void* pixels) {
  std::vector<unsigned char> bytes;
  OIIO::Filesystem::IOVecOutput memory(bytes);
  auto output = OIIO::ImageOutput::create(name, &memory);
  if (!output || !output->open(name, spec) || !output->write_image(type, pixels) ||
      !output->close()) {
    throw std::runtime_error("cannot encode " + std::string(name) + ": " +
                             (output ? output->geterror() : OIIO::geterror()));
  }
  return {bytes.begin(), bytes.end()};
}

}  // namespace

std::string encode_png(const Canvas& canvas) {
  OIIO::ImageSpec spec(canvas.width(), canvas.height(), 3, OIIO::TypeDesc::UINT8);
  spec.attribute("png:filter", kNoFilter);
  return encode("picture.png", spec, OIIO::TypeDesc::UINT8, canvas.data());
}

std::string encode_png_grey(int width, int height, const std::vector<std::uint8_t>& values) {
  OIIO::ImageSpec spec(width, height, 1, OIIO::TypeDesc::UINT8);
  spec.attribute("png:filter", kNoFilter);
  return encode("picture.png", spec, OIIO::TypeDesc::UINT8, values.data());
}

std::string encode_exr(int width, int height, const std::vector<Channel>& channels, bool half) {
  const std::size_t count = channels.size();
  OIIO::ImageSpec spec(width, height, static_cast<int>(count),
                       half ? OIIO::TypeDesc::HALF : OIIO::TypeDesc::FLOAT);
  spec.channelnames.clear();
  for (const Channel& channel : channels) spec.channelnames.push_back(channel.name);
  // Level 1 of 9: labels compress well at any, and a run should not wait for its pictures.
  spec.attribute("compression", "zips:1");
  const std::size_t pixels = static_cast<std::size_t>(width) * height;
  std::vector<float> interleaved(pixels * count);
  for (std::size_t c = 0; c < count; ++c) {
    for (std::size_t i = 0; i < pixels; ++i) interleaved[i * count + c] = channels[c].values[i];
  }
  return encode("picture.exr", spec, OIIO::TypeDesc::FLOAT, interleaved.data());
}

}  // namespace kagesen

#pragma once
/// Pictures as file contents, so that a file is written in one place only (Outputs).
#include <string>
#include <vector>

#include "sim/report/canvas.h"

namespace kagesen {

std::string encode_png(const Canvas& canvas);
/// 8-bit greyscale, width * height values.
std::string encode_png_grey(int width, int height, const std::vector<std::uint8_t>& values);

/// One channel of an EXR, width * height values, rows from the top.
struct Channel {
  std::string name;
  std::vector<float> values;
};
/// @param half  16-bit floats: exact for whole numbers up to 2048, half the size and the time
std::string encode_exr(int width, int height, const std::vector<Channel>& channels, bool half);

}  // namespace kagesen

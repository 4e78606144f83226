#pragma once
#include <cstdint>
#include <string>
#include <vector>

namespace kagesen {

/// The channels of a G-buffer, row by row; empty where an optional one is missing.
struct GBufferFile {
  std::uint32_t width = 0, height = 0;
  std::vector<float> position[3];  ///< world space
  std::vector<float> id;           ///< object number; negative or NaN: background
  std::vector<float> normal[3];    ///< optional
  std::vector<float> polygon;      ///< optional: triangle number in the scene, negative: unknown
};

/// Reads an EXR. Channel names are matched without case, and with or without a layer before them
/// ("View.Position.X"). Throws UserError that lists the channels found where one is missing.
GBufferFile read_gbuffer_file(const std::string& path);

/// Writes all channels that are not empty, through a PATH.part. Throws UserError.
void write_gbuffer_file(const std::string& path, const GBufferFile& file);

}  // namespace kagesen

#pragma once
#include <string>

#include "traces/raster/capture.h"

namespace kagesen {

inline constexpr std::uint32_t kMaxImageSide = 16384;  ///< pixels

/// Throws UserError for options, a camera, a light or a scene that cannot be captured.
void check_capture(const Scene& scene, const CaptureOptions& options);
/// "directional", "spot, 40 degrees", "point, 90 degrees".
std::string describe_light(const Light& light);

}  // namespace kagesen

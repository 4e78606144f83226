#pragma once
/// G-buffers: rendered EXR images with a world position and an object ID a pixel.
#include <string>

#include "traces/raster/capture.h"

namespace kagesen {

/// Writes what the camera sees as a float EXR that capture_gbuffer reads: position.x/y/z in world
/// space, normal.x/y/z towards the camera, id (object) and polygon (triangle number in the scene),
/// both -1 where nothing is seen. The file appears under its name only when it is whole.
/// Throws UserError for a scene that cannot be captured and a file that cannot be written.
void write_gbuffer(const Scene& scene, const CaptureOptions& options, const std::string& exr_path);

}  // namespace kagesen

#pragma once
#include <string>

#include "traces/scene/scene.h"

namespace kagesen {

/// SHA-256 of a scene's geometry (object names, flags, positions, indices), 64 hex digits.
std::string geometry_sha256(const Scene& scene);
/// SHA-256 of a file's bytes. Throws UserError when it cannot be read.
std::string file_sha256(const std::string& path);

}  // namespace kagesen

#pragma once
#include <string>

namespace kagesen {

/// Checks that every index of a glTF or GLB file's primitives names a vertex: Assimp leaves out the
/// others without a word. `bytes` is the whole file. Throws UserError.
void check_gltf(const std::string& path, const std::string& bytes, bool binary);

}  // namespace kagesen

#pragma once
/// What Assimp accepts in silence, or refuses without saying where, is found before it runs.
#include <string>

namespace kagesen {

/// Checks that the file is there, is of a known kind, and holds together: OBJ indices and numbers
/// by line, PLY element counts against the data, glTF indices. Throws UserError. Returns the
/// extension in lower case, without the dot.
std::string check_mesh_file(const std::string& path);

}  // namespace kagesen

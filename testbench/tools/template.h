#pragma once
/// Scripts with @NAME@ in the places that a run fills in.
#include <map>
#include <string>

namespace kagesen {

/// Throws std::logic_error if the text names what `values` has not.
std::string fill_template(const std::string& text,
                          const std::map<std::string, std::string>& values);

}  // namespace kagesen

#pragma once
/// The RTL and its bench as text, embedded when the program is built: an installed program needs no
/// source tree.
#include <string>
#include <vector>

namespace kagesen {

struct SourceText {
  std::string path;  ///< from the project's root, for example "rtl/common/fifo.sv"
  std::string text;
};
/// Everything under rtl/, and what a bench is compiled from.
const std::vector<SourceText>& embedded_sources();
/// The text of one. @pre it is there
const std::string& embedded_source(const std::string& path);

}  // namespace kagesen

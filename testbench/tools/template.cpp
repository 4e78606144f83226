#include "testbench/tools/template.h"

#include <regex>
#include <stdexcept>

namespace kagesen {

std::string fill_template(const std::string& text,
                          const std::map<std::string, std::string>& values) {
  static const std::regex name("@([A-Z_]+)@");
  std::string filled;
  auto last = text.begin();
  for (std::sregex_iterator found(text.begin(), text.end(), name), end; found != end; ++found) {
    const auto value = values.find((*found)[1]);
    if (value == values.end()) throw std::logic_error("template: no value for " + found->str());
    filled.append(last, (*found)[0].first);
    filled += value->second;
    last = (*found)[0].second;
  }
  return filled.append(last, text.end());
}

}  // namespace kagesen

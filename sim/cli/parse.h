#pragma once
/// Option values with more than one number in them. All throw UserError naming the option.
#include <cstdint>
#include <glm/glm.hpp>
#include <string>
#include <utility>

namespace kagesen {

/// "1920x1080", or "512" for both; whole numbers from 1 to `largest`.
std::pair<std::uint32_t, std::uint32_t> parse_size(const std::string& option,
                                                   const std::string& text, std::uint32_t largest);
/// "4" or "4x16": numbers from 1 to 1024.
std::pair<double, double> parse_scale(const std::string& option, const std::string& text);
/// "x,y,z", finite.
glm::dvec3 parse_vector(const std::string& option, const std::string& text);
/// A finite number in a range.
double parse_number(const std::string& option, const std::string& text, double least, double most);

}  // namespace kagesen

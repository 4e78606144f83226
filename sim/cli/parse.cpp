#include "sim/cli/parse.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <optional>
#include <vector>

#include "traces/format/error.h"

namespace kagesen {
namespace {

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::size_t from = 0;
  for (;;) {
    const std::size_t to = text.find(separator, from);
    parts.push_back(text.substr(from, to - from));
    if (to == std::string::npos) return parts;
    from = to + 1;
  }
}

template <class Number>
std::optional<Number> number(const std::string& text) {
  Number value{};
  const char* end = text.data() + text.size();
  const auto [stopped, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || stopped != end) return std::nullopt;
  return value;
}

UserError refusal(const std::string& option, const std::string& text, const std::string& wanted) {
  return UserError(option, fmt::format("'{}' is not {}", text, wanted), "see --help");
}

/// One value, or two with an x between them.
template <class Number>
std::pair<Number, Number> parse_pair(const std::string& option, const std::string& text,
                                     Number most, const std::string& wanted) {
  const std::vector<std::string> parts = split(text, 'x');
  const auto first = number<Number>(parts.front());
  const auto second = number<Number>(parts.back());
  const auto valid = [most](const std::optional<Number>& value) {
    return value && *value >= 1 && *value <= most;  // false for NaN too
  };
  if (parts.size() > 2 || !valid(first) || !valid(second)) throw refusal(option, text, wanted);
  return {*first, *second};
}

}  // namespace

std::pair<std::uint32_t, std::uint32_t> parse_size(const std::string& option,
                                                   const std::string& text, std::uint32_t largest) {
  return parse_pair<std::uint32_t>(
      option, text, largest, fmt::format("WIDTHxHEIGHT with whole numbers from 1 to {}", largest));
}

std::pair<double, double> parse_scale(const std::string& option, const std::string& text) {
  return parse_pair<double>(option, text, 1024.0, "N or NxM with numbers from 1 to 1024");
}

glm::dvec3 parse_vector(const std::string& option, const std::string& text) {
  const std::vector<std::string> parts = split(text, ',');
  glm::dvec3 vector(0);
  bool good = parts.size() == 3;
  for (int i = 0; good && i < 3; ++i) {
    const auto value = number<double>(parts[static_cast<std::size_t>(i)]);
    good = value && std::isfinite(*value);
    if (good) vector[i] = *value;
  }
  if (!good) throw refusal(option, text, "X,Y,Z with three finite numbers");
  return vector;
}

double parse_number(const std::string& option, const std::string& text, double least, double most) {
  const auto value = number<double>(text);
  if (!value || !(*value >= least && *value <= most)) {
    throw refusal(option, text, fmt::format("a number from {:g} to {:g}", least, most));
  }
  return *value;
}

}  // namespace kagesen

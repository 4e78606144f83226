#include "traces/format/text_string.h"

#include <fmt/format.h>

#include <charconv>

namespace kagesen {
namespace {

constexpr std::string_view kBlanks = " \t\r";

std::string_view skip_blanks(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of(kBlanks), text.size()));
  return text;
}

}  // namespace

std::string escape_text(std::string_view text) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    const bool at_end = i == 0 || i + 1 == text.size();
    if (byte == '\\' || byte == '#') {
      out += '\\';
      out += text[i];
    } else if (byte < ' ' || byte == 0x7F || (byte == ' ' && at_end)) {
      out += fmt::format("\\x{:02x}", byte);
    } else {
      out += text[i];
    }
  }
  return out;
}

bool unescape_text(std::string_view line, std::string& text) {
  text.clear();
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] != '\\') {
      text += line[i];
    } else if (i + 1 < line.size() && (line[i + 1] == '\\' || line[i + 1] == '#')) {
      text += line[++i];
    } else if (i + 3 < line.size() && line[i + 1] == 'x') {
      const char* digits = line.data() + i + 2;
      unsigned byte = 0;
      if (std::from_chars(digits, digits + 2, byte, 16).ptr != digits + 2) return false;
      text += static_cast<char>(byte);
      i += 3;
    } else {
      return false;
    }
  }
  return true;
}

std::string_view strip_comment(std::string_view line) {
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '\\') {
      ++i;
    } else if (line[i] == '#') {
      line = line.substr(0, i);
    }
  }
  line = skip_blanks(line);
  return line.substr(0, line.find_last_not_of(kBlanks) + 1);
}

std::string_view take_word(std::string_view& line) {
  line = skip_blanks(line);
  const std::string_view word = line.substr(0, line.find_first_of(kBlanks));
  line = skip_blanks(line.substr(word.size()));
  return word;
}

}  // namespace kagesen

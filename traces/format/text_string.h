#pragma once
/// Strings of the text form: any bytes on one line. Not for use outside this folder.
#include <string>
#include <string_view>

namespace kagesen {

/// `\\`, `\#`, and `\xHH` for control bytes and for a blank at either end.
std::string escape_text(std::string_view text);
/// The reverse; false if a backslash begins none of the three.
bool unescape_text(std::string_view line, std::string& text);
/// The line without its comment and the blanks at both ends.
std::string_view strip_comment(std::string_view line);
/// Takes the first word off the line, with the blanks around it; empty at its end.
std::string_view take_word(std::string_view& line);

}  // namespace kagesen

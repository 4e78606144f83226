#pragma once
/// What a mistyped word was probably meant to be.
#include <string>
#include <vector>

namespace kagesen {

/// Insertions, deletions, replacements and swaps of neighbours that turn one word into the other.
std::size_t edit_distance(const std::string& a, const std::string& b);

/// "did you mean 'x'?", or "choose one of a, b, c" when nothing is close.
std::string suggestion(const std::string& word, const std::vector<std::string>& choices);

}  // namespace kagesen

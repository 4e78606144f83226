#pragma once
#include <stdexcept>
#include <string>

namespace kagesen {

/// Something the person at the keyboard can mend: a bad file, value or option.
///
/// `what()` is one line, "WHERE: WHAT; MEND". The program prints it and exits with status 2.
class UserError : public std::runtime_error {
 public:
  /// @param where  the file, and the place in it, or the option or key
  /// @param what   what is wrong
  /// @param mend   what to do about it
  UserError(const std::string& where, const std::string& what, const std::string& mend)
      : std::runtime_error(where + ": " + what + "; " + mend) {}
  /// The same error seen from farther out: `place` is the file and line that held the value.
  UserError(const std::string& place, const UserError& inner)
      : std::runtime_error(place + ": " + inner.what()) {}
};

}  // namespace kagesen

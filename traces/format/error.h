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
};

}  // namespace kagesen

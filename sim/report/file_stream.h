#pragma once
/// An output stream that remembers why a write failed, which std::ofstream forgets.
#include <array>
#include <ostream>
#include <streambuf>
#include <string>

namespace kagesen {

class FileStream : private std::streambuf, public std::ostream {
 public:
  /// Creates or empties the file; error() says whether that worked.
  explicit FileStream(const std::string& path);
  ~FileStream() override;
  FileStream(const FileStream&) = delete;
  FileStream& operator=(const FileStream&) = delete;
  /// Flushes and closes; once is enough.
  void close();
  /// The errno of the first failure; 0 while all is well.
  int error() const { return error_; }

 private:
  std::streambuf::int_type overflow(std::streambuf::int_type letter) override;
  int sync() override;
  bool drain();

  int descriptor_;
  int error_ = 0;
  std::array<char, 1 << 16> buffer_;
};

}  // namespace kagesen

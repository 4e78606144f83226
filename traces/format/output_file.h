#pragma once
/// A file that appears under its name only when it is whole. Not for use outside this folder.
#include <cstdint>
#include <string>

namespace kagesen {

/// Grows as NAME.part and is renamed by commit(); without commit() nothing is left behind.
///
/// A device or a pipe is written in place. Throws UserError when the system refuses.
class OutputFile {
 public:
  explicit OutputFile(const std::string& path);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  void write(const std::uint8_t* data, std::size_t bytes);
  void commit();  ///< flushed to the disk, closed and renamed, or UserError

 private:
  [[noreturn]] void fail(const char* what, int error);
  void discard();

  std::string path_;           ///< as given, for messages
  std::string target_, part_;  ///< both the same when written in place
  int descriptor_ = -1;
};

}  // namespace kagesen

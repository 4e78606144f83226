#include "traces/format/output_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>

#include "traces/format/error.h"

namespace kagesen {
namespace {

namespace fs = std::filesystem;

const char* mend_of(int error) {
  switch (error) {
    case ENOSPC:
    case EDQUOT:
    case EFBIG:
      return "free some space or write to another disk";
    case ENOENT:
    case ENOTDIR:
      return "make its folder first";
    case EACCES:
    case EPERM:
    case EROFS:
      return "choose a place where you may write";
    default:
      return "choose another place";
  }
}

}  // namespace

OutputFile::OutputFile(const std::string& path) : path_(path), target_(path) {
  std::error_code ignored;
  if (fs::is_symlink(path, ignored) && fs::exists(path, ignored)) {
    target_ = fs::canonical(path, ignored).string();  // keep the link, replace what it points to
  }
  const fs::file_status status = fs::status(target_, ignored);
  if (fs::is_directory(status)) throw UserError(path, "is a folder", "name a file");
  const bool in_place = fs::exists(status) && !fs::is_regular_file(status);
  part_ = in_place ? target_ : target_ + ".part";
  const int flags = in_place ? O_WRONLY : O_WRONLY | O_CREAT | O_TRUNC | O_NOFOLLOW;
  descriptor_ = ::open(part_.c_str(), flags | O_CLOEXEC, 0666);
  if (descriptor_ < 0) {
    const int error = errno;
    throw UserError(path, fmt::format("cannot be created ({})", std::strerror(error)),
                    mend_of(error));
  }
}

OutputFile::~OutputFile() { discard(); }

void OutputFile::write(const std::uint8_t* data, std::size_t bytes) {
  while (bytes > 0) {
    const ssize_t written = ::write(descriptor_, data, bytes);
    if (written < 0) {
      if (errno == EINTR) continue;
      fail("writing failed", errno);
    }
    data += written;
    bytes -= static_cast<std::size_t>(written);
  }
}

void OutputFile::commit() {
  const bool in_place = part_ == target_;
  if (!in_place && ::fsync(descriptor_) != 0) fail("writing failed", errno);
  const int closing = descriptor_;
  descriptor_ = -1;
  bool ok = ::close(closing) == 0;
  if (ok && !in_place) ok = std::rename(part_.c_str(), target_.c_str()) == 0;
  if (ok) return;
  const int error = errno;
  if (!in_place) std::remove(part_.c_str());
  throw UserError(path_, fmt::format("writing failed ({})", std::strerror(error)), mend_of(error));
}

void OutputFile::fail(const char* what, int error) {
  discard();
  throw UserError(path_, fmt::format("{} ({})", what, std::strerror(error)), mend_of(error));
}

void OutputFile::discard() {
  if (descriptor_ < 0) return;
  ::close(descriptor_);
  descriptor_ = -1;
  if (part_ != target_) std::remove(part_.c_str());
}

}  // namespace kagesen

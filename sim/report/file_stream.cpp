#include "sim/report/file_stream.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>

namespace kagesen {

FileStream::FileStream(const std::string& path)
    : std::ostream(this),
      descriptor_(::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666)) {
  if (descriptor_ < 0) {
    error_ = errno;
    setstate(std::ios::failbit);
  }
  setp(buffer_.data(), buffer_.data() + buffer_.size());
}

FileStream::~FileStream() { close(); }

void FileStream::close() {
  if (descriptor_ < 0) return;
  drain();
  if (::close(descriptor_) != 0 && error_ == 0) error_ = errno;
  descriptor_ = -1;
}

bool FileStream::drain() {
  const char* from = pbase();
  while (from < pptr() && error_ == 0) {
    const ssize_t written = ::write(descriptor_, from, static_cast<std::size_t>(pptr() - from));
    if (written >= 0) {
      from += written;
    } else if (errno != EINTR) {
      error_ = errno;
    }
  }
  setp(buffer_.data(), buffer_.data() + buffer_.size());
  return error_ == 0;
}

std::streambuf::int_type FileStream::overflow(std::streambuf::int_type letter) {
  using Traits = std::streambuf::traits_type;
  if (!drain()) return Traits::eof();
  if (Traits::eq_int_type(letter, Traits::eof())) return Traits::not_eof(letter);
  return sputc(Traits::to_char_type(letter));
}

int FileStream::sync() { return drain() ? 0 : -1; }

}  // namespace kagesen

#include "testbench/tools/cache.h"

#include <fmt/format.h>
#include <unistd.h>
#include <xxhash.h>

#include <cstdlib>
#include <fstream>
#include <sstream>

#include "traces/format/error.h"

namespace kagesen {

namespace fs = std::filesystem;

fs::path cache_folder() {
  const char* set = std::getenv("KAGESEN_CACHE");
  return set && *set ? fs::absolute(set) : fs::path(KAGESEN_BUILD) / "cache";
}

ContentKey& ContentKey::add(const std::string& name, const std::string& text) {
  all_ += fmt::format("{} {}\n{}\n", name, text.size(), text);
  return *this;
}

std::string ContentKey::hex() const {
  const XXH128_hash_t hash = XXH3_128bits(all_.data(), all_.size());
  return fmt::format("{:016x}{:016x}", hash.high64, hash.low64);
}

CacheEntry::CacheEntry(const std::string& kind, const std::string& key)
    : final_(cache_folder() / kind / key),
      part_(fmt::format("{}.{}.part", final_.string(), getpid())),
      complete_(fs::is_directory(final_)) {
  if (complete_) return;
  std::error_code error;
  fs::create_directories(part_, error);
  if (error) {
    throw UserError(part_.string(), "cannot be made: " + error.message(),
                    "set KAGESEN_CACHE to a folder that can be written to");
  }
}

CacheEntry::~CacheEntry() {
  std::error_code ignored;
  if (!complete_ && !keep_) fs::remove_all(part_, ignored);
}

void CacheEntry::commit() {
  std::error_code error;
  fs::rename(part_, final_, error);
  // Another program was first: its folder has the same content.
  if (error && fs::is_directory(final_))
    fs::remove_all(part_);
  else if (error)
    throw UserError(final_.string(), error.message(), "set KAGESEN_CACHE");
  complete_ = true;
}

std::string read_file(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream text;
  if (!in || (fs::file_size(path) > 0 && !(text << in.rdbuf()))) {
    throw UserError(path.string(), "cannot be read", "check that it is there");
  }
  return text.str();
}

void write_file(const fs::path& path, const std::string& text) {
  std::ofstream out(path, std::ios::binary);
  if (!(out << text) || !out.flush()) {
    throw UserError(path.string(), "cannot be written", "make room");
  }
}

}  // namespace kagesen

#pragma once
/// Results of long runs, kept under a hash of everything that they depend on.
#include <filesystem>
#include <string>

namespace kagesen {

/// $KAGESEN_CACHE, or a folder of the build.
std::filesystem::path cache_folder();

/// Hash of named texts; names and their order count too. 32 hex digits.
class ContentKey {
 public:
  ContentKey& add(const std::string& name, const std::string& text);
  std::string hex() const;

 private:
  std::string all_;
};

/// A folder that appears under its final name only once everything in it is written. Two programs
/// that make the same one do not disturb each other.
class CacheEntry {
 public:
  /// @param kind  "gates", "mutants", ...
  CacheEntry(const std::string& kind, const std::string& key);
  ~CacheEntry();
  CacheEntry(const CacheEntry&) = delete;
  CacheEntry& operator=(const CacheEntry&) = delete;
  bool complete() const { return complete_; }
  /// Where to write until commit(), and where to read from then on.
  const std::filesystem::path& folder() const { return complete_ ? final_ : part_; }
  void commit();
  /// Leaves the unfinished folder where it is, so that its logs can be read.
  void keep_unfinished() { keep_ = true; }

 private:
  std::filesystem::path final_, part_;
  bool complete_, keep_ = false;
};

/// Whole text of a file. Throws UserError.
std::string read_file(const std::filesystem::path& path);
/// Throws UserError when the disk refuses.
void write_file(const std::filesystem::path& path, const std::string& text);

}  // namespace kagesen

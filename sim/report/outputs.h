#pragma once
/// Output files that appear all together or not at all.
#include <filesystem>
#include <memory>
#include <ostream>
#include <string>
#include <vector>

namespace kagesen {

/// Removes `path` when the program is interrupted while this object lives.
class PartGuard {
 public:
  explicit PartGuard(const std::string& path);
  ~PartGuard();
  PartGuard(const PartGuard&) = delete;
  PartGuard& operator=(const PartGuard&) = delete;

 private:
  int slot_;
};

/// From here on SIGINT and SIGTERM remove the guarded files and end the program with 128 + signal.
void remove_parts_on_interrupt();

/// Files being written. Each grows as NAME.part; commit() gives all of them their names, and
/// without it the destructor removes the parts and the folders that were made for them. An existing
/// device or pipe is written directly. Every function throws UserError when the disk refuses.
class Outputs {
 public:
  Outputs();
  ~Outputs();
  Outputs(const Outputs&) = delete;
  Outputs& operator=(const Outputs&) = delete;

  /// Makes the folder, and its parents, unless it is there; checks that it can be written to.
  void make_folder(const std::string& path);
  /// A stream that lives as long as this object. `path` must lie in an existing folder.
  std::ostream& open(const std::string& path);
  /// The whole content of a file at once.
  void write(const std::string& path, const std::string& bytes);
  /// Flushes, checks and renames.
  void commit();
  /// Names in the order they were opened.
  std::vector<std::string> names() const;

 private:
  struct File;
  static void close(File& file);

  std::vector<std::unique_ptr<File>> files_;
  std::vector<std::filesystem::path> made_folders_;
  bool committed_ = false;
};

}  // namespace kagesen

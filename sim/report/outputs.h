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
  enum class Kind { kFile, kFolder };  ///< a folder goes only if it is empty by then
  explicit PartGuard(const std::string& path, Kind kind = Kind::kFile);
  ~PartGuard();
  PartGuard(const PartGuard&) = delete;
  PartGuard& operator=(const PartGuard&) = delete;

 private:
  int slot_;
};

/// From here on SIGINT, SIGTERM and SIGHUP remove what is guarded and end the program with
/// 128 + signal. One that the program was started to ignore stays ignored.
void remove_parts_on_interrupt();

/// Files being written. Each grows as NAME.part; commit() gives all of them their names, and
/// without it the destructor removes the parts and the folders that were made for them. An existing
/// device or pipe is written directly. Every function throws UserError when the disk refuses, or
/// when one file would be written twice.
class Outputs {
 public:
  Outputs();
  ~Outputs();
  Outputs(const Outputs&) = delete;
  Outputs& operator=(const Outputs&) = delete;

  /// Makes the folder, and its parents, unless it is there; checks that it can be written to.
  void make_folder(const std::string& path);
  /// Keeps `path` from being opened under another name; `role` says what it is ("--json").
  void reserve(const std::string& path, const std::string& role);
  /// The same for a file that is read; a name without a file is left alone.
  void reserve_input(const std::string& path, const std::string& role);
  /// Throws UserError naming the first file that could not be written so far.
  void check() const;
  /// A stream that lives as long as this object. `path` must lie in an existing folder.
  /// @param role  as in reserve(); a path that was reserved is opened with the same one
  std::ostream& open(const std::string& path, const std::string& role = "output");
  /// The whole content of a file at once.
  void write(const std::string& path, const std::string& bytes, const std::string& role = "output");
  /// Flushes, checks and renames. Where a name is refused, new files do not stay.
  void commit();
  /// Names in the order they were opened.
  std::vector<std::string> names() const;

 private:
  struct File;
  struct Claim {
    std::filesystem::path file;  ///< canonical
    std::string path, role;      ///< as given
    bool opened;
  };
  void claim(const std::string& path, const std::string& role, bool opened);
  static void close(File& file);

  std::vector<std::unique_ptr<File>> files_;
  std::vector<Claim> claims_;
  std::vector<std::filesystem::path> made_folders_;
  std::vector<std::unique_ptr<PartGuard>> folder_guards_;
  bool committed_ = false;
};

}  // namespace kagesen

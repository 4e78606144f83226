#include "sim/report/outputs.h"

#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <climits>
#include <csignal>
#include <cstring>

#include "sim/report/file_stream.h"
#include "traces/format/error.h"

namespace kagesen {
namespace {

namespace fs = std::filesystem;

// A signal handler may touch neither the heap nor a std::string: names lie in a fixed table.
struct Slot {
  std::atomic<bool> used{false};
  bool folder = false;
  char path[PATH_MAX] = {};
};
std::array<Slot, 32> g_slots;

extern "C" void on_interrupt(int signal) {
  for (Slot& slot : g_slots) {
    if (slot.used.load() && !slot.folder) unlink(slot.path);
  }
  // A folder goes after those in it, wherever their slots are.
  for (bool removed = true; removed;) {
    removed = false;
    for (Slot& slot : g_slots) {
      if (slot.used.load() && slot.folder && rmdir(slot.path) == 0) removed = true;
    }
  }
  _exit(128 + signal);
}

[[noreturn]] void refuse(const std::string& path, int error) {
  throw UserError(path, std::string("cannot write: ") + std::strerror(error),
                  "make room, or write elsewhere");
}

}  // namespace

struct Outputs::File {
  File(const std::string& name, const std::string& part_name)
      : path(name),
        part(part_name),
        guard(part_name),
        stream(part_name.empty() ? name : part_name) {}
  std::string path, part;  ///< part is empty for a device
  PartGuard guard;         // before the stream: a name is guarded before the file exists
  FileStream stream;
};

PartGuard::PartGuard(const std::string& path, Kind kind) : slot_(-1) {
  if (path.empty() || path.size() >= PATH_MAX) return;
  for (int i = 0; i < static_cast<int>(g_slots.size()); ++i) {
    if (g_slots[i].used.load()) continue;
    std::memcpy(g_slots[i].path, path.c_str(), path.size() + 1);
    g_slots[i].folder = kind == Kind::kFolder;
    g_slots[i].used.store(true);
    slot_ = i;
    return;
  }
}

PartGuard::~PartGuard() {
  if (slot_ >= 0) g_slots[slot_].used.store(false);
}

void remove_parts_on_interrupt() {
  struct sigaction action {};
  action.sa_handler = on_interrupt;
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction before {};
    sigaction(signal, nullptr, &before);
    if (before.sa_handler != SIG_IGN) sigaction(signal, &action, nullptr);
  }
}

Outputs::Outputs() = default;

Outputs::~Outputs() {
  if (committed_) return;
  std::error_code ignored;
  for (const auto& file : files_) {
    file->stream.close();
    if (!file->part.empty()) fs::remove(file->part, ignored);
  }
  // Innermost first; a folder that holds something else stays.
  for (auto folder = made_folders_.rbegin(); folder != made_folders_.rend(); ++folder) {
    fs::remove(*folder, ignored);
  }
}

void Outputs::make_folder(const std::string& path) {
  std::vector<fs::path> missing;
  std::error_code error;
  fs::path folder = fs::absolute(path).lexically_normal();
  if (!folder.has_filename()) folder = folder.parent_path();
  while (!fs::exists(folder, error) && folder.has_relative_path()) {
    missing.push_back(folder);
    folder = folder.parent_path();
  }
  for (auto part = missing.rbegin(); part != missing.rend(); ++part) {
    folder_guards_.push_back(std::make_unique<PartGuard>(part->string(), PartGuard::Kind::kFolder));
    if (!fs::create_directory(*part, error) && error) {
      throw UserError(path, "cannot make the folder: " + error.message(), "choose another place");
    }
    made_folders_.push_back(*part);
  }
  if (!fs::is_directory(path, error)) {
    throw UserError(path, "is not a folder", "choose another place");
  }
  if (access(path.c_str(), W_OK | X_OK) != 0) refuse(path, errno);
}

void Outputs::reserve(const std::string& path, const std::string& role) {
  claim(path, role, /*opened=*/false);
}

void Outputs::reserve_input(const std::string& path, const std::string& role) {
  std::error_code ignored;
  if (fs::exists(path, ignored)) reserve(path, role);
}

void Outputs::check() const {
  for (const auto& file : files_) {
    if (file->stream.error() != 0) refuse(file->path, file->stream.error());
  }
}

void Outputs::claim(const std::string& path, const std::string& role, bool opened) {
  std::error_code ignored;
  // Two outputs may share a device.
  if (fs::exists(path, ignored) && !fs::is_regular_file(path, ignored)) return;
  const fs::path file = fs::weakly_canonical(fs::absolute(path), ignored);
  for (Claim& other : claims_) {
    if (other.file != file) continue;
    if (opened && !other.opened && other.role == role) {
      other.opened = true;
      return;
    }
    throw UserError(role + " " + path, "is the same file as " + other.role + " " + other.path,
                    "name another file");
  }
  claims_.push_back({file, path, role, opened});
}

std::ostream& Outputs::open(const std::string& path, const std::string& role) {
  std::error_code error;
  if (path.empty()) throw UserError("output file", "the name is empty", "give one");
  if (fs::is_directory(path, error)) throw UserError(path, "is a folder", "name a file in it");
  claim(path, role, /*opened=*/true);
  const bool device = fs::exists(path, error) && !fs::is_regular_file(path, error);
  auto file = std::make_unique<File>(path, device ? "" : path + ".part");
  if (file->stream.error() != 0) refuse(path, file->stream.error());
  files_.push_back(std::move(file));
  return files_.back()->stream;
}

void Outputs::write(const std::string& path, const std::string& bytes, const std::string& role) {
  open(path, role);
  File& file = *files_.back();
  file.stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  close(file);
}

void Outputs::close(File& file) {
  file.stream.close();
  if (file.stream.error() != 0) refuse(file.path, file.stream.error());
}

void Outputs::commit() {
  for (const auto& file : files_) close(*file);
  std::vector<std::string> added;
  for (const auto& file : files_) {
    if (file->part.empty()) continue;
    std::error_code error, ignored;
    const bool is_new = !fs::exists(file->path, ignored);
    fs::rename(file->part, file->path, error);
    if (error) {
      for (const std::string& path : added) fs::remove(path, ignored);
      refuse(file->path, error.value());
    }
    if (is_new) added.push_back(file->path);
  }
  committed_ = true;
}

std::vector<std::string> Outputs::names() const {
  std::vector<std::string> result;
  for (const auto& file : files_) result.push_back(file->path);
  return result;
}

}  // namespace kagesen

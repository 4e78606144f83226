#include "testbench/tools/process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <thread>

#include "traces/format/error.h"

namespace kagesen {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void become(const std::vector<char*>& arguments, const std::string& folder, int log) {
  setpgid(0, 0);
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  dup2(log, STDOUT_FILENO);
  dup2(log, STDERR_FILENO);
  const int nothing = open("/dev/null", O_RDONLY);
  dup2(nothing, STDIN_FILENO);
  if (chdir(folder.c_str()) == 0) execv(arguments[0], arguments.data());
  _exit(127);
}

}  // namespace

ProcessResult run_process(const std::vector<std::string>& command, const std::string& folder,
                          const std::string& log, double limit_s) {
  std::vector<char*> arguments;
  for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  const int file = open(log.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (file < 0) throw UserError(log, "cannot be written", "make room, or set KAGESEN_CACHE");
  const auto start = std::chrono::steady_clock::now();
  const pid_t child = fork();
  if (child == 0) become(arguments, folder, file);
  close(file);
  if (child < 0) throw std::runtime_error("cannot start " + command.front());
  setpgid(child, child);

  ProcessResult result;
  int status = 0;
  auto pause = std::chrono::milliseconds(1);
  for (;;) {
    const pid_t ended = waitpid(child, &status, WNOHANG);
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
    result.seconds = took.count();
    if (ended == child || (ended < 0 && errno != EINTR)) break;
    if (limit_s > 0 && result.seconds > limit_s && !result.timed_out) {
      result.timed_out = true;
      kill(-child, SIGKILL);
    }
    std::this_thread::sleep_for(pause);
    pause = std::min(2 * pause, std::chrono::milliseconds(50));
  }
  result.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return result;
}

std::string find_tool(const std::string& name, const std::string& package) {
  const char* path = std::getenv("PATH");
  std::istringstream folders(path ? path : "");
  for (std::string folder; std::getline(folders, folder, ':');) {
    const fs::path file = fs::path(folder) / name;
    if (access(file.c_str(), X_OK) == 0) return file.string();
  }
  throw UserError(name, "is not installed", "apt-get install " + package);
}

std::string tool_version(const std::string& path, const std::vector<std::string>& arguments) {
  std::vector<std::string> command{path};
  command.insert(command.end(), arguments.begin(), arguments.end());
  std::string log = (fs::temp_directory_path() / "kagesen_version_XXXXXX").string();
  const int file = mkstemp(log.data());
  if (file < 0) throw UserError(log, "cannot be written", "make room in the temporary folder");
  close(file);
  run_process(command, "/", log, 20);
  std::ifstream in(log);
  std::string line;
  std::getline(in, line);
  fs::remove(log);
  return line;
}

}  // namespace kagesen

#pragma once
/// Runs the built program as a person would, in a folder of its own.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <functional>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

namespace kagesen {

struct Outcome {
  int status = -1;  ///< of exit; 128 + n after signal n
  std::string out, err;
};

inline std::string read_file(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

inline void write_file(const std::filesystem::path& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

/// A folder that is the program's working directory and vanishes with the test.
class ProgramTest : public ::testing::Test {
 protected:
  void SetUp() override {
    std::string name = (std::filesystem::temp_directory_path() / "kagesen-test-XXXXXX").string();
    ASSERT_NE(mkdtemp(name.data()), nullptr);
    folder_ = name;
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  struct Limits {
    rlim_t file_bytes = RLIM_INFINITY;
    std::function<void(pid_t)> meanwhile;  ///< runs while the program does
  };

  Outcome run(const std::vector<std::string>& arguments) const { return run(arguments, {}); }
  Outcome run(const std::vector<std::string>& arguments, const Limits& limits) const {
    const auto out = folder_ / ".stdout", err = folder_ / ".stderr";
    const pid_t child = fork();
    if (child == 0) {
      if (chdir(folder_.c_str()) != 0) _exit(99);
      dup2(open("/dev/null", O_RDONLY), STDIN_FILENO);
      dup2(open(out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600), STDOUT_FILENO);
      dup2(open(err.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600), STDERR_FILENO);
      if (limits.file_bytes != RLIM_INFINITY) {
        const rlimit limit{limits.file_bytes, limits.file_bytes};
        setrlimit(RLIMIT_FSIZE, &limit);
      }
      std::vector<char*> words{const_cast<char*>(KAGESEN_PROGRAM)};
      for (const std::string& word : arguments) words.push_back(const_cast<char*>(word.c_str()));
      words.push_back(nullptr);
      execv(KAGESEN_PROGRAM, words.data());
      _exit(98);
    }
    if (limits.meanwhile) limits.meanwhile(child);
    int status = 0;
    waitpid(child, &status, 0);
    Outcome outcome;
    outcome.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    outcome.out = read_file(out);
    outcome.err = read_file(err);
    return outcome;
  }

  /// Exit status 2, nothing on stdout, and one line on stderr with every one of `words` in it.
  void expect_refusal(const std::vector<std::string>& arguments,
                      const std::vector<std::string>& words) const {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.status, 2) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    EXPECT_EQ(outcome.err.rfind("kagesen: ", 0), 0u) << outcome.err;
    for (const std::string& word : words) {
      EXPECT_NE(outcome.err.find(word), std::string::npos) << outcome.err << "lacks " << word;
    }
    EXPECT_EQ(left_behind(), std::vector<std::string>{}) << outcome.err;
  }

  /// Output of the program below the folder: parts, reports and pictures.
  std::vector<std::string> left_behind() const {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder_)) {
      const std::string name = entry.path().filename().string();
      const std::string kind = entry.path().extension().string();
      if (name == "out" || name == "report.json" || kind == ".part" || kind == ".png") {
        names.push_back(name);
      }
    }
    return names;
  }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  std::filesystem::path folder_;
};

/// A frame small enough for a test to take no time.
inline std::vector<std::string> small(std::vector<std::string> arguments) {
  arguments.insert(arguments.end(), {"--image", "160x90", "--map", "128"});
  return arguments;
}

}  // namespace kagesen

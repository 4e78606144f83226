#pragma once
/// One line on a terminal's stderr that says what is being done; silent elsewhere.
#include <chrono>
#include <functional>
#include <string>

namespace kagesen {

class Progress {
 public:
  explicit Progress(bool wanted);
  ~Progress() { clear(); }
  /// @param done  from 0 to 1
  void update(const std::string& stage, double done);
  void clear();
  /// For code that reports through a function; empty when silent.
  std::function<void(const std::string&, double)> callback();

 private:
  bool shown_, drawn_ = false;
  std::chrono::steady_clock::time_point last_{};
};

}  // namespace kagesen

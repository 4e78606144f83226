#include "sim/cli/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace kagesen {

Progress::Progress(bool wanted) : shown_(wanted && isatty(STDERR_FILENO)) {}

void Progress::update(const std::string& stage, double done) {
  if (!shown_) return;
  // Twenty times a second is smooth; more only slows the work.
  const auto now = std::chrono::steady_clock::now();
  if (drawn_ && now - last_ < std::chrono::milliseconds(50)) return;
  last_ = now;
  drawn_ = true;
  fmt::print(stderr, "\r\033[Kkagesen: {} {:3.0f} %", stage.substr(0, 60),
             100 * std::clamp(done, 0.0, 1.0));
  std::fflush(stderr);
}

void Progress::clear() {
  if (!drawn_) return;
  drawn_ = false;
  fmt::print(stderr, "\r\033[K");
  std::fflush(stderr);
}

std::function<void(const std::string&, double)> Progress::callback() {
  if (!shown_) return {};
  return [this](const std::string& stage, double done) { update(stage, done); };
}

}  // namespace kagesen

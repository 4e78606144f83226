#pragma once
/// FST waves of a window of cycles, in a build that has them.
#include <cstdint>
#include <string>

#include "testbench/verilator/bench_top.h"
#if KAGESEN_TRACE
#include "verilated_fst_c.h"
#endif

namespace kagesen::bench {

class Waves {
 public:
#if KAGESEN_TRACE
  void open(const char* path, std::uint64_t first, std::uint64_t last) {
    if (fst_.isOpen()) fst_.close();
    path_ = path ? path : "";
    first_ = first;
    last_ = last;
  }
  void open_in_pass(const char* path, Pass pass, std::uint64_t first, std::uint64_t last) {
    open("", 0, 0);
    due_ = {path, pass, first, last};
  }
  /// A pass begins in cycle `now`, of whose kind `before` cycles have been.
  void begin_pass(Pass pass, std::uint64_t before, std::uint64_t now) {
    if (due_.path.empty() || pass != due_.pass || due_.last < before) return;
    const std::uint64_t first = now + (due_.first > before ? due_.first - before : 0);
    open(due_.path.c_str(), first, now + (due_.last - before));
    due_.path.clear();
  }
  void dump(Vshadow_bench& top, std::uint64_t now, unsigned phase) {
    if (now < first_ || path_.empty()) return;
    if (now > last_) {
      fst_.close();
      path_.clear();
      return;
    }
    if (!fst_.isOpen()) {
      top.trace(&fst_, 99);
      fst_.open(path_.c_str());
    }
    fst_.dump(2 * now + phase);
  }

 private:
  struct Due {
    std::string path;
    Pass pass = Pass::kIdle;
    std::uint64_t first = 0, last = 0;
  };
  Due due_;
  VerilatedFstC fst_;
  std::string path_;
  std::uint64_t first_ = 0, last_ = 0;
#else
  void open(const char*, std::uint64_t, std::uint64_t) {
    throw Failure("this build of the bench writes no waves");
  }
  void open_in_pass(const char* path, Pass, std::uint64_t first, std::uint64_t last) {
    open(path, first, last);
  }
  void begin_pass(Pass, std::uint64_t, std::uint64_t) {}
  void dump(Vshadow_bench&, std::uint64_t, unsigned) {}
#endif
};

}  // namespace kagesen::bench

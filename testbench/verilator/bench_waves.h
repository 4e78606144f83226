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
  VerilatedFstC fst_;
  std::string path_;
  std::uint64_t first_ = 0, last_ = 0;
#else
  void open(const char*, std::uint64_t, std::uint64_t) {
    throw Failure("this build of the bench writes no waves");
  }
  void dump(Vshadow_bench&, std::uint64_t, unsigned) {}
#endif
};

}  // namespace kagesen::bench

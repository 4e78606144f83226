// What Verilator's runtime calls: VL_PRINTF, VL_USER_STOP, VL_USER_FATAL.
#include <cstdarg>
#include <cstdio>
#include <string>
#include <utility>

#include "testbench/verilator/bench_top.h"
#include "verilated.h"

namespace {

std::string last_message;  // what an assertion printed
std::string failure;       // where one failed; empty: nowhere

}  // namespace

int kagesen_print(const char* format, ...) {
  char text[1024];
  va_list arguments;
  va_start(arguments, format);
  const int length = std::vsnprintf(text, sizeof text, format, arguments);
  va_end(arguments);
  last_message = text;
  return length;
}
void vl_stop(const char* file, int line, const char*) {
  if (!failure.empty()) return;
  failure = std::string(file) + ":" + std::to_string(line) + ": " + last_message;
}
void vl_fatal(const char* file, int line, const char* hierarchy, const char* message) {
  last_message = message;
  vl_stop(file, line, hierarchy);
}

namespace kagesen::bench {

std::string take_failure() {
  if (failure.empty()) return {};
  return std::exchange(failure, {});
}

}  // namespace kagesen::bench

/// libFuzzer target of both trace readers. Build with -DKAGESEN_FUZZ=ON and clang, then run
/// `trace_fuzz NEW_CORPUS tests/data/fuzz/trace`.
#include "tests/fuzz/trace_exercise.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  kagesen::exercise({reinterpret_cast<const char*>(data), size});
  return 0;
}

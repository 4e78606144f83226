/// Where recorders (recorder.cmake) write: $KAGESEN_RECORD/TARGET.pins, or nowhere; and how much.
#include <cstdlib>
#include <map>
#include <string>

namespace {

struct Beats {
  long all = 0, instance = 0;
};

Beats& beats_of(const char* target) {
  static std::map<std::string, Beats> beats;
  return beats[target];
}

}  // namespace

/// Asked for once by each new instance.
extern "C" const char* kagesen_record_file(const char* target) {
  static thread_local std::string path;
  beats_of(target).instance = 0;
  const char* folder = std::getenv("KAGESEN_RECORD");
  path = folder && *folder ? std::string(folder) + "/" + target + ".pins" : std::string();
  return path.c_str();
}

/// The first $KAGESEN_RECORD_BEATS clock edges of a target in this process, 60,000 by default, and of
/// one instance a quarter of that: a test that begins anew keeps some of each beginning.
extern "C" int kagesen_record_more(const char* target) {
  static const long limit = [] {
    const char* set = std::getenv("KAGESEN_RECORD_BEATS");
    return set ? std::atol(set) : 60000L;
  }();
  Beats& beats = beats_of(target);
  return ++beats.instance <= limit / 4 && ++beats.all <= limit;
}

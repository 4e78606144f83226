#pragma once
/// Verilates and compiles a bench for a configuration when it is first needed, and keeps it.
#include <memory>
#include <string>
#include <vector>

#include "model/unit/config.h"
#include "testbench/verilator/bench.h"
#include "testbench/verilator/sources.h"

namespace kagesen {

enum class BuildKind {
  kFast,      ///< as quick as it gets; no assertions
  kCheck,     ///< assertions; what is undefined is random
  kTrace,     ///< as kCheck, and writes waves
  kCoverage,  ///< as kCheck, and counts coverage
};

/// What is compiled: a hash of it names the result.
struct BuildRecipe {
  std::string top;                  ///< module, for example "shadow_bench"
  std::vector<SourceText> sources;  ///< with a shadow_pkg.sv; C++ files are compiled too
  std::vector<std::string> verilator, compiler;  ///< options
};
BuildRecipe bench_recipe(const UnitConfig& config, BuildKind kind);
/// 16 hex digits: what is compiled, and how.
std::string hash_of(const BuildRecipe& recipe);

/// The folder of builds: $KAGESEN_CACHE, or rtl-cache in the program's build folder, or, where that
/// is gone, ~/.cache/kagesen.
std::string build_cache_folder();
/// The shared object of a recipe, built unless it is there. Processes that want the same one wait
/// for each other. Throws UserError naming the log.
std::string built_object(const BuildRecipe& recipe, const std::string& cache_folder);

/// A bench of its own for every call.
/// @param replaced  sources instead of the recipe's of that name, or beside them
std::unique_ptr<bench::Bench> make_bench(const UnitConfig& config, BuildKind kind,
                                         const std::vector<SourceText>& replaced = {});

}  // namespace kagesen

#include "tests/stress/suite.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

namespace kagesen::stress {
namespace {

using Clock = std::chrono::steady_clock;

/// "--set key=value" for every key that differs from the default.
std::string settings_text(const UnitConfig& config) {
  std::string text;
  for (const ConfigField& field : config_fields()) {
    const std::string value = get_field(config, field.key);
    if (field.key == "map_width" || field.key == "map_height") continue;  // the trace's
    if (value == get_field(UnitConfig{}, field.key)) continue;
    text += fmt::format(" --set {}={}", field.key, value);
  }
  return text;
}

std::string run_line(const std::string& file, const Setting& setting) {
  return fmt::format("kagesen run {}{}{}", file, settings_text(setting.config),
                     setting.facet_hints ? "" : "  # but without facet hints");
}

class Suite {
 public:
  Suite(const SuiteOptions& options, State& state)
      : options_(options), state_(state), spent_before_(state.seconds) {}

  void run() {
    std::uint64_t done = 0;
    while (!time_is_up() && (options_.case_limit == 0 || done < options_.case_limit)) {
      const std::uint64_t number = state_.next_case;
      if (options_.family.empty() || family_of(number).name == options_.family) {
        StressCase test = make_case(state_.seed, number, options_.cases);
        if (options_.prepare) options_.prepare(test);
        run_case(test);
        ++done;
      }
      ++state_.next_case;
      state_.seconds = spent_before_ + spent();
      if (options_.after_case && !options_.after_case(state_)) return;
    }
  }

 private:
  double spent() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }
  bool time_is_up() const { return options_.seconds > 0 && spent() >= options_.seconds; }

  void run_case(const StressCase& test) {
    const Subject subject(test.trace);
    Totals& totals = state_.families[test.family->name];
    ++totals.cases;
    totals.fragments += test.trace.all_fragments.size();
    for (const PlannedCheck& planned : test.plan) {
      const CheckResult result =
          planned.check->run({subject, planned.setting, planned.seed, options_.make_engine});
      totals.judged += result.judged;
      totals.compared += result.compared;
      totals.violations += result.failed.size();
      if (!result.failed.empty()) record(test, planned, result);
    }
  }

  Failure& failure_of(const StressCase& test, const Check& check) {
    for (Failure& f : state_.failures) {
      if (f.family == test.family->name && f.check == check.name) return f;
    }
    Failure failure;
    failure.family = test.family->name;
    failure.check = check.name;
    state_.failures.push_back(failure);
    return state_.failures.back();
  }

  void record(const StressCase& test, PlannedCheck planned, const CheckResult& result) {
    Failure& failure = failure_of(test, *planned.check);
    failure.violations += result.failed.size();
    if (++failure.cases > options_.shrink_per_kind) return;

    // What breaks the contract in another form breaks it in that form alone.
    const Trace* trace = &test.trace;
    const Check* contract = find_check("contract");
    if (planned.check->of_contract && result.changed &&
        fails(*result.changed, *contract, planned)) {
      trace = &*result.changed;
      planned.check = contract;
    }
    const Trace small = shrink(
        *trace, result.failed.front(),
        [&](const Trace& trial) { return fails(trial, *planned.check, planned); },
        options_.shrinking);
    const std::uint64_t size = small.all_casters.size() + small.all_fragments.size();
    if (failure.cases > 1 && size >= failure.size()) return;
    failure.case_number = test.number;
    failure.casters = small.all_casters.size();
    failure.fragments = small.all_fragments.size();
    write(small, planned, failure);
  }

  bool fails(const Trace& trace, const Check& check, const PlannedCheck& planned) const {
    const Subject subject(trace);
    return !check.run({subject, planned.setting, planned.seed, options_.make_engine})
                .failed.empty();
  }

  void write(const Trace& small, const PlannedCheck& planned, Failure& failure) const {
    if (!options_.write_trace) return;
    const std::string name = fmt::format("{}-{}", failure.family, failure.check);
    failure.file = options_.write_trace(small, name);
    failure.replay = {run_line(failure.file, planned.setting)};
    // Where two runs differ, both are needed.
    const Subject subject(small);
    const CheckResult result =
        planned.check->run({subject, planned.setting, planned.seed, options_.make_engine});
    if (result.other) failure.replay.push_back(run_line(failure.file, *result.other));
    if (result.changed) {
      const std::string other = options_.write_trace(*result.changed, name + "-changed");
      failure.replay.push_back(run_line(other, planned.setting));
    }
  }

  const SuiteOptions& options_;
  State& state_;
  const double spent_before_;
  const Clock::time_point start_ = Clock::now();
};

}  // namespace

Totals& Totals::operator+=(const Totals& o) {
  cases += o.cases;
  fragments += o.fragments;
  judged += o.judged;
  compared += o.compared;
  violations += o.violations;
  return *this;
}

Totals State::total() const {
  Totals sum;
  for (const auto& [name, totals] : families) sum += totals;
  return sum;
}

const Failure* smallest(const State& state) {
  const auto found =
      std::min_element(state.failures.begin(), state.failures.end(),
                       [](const Failure& a, const Failure& b) { return a.size() < b.size(); });
  return found == state.failures.end() ? nullptr : &*found;
}

void run_suite(const SuiteOptions& options, State& state) { Suite(options, state).run(); }

}  // namespace kagesen::stress

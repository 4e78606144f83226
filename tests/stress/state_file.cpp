#include "tests/stress/state_file.h"

#include <filesystem>
#include <fstream>
#include <system_error>

#include "traces/format/error.h"

namespace kagesen::stress {
namespace {

using Json = nlohmann::ordered_json;

Json totals_json(const Totals& t) {
  return {{"cases", t.cases},
          {"fragments", t.fragments},
          {"verdicts_judged", t.judged},
          {"verdicts_compared", t.compared},
          {"violations", t.violations}};
}

Totals read_totals(const Json& json) {
  Totals t;
  json.at("cases").get_to(t.cases);
  json.at("fragments").get_to(t.fragments);
  json.at("verdicts_judged").get_to(t.judged);
  json.at("verdicts_compared").get_to(t.compared);
  json.at("violations").get_to(t.violations);
  return t;
}

Json failure_json(const Failure& f) {
  return {{"family", f.family},         {"check", f.check},      {"cases", f.cases},
          {"violations", f.violations}, {"case", f.case_number}, {"casters", f.casters},
          {"fragments", f.fragments},   {"file", f.file},        {"replay", f.replay}};
}

Failure read_failure(const Json& json) {
  Failure f;
  json.at("family").get_to(f.family);
  json.at("check").get_to(f.check);
  json.at("cases").get_to(f.cases);
  json.at("violations").get_to(f.violations);
  json.at("case").get_to(f.case_number);
  json.at("casters").get_to(f.casters);
  json.at("fragments").get_to(f.fragments);
  json.at("file").get_to(f.file);
  json.at("replay").get_to(f.replay);
  return f;
}

}  // namespace

Json state_json(const State& state) {
  Json families = Json::object(), failures = Json::array();
  for (const auto& [name, totals] : state.families) families[name] = totals_json(totals);
  for (const Failure& failure : state.failures) failures.push_back(failure_json(failure));
  return {{"seed", state.seed},       {"next_case", state.next_case},
          {"seconds", state.seconds}, {"total", totals_json(state.total())},
          {"families", families},     {"failures", failures}};
}

State read_state(const std::string& path) {
  std::ifstream in(path);
  if (!in) {
    throw UserError(path, "there is no run to go on with", "leave --resume out");
  }
  State state;
  try {
    const Json json = Json::parse(in);
    json.at("seed").get_to(state.seed);
    json.at("next_case").get_to(state.next_case);
    json.at("seconds").get_to(state.seconds);
    for (const auto& [name, totals] : json.at("families").items()) {
      state.families[name] = read_totals(totals);
    }
    for (const Json& failure : json.at("failures")) state.failures.push_back(read_failure(failure));
  } catch (const Json::exception&) {
    throw UserError(path, "is not the state of a stress run", "remove it, and leave --resume out");
  }
  return state;
}

void write_state(const State& state, const std::string& path) {
  const std::string part = path + ".part";
  std::ofstream out(part);
  out << state_json(state).dump(1) << "\n";
  out.close();
  std::error_code error;
  if (out) std::filesystem::rename(part, path, error);
  if (!out || error) {
    std::filesystem::remove(part, error);
    throw UserError(path, "cannot write the state of the run", "make room, or name another folder");
  }
}

}  // namespace kagesen::stress

#include "cli/grading/lab_result.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "cli/grading/crash_report.hpp"
#include "cli/grading/graded_run.hpp"
#include "cli/grading/lab_files.hpp"
#include "cli/grading/long_tests.hpp"
#include "cli/grading/pictures.hpp"
#include "cli/system/build_log.hpp"
#include "cli/system/files.hpp"
#include "cli/system/project.hpp"
#include "files/output_file.hpp"

namespace cs550::cli {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using std::chrono::seconds;

namespace {

fs::path result_file(const std::string& lab_name) {
  return project_root() / "build/results" / fmt::format("lab{}.json", lab_number(lab_name));
}

Json to_json(const LabResult& result) {
  Json challenge = Json::array();
  for (const ChallengeCount& one : result.challenge) {
    challenge.push_back({{"what", one.what},
                         {"better", one.fewer_is_better ? "fewer" : "more"},
                         {"count", one.count}});
  }
  Json tests = Json::array();
  for (const Verdict& verdict : result.verdicts) {
    tests.push_back({{"test", verdict.test.name},
                     {"step", verdict.test.step},
                     {"points", verdict.test.points},
                     {"long", verdict.test.is_long},
                     {"earned", verdict.earned()},
                     {"status", to_string(verdict.kind)},
                     {"message", verdict.message},
                     {"seconds", verdict.seconds},
                     {"blocked_by", verdict.blocked_by}});
  }
  return {{"lab", result.lab_name},
          {"fingerprint", result.fingerprint},
          {"points", result.points()},
          {"earned", result.earned()},
          {"compile_error", result.compile_error},
          {"tests", tests},
          {"challenge", challenge}};
}

LabResult from_json(const Json& json) {
  LabResult result{json.at("lab"), json.at("fingerprint"), json.at("compile_error"), {}};
  for (const Json& row : json.at("tests")) {
    result.verdicts.push_back({{row.at("test"), row.at("step"), row.at("points"), row.at("long")},
                               verdict_kind(row.at("status")),
                               row.at("message"),
                               row.at("seconds"),
                               row.at("blocked_by")});
  }
  for (const Json& row : json.at("challenge")) {
    result.challenge.push_back({row.at("what"), row.at("better") == "fewer", row.at("count")});
  }
  return result;
}

}  // namespace

int LabResult::earned() const {
  int sum = 0;
  for (const Verdict& verdict : verdicts) sum += verdict.earned();
  return sum;
}

int LabResult::points() const {
  int sum = 0;
  for (const Verdict& verdict : verdicts) sum += verdict.test.points;
  return sum;
}

std::string LabResult::defect() const {
  if (!fault_of_absent_code(lab_name).empty()) return "has no code";
  return is_machines_error ? "was not built" : "does not compile";
}

std::optional<Verdict> LabResult::next_failure() const {
  std::optional<Verdict> next;
  for (const Verdict& verdict : verdicts) {
    if (verdict.kind == Verdict::Kind::Passed) continue;
    const bool comes_first = !next || is_earlier_step(verdict.test.step, next->test.step);
    const bool is_clearer = next && verdict.test.step == next->test.step &&
                            next->kind == Verdict::Kind::Blocked &&
                            verdict.kind == Verdict::Kind::Failed;
    if (comes_first || is_clearer) next = verdict;
  }
  return next;
}

std::optional<LabResult> remembered_result(const std::string& lab_name) {
  std::ifstream stream(result_file(lab_name));
  if (!stream) return std::nullopt;
  try {
    LabResult result = from_json(Json::parse(stream));
    if (result.fingerprint == fingerprint(lab_name)) return result;
  } catch (const Json::exception&) {
    // Damaged, or written by another version: graded again.
  }
  return std::nullopt;
}

void remember(const LabResult& result) {
  if (fingerprint(result.lab_name) != result.fingerprint) return;
  files::write_file(result_file(result.lab_name), to_json(result).dump(2) + '\n');
}

LabResult result_of(const std::string& lab_name) {
  if (const std::optional<LabResult> known = remembered_result(lab_name)) return *known;
  LabResult result = result_of_starter(lab_name);
  const int lab = lab_number(lab_name);
  const std::string absent = fault_of_absent_code(lab_name);
  const std::string error =
      absent.empty() ? build_quietly(graded_target(lab, Grading::Plain)) : absent;
  result.compile_error = error;
  if (error.empty()) result.verdicts = grade(lab, Grading::Plain, graded_tests(lab_name));
  result.is_machines_error = !error.empty() && absent.empty() && !is_students_error(error);
  if (!result.is_machines_error) remember(result);
  return result;
}

LabResult result_of_starter(const std::string& lab_name) {
  LabResult result{lab_name, fingerprint(lab_name), "", {}};
  for (const GradedTest& test : graded_tests(lab_name)) {
    result.verdicts.push_back({test, Verdict::Kind::Failed, "", 0});
  }
  return result;
}

std::string variant(Grading grading) {
  constexpr const char* variants[] = {"student", "sanitized", "debugged"};
  return variants[static_cast<int>(grading)];
}

std::string graded_target(int lab, Grading grading) {
  return fmt::format("lab{}_{}", lab, variant(grading));
}

std::vector<Verdict> grade(int lab, Grading grading, const std::vector<GradedTest>& tests,
                           const Arrived& arrived, bool everything) {
  const bool sanitized = grading == Grading::Sanitized;
  if (sanitized) configure_sanitizers();
  const int slowdown = sanitized ? 5 : 1;
  const Limits limits = students_limits(sanitized);
  const fs::path program = built_program("student", graded_target(lab, grading));
  // A test that fails draws a new one, unless it crashes or is not run.
  for (const GradedTest& test : tests) remove_picture(lab, test);
  std::vector<Verdict> verdicts;
  const Arrived add = [&](const std::vector<Verdict>& some) {
    if (arrived && !some.empty()) arrived(some);
    verdicts.insert(verdicts.end(), some.begin(), some.end());
  };
  add(run_graded_tests(program, lab, only(tests, false), slowdown * seconds{5}, {}, limits));
  const LongTests slow = long_tests(only(tests, true), verdicts, everything);
  add(slow.waiting);
  run_graded_tests(program, lab, slow.ready, slowdown * seconds{60}, add, limits);
  std::stable_sort(verdicts.begin(), verdicts.end(), [](const Verdict& a, const Verdict& b) {
    return is_earlier_step(a.test.step, b.test.step);
  });
  return verdicts;
}

}  // namespace cs550::cli

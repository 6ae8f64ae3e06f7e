#include "lab_result.hpp"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "graded_run.hpp"
#include "lab_files.hpp"
#include "manifest.hpp"
#include "process.hpp"
#include "project.hpp"
#include "quiet_build.hpp"

namespace cs550::cli {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using std::chrono::seconds;

namespace {

fs::path result_file(const std::string& lab_name) {
  return project_root() / "build/results" /
         ("lab" + std::to_string(lab_number(lab_name)) + ".json");
}

/// Undefined behaviour and failed assertions are then reported with the calls that led there.
void ask_sanitizers_for_places() {
  constexpr int keep_the_users = 0;
  setenv("UBSAN_OPTIONS", "print_stacktrace=1", keep_the_users);
  setenv("ASAN_OPTIONS", "handle_abort=1", keep_the_users);
}

/// A test that is blocked waits for another lab's files.
bool waits_for_other_labs(const LabResult& result) {
  return std::any_of(result.verdicts.begin(), result.verdicts.end(),
                     [](const Verdict& verdict) { return verdict.kind == Verdict::Kind::Blocked; });
}

Json to_json(const LabResult& result) {
  Json tests = Json::array();
  for (const Verdict& verdict : result.verdicts) {
    tests.push_back({{"test", verdict.test.name},
                     {"step", verdict.test.step},
                     {"points", verdict.test.points},
                     {"long", verdict.test.is_long},
                     {"earned", verdict.earned()},
                     {"status", to_string(verdict.kind)},
                     {"message", verdict.message},
                     {"seconds", verdict.seconds}});
  }
  return {{"lab", result.lab_name},
          {"fingerprint", result.fingerprint},
          {"points", result.points()},
          {"earned", result.earned()},
          {"compile_error", result.compile_error},
          {"tests", tests}};
}

LabResult from_json(const Json& json) {
  LabResult result{json.at("lab"), json.at("fingerprint"), json.at("compile_error"), {}};
  for (const Json& row : json.at("tests")) {
    result.verdicts.push_back({{row.at("test"), row.at("step"), row.at("points"), row.at("long")},
                               verdict_kind(row.at("status")),
                               row.at("message"),
                               row.at("seconds")});
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

std::optional<Verdict> LabResult::next_failure() const {
  const auto failure = std::find_if(verdicts.begin(), verdicts.end(), [](const Verdict& verdict) {
    return verdict.kind != Verdict::Kind::Passed;
  });
  return failure == verdicts.end() ? std::nullopt : std::optional(*failure);
}

std::optional<LabResult> remembered_result(const std::string& lab_name) {
  std::ifstream stream(result_file(lab_name));
  if (!stream) return std::nullopt;
  const Json json = Json::parse(stream, nullptr, false);
  if (!json.contains("fingerprint")) return std::nullopt;  // unreadable, or of an older version
  LabResult result = from_json(json);
  const fs::file_time_type written = fs::last_write_time(result_file(lab_name));
  const fs::path root = project_root();
  const bool stale = result.fingerprint != fingerprint(lab_name) ||
                     has_newer_file(root / "framework", written) ||
                     has_newer_file(root / "tests" / lab_name, written) ||
                     (waits_for_other_labs(result) && has_newer_file(root / "labs", written));
  return stale ? std::nullopt : std::optional(result);
}

void remember(const LabResult& result) {
  fs::create_directories(result_file(result.lab_name).parent_path());
  write_text(result_file(result.lab_name), to_json(result).dump(2) + '\n');
}

LabResult result_of(const std::string& lab_name) {
  if (const std::optional<LabResult> known = remembered_result(lab_name)) return *known;
  const int lab = lab_number(lab_name);
  LabResult result = result_of_starter(lab_name);
  result.compile_error = build_quietly(graded_target(lab, Grading::Plain));
  if (result.compile_error.empty()) {
    result.verdicts = grade(lab, Grading::Plain, graded_tests(lab_name));
  }
  remember(result);
  return result;
}

LabResult result_of_starter(const std::string& lab_name) {
  LabResult result{lab_name, fingerprint(lab_name), "", {}};
  for (const GradedTest& test : graded_tests(lab_name)) {
    result.verdicts.push_back({test, Verdict::Kind::Failed, "", 0});
  }
  return result;
}

std::string graded_target(int lab, Grading grading) {
  const std::string variant = grading == Grading::Sanitized ? "sanitized" : "student";
  return "lab" + std::to_string(lab) + '_' + variant;
}

std::vector<Verdict> grade(int lab, Grading grading, const std::vector<GradedTest>& tests) {
  const bool sanitized = grading == Grading::Sanitized;
  if (sanitized) ask_sanitizers_for_places();
  const int slowdown = sanitized ? 5 : 1;
  const fs::path program = built_program("student", graded_target(lab, grading));
  std::vector<Verdict> verdicts =
      run_graded_tests(program, lab, only(tests, false), slowdown * seconds{5});
  const std::vector<Verdict> slow =
      run_graded_tests(program, lab, only(tests, true), slowdown * seconds{60});
  verdicts.insert(verdicts.end(), slow.begin(), slow.end());
  std::stable_sort(verdicts.begin(), verdicts.end(), [](const Verdict& a, const Verdict& b) {
    return is_earlier_step(a.test.step, b.test.step);
  });
  return verdicts;
}

std::vector<GradedTest> only(const std::vector<GradedTest>& tests, bool is_long) {
  std::vector<GradedTest> chosen;
  std::copy_if(tests.begin(), tests.end(), std::back_inserter(chosen),
               [is_long](const GradedTest& test) { return test.is_long == is_long; });
  return chosen;
}

}  // namespace cs550::cli

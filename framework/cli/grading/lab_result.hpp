#pragma once
/// @file lab_result.hpp
/// The result of a lab: graded when anything that it depends on has changed, else remembered in
/// build/results/labN.json.

#include <optional>
#include <string>
#include <vector>

#include "cli/grading/graded_run.hpp"
#include "cli/grading/graded_tests.hpp"

namespace cs550::cli {

/// What a challenge counts: ungraded, once every test passes.
struct ChallengeCount {
  std::string what;             ///< "vertices visited by 1000 climbs on a sphere"
  bool fewer_is_better = true;  ///< else more is
  long count = 0;
};

struct LabResult {
  std::string lab_name;
  std::string fingerprint;    ///< of everything that was graded, taken before it was built
  std::string compile_error;  ///< why there is no program: the first error; empty when it compiled
  std::vector<Verdict> verdicts;
  std::vector<ChallengeCount> challenge = {};  ///< empty until `lab N --challenge`
  bool is_machines_error = false;  ///< a full disk, for example: the lab itself may be good

  int earned() const;
  int points() const;
  bool is_finished() const { return earned() == points(); }
  /// What a compile error means: the lab "does not compile", "has no code" or "was not built".
  std::string defect() const;
  /// A test of the first step with a test that did not pass: a failed one rather than a blocked
  /// one. None when all passed or none was run.
  std::optional<Verdict> next_failure() const;
};

/// The result on file, if it is still valid.
std::optional<LabResult> remembered_result(const std::string& lab_name);

/// Writes the result to its file, unless something has changed since its fingerprint was taken: it may or may not
/// be in the program that was graded.
void remember(const LabResult& result);

/// The remembered result, else a new one: builds quietly and runs all graded tests.
LabResult result_of(const std::string& lab_name);

/// The result before anything is written: no test was run, none passed.
LabResult result_of_starter(const std::string& lab_name);

/// Which build of the student's code is graded.
enum class Grading { Plain, Sanitized, Debugged };

/// The name of that build in CMake's targets: "student", "sanitized", "debugged".
std::string variant(Grading grading);

/// The program that grades a lab.
std::string graded_target(int lab, Grading grading);

/// Runs tests in that program, each with a time limit. Pictures of their earlier failures are removed.
/// Long tests come last. One whose step, or an earlier one, has a failing short test is not run but
/// blocked by that step, unless everything is asked for.
/// @param arrived called first with all short tests, then with long ones when they are known
std::vector<Verdict> grade(int lab, Grading grading, const std::vector<GradedTest>& tests,
                           const Arrived& arrived = {}, bool everything = false);

}  // namespace cs550::cli

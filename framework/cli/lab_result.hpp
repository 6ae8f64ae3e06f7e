#pragma once
/// @file lab_result.hpp
/// How a lab stands: graded when its files have changed, else remembered in build/results/labN.json.

#include <optional>
#include <string>
#include <vector>

#include "verdict.hpp"

namespace cs550::cli {

struct LabResult {
  std::string lab_name;
  std::string fingerprint;    ///< of the files that were graded
  std::string compile_error;  ///< the compiler's first error; empty when it compiled
  std::vector<Verdict> verdicts;

  int earned() const;
  int points() const;
  bool is_finished() const { return earned() == points(); }
  /// The first test that does not pass, by step; none when all do or nothing was run.
  std::optional<Verdict> next_failure() const;
};

/// What is remembered of a lab, if neither its files nor its tests nor the framework have changed.
std::optional<LabResult> remembered_result(const std::string& lab_name);

void remember(const LabResult& result);

/// The remembered result, else a new one: builds quietly and runs all graded tests.
LabResult result_of(const std::string& lab_name);

/// How a lab stands before anything is written: no test was run, none is passed.
LabResult result_of_starter(const std::string& lab_name);

/// Which build of the student's code is graded.
enum class Grading { Plain, Sanitized };

/// The program that grades a lab.
std::string graded_target(int lab, Grading grading);

/// Runs tests on that program, and waits for each as long as its kind may take.
std::vector<Verdict> grade(int lab, Grading grading, const std::vector<GradedTest>& tests);

/// The quick tests, or the long ones.
std::vector<GradedTest> only(const std::vector<GradedTest>& tests, bool is_long);

}  // namespace cs550::cli

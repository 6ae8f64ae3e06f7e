#pragma once
/// @file graded_run.hpp
/// Running a lab's graded tests on someone's code, whatever that code does.

#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

namespace cs550::cli {

/// One graded test, as tests/labN_topic/manifest.json lists it.
struct GradedTest {
  std::string name;  ///< "HillClimbMatchesBruteForce"
  std::string step;  ///< "L3.2"
  int points = 0;
  bool is_long = false;  ///< takes more than half a second
};

/// What became of a test. A crash, an endless loop and an exit are verdicts like any other.
struct Verdict {
  enum class Kind { Passed, Failed, Blocked };

  GradedTest test;
  Kind kind = Kind::Failed;
  std::string message;  ///< what the test said, or how the program ended
  double seconds = 0;

  int earned() const { return kind == Kind::Passed ? test.points : 0; }
};

/// The word for a kind in result files, `passed`, and the way back; an unknown word means failed.
std::string to_string(Verdict::Kind kind);
Verdict::Kind verdict_kind(const std::string& word);

/// The tests of a lab that are present, step by step: without the hidden ones where their sources
/// are not.
/// Throws std::runtime_error when there is no manifest.
std::vector<GradedTest> graded_tests(const std::string& lab_name);

/// Points of tests that the manifest lists but whose sources are elsewhere.
int points_graded_elsewhere(const std::string& lab_name);

/// Runs tests of lab `lab` in a graded program, of which as many run side by side as there are
/// processors. A test that ends its program has that as its verdict; the others still run. Verdicts
/// come in the order of the tests.
/// @param patience longest time for one test
std::vector<Verdict> run_graded_tests(const std::filesystem::path& program, int lab,
                                      const std::vector<GradedTest>& tests,
                                      std::chrono::seconds patience);

}  // namespace cs550::cli

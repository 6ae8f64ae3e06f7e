#pragma once
/// @file graded_tests.hpp
/// The graded tests of a lab, with their points, and the verdict on each: 48 points are for visible
/// tests, 12 for hidden ones.

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

/// The outcome of a test. A crash, an endless loop and an exit are failures like any other.
struct Verdict {
  enum class Kind { Passed, Failed, Blocked };

  GradedTest test;
  Kind kind = Kind::Failed;
  std::string message;  ///< the test's report, or how the program ended
  double seconds = 0;
  std::string blocked_by = {};  ///< the unwritten step that a blocked test needs, "L1.4"
  /// How a test ended the program, "crashed: Aborted"; empty if it did not. Not kept in files.
  std::string ending = {};

  /// The step to work on so that the test passes: its own, or the one that blocks it.
  const std::string& step_to_mend() const { return blocked_by.empty() ? test.step : blocked_by; }
  bool is_blocked_by_other_lab() const {
    return !blocked_by.empty() &&
           blocked_by.substr(0, blocked_by.find('.')) != test.step.substr(0, test.step.find('.'));
  }
  int earned() const { return kind == Kind::Passed ? test.points : 0; }
};

/// The tests of a lab that are present, in the order of its steps, from
/// tests/labN_topic/manifest.json. The hidden ones are left out where their sources are absent.
/// Throws std::runtime_error when there is no manifest.
std::vector<GradedTest> graded_tests(const std::string& lab_name);

/// Points of the tests that the manifest lists and that are not present.
int points_graded_elsewhere(const std::string& lab_name);

/// Whether step a of a lab comes before step b in the order in which the handout advises to write
/// them: L2.5 before L2.4. Steps without a place in it come last, L7.9 before L7.10.
bool is_earlier_step(const std::string& a, const std::string& b);

/// The word for a kind in result files, `passed`, and the reverse; an unknown word means failed.
std::string to_string(Verdict::Kind kind);
Verdict::Kind verdict_kind(const std::string& word);

}  // namespace cs550::cli

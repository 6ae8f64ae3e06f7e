#pragma once
/// @file verdict.hpp
/// A graded test, and what became of it.

#include <string>

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

/// Whether step a of a lab comes before step b: L7.9 before L7.10.
bool is_earlier_step(const std::string& a, const std::string& b);

/// The word for a kind in result files, `passed`, and the way back; an unknown word means failed.
std::string to_string(Verdict::Kind kind);
Verdict::Kind verdict_kind(const std::string& word);

}  // namespace cs550::cli

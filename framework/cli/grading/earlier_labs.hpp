#pragma once
/// @file earlier_labs.hpp
/// In a students' copy the tests of a lab run on the student's own earlier labs.

#include <string>
#include <vector>

#include "cli/grading/graded_tests.hpp"

namespace cs550::cli {

/// An earlier lab that fails by itself.
struct EarlierFault {
  int lab = 0;
  std::string step;    ///< the first one that fails, "L3.1"; empty if the lab was not built
  std::string defect;  ///< "fails L3.1", "does not compile"

  /// What to fix: "L3.1" or "lab 3".
  std::string in_words() const { return step.empty() ? "lab " + std::to_string(lab) : step; }
};

/// Warns of earlier labs that do not compile or fail their own tests, if a failing test calls them or
/// a test is blocked by them.
/// @return those that it has warned of
std::vector<EarlierFault> warn_of_earlier_labs(const std::string& lab_name,
                                               const std::vector<Verdict>& verdicts);

/// A test that is blocked by a lab that does not compile ran on that lab's starter: its message is
/// replaced, because it names an unwritten step of the starter.
void explain_blocked_tests(std::vector<Verdict>& verdicts, const std::vector<EarlierFault>& faults);

}  // namespace cs550::cli

#pragma once
/// @file long_tests.hpp
/// Long tests run after the short ones, and only when these leave them a chance to pass.

#include <vector>

#include "cli/grading/graded_tests.hpp"

namespace cs550::cli {

/// The short tests, or the long ones.
std::vector<GradedTest> only(const std::vector<GradedTest>& tests, bool is_long);

struct LongTests {
  std::vector<GradedTest> ready;
  std::vector<Verdict> waiting;  ///< blocked by a failing step: their own or an earlier one
};

/// @param short_tests the verdicts on the short tests
/// @param everything no test waits
LongTests long_tests(const std::vector<GradedTest>& tests, const std::vector<Verdict>& short_tests,
                     bool everything);

}  // namespace cs550::cli

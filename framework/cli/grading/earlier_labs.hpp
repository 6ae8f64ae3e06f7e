#pragma once
/// @file earlier_labs.hpp
/// In a students' copy the tests of a lab run on the student's own earlier labs.

#include <string>
#include <vector>

#include "cli/grading/graded_tests.hpp"

namespace cs550::cli {

/// Warns of earlier labs that do not compile or fail their own tests, if a failing test calls them or
/// a test is blocked by them.
/// @return whether an earlier lab was looked at
bool warn_of_earlier_labs(const std::string& lab_name, const std::vector<Verdict>& verdicts);

}  // namespace cs550::cli

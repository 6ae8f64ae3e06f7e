#pragma once
/// @file graded_run.hpp
/// Running a lab's graded tests on a student's code, whatever that code does.

#include <chrono>
#include <filesystem>
#include <functional>
#include <vector>

#include "cli/grading/graded_tests.hpp"
#include "cli/system/process.hpp"

namespace cs550::cli {

using Arrived = std::function<void(const std::vector<Verdict>&)>;

/// Runs tests of lab `lab` in a graded program, as many at a time as there are processors. A test
/// that crashes or hangs is a failure; the others still run. Prints every few seconds what is running.
/// @param patience longest time for one test
/// @param arrived called with the verdicts of some tests as soon as they are known
/// @param limits of the program that runs them; a test that exceeds one is a failure
/// @return the verdicts in the order of the tests
std::vector<Verdict> run_graded_tests(const std::filesystem::path& program, int lab,
                                      const std::vector<GradedTest>& tests,
                                      std::chrono::seconds patience, const Arrived& arrived = {},
                                      const Limits& limits = {});

}  // namespace cs550::cli

#pragma once
/// @file graded_run.hpp
/// Running a lab's graded tests on someone's code, whatever that code does.

#include <chrono>
#include <filesystem>
#include <vector>

#include "verdict.hpp"

namespace cs550::cli {

/// Runs tests of lab `lab` in a graded program, of which as many run side by side as there are
/// processors. A test that ends its program has that as its verdict; the others still run. Verdicts
/// come in the order of the tests.
/// @param patience longest time for one test
std::vector<Verdict> run_graded_tests(const std::filesystem::path& program, int lab,
                                      const std::vector<GradedTest>& tests,
                                      std::chrono::seconds patience);

}  // namespace cs550::cli

#pragma once
/// @file own_tests.hpp
/// Grading the tests that a student has written.

#include <nlohmann/json.hpp>

#include "autograder/grader/grade_lab/options.hpp"

namespace cs550::grader {

/// Runs the tests on the reference, several times, and on each known mistake, in random order. A run
/// that does not end in time, or crashes, fails.
/// @param lab_name "lab3_hill_climbing"
/// @return {lab, isolation, compiled, stopped, message, mistakes, caught, reference_runs,
///   reference_failures}; caught is 0 if the tests ever fail on the reference, or if the time for the
///   lab is over. They are stopped if that is over, or if the compiler or a run on the reference was
nlohmann::ordered_json grade_own_tests(const Options& options, const std::string& lab_name);

}  // namespace cs550::grader

#pragma once
/// @file manifest.hpp
/// Which graded tests a lab has: tests/labN_topic/manifest.json, less what is not in this copy.

#include <string>
#include <vector>

#include "verdict.hpp"

namespace cs550::cli {

/// The tests of a lab that are present, step by step: without the hidden ones where their sources
/// are not.
/// Throws std::runtime_error when there is no manifest.
std::vector<GradedTest> graded_tests(const std::string& lab_name);

/// Points of tests that the manifest lists but whose sources are elsewhere.
int points_graded_elsewhere(const std::string& lab_name);

}  // namespace cs550::cli

#pragma once
/// @file pictures.hpp
/// The pictures that failing tests write.

#include <filesystem>
#include <string>
#include <vector>

#include "cli/grading/graded_tests.hpp"

namespace cs550::cli {

/// The picture of a test, which exists if the test failed and drew one.
/// @param test "Lab3.HillClimbMatchesBruteForce"
std::filesystem::path picture_of(const std::string& test);

/// The tests with pictures, sorted.
std::vector<std::string> tests_with_pictures();

/// Removes the picture of an earlier failure of a test.
void remove_picture(int lab, const GradedTest& test);

/// Writes PNG files beside the pictures of the first failing step, for programs that show no SVG.
/// Advises once to install rsvg-convert if it is missing. Prints how to see the first one from all sides.
void finish_pictures(int lab, const std::vector<Verdict>& verdicts);

}  // namespace cs550::cli

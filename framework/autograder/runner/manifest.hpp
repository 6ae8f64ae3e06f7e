#pragma once
/// @file manifest.hpp
/// The list of a program's graded tests, as JSON.

#include <string>

namespace cs550::autograder {

/// {lab, points {visible, hidden}, tests [{name, points, step, hidden, long}]}, ending in a
/// newline.
std::string manifest();

}  // namespace cs550::autograder

#pragma once
/// @file manifest.hpp
/// The list of a program's graded tests and the counts of its challenges, as JSON.

#include <string>

namespace cs550::autograder {

/// {lab, points {visible, hidden}, tests [{name, points, step, hidden, long}], challenge [...]}, ending
/// in a newline. Without the counts if the lab's code is not written.
std::string manifest();

/// [{what, better, count}], ending in a newline. Throws what the lab's code throws.
std::string challenge_counts();

}  // namespace cs550::autograder

#pragma once
/// @file feedback.hpp
/// What a student gets back.

#include <string>

#include "gradebook/marks/mark.hpp"

namespace cs550::gradebook {

/// Marks, what changed them, failed tests with their messages, files that were ignored. Of hidden
/// tests the names and points only.
/// @param mark of a student with this one record
std::string feedback_markdown(const StudentMark& mark, const Course& course);

/// The same as a page without other files.
std::string feedback_html(const StudentMark& mark, const Course& course);

}  // namespace cs550::gradebook

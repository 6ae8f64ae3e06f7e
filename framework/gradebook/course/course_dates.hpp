#pragma once
/// @file course_dates.hpp
/// Whether the dates of a course can be meant.

#include <string>

#include "gradebook/course/course.hpp"

namespace cs550::gradebook {

/// Throws CourseError if a solution is released before its lab is due, if an extension ends before the due date
/// or after the release of the solution, or if a student has two extensions of one lab.
/// @param file its name in messages
void check_dates(const Course& course, const std::string& file);

}  // namespace cs550::gradebook

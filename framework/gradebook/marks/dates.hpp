#pragma once
/// @file dates.hpp
/// When a student submitted, and when a lab is due.

#include <optional>
#include <vector>

#include "gradebook/marks/roster.hpp"

namespace cs550::gradebook {

/// When a record was submitted, by the clock of the late policy; nothing if that is unknown.
std::optional<Time> time_of_submission(const Student& student, const Record& record,
                                       const Course& course);

/// The extension that a student has for a lab; null without one.
const Extension* extension_of(const Student& student, int lab, const Course& course);

/// Throws CourseError if a student of the roster has two extensions of one lab, by id and address.
void check_extensions(const Course& course, const std::vector<Student>& roster);

/// A time at which a submission earns the same marks in these labs, and which tells no more than that:
/// the end of the period between two dates of the late policy.
Time coarse_time(Time time, const std::vector<int>& labs, const Student& student,
                 const Course& course);

}  // namespace cs550::gradebook

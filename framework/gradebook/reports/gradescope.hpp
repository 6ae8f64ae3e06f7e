#pragma once
/// @file gradescope.hpp
/// The file results.json of a Gradescope autograder.
/// https://gradescope-autograders.readthedocs.io/en/latest/specs/

#include <string>

#include "gradebook/marks/mark.hpp"

namespace cs550::gradebook {

/// @param mark of a student with this one record
std::string gradescope_json(const StudentMark& mark, const Course& course);

}  // namespace cs550::gradebook

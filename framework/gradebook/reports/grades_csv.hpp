#pragma once
/// @file grades_csv.hpp
/// The marks of a class as CSV.

#include <string>
#include <vector>

#include "gradebook/marks/mark.hpp"

namespace cs550::gradebook {

/// Why no submission of a student could be read; empty if one could.
std::string trouble_of(const Student& student);

/// "graded", or why there may be no mark: "missing", "NOT GRADED", "no graded lab" and others.
std::string status_of(const StudentMark& mark);

/// One line per student: id, name, email, section, status, percent, a column per lab, notes.
/// Students without a submission are listed with status `missing`. The percent of one without a
/// mark is empty.
std::string grades_csv(const std::vector<StudentMark>& marks, const std::vector<int>& labs);

}  // namespace cs550::gradebook
